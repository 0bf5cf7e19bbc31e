// SPDX-License-Identifier: Apache-2.0
//
// One axis of the stepper interface of Larson 1974, section II: rate, one's complement count, busy,
// limit latch and done event.
//
//   edge of the clock of 240 kHz, while steps are left: divider + 1; where it overflows, a step:
//   count + 1, divider := rate. So steps come at 240 kHz / (4096 - rate).
//   count = 177777, last pulse over, buffer not busy: busy := 0, done
//   switch in the direction of travel closed while busy: busy := 0, latch := 1, done
//
// At one edge the step comes first, then a write of the count, then one of the status word, in this
// order: rate, direction, enable stored; reset; start or stop. The pins pass two flip-flops.
// TickClk: clocks from tick to tick, at least. With Buffered = 0 buf_busy_i is not used.

module step_channel
  import trammel_pkg::*;
  import step_pkg::*;
#(
    parameter int unsigned TickClk = 208,
    parameter bit Buffered = 1'b1
) (
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,      // of step_clock, as the next four
    input logic half_i,
    input gap_t ticks_i,
    input gap_t next_tick_i,
    input gap_t next_half_i,

    input logic        count_write_i,
    input logic [15:0] count_i,
    input logic        status_write_i,
    input logic [15:0] status_i,
    input logic        grant_i,         // the interrupt is taken

    input logic limit_low_i,
    input logic limit_high_i,
    input logic buf_busy_i,    // pulses wait behind step_o

    output logic        step_o,      // half a period of 240 kHz
    output logic        forward_o,
    output logic        flush_o,     // the limit latch: waiting pulses are void
    output logic [15:0] count_o,
    output logic [15:0] status_o,
    output logic        irq_o,
    output gap_t        next_o,
    output logic        quiescent_o
);

  localparam logic [15:0] Terminal = '1;  // minus zero

  logic low_meta_q, low_q, high_meta_q, high_q, buf_meta_q, buf_q;
  logic [11:0] rate_d, rate_q, divider_d, divider_q;
  logic [15:0] count_d, count_q;
  logic forward_d, forward_q, enable_d, enable_q;
  logic busy_d, busy_q, latch_d, latch_q, done_d, done_q, step_d, step_q;
  logic moving, trip, over, ended;

  assign moving = busy_q && count_q != Terminal;
  assign trip   = busy_q && (forward_q ? high_q : low_q);
  assign over   = tick_i && moving && divider_q == '1;
  assign ended  = busy_q && !moving && !step_q && !buf_q;

  always_comb begin
    rate_d    = rate_q;
    forward_d = forward_q;
    enable_d  = enable_q;
    divider_d = divider_q;
    count_d   = count_q;
    busy_d    = busy_q;
    latch_d   = latch_q;
    done_d    = done_q && !grant_i;
    step_d    = step_q && !half_i;
    if (over) divider_d = rate_q;
    else if (moving) divider_d = divider_q + ticks_i;
    if (trip) begin
      busy_d  = 1'b0;
      latch_d = 1'b1;
      done_d  = 1'b1;
    end else if (over) begin
      count_d = count_q + 16'd1;
      step_d  = 1'b1;
    end else if (ended) begin
      busy_d = 1'b0;
      done_d = 1'b1;
    end
    if (count_write_i) count_d = count_i;
    if (status_write_i) begin
      rate_d    = status_i[11:0];
      forward_d = status_i[StatusForward];
      enable_d  = status_i[StatusEnable];
      if (status_i[StatusReset]) begin
        divider_d = '0;
        busy_d    = 1'b0;
        latch_d   = 1'b0;
        done_d    = 1'b0;
      end
      if (!status_i[StatusBusy]) begin
        busy_d = 1'b0;
      end else if (!busy_d && !latch_d) begin
        divider_d = status_i[11:0];
        busy_d    = count_d != Terminal;
        done_d    = count_d == Terminal;  // a start with nothing to do
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      rate_q    <= '0;
      divider_q <= '0;
      count_q   <= Terminal;
      forward_q <= 1'b0;
      enable_q  <= 1'b0;
      busy_q    <= 1'b0;
      latch_q   <= 1'b0;
      done_q    <= 1'b0;
      step_q    <= 1'b0;
    end else begin
      rate_q    <= rate_d;
      divider_q <= divider_d;
      count_q   <= count_d;
      forward_q <= forward_d;
      enable_q  <= enable_d;
      busy_q    <= busy_d;
      latch_q   <= latch_d;
      done_q    <= done_d;
      step_q    <= step_d;
    end
  end

  always_ff @(posedge clk_i) begin
    low_meta_q  <= limit_low_i;
    low_q       <= low_meta_q;
    high_meta_q <= limit_high_i;
    high_q      <= high_meta_q;
    buf_meta_q  <= Buffered && buf_busy_i;
    buf_q       <= buf_meta_q;
  end

  assign step_o    = step_q;
  assign forward_o = forward_q;
  assign flush_o   = latch_q;
  assign count_o   = count_q;
  assign status_o  = {enable_q, low_q || high_q, forward_q, busy_q, rate_q};
  assign irq_o     = done_q && enable_q;

  // Clocks before the overflow: those of whole periods are counted short.
  logic [31:0] to_step;
  assign to_step = times(32'd4095 - 32'(divider_q), 16'(TickClk)) + 32'(next_tick_i);

  always_comb begin
    next_o = GapMax;
    if (moving) next_o = to_step >= 32'(GapMax) ? GapMax - gap_t'(1) : gap_t'(to_step);
    if (step_q && next_half_i < next_o) next_o = next_half_i;
  end

  assign quiescent_o = !trip && !ended && !count_write_i && !status_write_i &&
      !(grant_i && done_q) && limit_low_i == low_meta_q && low_meta_q == low_q &&
      limit_high_i == high_meta_q && high_meta_q == high_q &&
      (Buffered && buf_busy_i) == buf_meta_q && buf_meta_q == buf_q;

endmodule
