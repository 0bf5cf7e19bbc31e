// SPDX-License-Identifier: Apache-2.0
//
// Triangular carrier against three compare values (specification section 8).
//
//   triangle = phase <= period / 2 ? phase : period - phase;  on = triangle > CMP, one clock later
//   that is: on from phase CMP + 1 to phase period - 1 - CMP, period - 1 - 2 CMP clocks of a period
//
// Compare values load at load_i, which comes at phase 0, where no switch is on. CMP = 0 still
// switches off for one clock of a period; CMP = period / 2 never switches on.

module pwm
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input carrier_t carrier_i,
    input phase_t   phase_i,
    input logic     load_i,

    input logic enable_i,

    input cmp_t cmp_a_i,
    input cmp_t cmp_b_i,
    input cmp_t cmp_c_i,

    output logic [2:0] on_o,
    output gap_t       next_o,
    output logic       quiescent_o
);

  phase_t period;
  assign period = pwm_period(carrier_i);

  // Clocks as a gap that is not "none".
  function automatic gap_t clipped(phase_t clocks);
    return clocks >= 13'(GapMax) ? GapMax - gap_t'(1) : gap_t'(clocks);
  endfunction

  // Clocks to the phase whose edge switches; the end of the period is an event of the time base.
  function automatic gap_t gap(phase_t whole, phase_t phase, cmp_t cmp);
    phase_t rise, fall;
    rise = 13'(cmp) + 13'd1;
    fall = whole - 13'(cmp);
    if (phase < rise) return clipped(rise - phase);
    if (phase < fall) return clipped(fall - phase);
    return GapMax;
  endfunction

  function automatic gap_t least(gap_t x, gap_t y);
    return x < y ? x : y;
  endfunction

  phase_t triangle;
  cmp_t cmp_a_q, cmp_b_q, cmp_c_q;
  logic [2:0] on_d, on_q;

  assign triangle = phase_i <= period >> 1 ? phase_i : period - phase_i;

  always_comb begin
    on_d = '0;
    if (enable_i) begin
      on_d = {triangle > 13'(cmp_c_q), triangle > 13'(cmp_b_q), triangle > 13'(cmp_a_q)};
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      cmp_a_q <= '1;
      cmp_b_q <= '1;
      cmp_c_q <= '1;
      on_q    <= '0;
    end else begin
      on_q <= on_d;
      if (load_i) begin
        cmp_a_q <= cmp_a_i;
        cmp_b_q <= cmp_b_i;
        cmp_c_q <= cmp_c_i;
      end
    end
  end

  always_comb begin
    next_o = GapMax;
    if (enable_i) begin
      next_o = least(gap(period, phase_i, cmp_a_q),
                     least(gap(period, phase_i, cmp_b_q), gap(period, phase_i, cmp_c_q)));
    end
  end

  assign on_o        = on_q;
  assign quiescent_o = !load_i && on_d == on_q;

endmodule
