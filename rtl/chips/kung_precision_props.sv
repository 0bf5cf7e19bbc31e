// SPDX-License-Identifier: Apache-2.0
//
// Properties of kung_precision whatever the law answers: that is free here, as the edge times are.

module kung_precision_props
  import trammel_pkg::*;
  import kung_xy_regs_pkg::axis_regs__out_t;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_cur_i,
    input logic tick_pos_i,

    input axis_regs__out_t [1:0]     regs_i,
    input logic                      knot_read_i,
    input logic                      knot_ack_o,
    input logic [1:0]                edge_i,
    input kung_pkg::precision_t [1:0] axis_o,
    input logic                      timed_o,

    input logic [1:0]  timed,
    input logic        request,
    input logic        we,
    input logic [ 6:0] address,
    input logic [31:0] wdata,
    input logic        law_ack,
    input logic        busy,
    input logic        done,
    input word_t [1:0] i_q
);

  logic live_q = 1'b0;

  // ---- requests of the registers; the bus makes one at a time ----

  logic [1:0] on;
  logic [1:0][4:0] asks;  // PREC_DATA, PREC_ERR, ERR_SUM, IQ_SUM, PREC_DIST
  logic [1:0] whole, writes, wrote;
  logic [3:0] number;
  logic named;
  logic last_write_q, lone_q, asked_q, ack;
  logic [1:0] last_data_q;

  always_comb begin
    number = 4'(knot_read_i);
    for (int unsigned n = 0; n < 2; n++) begin
      writes[n] = regs_i[n].prec_data.req_is_wr;
      whole[n]  = regs_i[n].prec_data.wr_biten.value == '1;
      wrote[n]  = regs_i[n].prec_data.req && writes[n] && !whole[n];
      asks[n]   = {regs_i[n].prec_data.req && !wrote[n], regs_i[n].prec_err.req,
                   regs_i[n].err_sum.req, regs_i[n].iq_sum.req, regs_i[n].prec_dist.req};
      number    = number + 4'(asks[n][4]) + 4'(asks[n][3]) + 4'(asks[n][2]) + 4'(asks[n][1]) +
          4'(asks[n][0]);
    end
  end

  function automatic logic names(logic asked, logic [6:0] word);
    return !asked || request && address == word;
  endfunction

  always_comb begin
    named = names(knot_read_i, {!on[0], 6'd62});
    for (int unsigned n = 0; n < 2; n++) begin
      named = named && names(asks[n][4], {n[0], 1'b0, regs_i[n].prec_addr.word.value}) &&
          names(asks[n][3], {n[0], 6'd54}) && names(asks[n][2], {n[0], 6'd59}) &&
          names(asks[n][1], {n[0], 6'd60}) && names(asks[n][0], {n[0], 6'd61}) &&
          (!asks[n][4] || we == writes[n] && wdata == regs_i[n].prec_data.wr_data.value) &&
          (!(asks[n][3:0] != '0) || !we);
    end
  end

  assign on  = {regs_i[1].ctrl.precision.value, regs_i[0].ctrl.precision.value};
  assign ack = law_ack && asked_q;

  // ---- runs of the law ----

  logic position_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      live_q      <= 1'b1;
      last_data_q <= '0;
      position_q  <= 1'b0;
      asked_q     <= 1'b0;
    end else begin
      if (number != '0) begin
        last_write_q <= (asks[0][4] && writes[0]) || (asks[1][4] && writes[1]);
        lone_q       <= number == 4'd1;
        last_data_q  <= {asks[1][4], asks[0][4]};
        asked_q      <= 1'b1;
      end else if (law_ack) begin
        asked_q <= 1'b0;
      end
      if (tick_cur_i && !busy && on != '0) position_q <= tick_pos_i;
    end
    if (live_q && !rst_i) begin
      a_request_names_its_word : assert (number > 4'd1 || named);
      no_request_without_a_register : assert (request == (number != '0));
      answers_are_of_the_last_request :
      assert (asked_q && !lone_q || axis_o[0].read == (ack && !last_write_q) &&
              axis_o[1].read == (ack && !last_write_q) && knot_ack_o == (ack && !last_write_q) &&
              axis_o[0].written == (ack && last_write_q || wrote[0]) &&
              axis_o[1].written == (ack && last_write_q || wrote[1]));
      part_of_a_word_is_answered_at_once :
      assert ((!wrote[0] || axis_o[0].written) && (!wrote[1] || axis_o[1].written));
      address_counts_behind_its_data_only :
      assert ({axis_o[1].counts, axis_o[0].counts} == (last_data_q & {2{ack}}));
      flags_of_enabled_axes_only :
      assert ((on[0] || {axis_o[0].saturated, axis_o[0].clipped, axis_o[0].overrun,
                                    axis_o[0].underrun} == '0) &&
              (on[1] || {axis_o[1].saturated, axis_o[1].clipped, axis_o[1].overrun,
                                    axis_o[1].underrun} == '0));
      i_q_of_its_axis_where_its_bit_is_set :
      assert (axis_o[0].enable == on[0] && axis_o[1].enable == on[1] &&
              {axis_o[1].i_q_ref, axis_o[0].i_q_ref} == i_q);
      done_of_position_ticks_only :
      assert (axis_o[0].done == (done && position_q) && axis_o[1].done == (done && position_q));
      edges_of_enabled_axes_are_timed :
      assert (timed == (edge_i & on) && timed_o == (timed != '0));
      reaches_an_answer : cover (ack && last_data_q[1] && last_write_q);
      reaches_a_position : cover (done && position_q);
    end
  end

  // prove: cut precision edge_time
  // breaks a_request_names_its_word: address = address & 7'h3f
  // breaks no_request_without_a_register: request = request || law_ack
  // breaks answers_are_of_the_last_request: we_q <= request ? !we : next
  // breaks part_of_a_word_is_answered_at_once: part = {1'b0, part[0]}
  // breaks address_counts_behind_its_data_only: counts_d = data
  // breaks flags_of_enabled_axes_only: enable = {enable[1], 1'b1}
  // breaks i_q_of_its_axis_where_its_bit_is_set: enable = {2{enable[0]}}
  // breaks done_of_position_ticks_only: pos_q <= rst_i ? next : tick_pos_i
  // breaks edges_of_enabled_axes_are_timed: timed = edge_i

endmodule

bind kung_precision kung_precision_props u_kung_precision_props (.*);
