// SPDX-License-Identifier: Apache-2.0
//
// Properties of mcafee_xy for any input, on its bus and its pins. The parts' engines and encoders
// and the feed rate are cut: what they give is free. Clocks passed by leaps count.

module mcafee_xy_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic        s_axil_awvalid_i,
    input logic        s_axil_wvalid_i,
    input logic        s_axil_bvalid_o,
    input logic        s_axil_arvalid_i,
    input logic        s_axil_rvalid_o,
    input logic [31:0] s_axil_rdata_o,
    input logic [ 3:0] limit_i,
    input logic [ 7:0] dac_x_o,
    input logic [ 7:0] dac_y_o,
    input logic        cs_x_n_o,
    input logic        cs_y_n_o,
    input logic        rd_n_o,
    input logic        wr_n_o,
    input logic        transceiver_o,
    input logic        selector_o,
    input logic        d_oe_x_o,
    input logic        d_oe_y_o,
    input logic [ 1:0] sample_o,
    input logic [ 1:0] hi_o,
    input logic        irq_o,
    input gap_t        next_o,
    input logic        quiescent_o,
    input logic        feed_written,
    input logic        reset_pulse,
    input logic        reset_n,
    input logic        feed_ready,
    input logic        feed_valid,
    input logic        asked_q,
    input logic [ 1:0] high,  // the high part of 12 bits, or all 8
    input gap_t        next_x,
    input gap_t        next_y,
    input gap_t        bridge_next,
    // of the register block
    input logic        read_waits,
    input logic        write_waits,
    input logic [1:0]  in_flight,
    input logic [1:0]  unanswered,
    // of the parts
    input logic        rst_x,
    input logic        rst_y,
    input logic [1:0]  restarts,
    input logic [3:0]  reset_stages,  // of both pins
    input logic [21:0] time_x,
    input logic [21:0] time_y,
    input logic [3:0]  limits         // as in the register
);

  logic live_q = 1'b0;
  logic was_rst_q, was_asked_q, was_ready_q, was_quiescent_q, was_reset_n_q;
  logic parted_q;  // one part was reset alone since both were last
  logic was_swmod_q, was_valid_q;
  logic [3:0] limit_q, limit_late_q;
  logic [1:0] history_q, low_q;  // edges since live, up to 3; RST at the two edges before
  logic [27:0] shown, was_shown_q;
  gap_t was_next_q, was_leap_q;

  assign shown = {dac_x_o, dac_y_o, cs_x_n_o, cs_y_n_o, rd_n_o, wr_n_o, transceiver_o, selector_o,
                  irq_o, reset_n, limits};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_asked_q     <= !rst_i && (s_axil_awvalid_i || s_axil_wvalid_i || s_axil_arvalid_i);
    was_ready_q     <= !rst_i && feed_ready;
    was_swmod_q     <= !rst_i && feed_written;
    was_valid_q     <= !rst_i && feed_valid;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_reset_n_q   <= reset_n;
    was_shown_q     <= shown;
    was_next_q      <= next_o;
    was_leap_q      <= leap_i;
    limit_q         <= limit_i;
    limit_late_q    <= limit_q;
    low_q           <= rst_i ? '1 : {low_q[0], reset_n};
    if (!live_q) history_q <= '0;
    else if (history_q != 2'd3) history_q <= history_q + 2'd1;
    parted_q        <= !(rst_x && rst_y) && (parted_q || rst_x || rst_y);
    if (live_q) begin
      never_both_selected : assert (cs_x_n_o || cs_y_n_o);
      never_both_drive_port_or_bus : assert (!(transceiver_o && selector_o));
      strobes_by_their_driver : assert ((wr_n_o || transceiver_o) && (rd_n_o || selector_o));
      never_both_parts_on_the_bus : assert (history_q != 2'd3 || !(d_oe_x_o && d_oe_y_o));
      converters_at_zero_in_the_low_bits :
      assert ((high[0] || dac_x_o == 8'h80) && (high[1] || dac_y_o == 8'h80));
      quiet_from_reset :
      assert (!was_rst_q || (dac_x_o == 8'h80 && dac_y_o == 8'h80 && !irq_o && rd_n_o && wr_n_o &&
              !s_axil_bvalid_o && !s_axil_rvalid_o));
      reset_reaches_both_parts : assert (history_q != 2'd3 || low_q[1] || (rst_x && rst_y));
      one_part_alone_by_its_command_only :
      assert (history_q != 2'd3 || rst_x == rst_y || restarts != '0);
      samples_coincide_from_a_common_reset :
      assert (parted_q || history_q == '0 || sample_o[0] == sample_o[1]);
      irq_is_that_of_either_part : assert (irq_o == (hi_o[0] || hi_o[1]));
      limits_shown_2_clocks_later : assert (history_q != 2'd3 || limits == limit_late_q);
      not_ready_after_a_write : assert (!was_swmod_q || !feed_ready);
      ready_by_a_result_only : assert (!feed_ready || was_ready_q || was_valid_q);
      next_is_the_least :
      assert (next_o <= bridge_next && next_o <= next_x && next_o <= next_y &&
              (next_o == bridge_next || next_o == next_x || next_o == next_y));
      quiescent_without_transfers_only :
      assert (!quiescent_o || (in_flight == '0 && !read_waits && !write_waits));
      quiescent_holds_the_pins :
      assert (!was_quiescent_q || rst_i || was_leap_q >= was_next_q || shown == was_shown_q);
      inv_asked : assert (was_rst_q || asked_q == was_asked_q);
      inv_in_flight :
      assert (in_flight == unanswered && in_flight <= 2'd2 &&
              (in_flight != '0) == (s_axil_bvalid_o || s_axil_rvalid_o));
      inv_waits : assert (!(read_waits || write_waits) || asked_q || in_flight != '0);
      inv_pulse : assert (!reset_pulse || in_flight != '0);
      inv_time : assert (parted_q || history_q == '0 || time_x == time_y);
      inv_stages :
      assert (history_q != 2'd3 || ({2{reset_stages[2]}} == reset_stages[3:2] &&
              {2{reset_stages[0]}} == reset_stages[1:0]));
      reaches_a_reset : cover (!reset_n && was_reset_n_q);
      reaches_an_answer : cover (s_axil_rvalid_o && s_axil_rdata_o == 32'h4d43_0001);
      reaches_a_speed : cover (feed_ready);
      reaches_a_pulse : cover (!wr_n_o && !cs_y_n_o);
    end
  end

  // breaks never_both_selected: cs_y_n_o = 1'b0
  // breaks never_both_drive_port_or_bus (lm628_bridge): selector_o = read_i && !change_q
  // breaks strobes_by_their_driver (lm628_bridge): writes_q <= !rst_i && state_d == StPulse && !read_i
  // breaks never_both_parts_on_the_bus: u_y.cs_n_i = 1'b0
  // breaks converters_at_zero_in_the_low_bits: dac_y_o = high[0] ? dac_y : 8'h80
  // breaks quiet_from_reset (lm628_output): u_q <= rst_i ? u_i : next
  // breaks reset_reaches_both_parts (lm628): reset_n_q <= next || reset_n_q
  // breaks one_part_alone_by_its_command_only (lm628): rst = rst_i || !reset_n_q || restart || !cs_n_i
  // breaks samples_coincide_from_a_common_reset (lm628_time): state_q <= rst_i ? state_d : next
  // breaks irq_is_that_of_either_part: irq_o = hi_o == '1
  // breaks limits_shown_2_clocks_later: limit_q <= limit_i
  // breaks not_ready_after_a_write: feed_ready = fed_q
  // breaks ready_by_a_result_only: fed_q <= !rst_i && (feed_valid || !feed_starts)
  // breaks next_is_the_least: next_o = next_y > next_o ? next_y : next_o
  // breaks quiescent_without_transfers_only: bus_idle = !asked && !s_axil_bvalid_o && !s_axil_rvalid_o
  // breaks quiescent_holds_the_pins: quiescent_o = bus_idle && bridge_quiescent && unused_quiescent == '1 && feed_quiescent && !feed_asked_q && !feeding_q && limit_i == limit_q

  // prove: cut lm628_engine qep feed_rate
  // prove: leap inv_in_flight inv_waits inv_pulse

endmodule

bind mcafee_xy mcafee_xy_props u_mcafee_xy_props (
    .*,
    .read_waits  (u_regs.axil_arvalid),
    .write_waits (u_regs.axil_awvalid && u_regs.axil_wvalid),
    .in_flight   (u_regs.axil_n_in_flight),
    .unanswered  (u_regs.axil_resp_wptr - u_regs.axil_resp_rptr),
    .rst_x       (u_x.rst),
    .rst_y       (u_y.rst),
    .restarts    ({u_y.restart, u_x.restart}),
    .reset_stages({u_y.reset_n_q, u_x.reset_n_q, u_y.reset_n_meta_q, u_x.reset_n_meta_q}),
    .time_x      ({u_x.u_time.u_part.count_q, 3'(u_x.u_time.state_q), u_x.u_time.rest_q}),
    .time_y      ({u_y.u_time.u_part.count_q, 3'(u_y.u_time.state_q), u_y.u_time.rest_q}),
    .feed_written(hwif_out.feed_in.c.swmod),
    .reset_pulse (hwif_out.reset.strobe.value),
    .limits      (limit_q)
);
