// SPDX-License-Identifier: Apache-2.0
//
// The one phase counter of the chip and its ticks (specification section 1).
//
//   tick_cur  8, 16, 20, 40 kHz  every period of the carrier, phase 0
//   tick_pos  1, 2, 4 kHz        the first tick_cur after reset, then every n-th
//   tick_irq                     every irq_period-th tick_pos, starting with the first after reset
//
// Another carrier counts from the next tick_cur on, another n from the next tick_pos on. A tick is
// high in the clock before the edge that acts on it. The timer is 0 at phase 0, so that
// the tick, the reload and the event of the timer are one and the same edge.

module timebase
  import trammel_pkg::*;
#(
    parameter int unsigned ClockHz = 50_000_000
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input carrier_t   carrier_i,
    input logic [1:0] rate_i,       // of tick_pos: 0 1 kHz, 1 2 kHz, others 4 kHz
    input logic [7:0] irq_period_i,

    output carrier_t    carrier_o,     // of this period
    output phase_t      phase_o,
    output phase_t      rest_o,        // clocks to the end of the period
    output logic        tick_cur_o,
    output logic        tick_pos_o,
    output logic        tick_irq_o,
    output logic [31:0] tick_count_o,
    output gap_t        next_o,
    output logic        quiescent_o
);

  if (!makes_carriers(ClockHz)) begin : gen_refused
    $error("timebase: its carriers need ClockHz to be a multiple of 80,000, 8 to 55.36 MHz");
  end

  localparam periods_t Periods = pwm_periods(ClockHz);

  phase_t count, period;
  carrier_t carrier_q;
  logic [5:0] in_ms;  // tick_cur of that carrier
  logic [5:0] cur_d, cur_q;
  logic [7:0] irq_d, irq_q;
  logic [31:0] tick_count_q;

  timer #(
      .Width(13)
  ) u_phase (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (tick_cur_o),
      .value_i(Periods[carrier_i] - 13'd1),
      .count_o(count),
      .next_o (next_o)
  );

  assign period     = Periods[carrier_q];
  assign phase_o    = tick_cur_o ? 13'd0 : period - count;
  assign rest_o     = tick_cur_o ? period : count;
  assign tick_cur_o = count == 13'd0;
  assign tick_pos_o = tick_cur_o && cur_q == 6'd0;
  assign tick_irq_o = tick_pos_o && irq_q == 8'd0;

  assign carrier_o  = carrier_q;

  // Ticks to come until the next tick_pos.
  always_comb begin
    unique case (carrier_i)
      Carrier8kHz:  in_ms = 6'd8;
      Carrier20kHz: in_ms = 6'd20;
      Carrier40kHz: in_ms = 6'd40;
      default:      in_ms = 6'd16;
    endcase
    cur_d = cur_q - 6'd1;
    if (tick_pos_o) begin
      unique case (rate_i)
        2'd0:    cur_d = in_ms - 6'd1;
        2'd1:    cur_d = (in_ms >> 1) - 6'd1;
        default: cur_d = (in_ms >> 2) - 6'd1;
      endcase
    end
  end

  // A new period counts from the next interrupt on.
  always_comb begin
    irq_d = irq_q - 8'd1;
    if (tick_irq_o) irq_d = irq_period_i == 8'd0 ? 8'd0 : irq_period_i - 8'd1;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      carrier_q    <= Carrier16kHz;
      cur_q        <= '0;
      irq_q        <= '0;
      tick_count_q <= '0;
    end else begin
      if (tick_cur_o) begin
        carrier_q <= carrier_i;
        cur_q     <= cur_d;
      end
      if (tick_pos_o) begin
        irq_q        <= irq_d;
        tick_count_q <= tick_count_q + 32'd1;
      end
    end
  end

  assign tick_count_o = tick_count_q;
  assign quiescent_o  = !tick_cur_o;

endmodule
