// SPDX-License-Identifier: Apache-2.0
//
// The one phase counter of the chip and its ticks (specification section 1).
//
//   tick_cur  16 kHz   every 3125 clocks, phase 0
//   tick_pos   2 kHz   every eighth tick_cur, starting with the first after reset
//   tick_irq           every irq_period-th tick_pos, starting with the first after reset
//
// A tick is high in the clock before the edge that acts on it. The timer is 0 at phase 0, so that
// the tick, the reload and the event of the timer are one and the same edge.

module timebase
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic [7:0] irq_period_i,

    output logic [11:0] phase_o,
    output logic        tick_cur_o,
    output logic        tick_pos_o,
    output logic        tick_irq_o,
    output logic [31:0] tick_count_o,
    output gap_t        next_o,
    output logic        quiescent_o
);

  logic [11:0] count;
  logic [2:0] cur_q;
  logic [7:0] irq_d, irq_q;
  logic [31:0] tick_count_q;

  timer #(
      .Width(12)
  ) u_phase (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (tick_cur_o),
      .value_i(12'(PwmPeriod - 1)),
      .count_o(count),
      .next_o (next_o)
  );

  assign phase_o    = tick_cur_o ? 12'd0 : 12'(PwmPeriod) - count;
  assign tick_cur_o = count == 12'd0;
  assign tick_pos_o = tick_cur_o && cur_q == 3'd0;
  assign tick_irq_o = tick_pos_o && irq_q == 8'd0;

  // A new period counts from the next interrupt on.
  always_comb begin
    irq_d = irq_q - 8'd1;
    if (tick_irq_o) irq_d = irq_period_i == 8'd0 ? 8'd0 : irq_period_i - 8'd1;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      cur_q        <= '0;
      irq_q        <= '0;
      tick_count_q <= '0;
    end else begin
      if (tick_cur_o) cur_q <= cur_q + 3'd1;
      if (tick_pos_o) begin
        irq_q        <= irq_d;
        tick_count_q <= tick_count_q + 32'd1;
      end
    end
  end

  assign tick_count_o = tick_count_q;
  assign quiescent_o  = !tick_cur_o;

endmodule
