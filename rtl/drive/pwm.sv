// SPDX-License-Identifier: Apache-2.0
//
// Triangular carrier against three compare values (specification section 8).
//
//   triangle = min(phase, rest), rest = period - phase;  on = triangle > CMP, one clock later
//   that is: on from phase CMP + 1 to phase period - 1 - CMP, period - 1 - 2 CMP clocks of a period
//
// Compare values load at load_i, which comes at phase 0, where no switch is on. CMP = 0 still
// switches off for one clock of a period; CMP = period / 2 never switches on.

module pwm
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input phase_t phase_i,
    input phase_t rest_i,  // of the period, with this clock
    input logic   load_i,

    input logic enable_i,

    input cmp_t cmp_a_i,
    input cmp_t cmp_b_i,
    input cmp_t cmp_c_i,

    output logic [2:0] on_o,
    output gap_t       next_o,
    output logic       quiescent_o
);

  // Clocks to the phase whose edge switches; the end of the period is an event of the time base.
  function automatic phase_t gap(phase_t phase, phase_t rest, cmp_t cmp);
    if (phase <= 13'(cmp)) return 13'(cmp) - phase + 13'd1;
    if (rest > 13'(cmp)) return rest - 13'(cmp);
    return '1;
  endfunction

  function automatic phase_t least(phase_t x, phase_t y);
    return x < y ? x : y;
  endfunction

  phase_t triangle, first;
  cmp_t cmp_a_q, cmp_b_q, cmp_c_q;
  logic [2:0] on_d, on_q;

  assign triangle = phase_i < rest_i ? phase_i : rest_i;

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
    first = least(gap(phase_i, rest_i, cmp_a_q),
                  least(gap(phase_i, rest_i, cmp_b_q), gap(phase_i, rest_i, cmp_c_q)));
    next_o = GapMax;
    if (enable_i && first != '1) begin
      next_o = first >= 13'(GapMax) ? GapMax - gap_t'(1) : gap_t'(first);
    end
  end

  assign on_o        = on_q;
  assign quiescent_o = !load_i && on_d == on_q;

endmodule
