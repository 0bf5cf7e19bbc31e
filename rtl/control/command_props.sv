// SPDX-License-Identifier: Apache-2.0
//
// Properties of command for any input, against a model that knows only where a command started,
// where it ends and how many of its four parts have passed.

module command_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_pos_i,

    input logic   commit_i,
    input logic   interpolate_i,
    input logic   preset_i,
    input count_t preset_value_i,

    input count_t pos_cmd_i,
    input count_t r_o,

    input logic quiescent_o,

    input logic               pending_q,
    input logic               pending_d,
    input count_t             next_q,
    input count_t             next_d,
    input logic signed [25:0] quarters_q,
    input logic signed [25:0] quarters_d,
    input logic signed [25:0] stride_q,
    input logic signed [25:0] stride_d,
    input logic        [ 1:0] left_q,
    input logic        [ 1:0] left_d
);

  typedef logic signed [27:0] wide_t;

  logic live_q = 1'b0;
  logic asked_q;         // a command is committed and not yet taken
  count_t asked_for_q;
  count_t from_q, to_q;
  logic [2:0] part_q;    // of the move, 4 = at its end
  count_t was_r_q;
  logic stays_q, taken_q, preset_q;

  // In quarters of a count: where the move should be, and where it will end.
  wide_t distance, stride, quarters, model, target;
  assign distance = wide_t'(to_q) - wide_t'(from_q);
  assign stride   = wide_t'(stride_q);
  assign quarters = wide_t'(quarters_q);
  always_comb begin
    model  = wide_t'(to_q) <<< 2;
    target = quarters;
    unique case (part_q)
      3'd1: begin
        model  = (wide_t'(from_q) <<< 2) + distance;
        target = ((quarters + stride) + stride) + stride;
      end
      3'd2: begin
        model  = ((wide_t'(from_q) <<< 2) + distance) + distance;
        target = (quarters + stride) + stride;
      end
      3'd3: begin
        model  = (((wide_t'(from_q) <<< 2) + distance) + distance) + distance;
        target = quarters + stride;
      end
      default: ;
    endcase
  end

  always_ff @(posedge clk_i) begin
    was_r_q  <= r_o;
    stays_q  <= !rst_i && !tick_pos_i && !preset_i;
    taken_q  <= !rst_i && tick_pos_i && asked_q && !interpolate_i && !preset_i;
    preset_q <= !rst_i && preset_i;
    if (rst_i) begin
      live_q  <= 1'b1;
      asked_q <= 1'b0;
      from_q  <= '0;
      to_q    <= '0;
      part_q  <= 3'd4;
    end else begin
      if (tick_pos_i && asked_q) begin
        asked_q <= 1'b0;
        from_q  <= interpolate_i ? r_o : asked_for_q;
        to_q    <= asked_for_q;
        part_q  <= interpolate_i ? 3'd1 : 3'd4;
      end else if (tick_pos_i && part_q != 3'd4) begin
        part_q <= part_q + 3'd1;
      end
      if (commit_i) begin
        asked_q     <= 1'b1;
        asked_for_q <= pos_cmd_i;
      end
      if (preset_i) begin
        asked_q <= 1'b0;
        from_q  <= preset_value_i;
        to_q    <= preset_value_i;
        part_q  <= 3'd4;
      end
    end
    if (live_q) begin
      moves_only_at_a_tick : assert (!stays_q || r_o == was_r_q);
      taken_at_the_next_tick : assert (!taken_q || r_o == to_q);
      preset_acts_at_once : assert (!preset_q || r_o == to_q);
      parts_are_equal : assert (wide_t'(r_o) == (model + wide_t'(2)) >>> 2);
      ends_exactly_at_the_command : assert (part_q != 3'd4 || r_o == to_q);
      never_overshoots :
      assert (from_q <= to_q ? r_o >= from_q && r_o <= to_q : r_o <= from_q && r_o >= to_q);
      quiescent_is_honest :
      assert (!quiescent_o || {pending_d, next_d, quarters_d, stride_d, left_d} ==
          {pending_q, next_q, quarters_q, stride_q, left_q});

      inv_asked : assert (pending_q == asked_q && (!asked_q || next_q == asked_for_q));
      inv_part : assert (3'(left_q) == 3'd4 - part_q && part_q >= 3'd1 && part_q <= 3'd4);
      inv_stride : assert (part_q == 3'd4 || stride == distance);
      inv_model : assert (quarters == model);
      inv_target : assert (target == wide_t'(to_q) <<< 2);

      reaches_second_part : cover (part_q == 3'd2 && r_o != from_q && r_o != to_q);
      reaches_a_new_command_on_the_way : cover (part_q == 3'd3 && tick_pos_i && asked_q);
    end
  end

  // breaks moves_only_at_a_tick: quarters_d = !take && left_q != 2'd0 && !preset_i ? moved : quarters_d
  // breaks taken_at_the_next_tick: quarters_d = take && !interpolate_i && !preset_i ? {pos_cmd_i, 2'd0} : quarters_d
  // breaks taken_at_the_next_tick: take = tick_pos_i && commit_i
  // breaks preset_acts_at_once: quarters_d = preset_i ? quarters_q : quarters_d
  // breaks parts_are_equal, never_overshoots: moved = {quarters_q[25:2], take ? {2{up}} : quarters_q[1:0]} + (take ? distance <<< 3 : stride_q) + quarter_t'({1'b0, up})
  // breaks parts_are_equal: r_o = quarters_q[25:2] + {23'd0, quarters_q[0]}
  // breaks parts_are_equal: up = take && quarters_q[0]
  // breaks ends_exactly_at_the_command: left_d = take && interpolate_i && !preset_i ? 2'd2 : left_d
  // breaks quiescent_is_honest: quiescent_o = !preset_i && !(tick_pos_i && (pending_q || left_q != 2'd0))
  // breaks quiescent_is_honest: quiescent_o = !commit_i && !preset_i && !(tick_pos_i && pending_q)

endmodule

bind command command_props u_command_props (.*);
