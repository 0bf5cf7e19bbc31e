// SPDX-License-Identifier: Apache-2.0
//
// Two outputs of 10 bits with direction, phase-correct: the pulse is centred in its period
// (Brochier 2006, C.8 and C.12, the pulse of 2 OCR counts around the bottom of the counter).
//
//   on for 2 C clocks of 2 Half, C = (|force| Scale + 512) >> 10;   1023 -> Half, 0 -> 0
//   the count falls from 2 Half to 1; on where Half - C < count <= Half + C, one clock later
//
// Force and direction are taken together as the count begins anew, where no pulse is on unless it
// is on for the whole period. -1024 acts as -1023. Half = 3472 clocks: 7200 Hz at 50 MHz. Scale is
// Half 1024 / 1023, so that 1023 gives Half.

module force_pwm
  import trammel_pkg::*;
  import step_pkg::*;
#(
    parameter int unsigned Half = 3472,
    parameter int unsigned Scale = 3475
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic signed [10:0] force_1_i,
    input logic signed [10:0] force_2_i,

    output logic [1:0] pwm_o,
    output logic [1:0] negative_o,
    output gap_t       next_o,
    output logic       quiescent_o
);

  localparam int unsigned Width = $clog2(2 * Half + 1);
  typedef logic [Width-1:0] count_t;
  localparam count_t Middle = count_t'(Half);
  localparam count_t Period = count_t'(2 * Half);

  count_t count;
  logic load;
  gap_t period_next;
  count_t on_q[2], on_d[2];
  logic [1:0] pwm_d, pwm_q, taken_q, negative_q;

  assign load = count <= count_t'(1);

  timer #(
      .Width(Width)
  ) u_period (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (load),
      .value_i(Period),
      .count_o(count),
      .next_o (period_next)
  );

  // Clocks of half the pulse.
  function automatic count_t half_pulse(logic signed [10:0] force_);
    logic [9:0] size;
    if (force_ == -11'sd1024) size = '1;
    else size = 10'(force_[10] ? -force_ : force_);
    return count_t'((times(32'(size), 16'(Scale)) + 32'd512) >> 10);
  endfunction

  assign on_d[0] = half_pulse(force_1_i);
  assign on_d[1] = half_pulse(force_2_i);

  always_comb begin
    for (int k = 0; k < 2; k++) begin
      pwm_d[k] = count > Middle - on_q[k] && count <= Middle + on_q[k];
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      pwm_q      <= '0;
      taken_q    <= '0;
      negative_q <= '0;
      for (int k = 0; k < 2; k++) on_q[k] <= '0;
    end else begin
      pwm_q      <= pwm_d;
      negative_q <= taken_q;
      if (load) begin
        taken_q <= {force_2_i[10], force_1_i[10]};
        for (int k = 0; k < 2; k++) on_q[k] <= on_d[k];
      end
    end
  end

  // Clocks to the count that switches; the end of the period is the timer's.
  function automatic gap_t switches(count_t count_now, count_t half);
    count_t far;
    far = '1;
    if (count_now > Middle + half) far = count_now - (Middle + half);
    else if (count_now > Middle - half) far = count_now - (Middle - half);
    return far >= count_t'(GapMax) ? GapMax - gap_t'(1) : gap_t'(far);
  endfunction

  always_comb begin
    next_o = period_next;
    for (int k = 0; k < 2; k++) begin
      if (switches(count, on_q[k]) < next_o) next_o = switches(count, on_q[k]);
    end
  end

  assign pwm_o       = pwm_q;
  assign negative_o  = negative_q;
  assign quiescent_o = !load && pwm_d == pwm_q && taken_q == negative_q;

endmodule
