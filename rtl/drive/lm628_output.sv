// SPDX-License-Identifier: Apache-2.0
//
// Outputs of the LM628 and LM629 (data sheet SNVS781C) for a command u of 16 bits, signed:
//
//   8 bits   dac = u / 256 + 80h from the edge of commit_i on
//   12 bits  u / 16 + 800h on dac[7:2]: its low six bits with dac_hi_lo_o low, its high six with
//            it high, 16 ticks apart; dac_wr_n_o is low for the first 8 of each and strobes at
//            its rise
//   LM629    sign, and magnitude m = min(|u / 256|, 127) as 4 m of 512 ticks, from commit_i on
//
// A reset puts out 800h with its strobes, and then 80h. A tick is 25 / Inc clocks.

module lm628_output
  import trammel_pkg::*;
  import lm628_pkg::*;
#(
    parameter int unsigned Inc = 4
) (
    input logic clk_i,       // of the timers; gated for the other registers
    input logic clock_en_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic commit_i,

    input logic eight_bits_i,

    input logic [11:0] u_i,  // upper bits of the command

    output logic [7:0] dac_o,
    output logic       dac_hi_lo_o,
    output logic       dac_wr_n_o,
    output logic       pwm_mag_o,
    output logic       pwm_sign_o,
    output gap_t       next_o,
    output logic       quiescent_o
);

  logic clk_gated;
  assign clk_gated = clk_i & clock_en_i;

  localparam logic [ 6:0] Strobe = 7'(lm628_clocks(Inc, 8) - 1);
  localparam logic [12:0] Period = 13'(lm628_clocks(Inc, 512) - 1);

  typedef enum logic [2:0] {
    StStart,
    StLowWrite,
    StLowHold,
    StHighWrite,
    StIdle
  } state_e;

  state_e state_d, state_q;
  logic [11:0] u_q;  // two's complement; offset binary inverts its top bit
  logic [7:0] top;  // upper bits of the command in use from the next edge on
  logic eight_q;

  assign top = commit_i ? u_i[11:4] : u_q[11:4];

  always_ff @(posedge clk_gated) begin
    if (rst_i) begin
      state_q <= StStart;
      u_q     <= '0;
      eight_q <= 1'b0;
    end else begin
      state_q <= state_d;
      if (commit_i) begin
        u_q     <= u_i;
        eight_q <= eight_bits_i;
      end
    end
  end

  // ---- converter ----

  logic [6:0] strobe;
  logic strobe_last, strobe_load, low;
  gap_t strobe_next;

  timer #(
      .Width(7)
  ) u_strobe (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (strobe_load),
      .value_i(Strobe),
      .count_o(strobe),
      .next_o (strobe_next)
  );

  assign strobe_last = strobe == '0;
  assign strobe_load = state_d != StIdle && (commit_i || strobe_last);

  always_comb begin
    state_d = state_q;
    if (commit_i) begin
      state_d = eight_bits_i ? StIdle : StLowWrite;
    end else if (strobe_last) begin
      unique case (state_q)
        StStart:    state_d = StLowWrite;
        StLowWrite: state_d = StLowHold;
        StLowHold:  state_d = StHighWrite;
        default:    state_d = StIdle;
      endcase
    end
  end

  assign low = state_q == StLowWrite || state_q == StLowHold;

  always_comb begin
    dac_o = {~u_q[11], u_q[10:6], eight_q ? u_q[5:4] : 2'b00};
    if (low) dac_o = {u_q[5:0], 2'b00};
  end

  assign dac_hi_lo_o = !low;
  assign dac_wr_n_o  = state_q != StLowWrite && state_q != StHighWrite;

  // ---- pulse width ----

  logic [12:0] period, high, high_value;
  logic [6:0] m;
  logic begins;
  gap_t period_next, high_next;

  timer #(
      .Width(13)
  ) u_period (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (begins),
      .value_i(Period),
      .count_o(period),
      .next_o (period_next)
  );

  timer #(
      .Width(13)
  ) u_high (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (begins),
      .value_i(high_value),
      .count_o(high),
      .next_o (high_next)
  );

  assign begins = commit_i || period == '0;

  always_comb begin
    m = top[6:0];
    if (top[7]) m = top[6:0] == '0 ? 7'd127 : ~top[6:0] + 7'd1;
  end

  // 100 m / Inc clocks by shifts and sums; a third of m is 43 m / 128 for all m.
  if (Inc == 3) begin : gen_thirds
    assign high_value = (13'(m) << 5) + 13'(m) +
        (((13'(m) << 5) + (13'(m) << 3) + (13'(m) << 1) + 13'(m)) >> 7);
  end else if (Inc == 4) begin : gen_quarters
    assign high_value = (13'(m) << 4) + (13'(m) << 3) + 13'(m);
  end else if (Inc == 10) begin : gen_tenths
    assign high_value = (13'(m) << 3) + (13'(m) << 1);
  end else begin : gen_refused
    $error("lm628_output: Inc is 3, 4 or 10");
  end

  assign pwm_mag_o  = high != '0;
  assign pwm_sign_o = u_q[11];

  always_comb begin
    next_o = strobe_next;
    if (period_next < next_o) next_o = period_next;
    if (high_next < next_o) next_o = high_next;
  end

  assign quiescent_o = !begins && (state_q == StIdle || !strobe_last);

endmodule
