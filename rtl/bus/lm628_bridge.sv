// SPDX-License-Identifier: Apache-2.0
//
// Port of two bytes to two LM628 (McAfee 1994, tables 2 to 4): a rising strobe bit of port B starts
// a pulse of WR or RD, as the 74LS123 do there. From that edge on, until the pulse and its hold
// time are over, the pins do not change, whatever is written to the ports.
//
//   clocks  stage
//   1       a transceiver or part that was on goes off before the other goes on
//   2       PS, CS and data before the strobe: 30 ns
//   Pulse   WR or RD low, 5.5 us at 50 MHz; the end of RD takes the byte
//   9       hold: 120 ns after WR; a part is off the bus 180 ns after RD
//
// A strobe starts nothing while a pulse runs, where it would be lost in a longer pulse, nor against
// the direction of `read`, where two would drive the bus. refused_o reports it.

module lm628_bridge
  import trammel_pkg::*;
#(
    parameter int unsigned Pulse = 275
) (
    input logic clk_i,       // of the timers; gated for the other registers
    input logic clock_en_i,
    input logic rst_i,

    input gap_t leap_i,

    input  logic       write_strobe_i,  // port B
    input  logic       read_strobe_i,
    input  logic       ps_i,
    input  logic       read_i,
    input  logic       y_i,
    input  logic [7:0] to_part_i,       // port C
    output logic [7:0] from_part_o,
    output logic       busy_o,
    output logic       refused_o,

    output logic       cs_x_n_o,
    output logic       cs_y_n_o,
    output logic       rd_n_o,
    output logic       wr_n_o,
    output logic       ps_o,
    output logic [7:0] d_o,
    output logic       transceiver_o,  // drives the parts' bus
    output logic       selector_o,     // drives port C
    input  logic [7:0] d_x_i,
    input  logic [7:0] d_y_i,

    output gap_t next_o,
    output logic quiescent_o
);

  logic clk_gated;
  assign clk_gated = clk_i & clock_en_i;

  localparam logic [8:0] Setup = 9'd1, Low = 9'(Pulse - 1), Hold = 9'd8;

  typedef struct packed {
    logic ps;
    logic read;
    logic y;
    logic [7:0] d;
  } pins_t;

  typedef enum logic [1:0] {
    StRest,   // pins follow the ports
    StSetup,
    StPulse,
    StHold
  } state_e;

  state_e state_q, state_d;
  pins_t ports, pins_q;
  logic change, change_q;  // of driver or part: for a clock nothing drives or is selected
  logic write_was_q, read_was_q, write_rises, read_rises;
  logic start, load, last, writes_q, reads_q;
  logic [7:0] byte_q;
  logic [8:0] count, value;

  assign ports       = {ps_i, read_i, y_i, to_part_i};
  assign write_rises = write_strobe_i && !write_was_q;
  assign read_rises  = read_strobe_i && !read_was_q;
  assign start       = state_q == StRest && (read_i ? read_rises : write_rises);
  assign refused_o   = (write_rises && !(start && !read_i)) || (read_rises && !(start && read_i));
  assign change      = state_q == StRest && {read_i, y_i} != {pins_q.read, pins_q.y};

  timer #(
      .Width(9)
  ) u_count (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (load),
      .value_i(value),
      .count_o(count),
      .next_o (next_o)
  );

  assign last = count == '0;

  always_comb begin
    state_d = state_q;
    value   = Setup;
    unique case (state_q)
      StRest: if (start) state_d = StSetup;
      StSetup: begin
        value = Low;
        // The clock in which nothing was selected does not count as set-up time.
        if (change_q) value = Setup;
        else if (last) state_d = StPulse;
      end
      StPulse: begin
        value = Hold;
        if (last) state_d = StHold;
      end
      default: if (last) state_d = StRest;
    endcase
  end

  assign load = start || (state_q == StSetup && (change_q || last)) || (state_q == StPulse && last);

  always_ff @(posedge clk_gated) begin
    if (rst_i) begin
      state_q     <= StRest;
      change_q    <= 1'b0;
      pins_q      <= '0;
      write_was_q <= 1'b0;
      read_was_q  <= 1'b0;
      writes_q    <= 1'b0;
      reads_q     <= 1'b0;
      byte_q      <= '0;
    end else begin
      state_q     <= state_d;
      change_q    <= change;
      write_was_q <= write_strobe_i;
      read_was_q  <= read_strobe_i;
      writes_q    <= state_d == StPulse && !pins_q.read;
      reads_q     <= state_d == StPulse && pins_q.read;
      if (state_q == StRest) pins_q <= ports;
      if (reads_q && last) byte_q <= pins_q.y ? d_y_i : d_x_i;
    end
  end

  assign cs_x_n_o      = pins_q.y || change_q;
  assign cs_y_n_o      = !pins_q.y || change_q;
  assign rd_n_o        = !reads_q;
  assign wr_n_o        = !writes_q;
  assign ps_o          = pins_q.ps;
  assign d_o           = pins_q.d;
  assign transceiver_o = !pins_q.read && !change_q;
  assign selector_o    = pins_q.read && !change_q;
  assign from_part_o   = byte_q;
  assign busy_o        = state_q != StRest || start;
  assign quiescent_o   = !change_q && write_strobe_i == write_was_q &&
      read_strobe_i == read_was_q && (state_q == StRest ? ports == pins_q : !last);

endmodule
