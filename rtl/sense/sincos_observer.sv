// SPDX-License-Identifier: Apache-2.0
//
// Position and velocity from sine and cosine of a stripe sensor (Brochier 2006, 2.2.4 and C.14).
// A the cosine, B the sine; in each of four regions of the phase the steep one of both is used.
//
//   start     A and B once: the quarter in which (A, B) points is the phase
//   ask       region of the phase by four limits -> encoder; then its derivative
//   encoder   x = (code - 512) << 6 - ymid;  phase = ((c0 x + c1) x + c2) x + c3, products >> 14
//             position += shortest way from it to the phase, modulo a period
//   dot       not saturated: t = 8 (phase - phasemid); p = quartic of t, products >> 15
//             velocity = (p ((code - offset) << 5) >> 15) << (18 - exponent), bit 0 = 0
//             saturated: difference of phase times 32768 / ticks >> 15, << 9, bit 0 = 1; 0 where
//             the region changed (bit 0 = 0) or the ticks are not 1 to 16 (bit 0 = 1)
//
// Words of 16 bits wrap. An answer to ask_i comes at most 5 clocks later, an encoder's code is
// worked in 6, a derivative's in at most 11; codes and asks come while it rests.

module sincos_observer
  import sincos_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input logic restart_i,
    input logic active_i,
    input logic velocity_i,  // ask for derivatives
    input logic ask_i,

    input logic       sample_i,
    input logic [2:0] channel_i,
    input logic [9:0] code_i,

    output calib_addr_t calib_addr_o,
    input  calib_t      calib_i,       // at the same clock

    output logic               asked_o,
    output logic        [ 2:0] channel_o,
    output logic signed [31:0] position_o,
    output logic signed [22:0] velocity_o,
    output logic        [13:0] phase_o,
    output logic        [ 1:0] region_o,
    output logic               known_o,
    output logic               busy_o,
    output logic               quiescent_o
);

  typedef enum logic [4:0] {
    StRest,
    StOriginA,  // start: a - origin, then the quarter
    StOriginB,
    StLimit2,  // ask: limits, then the channel
    StLimit01,
    StLimit3,
    StChannel,
    StX,  // encoder
    StCubic,
    StPhase,
    StDotMin,  // derivative
    StDotMax,
    StT,
    StQuartic,
    StOffset,
    StRate,
    StShift,
    StTable,
    StNumeric
  } state_e;

  state_e state_d, state_q;
  calib_t x_d, x_q, p_d, p_q;
  logic [2:0] step_d, step_q;  // coefficients so far
  logic [9:0] code_d, code_q;
  logic encoder_d, encoder_q;  // of the code: 0 A, 1 B
  logic [13:0] phase_d, phase_q, last_phase_d, last_phase_q;
  logic [1:0] region_d, region_q, used_region_d, used_region_q;
  logic signed [31:0] position_d, position_q;
  logic signed [22:0] velocity_d, velocity_q;
  logic known_d, known_q, dot_next_d, dot_next_q, low_d, low_q;
  logic used_d, used_q, same;  // a sample was used; in the region of the present one
  logic invert_d, invert_q;
  logic [1:0] seen_d, seen_q;
  logic [9:0] start_code_q[2];
  logic [4:0] since_q;  // ticks since the last code of an encoder that was used, 31 at most
  logic [4:0] ticks_d, ticks_q;  // from the one before to it

  // ---- arithmetic ----

  logic signed [31:0] product;
  calib_t difference, sum14, sum15, rate;
  logic [13:0] target, step, way;
  logic signed [15:0] table_word;
  logic [21:0] numeric;  // above the bit of the source
  logic signed [7:0] shift;
  logic [22:0] shifted;

  assign product    = p_q * x_q;
  assign difference = 16'(signed'({6'd0, code_q})) - calib_i;
  assign sum14      = 16'(product >>> 14) + calib_i;
  assign sum15      = 16'(product >>> 15) + calib_i;
  assign rate       = 16'(product >>> 15);
  assign target     = calib_i[0] ? -p_q[13:0] : p_q[13:0];
  assign step       = target - position_q[13:0];
  assign way        = phase_q - last_phase_q;
  assign shift      = 8'sd18 - calib_i[7:0];
  assign numeric    = ticks_q == 5'd1 ? 22'({p_q, 8'd0}) : 22'({rate, 8'd0});

  always_comb begin
    if (shift > 8'sd0) shifted = shift > 8'sd22 ? '0 : 23'(signed'(p_q)) << shift[4:0];
    else shifted = 23'(23'(signed'(p_q)) >>> (shift < -8'sd15 ? 4'd15 : 4'(-shift)));
  end

  always_comb begin  // 32768 / ticks, rounded half up; that of 1 is handled apart
    unique case (ticks_q)
      5'd2: table_word = 16'sd16384;
      5'd3: table_word = 16'sd10923;
      5'd4: table_word = 16'sd8192;
      5'd5: table_word = 16'sd6554;
      5'd6: table_word = 16'sd5461;
      5'd7: table_word = 16'sd4681;
      5'd8: table_word = 16'sd4096;
      5'd9: table_word = 16'sd3641;
      5'd10: table_word = 16'sd3277;
      5'd11: table_word = 16'sd2979;
      5'd12: table_word = 16'sd2731;
      5'd13: table_word = 16'sd2521;
      5'd14: table_word = 16'sd2341;
      5'd15: table_word = 16'sd2185;
      5'd16: table_word = 16'sd2048;
      default: table_word = '0;
    endcase
  end

  // With the limits sorted: up to r0 0, up to r1 1, below r2 2, below r3 3, else 0.
  logic signed [15:0] angle;
  assign angle = 16'(signed'({2'd0, phase_q}));

  function automatic logic [22:0] turned(logic [22:0] value, logic invert);
    return invert ? -value : value;
  endfunction

  // The quarter of (a, b): the one of the larger magnitude, by its sign.
  logic signed [15:0] b;
  logic [15:0] size_a, size_b;
  logic [1:0] quarter;
  assign b      = 16'(signed'({6'd0, start_code_q[1]})) - calib_i;
  assign size_a = x_q[15] ? -x_q : x_q;
  assign size_b = b[15] ? -b : b;
  always_comb begin
    // As words of 16 bits: of the most negative one the magnitude is negative.
    if (signed'(size_a) >= signed'(size_b)) quarter = x_q > 16'sd0 ? 2'd0 : 2'd2;
    else quarter = b > 16'sd0 ? 2'd1 : 2'd3;
  end

  // ---- steps ----

  logic uses, uses_dot, starts;

  assign uses     = sample_i && active_i && !channel_i[2] && known_q && channel_i[1] != region_q[0];
  assign same     = used_q && used_region_q == region_q;
  assign uses_dot = uses && channel_i[0];
  assign starts   = sample_i && active_i && !channel_i[2] && !channel_i[0] && !known_q;

  always_comb begin
    state_d       = state_q;
    x_d           = x_q;
    p_d           = p_q;
    step_d        = step_q;
    code_d        = code_q;
    encoder_d     = encoder_q;
    phase_d       = phase_q;
    last_phase_d  = last_phase_q;
    region_d      = region_q;
    used_region_d = used_region_q;
    position_d    = position_q;
    velocity_d    = velocity_q;
    known_d       = known_q;
    dot_next_d    = dot_next_q;
    low_d         = low_q;
    used_d        = used_q;
    invert_d      = invert_q;
    seen_d        = seen_q;
    ticks_d       = ticks_q;
    calib_addr_o  = CalibFlags;
    asked_o       = 1'b0;
    channel_o     = {1'b0, !region_q[0], 1'b0};
    unique case (state_q)
      StRest: begin
        if (sample_i) begin
          code_d    = code_i;
          encoder_d = channel_i[1];
        end
        if (starts) begin
          seen_d[channel_i[1]] = 1'b1;
          if (seen_d == '1) state_d = StOriginA;
        end else if (uses) begin
          state_d = uses_dot ? StDotMin : StX;
        end else if (ask_i && !known_q) begin
          asked_o   = 1'b1;
          channel_o = {1'b0, seen_q[0], 1'b0};
        end else if (ask_i && dot_next_q) begin
          asked_o    = 1'b1;
          channel_o  = {1'b0, !region_q[0], 1'b1};
          dot_next_d = 1'b0;
        end else if (ask_i) begin
          state_d = StLimit2;
        end
      end
      StOriginA: begin
        calib_addr_o = CalibOrigin;
        x_d          = 16'(signed'({6'd0, start_code_q[0]})) - calib_i;
        state_d      = StOriginB;
      end
      StOriginB: begin
        calib_addr_o = CalibOrigin + 6'd1;
        phase_d      = {quarter, 12'd0};
        known_d      = 1'b1;
        state_d      = StRest;
      end
      StLimit2: begin
        calib_addr_o = CalibRegion + 6'd2;
        step_d       = 3'd1;
        region_d     = 2'd2;
        state_d      = angle < calib_i ? StLimit01 : StLimit3;
      end
      StLimit01: begin  // r1, then r0
        calib_addr_o = CalibRegion + 6'(step_q);
        step_d       = '0;
        if (angle > calib_i) state_d = StChannel;
        else region_d = 2'(step_q);
        if (step_q == '0) state_d = StChannel;
      end
      StLimit3: begin
        calib_addr_o = CalibRegion + 6'd3;
        region_d     = angle < calib_i ? 2'd3 : 2'd0;
        state_d      = StChannel;
      end
      StChannel: begin
        asked_o    = 1'b1;
        dot_next_d = velocity_i;
        state_d    = StRest;
      end
      StX: begin
        calib_addr_o = CalibYmid + 6'(region_q);
        x_d          = {code_q ^ 10'h200, 6'd0} - calib_i;
        step_d       = '0;
        state_d      = StCubic;
      end
      StCubic: begin
        calib_addr_o = CalibPoly + {2'd0, region_q, 2'd0} + 6'(step_q);
        p_d          = step_q == '0 ? calib_i : sum14;
        step_d       = step_q + 3'd1;
        if (step_q == 3'd3) state_d = StPhase;
      end
      StPhase: begin
        calib_addr_o  = CalibFlags;
        invert_d      = calib_i[0];
        last_phase_d  = phase_q;
        phase_d       = p_q[13:0];
        position_d    = position_q + 32'(signed'(step));
        ticks_d       = since_q;
        used_d        = 1'b1;
        used_region_d = region_q;
        state_d       = StRest;
      end
      StDotMin: begin
        calib_addr_o = CalibDotMin + 6'(encoder_q);
        low_d        = 16'(signed'({6'd0, code_q})) < calib_i;
        state_d      = StDotMax;
      end
      StDotMax: begin
        calib_addr_o = CalibDotMax + 6'(encoder_q);
        state_d      = StT;
        if (low_q || 16'(signed'({6'd0, code_q})) > calib_i) begin
          state_d = StTable;
          if (!same) begin
            velocity_d = '0;
            state_d    = StRest;
          end
        end
      end
      StT: begin
        calib_addr_o = CalibPhasemid + 6'(region_q);
        x_d          = (angle - calib_i) <<< 3;
        step_d       = '0;
        state_d      = StQuartic;
      end
      StQuartic: begin
        calib_addr_o = CalibDotPoly + {2'd0, region_q, 2'd0} + 6'(region_q) + 6'(step_q);
        p_d          = step_q == '0 ? calib_i : sum15;
        step_d       = step_q + 3'd1;
        if (step_q == 3'd4) state_d = StOffset;
      end
      StOffset: begin
        calib_addr_o = CalibDotOffset + 6'(encoder_q);
        x_d          = difference <<< 5;
        state_d      = StRate;
      end
      StRate: begin
        p_d     = rate;
        state_d = StShift;
      end
      StShift: begin
        calib_addr_o = CalibExponent;
        velocity_d   = turned(shifted & ~23'd1, invert_q);
        state_d      = StRest;
      end
      StTable: begin
        x_d     = table_word;
        p_d     = 16'(signed'(way));
        state_d = StNumeric;
      end
      default: begin  // StNumeric
        velocity_d = turned({numeric, 1'b1}, invert_q);
        state_d    = StRest;
      end
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (rst_i || restart_i) begin
      state_q       <= StRest;
      x_q           <= '0;
      p_q           <= '0;
      step_q        <= '0;
      code_q        <= '0;
      encoder_q     <= 1'b0;
      phase_q       <= '0;
      last_phase_q  <= '0;
      region_q      <= '0;
      used_region_q <= '0;
      position_q    <= '0;
      velocity_q    <= '0;
      known_q       <= 1'b0;
      dot_next_q    <= 1'b0;
      low_q         <= 1'b0;
      used_q        <= 1'b0;
      invert_q      <= 1'b0;
      seen_q        <= '0;
      ticks_q       <= '0;
      since_q       <= '1;
      for (int k = 0; k < 2; k++) start_code_q[k] <= '0;
    end else begin
      state_q       <= state_d;
      x_q           <= x_d;
      p_q           <= p_d;
      step_q        <= step_d;
      code_q        <= code_d;
      encoder_q     <= encoder_d;
      phase_q       <= phase_d;
      last_phase_q  <= last_phase_d;
      region_q      <= region_d;
      used_region_q <= used_region_d;
      position_q    <= position_d;
      velocity_q    <= velocity_d;
      known_q       <= known_d;
      dot_next_q    <= dot_next_d;
      low_q         <= low_d;
      used_q        <= used_d;
      invert_q      <= invert_d;
      seen_q        <= seen_d;
      ticks_q       <= ticks_d;
      if (state_q == StPhase) since_q <= 5'(tick_i);
      else if (tick_i && since_q != '1) since_q <= since_q + 5'd1;
      for (int k = 0; k < 2; k++) begin
        if (state_q == StRest && starts && channel_i[1] == 1'(k)) start_code_q[k] <= code_i;
      end
    end
  end

  assign position_o  = position_q;
  assign velocity_o  = velocity_q;
  assign phase_o     = phase_q;
  assign region_o    = used_region_q;
  assign known_o     = known_q;
  assign busy_o      = state_q != StRest;
  assign quiescent_o = !busy_o && !ask_i && !sample_i && !tick_i && !restart_i;

endmodule
