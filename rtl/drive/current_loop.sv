// SPDX-License-Identifier: Apache-2.0
//
// Vector control of the current of one axis (specification section 7): a chain of flow blocks.
// valid_o is high at the 68th clock edge after the one that sees tick_i; inputs hold until then.
//
//   edges      what
//   0..19      angle: count ANGLE_STEP mod 2^32, a Booth digit of the count per clock; + offset
//   19..20     Clarke
//   21..24     sine, cosine
//   25..29     Park
//   30..34     PI of d and q
//   35..36     vector limit
//   37..41     inverse Park
//   42..66     space vector modulation
//   67         compare values of the next period; valid
//
// While clear_i is high the integrators are 0 and the duty is 50 %; currents are still measured.

module current_loop
  import trammel_pkg::*;
  import math_pkg::*;
#(
  parameter int unsigned ClockHz = 50_000_000
) (
  input  logic        clk_i,
  input  current_loop_pkg::domains_t clock_en_i,
  input  logic        rst_i,

  input  logic        tick_i,  // converter data are valid

  input  logic        clear_i,
  input  carrier_t    carrier_i,
  input  logic [31:0] angle_step_i,  // of a count [2^-32 revolution]
  input  logic [31:0] theta_ofs_i,
  input  gain_t       kp_i,
  input  gain_t       ki_i,

  input  logic [11:0] code_a_i,
  input  logic [11:0] code_b_i,
  input  word_t       offset_a_i,
  input  word_t       offset_b_i,
  input  count_t      count_i,
  input  word_t       i_q_ref_i,
  input  word_t       i_d_ref_i,

  output logic        busy_o,
  output logic        valid_o,
  output cmp_t        cmp_a_o,
  output cmp_t        cmp_b_o,
  output cmp_t        cmp_c_o,
  output word_t       i_a_o,
  output word_t       i_b_o,
  output word_t       i_d_o,
  output word_t       i_q_o,
  output word_t       v_d_o,
  output word_t       v_q_o,
  output logic        limited_o,
  output current_loop_pkg::domains_t awake_o,
  output logic        quiescent_o
);

  logic clk_angle, clk_rotate, clk_pi, clk_svpwm;
  assign clk_angle  = clk_i & clock_en_i.angle;
  assign clk_rotate = clk_i & clock_en_i.rotate;
  assign clk_pi     = clk_i & clock_en_i.pi;
  assign clk_svpwm  = clk_i & clock_en_i.svpwm;

  typedef logic [31:0] theta_t;
  typedef enum logic [1:0] {StIdle, StAngle, StChain} state_e;

  localparam logic [4:0] FirstDigit = 5'd18;  // of 19; those of a count are the last 12
  localparam periods_t   Periods = pwm_periods(ClockHz);
  localparam cmp_t       Centre16kHz = cmp_max(Periods[Carrier16kHz]) >> 1;

  cmp_t centre;
  assign centre = cmp_max(Periods[carrier_i]) >> 1;

  state_e     state_d, state_q;
  logic       valid_q;
  logic [4:0] digit_d, digit_q;
  theta_t     theta_d, theta_q;
  word_t      i_a_d, i_a_q;
  word_t      i_b_d, i_b_q;
  cmp_t       cmp_a_d, cmp_a_q;
  cmp_t       cmp_b_d, cmp_b_q;
  cmp_t       cmp_c_d, cmp_c_q;

  logic  clarke_valid, sine_valid, park_valid, pi_d_valid, pi_q_valid;
  logic  limit_valid, inverse_valid, svpwm_valid;
  logic  clarke_quiescent, sine_quiescent, park_quiescent, pi_d_quiescent, pi_q_quiescent;
  logic  limit_quiescent, inverse_quiescent, svpwm_quiescent;
  word_t i_alpha, i_beta, sin, cos, v_d, v_q, v_alpha, v_beta;
  cmp_t  cmp_a, cmp_b, cmp_c;
  logic  clarke_tick;
  angle_t angle;
  logic [2:0] unused_sector;

  // theta_q: the product by Horner's rule, from the highest digit of the count on. Digits are those
  // of Booth's radix 4, -2 to 2: three bits of the count, that of its lowest digit with a 0 below.
  logic [38:0] count_bits;
  logic [2:0]  booth;
  theta_t      addend;
  logic        subtract;
  assign count_bits = {{14{count_i[23]}}, count_i, 1'b0};
  assign booth = 3'(count_bits >> {digit_q, 1'b0});
  assign subtract = booth[2] && booth != 3'b111;
  always_comb begin
    unique case (booth)
      3'b000, 3'b111: addend = '0;
      3'b011, 3'b100: addend = {angle_step_i[30:0], 1'b0};
      default:        addend = angle_step_i;
    endcase
  end

  // Offset binary less the offset of the sensor.
  function automatic word_t current(logic [11:0] code, word_t offset);
    return sat12(acc_t'($signed({~code[11], code[10:0]})) - acc_t'(offset));
  endfunction

  assign angle = 10'((theta_q + theta_ofs_i) >> 22);

  always_comb begin
    state_d = state_q;
    digit_d = digit_q;
    theta_d = theta_q;
    i_a_d = i_a_q;
    i_b_d = i_b_q;
    clarke_tick = 1'b0;
    unique case (state_q)
      StIdle: begin
        if (tick_i) begin
          theta_d = '0;
          digit_d = FirstDigit;
          i_a_d = current(code_a_i, offset_a_i);
          i_b_d = current(code_b_i, offset_b_i);
          state_d = StAngle;
        end
      end
      StAngle: begin
        theta_d = {theta_q[29:0], 2'b00} + (addend ^ {32{subtract}}) + theta_t'(subtract);
        digit_d = digit_q - 5'd1;
        if (digit_q == '0) begin
          digit_d = '0;
          clarke_tick = 1'b1;
          state_d = StChain;
        end
      end
      default: begin  // StChain: each block starts the next one
        if (svpwm_valid) state_d = StIdle;
      end
    endcase
  end

  always_comb begin
    cmp_a_d = cmp_a_q;
    cmp_b_d = cmp_b_q;
    cmp_c_d = cmp_c_q;
    if (svpwm_valid) begin
      cmp_a_d = cmp_a;
      cmp_b_d = cmp_b;
      cmp_c_d = cmp_c;
    end
    if (clear_i) begin
      cmp_a_d = centre;
      cmp_b_d = centre;
      cmp_c_d = centre;
    end
  end

  clarke u_clarke (
    .clk_i      (clk_angle),
    .rst_i      (rst_i),
    .tick_i     (clarke_tick),
    .i_a_i      (i_a_q),
    .i_b_i      (i_b_q),
    .valid_o    (clarke_valid),
    .i_alpha_o  (i_alpha),
    .i_beta_o   (i_beta),
    .quiescent_o(clarke_quiescent)
  );

  sine u_sine (
    .clk_i      (clk_rotate),
    .rst_i      (rst_i),
    .tick_i     (clarke_valid),
    .angle_i    (angle),
    .valid_o    (sine_valid),
    .sin_o      (sin),
    .cos_o      (cos),
    .quiescent_o(sine_quiescent)
  );

  rotator #(
    .Inverse(1'b0)
  ) u_park (
    .clk_i      (clk_rotate),
    .rst_i      (rst_i),
    .tick_i     (sine_valid),
    .x_i        (i_alpha),
    .y_i        (i_beta),
    .sin_i      (sin),
    .cos_i      (cos),
    .valid_o    (park_valid),
    .x_o        (i_d_o),
    .y_o        (i_q_o),
    .quiescent_o(park_quiescent)
  );

  current_pi u_pi_d (
    .clk_i      (clk_pi),
    .rst_i      (rst_i),
    .tick_i     (park_valid),
    .clear_i    (clear_i),
    .ref_i      (i_d_ref_i),
    .meas_i     (i_d_o),
    .kp_i       (kp_i),
    .ki_i       (ki_i),
    .valid_o    (pi_d_valid),
    .v_o        (v_d),
    .quiescent_o(pi_d_quiescent)
  );

  current_pi u_pi_q (
    .clk_i      (clk_pi),
    .rst_i      (rst_i),
    .tick_i     (park_valid),
    .clear_i    (clear_i),
    .ref_i      (i_q_ref_i),
    .meas_i     (i_q_o),
    .kp_i       (kp_i),
    .ki_i       (ki_i),
    .valid_o    (pi_q_valid),
    .v_o        (v_q),
    .quiescent_o(pi_q_quiescent)
  );

  vector_limit u_vector_limit (
    .clk_i      (clk_pi),
    .rst_i      (rst_i),
    .tick_i     (pi_d_valid && pi_q_valid),
    .v_d_i      (v_d),
    .v_q_i      (v_q),
    .valid_o    (limit_valid),
    .v_d_o      (v_d_o),
    .v_q_o      (v_q_o),
    .limited_o  (limited_o),
    .quiescent_o(limit_quiescent)
  );

  rotator #(
    .Inverse(1'b1)
  ) u_inverse_park (
    .clk_i      (clk_svpwm),
    .rst_i      (rst_i),
    .tick_i     (limit_valid),
    .x_i        (v_d_o),
    .y_i        (v_q_o),
    .sin_i      (sin),
    .cos_i      (cos),
    .valid_o    (inverse_valid),
    .x_o        (v_alpha),
    .y_o        (v_beta),
    .quiescent_o(inverse_quiescent)
  );

  svpwm #(
    .ClockHz(ClockHz)
  ) u_svpwm (
    .clk_i      (clk_svpwm),
    .rst_i      (rst_i),
    .tick_i     (inverse_valid),
    .carrier_i  (carrier_i),
    .v_alpha_i  (v_alpha),
    .v_beta_i   (v_beta),
    .valid_o    (svpwm_valid),
    .cmp_a_o    (cmp_a),
    .cmp_b_o    (cmp_b),
    .cmp_c_o    (cmp_c),
    .sector_o   (unused_sector),
    .quiescent_o(svpwm_quiescent)
  );

  always_ff @(posedge clk_angle) begin
    if (rst_i) begin
      state_q <= StIdle;
      valid_q <= 1'b0;
      digit_q <= '0;
      theta_q <= '0;
      i_a_q <= '0;
      i_b_q <= '0;
      cmp_a_q <= Centre16kHz;
      cmp_b_q <= Centre16kHz;
      cmp_c_q <= Centre16kHz;
    end else begin
      state_q <= state_d;
      valid_q <= svpwm_valid;
      digit_q <= digit_d;
      theta_q <= theta_d;
      i_a_q <= i_a_d;
      i_b_q <= i_b_d;
      cmp_a_q <= cmp_a_d;
      cmp_b_q <= cmp_b_d;
      cmp_c_q <= cmp_c_d;
    end
  end

  assign busy_o = state_q != StIdle;
  assign valid_o = valid_q;
  assign cmp_a_o = cmp_a_q;
  assign cmp_b_o = cmp_b_q;
  assign cmp_c_o = cmp_c_q;
  assign i_a_o = i_a_q;
  assign i_b_o = i_b_q;
  // In StChain this block waits for the modulation.
  assign awake_o.angle = state_q == StAngle || tick_i || svpwm_valid || valid_q ||
                         !clarke_quiescent ||
                         (clear_i && (cmp_a_q != centre || cmp_b_q != centre ||
                                      cmp_c_q != centre));
  assign awake_o.rotate = !sine_quiescent || !park_quiescent;
  assign awake_o.pi     = !pi_d_quiescent || !pi_q_quiescent || !limit_quiescent;
  assign awake_o.svpwm  = !inverse_quiescent || !svpwm_quiescent;
  assign quiescent_o    = awake_o == '0;

endmodule
