// SPDX-License-Identifier: Apache-2.0
//
// Properties of force_pwm for any input; clocks passed by leaps count. A leap beyond next_o is an
// error of the caller: what it leads to is left out until the next reset.

module force_pwm_props
  import trammel_pkg::*;
#(
    parameter int unsigned Half = 3472,
    parameter int unsigned Scale = 3475
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic signed [10:0] force_1_i,
    input logic signed [10:0] force_2_i,
    input logic        [ 1:0] pwm_o,
    input logic        [ 1:0] negative_o,
    input gap_t               next_o,
    input logic               quiescent_o,

    input logic        load,
    input logic [31:0] count,
    input logic [31:0] on_1,   // clocks of half a pulse
    input logic [31:0] on_2,
    input logic [ 1:0] taken_q
);

  logic live_q = 1'b0;
  logic fair_q, was_rst_q, was_load_q, was_quiescent_q;
  logic [10:0] force_1_q, force_2_q;  // of the last load
  logic [1:0] was_pwm_q, was_negative_q, was_taken_q, wanted_q;
  logic [31:0] since_q;
  logic loaded_q;

  // |force|, 1023 at most.
  function automatic logic [31:0] size(logic [10:0] value);
    if (value == 11'h400) return 32'd1023;
    return value[10] ? 32'd2048 - 32'(value) : 32'(value);
  endfunction

  function automatic logic on(logic [31:0] half);
    return count > Half - half && count <= Half + half;
  endfunction

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    fair_q          <= rst_i || (fair_q && (leap_i == '0 || leap_i < next_o));
    was_rst_q       <= rst_i;
    was_load_q      <= !rst_i && load;
    was_quiescent_q <= !rst_i && quiescent_o && leap_i < next_o;
    if (load) begin
      force_1_q <= force_1_i;
      force_2_q <= force_2_i;
    end
    loaded_q       <= !rst_i && (loaded_q || load);
    was_pwm_q      <= pwm_o;
    was_negative_q <= negative_o;
    was_taken_q    <= rst_i ? '0 : taken_q;
    wanted_q       <= rst_i ? '0 : {on(on_2), on(on_1)};
    since_q        <= rst_i || load ? 32'd1 : since_q + 32'd1 + 32'(leap_i);
    if (live_q && fair_q) begin
      off_from_reset : assert (!was_rst_q || (pwm_o == '0 && negative_o == '0));
      period_of_2_half : assert (!loaded_q || !load || since_q == 2 * Half);
      pulse_in_the_middle : assert (pwm_o == wanted_q);
      pulse_of_the_force :
      assert (!loaded_q || (on_1 == (size(force_1_q) * Scale + 32'd512) >> 10 &&
              on_2 == (size(force_2_q) * Scale + 32'd512) >> 10));
      full_force_is_the_whole_period :
      assert (!loaded_q || size(force_1_q) != 32'd1023 || on_1 == Half);
      direction_of_the_force :
      assert (!loaded_q || taken_q == {force_2_q[10], force_1_q[10]});
      direction_with_the_first_pulse : assert (negative_o == was_taken_q);
      taken_at_the_begin_only : assert (was_rst_q || was_load_q || taken_q == was_taken_q);
      quiescent_is_honest :
      assert (!was_quiescent_q || (pwm_o == was_pwm_q && negative_o == was_negative_q));
      inv_count : assert (count <= 2 * Half && (was_rst_q || count != '0));
      inv_since : assert (!loaded_q || since_q + count == 2 * Half + 32'd1);
      inv_loaded : assert (was_rst_q || loaded_q);
      inv_on : assert (on_1 <= Half && on_2 <= Half && (loaded_q || on_1 + on_2 == '0));
      inv_taken : assert (loaded_q || taken_q == '0);
      reaches_a_pulse : cover (pwm_o == 2'd1);
      reaches_a_negative_pulse : cover (pwm_o == 2'd2 && negative_o == 2'd2);
    end
  end


  // breaks off_from_reset: negative_q <= rst_i ? taken_q : next
  // breaks period_of_2_half: Period = Period - count_t'(1)
  // breaks pulse_in_the_middle: pwm_o = pwm_q & ~{2{count[0]}}
  // breaks pulse_of_the_force, full_force_is_the_whole_period: 32'd512 => 32'd0
  // breaks direction_of_the_force: taken_q <= load && !rst_i ? {force_1_i[10], force_2_i[10]} : next
  // breaks direction_with_the_first_pulse: negative_o = taken_q
  // breaks taken_at_the_begin_only: taken_q <= rst_i ? '0 : {force_2_i[10], force_1_i[10]}
  // breaks quiescent_is_honest: quiescent_o = !load && pwm_d == pwm_q

  // prove: set Half=3 Scale=3
  // prove: set Half=3472 Scale=3475

endmodule

bind force_pwm force_pwm_props #(
    .Half (Half),
    .Scale(Scale)
) u_force_pwm_props (
    .*,
    .count(32'(count)),
    .on_1 (32'(on_q[0])),
    .on_2 (32'(on_q[1]))
);
