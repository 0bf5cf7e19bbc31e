// SPDX-License-Identifier: Apache-2.0
//
// Properties of afc for any input: its schedule, its rules and its words. The product is a free
// value, and the table is proven in its block; what needs a product of true size says so (fits_q).

module afc_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic start_i,

    input logic       adapt_i,
    input logic [5:0] rule_addr_i,
    input logic       rule_we_i,

    input logic       busy_o,
    input logic       done_o,
    input logic       overrun_o,
    input logic [6:0] step_o,
    input logic       iq_valid_o,

    input model_t x_m_o,
    input count_t x_r_o,
    input count_t dx_o,
    input word_t  e_o,
    input word_t  de_o,
    input word_t  u_o,
    input word_t  v_star_o,
    input word_t  v_o,
    input word_t  i_q_ref_o,
    input logic   saturated_o,
    input logic   table_busy_o,
    input logic   quiescent_o,

    input logic       running_q,
    input logic       running_d,
    input logic       phase_q,
    input logic [5:0] step_q,
    input logic       waiting_q,
    input logic       waiting_d,
    input logic       asked_q,
    input logic       asked_d,
    input logic       resetting_q,
    input logic       done_d,
    input logic       iq_valid_d,

    input count_t x_p_q,
    input count_t x_p_prev_q,
    input word_t  e_prev_q,
    input logic signed [13:0] scaled_q,

    input logic    [2:0] col_q,
    input logic    [2:0] row_q,
    input member_t       mu_a0_q,
    input member_t       mu_a1_q,
    input member_t       mu_b0_q,
    input member_t       mu_b1_q,

    input count_t             rule,
    input count_t             rules_q[64],
    input logic               filling,
    input logic               tune_we,
    input logic        [ 1:0] rule_sel,
    input logic signed [47:0] product_q,
    input logic        [ 2:0] place_low,
    input logic        [ 2:0] place_q,
    input logic               mul_used,
    input logic signed [39:0] shifted,
    input logic signed [39:0] acc_q,
    input logic signed [39:0] add_a_q,
    input logic signed [39:0] add_b_q,
    input logic               carry_q,
    input logic signed [39:0] sum
);

  typedef logic signed [41:0] exact_t;

  localparam logic [6:0] Clocks = 7'd70;

  // ---- schedule: clocks of the sample still to come ----

  logic live_q = 1'b0;
  logic [6:0] left_q, was_left_q;
  logic wait_q, go;

  assign go = left_q == '0 && !table_busy_o && (start_i || wait_q);

  function automatic logic ends(logic [6:0] left, logic [6:0] step);
    return left == Clocks - 7'd1 - 7'(step << 1);
  endfunction

  always_ff @(posedge clk_i) begin
    was_left_q <= rst_i ? '0 : left_q;
    if (rst_i) begin
      live_q <= 1'b1;
      left_q <= '0;
      wait_q <= 1'b0;
    end else if (left_q != '0) begin
      left_q <= left_q - 7'd1;
    end else if (go) begin
      left_q <= Clocks;
      wait_q <= 1'b0;
    end else if (table_busy_o && start_i) begin
      wait_q <= 1'b1;
    end
    if (live_q) begin
      done_after_70_clocks : assert (done_o == (was_left_q == 7'd1));
      step_is_two_clocks :
      assert (step_o == (left_q == '0 ? '0 : (Clocks - left_q) >> 1));
      busy_from_start_to_done : assert (busy_o == (left_q != '0 || wait_q || table_busy_o));
      lost_start_is_an_overrun : assert (overrun_o == (start_i && (left_q != '0 || wait_q)));
      i_q_is_valid_after_s29_only : assert (iq_valid_o == ends(was_left_q, 7'd29));
      quiescent_is_honest :
      assert (!quiescent_o || !running_q && !done_d && !iq_valid_d && !done_o && !iq_valid_o &&
          {running_d, waiting_d, asked_d} == {running_q, waiting_q, asked_q});

      inv_left : assert (left_q <= Clocks && running_q == (left_q != '0) && waiting_q == wait_q);
      inv_step :
      assert (running_q ? {step_q, phase_q} == Clocks - left_q : {step_q, phase_q} == '0);

      reaches_done : cover (done_o);
      reaches_overrun : cover (overrun_o && step_o == 7'd20);
    end
  end

  // ---- words: each moves in its own step; e, de and v are saturated differences ----

  model_t x_m_q;
  count_t x_r_q, dx_q;
  word_t e_q, de_q, u_q, v_star_q, v_q, i_q_q;
  logic saturated_q, was_reset_q;

  function automatic word_t clipped(logic signed [29:0] x);
    if (x > 30'sd2047) return 12'sd2047;
    if (x < -30'sd2048) return -12'sd2048;
    return word_t'(x);
  endfunction

  always_ff @(posedge clk_i) begin
    was_reset_q <= rst_i;
    {x_m_q, x_r_q, dx_q, e_q, de_q} <= {x_m_o, x_r_o, dx_o, e_o, de_o};
    {u_q, v_star_q, v_q, i_q_q, saturated_q} <= {u_o, v_star_o, v_o, i_q_ref_o, saturated_o};
    if (live_q && !was_reset_q) begin
      words_move_in_their_step_only :
      assert ((x_m_o == x_m_q || ends(was_left_q, 7'd5) || was_left_q == Clocks) &&
          (dx_o == dx_q || ends(was_left_q, 7'd4) || was_left_q == Clocks) &&
          (x_r_o == x_r_q || ends(was_left_q, 7'd6)) && (v_o == v_q || ends(was_left_q, 7'd7)) &&
          (e_o == e_q || ends(was_left_q, 7'd8)) && (de_o == de_q || ends(was_left_q, 7'd9)) &&
          (u_o == u_q || ends(was_left_q, 7'd22)) &&
          (v_star_o == v_star_q || ends(was_left_q, 7'd26)));
      i_q_moves_with_its_valid_only :
      assert (iq_valid_o || i_q_ref_o == i_q_q && saturated_o == saturated_q);
    end
    if (live_q) begin
      saturated_i_q_is_at_its_end :
      assert (!saturated_o || i_q_ref_o == 12'sd2047 || i_q_ref_o == -12'sd2048);
      v_e_de_are_saturated_differences :
      assert ((!ends(was_left_q, 7'd7) ||
               v_o == (resetting_q ? '0 :
                       clipped((30'(x_p_q) - 30'(x_p_prev_q)) <<< 4))) &&
          (!ends(was_left_q, 7'd8) || e_o == clipped(30'(x_r_o) - 30'(x_p_q))) &&
          (!ends(was_left_q, 7'd9) || de_o == clipped(30'(e_o) - 30'(e_prev_q))));
    end
  end

  // ---- fuzzification and the four fired rules ----

  logic [3:0] written_q;  // of the four
  logic adapting_q;       // adapt_i was high at every write so far
  logic [2:0] col_13_q, row_13_q;
  logic s34_q;

  logic [3:0] due;        // s31 to s34 have ended
  always_comb for (int unsigned n = 0; n < 4; n++) due[n] = left_q <= 7'(6 - 2 * n);

  function automatic logic one(member_t x, member_t y);
    return x <= 12'd2048 && y <= 12'd2048 && x + y == 12'd2048;
  endfunction

  always_ff @(posedge clk_i) begin
    s34_q <= !rst_i && ends(left_q, 7'd34);
    if (left_q == Clocks) begin
      written_q  <= '0;
      adapting_q <= 1'b1;
    end
    if (ends(left_q, 7'd13)) {col_13_q, row_13_q} <= {col_q, row_q};
    if (tune_we) written_q[rule_sel] <= 1'b1;
    if (left_q <= 7'd7 && left_q[0] && !adapt_i) adapting_q <= 1'b0;
    if (live_q) begin
      degrees_sum_to_one :
      assert ((left_q == '0 || left_q > 7'd48 || one(mu_a0_q, mu_a1_q)) &&
          (left_q == '0 || left_q > 7'd44 || one(mu_b0_q, mu_b1_q)));
      rules_move_only_when_adapting : assert (!tune_we || adapt_i);
      rules_move_in_s31_to_s34 : assert (!tune_we || left_q != '0 && left_q <= 7'd7);
      a_fired_rule_moves_once : assert (!tune_we || !written_q[rule_sel]);
      the_four_fired_rules_move : assert (!s34_q || !adapting_q || written_q == '1);
      section_stays_from_s13_on :
      assert (left_q == '0 || left_q > 7'd42 || col_q == col_13_q && row_q == row_13_q &&
          col_q <= 3'd5 && row_q <= 3'd5);

      inv_sections :
      assert ((left_q == '0 || left_q > 7'd48 || col_q <= 3'd5) &&
          (left_q == '0 || left_q > 7'd44 || row_q <= 3'd5));
      inv_written :
      assert (left_q == '0 || left_q == Clocks ||
          (written_q & ~due) == '0 && (!adapting_q || written_q == due));

      reaches_tuning : cover (s34_q && written_q == '1);
    end
  end

  // ---- one rule, any of them: the watched cell of the table ----

  logic [2:0] watch_i_q, watch_j_q;
  logic may_move_q, read_q, summed, weighed;
  logic [1:0] at_s18, at_s31;  // the rule that this step uses: {j + 1, i + 1}
  count_t watched, was_watched_q;

  assign watched = rules_q[{watch_j_q, watch_i_q}];
  assign at_s18 = 2'(step_q - 6'd18);
  assign at_s31 = 2'(step_q - 6'd31);

  function automatic logic fired(logic [1:0] which);
    return watch_i_q == col_q + 3'(which[0]) && watch_j_q == row_q + 3'(which[1]);
  endfunction

  assign weighed = left_q[0] == 1'b0 && step_q >= 6'd18 && step_q <= 6'd21 && fired(at_s18);
  assign summed  = left_q != '0 && step_q >= 6'd31 && step_q <= 6'd34 && fired(at_s31);

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      watch_i_q <= rule_addr_i[2:0] == '1 ? '0 : rule_addr_i[2:0];
      watch_j_q <= rule_addr_i[5:3] == '1 ? '0 : rule_addr_i[5:3];
    end
    was_watched_q <= watched;
    // 7 j + i, without a multiplication
    may_move_q <= rst_i || table_busy_o || (running_q ? tune_we && fired(rule_sel) :
        rule_we_i && rule_addr_i == {watch_j_q, 3'd0} - 6'(watch_j_q) + 6'(watch_i_q));
    if (!running_q) read_q <= 1'b0;
    else if (!phase_q) read_q <= fired(rule_sel);
    if (live_q) begin
      a_rule_moves_only_when_fired_or_from_outside :
      assert (may_move_q || watched == was_watched_q);
      a_degree_weighs_its_own_rule : assert (!weighed || rule == watched);
      a_rule_is_summed_with_itself : assert (!summed || !phase_q || add_a_q == 40'(watched));

      inv_watch : assert (watch_i_q <= 3'd6 && watch_j_q <= 3'd6);
      inv_hold : assert (!running_q || !filling);
      inv_read : assert (!running_q || !read_q || rule == watched);
      inv_summed : assert (!summed || phase_q || rule == watched);
    end
  end

  // ---- the adder: with products of their true size nothing is lost before a saturation ----

  logic fits, fits_q;   // the product has its true size; so had those before it
  logic used, shifting;  // the sum, the shifted product is used
  logic [2:0] zeros_q;  // below the product, for a shifted factor
  logic [5:0] last_place;
  exact_t exact;

  assign last_place = {place_q, ~zeros_q};
  assign exact = exact_t'(add_a_q) + exact_t'(add_b_q) + exact_t'({1'b0, carry_q});

  function automatic logic bounded(logic signed [47:0] x, logic signed [47:0] limit);
    return x <= limit && x >= -limit;
  endfunction

  function automatic logic sum_fits(exact_t x, exact_t low, exact_t high);
    return x >= low && x <= high;
  endfunction

  function automatic logic has_bits(logic signed [39:0] x, logic [5:0] n);
    return x >>> (n - 6'd1) == '0 || ~x >>> (n - 6'd1) == '0;
  endfunction

  always_comb begin
    fits = 1'b1;
    used = 1'b1;
    unique case (step_q) inside
      6'd1, 6'd2, 6'd3: fits = bounded(product_q, 48'sd1 <<< 46);
      6'd4: fits = bounded(product_q, 48'sd262143 * (48'sd1 <<< (place_q == 3'o2 ? 26 : 23)));
      [6'd15 : 6'd18]:
      fits = bounded(product_q, (48'sd2048 * 48'sd2048) <<< zeros_q) && !product_q[47];
      [6'd19 : 6'd22]: fits = bounded(product_q, (48'sd2048 * 48'sd2048) <<< zeros_q);
      6'd24, 6'd25, 6'd29, 6'd30:
      fits = bounded(product_q, (48'sd2047 * 48'sd2048) <<< zeros_q);
      [6'd31 : 6'd34]:
      fits = bounded(product_q, (48'sd2047 * 48'sd2048 * 48'sd2048) <<< zeros_q);
      default: ;
    endcase
    if (step_q inside {6'd11, 6'd13, 6'd14, 6'd28, 6'd30}) used = 1'b0;
    shifting = step_q inside {6'd3, 6'd4, [6'd15 : 6'd22], 6'd24, 6'd25, 6'd29, [6'd31 : 6'd34]};
  end

  always_ff @(posedge clk_i) begin
    fits_q <= left_q == '0 || fits_q && fits;
    if (phase_q && mul_used) zeros_q <= ~place_low;
    if (live_q && running_q && shifting && fits && fits_q) begin
      shifter_loses_no_bit_on_the_left :
      assert (place_q != 3'o6 && place_q != 3'o7 ||
          (place_q == 3'o6 ? shifted >>> 9 : shifted >>> 1) == 40'(product_q));
    end
    if (live_q && running_q && phase_q && used && fits && fits_q) begin
      adder_never_overflows : assert (exact == exact_t'(sum));
      words_fit_their_registers :
      assert ((step_q != 6'd5 || sum_fits(exact, -(42'sd1 <<< 31), (42'sd1 <<< 31) - 42'sd1) ||
               x_m_o >= 32'sd130560 <<< 14 || x_m_o <= -(32'sd130560 <<< 14)) &&
          (step_q != 6'd6 || sum_fits(exact, -42'sd131072, 42'sd131072)) &&
          (!(step_q inside {6'd10, 6'd12, [6'd15 : 6'd18]}) || sum_fits(exact, '0, 42'sd2048)));
      inv_acc :
      assert ((step_q != 6'd1 || has_bits(acc_q, 6'd26)) &&
          (step_q != 6'd2 || has_bits(acc_q, 6'd27)) &&
          (step_q != 6'd4 || has_bits(acc_q, 6'd25)) &&
          (step_q != 6'd20 || has_bits(acc_q, 6'd24)) &&
          (step_q != 6'd21 || has_bits(acc_q, 6'd25)) &&
          (step_q != 6'd22 || has_bits(acc_q, 6'd26)) &&
          (step_q != 6'd24 || has_bits(acc_q, 6'd16)) &&
          (!(step_q inside {6'd25, 6'd26}) || has_bits(acc_q, 6'd28)) &&
          (step_q != 6'd28 || has_bits(acc_q, 6'd12)));
      inv_operands : assert (has_bits(add_a_q, 6'd39) && has_bits(add_b_q, 6'd39));
    end
    if (live_q && running_q) begin
      inv_place :
      assert ((!(step_q inside {[6'd1 : 6'd3], 6'd30}) || last_place == 6'o27) &&
          (!(step_q inside {[6'd4 : 6'd14]}) || last_place inside {6'o47, 6'o27, 6'o17}) &&
          (!(step_q inside {[6'd15 : 6'd18]}) || last_place == 6'o13) &&
          (!(step_q inside {[6'd19 : 6'd23]}) || last_place == 6'o00) &&
          (!(step_q inside {6'd24, 6'd29}) || last_place >= 6'o74 || last_place <= 6'o33) &&
          (!(step_q inside {[6'd25 : 6'd28]}) || last_place >= 6'o60 || last_place <= 6'o17) &&
          (step_q < 6'd31 || last_place >= 6'o73 || last_place <= 6'o32));
    end
    if (live_q) begin
      inv_scaled :
      assert (left_q == '0 || left_q > 7'd50 ||
          sum_fits(exact_t'(scaled_q), -42'sd6144, 42'sd6140));
    end
  end

  // breaks done_after_70_clocks, the_four_fired_rules_move: step_d = step_q == 6'd32 && phase_q ? 6'd34 : step_d
  // breaks step_is_two_clocks: phase_d = running_q
  // breaks busy_from_start_to_done: busy_o = running_q || table_busy_o
  // breaks lost_start_is_an_overrun: overrun_o = start_i && running_q
  // breaks i_q_is_valid_after_s29_only: iq_valid_d = step_end && step_q == 6'd28
  // breaks quiescent_is_honest: quiescent_o = !busy_o && asked_q == asked_d && !done_q && !iq_valid_q && store_quiescent
  // breaks words_move_in_their_step_only: x_r_q <= step_end && step_q == 6'd0 && !rst_i ? r_new : next
  // breaks i_q_moves_with_its_valid_only: i_q_ref_q <= step_end && step_q == 6'd0 && !rst_i ? r_new[11:0] : next
  // breaks saturated_i_q_is_at_its_end: saturated_q <= next || rst_i
  // breaks v_e_de_are_saturated_differences: v_q <= step_end && step_q == 6'd7 && !resetting_q && !rst_i ? sat12(acc_t'(sum) <<< 3) : next
  // breaks degrees_sum_to_one: mu_a0_q <= step_end && step_q == 6'd10 && !rst_i ? sum[12:1] : next
  // breaks rules_move_only_when_adapting: tune_we = step_end && step_q >= 6'd31
  // breaks rules_move_in_s31_to_s34, a_fired_rule_moves_once: tune_we = step_end && adapt_i && step_q >= 6'd3
  // breaks section_stays_from_s13_on: row_q <= step_end && step_q == 6'd15 && !rst_i ? sum[2:0] : next
  // breaks a_degree_weighs_its_own_rule: step_d = running_q && phase_q && step_q == 6'd0 ? 6'd19 : step_d
  // breaks a_rule_is_summed_with_itself: step_d = running_q && phase_q && step_q == 6'd0 ? 6'd31 : step_d
  // breaks a_rule_moves_only_when_fired_or_from_outside: u_rules.hold_i = 1'b0
  // breaks adder_never_overflows: add_b = step_q == 6'd0 ? {r_2, 16'd0} : add_b
  // breaks shifter_loses_no_bit_on_the_left: Place24 = 6'o67
  // breaks words_fit_their_registers: add_b = step_q == 6'd6 ? sum_t'(x_m_q) >>> 13 : add_b

endmodule

bind afc afc_props u_afc_props (
    .*,
    .place_low(place[2:0]),
    .rules_q(u_rules.mem_q),
    .filling(u_rules.state_q[1])
);

// prove: free $mul
// prove: frames 130
// prove: from 54
// prove: depth 6
// prove: leap inv_step
