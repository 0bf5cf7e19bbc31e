// SPDX-License-Identifier: Apache-2.0
//
// Triangular carrier against three compare values (specification section 8).
//
//   carrier = phase <= 1562 ? phase : 3125 - phase;  on = carrier > CMP, one clock later
//   that is: on from phase CMP + 1 to phase 3124 - CMP, 3124 - 2 CMP clocks of 3125
//
// Compare values load at load_i, which comes at phase 0, where no switch is on. CMP = 0 still
// switches off for one clock of a period; CMP = 1562 never switches on.

module pwm
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic [11:0] phase_i,
    input logic        load_i,

    input logic enable_i,

    input cmp_t cmp_a_i,
    input cmp_t cmp_b_i,
    input cmp_t cmp_c_i,

    output logic [2:0] on_o,
    output gap_t       next_o,
    output logic       quiescent_o
);

  function automatic logic [11:0] rise(cmp_t cmp);
    return 12'(cmp) + 12'd1;
  endfunction

  function automatic logic [11:0] fall(cmp_t cmp);
    return 12'(PwmPeriod) - 12'(cmp);
  endfunction

  // Clocks to the phase whose edge switches; the end of the period is an event of the time base.
  function automatic gap_t gap(logic [11:0] phase, cmp_t cmp);
    if (phase < rise(cmp)) return rise(cmp) - phase;
    if (phase < fall(cmp)) return fall(cmp) - phase;
    return GapMax;
  endfunction

  function automatic gap_t least(gap_t x, gap_t y);
    return x < y ? x : y;
  endfunction

  cmp_t carrier;
  cmp_t cmp_a_q, cmp_b_q, cmp_c_q;
  logic [2:0] on_d, on_q;

  assign carrier = cmp_t'(phase_i <= 12'(CmpMax) ? phase_i : 12'(PwmPeriod) - phase_i);

  always_comb begin
    on_d = '0;
    if (enable_i) begin
      on_d = {carrier > cmp_c_q, carrier > cmp_b_q, carrier > cmp_a_q};
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      cmp_a_q <= CmpMax;
      cmp_b_q <= CmpMax;
      cmp_c_q <= CmpMax;
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
      next_o = least(gap(phase_i, cmp_a_q), least(gap(phase_i, cmp_b_q), gap(phase_i, cmp_c_q)));
    end
  end

  assign on_o        = on_q;
  assign quiescent_o = !load_i && on_d == on_q;

endmodule
