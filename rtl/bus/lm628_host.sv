// SPDX-License-Identifier: Apache-2.0
//
// One access of an LM628's port by the times of its data sheet (SNVS781C p.4), in clocks of ClockNs
// rounded up; done_o comes with the last one:
//
//   ns        stage
//   30        CS, PS and the byte of a write, before the strobe
//   100, 180  WR or RD low; the end of RD takes the byte
//   120, 180  hold: the byte of a write; a part is off the bus 180 ns after RD
//
// No pin changes in between, so that the next access may begin at once.

module lm628_host #(
    parameter int unsigned ClockNs = 20
) (
    input logic clk_i,
    input logic rst_i,

    input  logic start_i,  // ignored while busy
    output logic busy_o,
    output logic done_o,

    input  logic       write_i,
    input  logic       ps_i,
    input  logic [7:0] byte_i,
    output logic [7:0] byte_o,  // of the last read

    output logic       cs_n_o,
    output logic       rd_n_o,
    output logic       wr_n_o,
    output logic       ps_o,
    output logic [7:0] d_o,
    output logic       drive_o,  // d_o is on the bus
    input  logic [7:0] d_i,

    output logic quiescent_o
);

  if (ClockNs < 5 || ClockNs > 50) begin : gen_refused
    $error("lm628_host: ClockNs is 5 to 50");
  end

  typedef logic [5:0] clocks_t;

  // Of 30, 100, 180, 120 and 180 ns, rounded up, less one.
  localparam clocks_t Setup     = clocks_t'(29 / ClockNs);
  localparam clocks_t Write     = clocks_t'(99 / ClockNs);
  localparam clocks_t Read      = clocks_t'(179 / ClockNs);
  localparam clocks_t WriteHold = clocks_t'(119 / ClockNs);
  localparam clocks_t ReadHold  = clocks_t'(179 / ClockNs);

  typedef enum logic [1:0] {
    StIdle,
    StSetup,
    StStrobe,
    StHold
  } state_e;

  state_e state_q, state_d;
  clocks_t count_q, count_d;
  logic start, last, write_q, write_d, reads_q, writes_q, cs_q, drive_q, ps_q;
  logic [7:0] d_q, byte_q;

  assign start   = start_i && state_q == StIdle;
  assign write_d = start ? write_i : write_q;
  assign last    = count_q == '0;

  always_comb begin
    state_d = state_q;
    count_d = last ? '0 : count_q - 6'd1;
    unique case (state_q)
      StIdle:
      if (start) begin
        state_d = StSetup;
        count_d = Setup;
      end
      StSetup:
      if (last) begin
        state_d = StStrobe;
        count_d = write_q ? Write : Read;
      end
      StStrobe:
      if (last) begin
        state_d = StHold;
        count_d = write_q ? WriteHold : ReadHold;
      end
      default: if (last) state_d = StIdle;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      state_q  <= StIdle;
      count_q  <= '0;
      write_q  <= 1'b0;
      ps_q     <= 1'b0;
      d_q      <= '0;
      byte_q   <= '0;
      cs_q     <= 1'b0;
      drive_q  <= 1'b0;
      writes_q <= 1'b0;
      reads_q  <= 1'b0;
    end else begin
      state_q <= state_d;
      count_q <= count_d;
      write_q <= write_d;
      if (start) begin
        ps_q <= ps_i;
        d_q  <= byte_i;
      end
      cs_q     <= state_d != StIdle;
      drive_q  <= state_d != StIdle && write_d;
      writes_q <= state_d == StStrobe && write_d;
      reads_q  <= state_d == StStrobe && !write_d;
      if (reads_q && last) byte_q <= d_i;
    end
  end

  assign busy_o      = state_q != StIdle;
  assign done_o      = state_q == StHold && last;
  assign byte_o      = byte_q;
  assign cs_n_o      = !cs_q;
  assign rd_n_o      = !reads_q;
  assign wr_n_o      = !writes_q;
  assign ps_o        = ps_q;
  assign d_o         = d_q;
  assign drive_o     = drive_q;
  assign quiescent_o = state_q == StIdle && !start_i;

endmodule
