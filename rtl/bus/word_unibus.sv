// SPDX-License-Identifier: Apache-2.0
//
// Four words of 16 bits on a UNIBUS, and the interrupt of the device that has them: a slave of
// DATI, DATIP, DATO and DATOB at Base to Base + 7, and a master of one interrupt (DEC, PDP-11 Bus
// Handbook). All lines are true when high: receivers and drivers invert. They pass two flip-flops;
// address, control and data need not, for they stand before MSYN does.
//
//   slave      MSYN, address matches: one access, then SSYN until MSYN falls
//   interrupt  request: BR; BG: SACK, grant_o, the vector is kept; BG and BBSY and SSYN fall: BBSY
//              and INTR with the vector until SSYN; then the bus is free when SSYN has fallen
//
// A grant that comes without a request is passed on to the next device.

module word_unibus #(
    parameter logic [17:0] Base = 18'o764000
) (
    input logic clk_i,
    input logic rst_i,

    input  logic [17:0] a_i,
    input  logic [ 1:0] c_i,     // C1, C0: DATI, DATIP, DATO, DATOB
    input  logic        msyn_i,
    input  logic [15:0] d_i,
    output logic [15:0] d_o,
    output logic        d_oe_o,
    output logic        ssyn_o,

    output logic br_o,
    input  logic bg_i,
    output logic bg_o,
    output logic sack_o,
    input  logic bbsy_i,
    output logic bbsy_o,
    input  logic ssyn_i,
    output logic intr_o,

    output logic        write_o,
    output logic        y_o,
    output logic [ 3:0] bytes_o,   // of the status word the upper two
    output logic [31:0] data_o,
    input  logic [31:0] x_i,       // status word and count
    input  logic [31:0] y_i,
    input  logic        irq_i,
    input  logic [ 7:0] vector_i,
    output logic        grant_o,

    output logic quiescent_o
);

  typedef enum logic [1:0] {
    StIdle,
    StTaken,   // SACK; the bus is not yet free
    StVector,  // INTR, until the processor has the vector
    StRelease  // until it has let go of SSYN
  } state_e;

  state_e state_d, state_q;
  logic msyn_meta_q, msyn_q, bg_meta_q, bg_q, bbsy_meta_q, bbsy_q, ssyn_meta_q, ssyn_in_q;
  logic answered_q, reading_q, bg_was_q, passing_q;
  logic [15:0] read_q;
  logic [7:0] vector_q;
  logic [31:0] axis;
  logic match, acts, writes, takes, empty;

  // ---- slave ----

  assign match   = a_i[17:3] == Base[17:3];
  assign acts    = msyn_q && !answered_q && match;
  assign writes  = c_i[1];
  assign axis    = a_i[2] ? y_i : x_i;

  assign write_o = acts && writes;
  assign y_o     = a_i[2];
  assign bytes_o = c_i[0] ? 4'd1 << a_i[1:0] : a_i[1] ? 4'b1100 : 4'b0011;
  assign data_o  = {d_i, d_i};

  // ---- interrupt ----

  assign takes   = bg_q && !bg_was_q && state_q == StIdle && irq_i;
  assign grant_o = takes;
  assign empty   = vector_q == '0;

  always_comb begin
    state_d = state_q;
    unique case (state_q)
      StIdle: if (takes) state_d = StTaken;
      StTaken: if (!bg_q && !bbsy_q && !ssyn_in_q) state_d = empty ? StIdle : StVector;
      StVector: if (ssyn_in_q) state_d = StRelease;
      default: if (!ssyn_in_q) state_d = StIdle;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      state_q    <= StIdle;
      answered_q <= 1'b0;
      reading_q  <= 1'b0;
      read_q     <= '0;
      vector_q   <= '0;
      bg_was_q   <= 1'b0;
      passing_q  <= 1'b0;
    end else begin
      state_q    <= state_d;
      answered_q <= msyn_q && (answered_q || acts);
      if (acts) begin
        reading_q <= !writes;
        read_q    <= a_i[1] ? axis[31:16] : axis[15:0];
      end
      bg_was_q  <= bg_q;
      passing_q <= bg_q && (passing_q || (!bg_was_q && !takes && state_q != StTaken));
      if (takes) vector_q <= vector_i;
    end
  end

  always_ff @(posedge clk_i) begin
    msyn_meta_q <= msyn_i;
    msyn_q      <= msyn_meta_q;
    bg_meta_q   <= bg_i;
    bg_q        <= bg_meta_q;
    bbsy_meta_q <= bbsy_i;
    bbsy_q      <= bbsy_meta_q;
    ssyn_meta_q <= ssyn_i;
    ssyn_in_q   <= ssyn_meta_q;
  end

  assign ssyn_o = answered_q;
  assign d_oe_o = intr_o || (answered_q && reading_q);
  assign d_o    = intr_o ? 16'(vector_q) : read_q;
  assign br_o   = irq_i && state_q == StIdle;
  assign bg_o   = passing_q;
  assign sack_o = state_q == StTaken;
  assign bbsy_o = state_q == StVector;
  assign intr_o = state_q == StVector;

  assign quiescent_o = !acts && state_d == state_q && (msyn_q || !answered_q) && bg_q == bg_was_q &&
      msyn_i == msyn_meta_q && msyn_meta_q == msyn_q && bg_i == bg_meta_q && bg_meta_q == bg_q &&
      bbsy_i == bbsy_meta_q && bbsy_meta_q == bbsy_q && ssyn_i == ssyn_meta_q &&
      ssyn_meta_q == ssyn_in_q;

endmodule
