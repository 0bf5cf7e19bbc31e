// SPDX-License-Identifier: Apache-2.0
//
// Properties of lm628_bridge for any input; clocks passed by leaps count.

module lm628_bridge_props
  import trammel_pkg::*;
#(
    parameter int unsigned Pulse = 275
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic       write_strobe_i,
    input logic       read_strobe_i,
    input logic       ps_i,
    input logic       read_i,
    input logic       y_i,
    input logic [7:0] to_part_i,
    input logic [7:0] from_part_o,
    input logic       busy_o,
    input logic       refused_o,

    input logic       cs_x_n_o,
    input logic       cs_y_n_o,
    input logic       rd_n_o,
    input logic       wr_n_o,
    input logic       ps_o,
    input logic [7:0] d_o,
    input logic       transceiver_o,
    input logic       selector_o,
    input logic [7:0] d_x_i,
    input logic [7:0] d_y_i,

    input gap_t next_o,
    input logic quiescent_o,

    input logic [1:0] state_q,
    input logic [8:0] count,
    input logic       change_q,
    input logic       start
);

  localparam logic [9:0] Low = 10'(Pulse), Long = 10'd1000;

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, was_rest_q;
  logic was_write_q, was_read_q, write_rose, read_rose;  // strobe bits
  logic was_strobe_q, strobe, was_wr_n_q;
  logic [12:0] pins, was_pins_q;  // what must not change around a strobe
  logic [12:0] ports, was_ports_q;
  logic [7:0] was_byte_q, was_x_q, was_y_q;
  logic [12:0] passed;
  logic allowed, exact_q;  // no leap beyond next_o since the last start
  logic [9:0] low_q, still_q, rest_q;  // clocks of a strobe, with unchanged pins, since a strobe
  logic [24:0] state, was_state_q;

  assign strobe     = !rd_n_o || !wr_n_o;
  assign pins       = {cs_x_n_o, cs_y_n_o, transceiver_o, selector_o, ps_o, d_o};
  assign ports      = {y_i, !y_i, !read_i, read_i, ps_i, to_part_i};
  assign write_rose = write_strobe_i && !was_write_q;
  assign read_rose  = read_strobe_i && !was_read_q;
  assign passed     = 13'(leap_i) + 13'd1;
  assign allowed    = leap_i == '0 || leap_i < next_o;
  assign state      = {pins, rd_n_o, wr_n_o, from_part_o, state_q};

  function automatic logic [9:0] more(logic [9:0] clocks, logic [12:0] by);
    return 13'(clocks) + by > 13'(Long) ? Long : clocks + 10'(by);
  endfunction

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_rest_q      <= !rst_i && state_q == 2'd0;
    was_write_q     <= !rst_i && write_strobe_i;
    was_read_q      <= !rst_i && read_strobe_i;
    was_strobe_q    <= !rst_i && strobe;
    was_wr_n_q      <= wr_n_o;
    was_pins_q      <= pins;
    was_ports_q     <= ports;
    was_byte_q      <= from_part_o;
    was_x_q         <= d_x_i;
    was_y_q         <= d_y_i;
    was_state_q     <= state;
    low_q           <= !rst_i && strobe ? more(low_q, passed) : '0;
    rest_q          <= rst_i || !live_q ? Long : strobe ? '0 : more(rest_q, passed);
    still_q         <= rst_i || pins != was_pins_q ? '0 : more(still_q, passed);
    exact_q         <= state_q == 2'd0 || (exact_q && allowed);
    if (live_q) begin
      quiet_from_reset :
      assert (!was_rst_q || (!strobe && state_q == '0 && pins == 13'h0C00 && from_part_o == '0));
      never_both_selected : assert (cs_x_n_o || cs_y_n_o);
      never_both_drive : assert (!(transceiver_o && selector_o));
      off_for_a_clock_between :
      assert (was_rst_q || !((transceiver_o && was_pins_q[9]) || (selector_o && was_pins_q[10]) ||
              (!cs_x_n_o && !was_pins_q[11]) || (!cs_y_n_o && !was_pins_q[12])));
      never_both_strobes : assert (rd_n_o || wr_n_o);
      strobes_in_their_direction_only :
      assert ((wr_n_o || transceiver_o) && (rd_n_o || selector_o) &&
              (!strobe || cs_x_n_o != cs_y_n_o));
      pulse_is_exact :
      assert (was_rst_q || !exact_q || !was_strobe_q || strobe || low_q == Low);
      pulse_ends : assert (!exact_q || low_q < Low || !strobe);
      set_up_for_2_clocks :
      assert (!strobe || was_strobe_q || (pins == was_pins_q && still_q >= 10'd1));
      pins_stand_still_for_9_clocks_after :
      assert (was_rst_q || !exact_q || pins == was_pins_q || (!strobe && rest_q >= 10'd9));
      every_strobe_starts_or_is_refused :
      assert (rst_i || !(write_rose || read_rose) || start || refused_o);
      starts_at_rest_by_its_own_strobe :
      assert (rst_i || !start || (state_q == 2'd0 && (read_i ? read_rose : write_rose)));
      refuses_what_it_does_not_start :
      assert (rst_i || refused_o == ((write_rose && !(start && !read_i)) ||
                                     (read_rose && !(start && read_i))));
      busy_from_start_to_end : assert (busy_o == (start || state_q != 2'd0));
      no_pulse_at_rest : assert (state_q != 2'd0 || !strobe);
      takes_the_byte_at_the_end_of_rd :
      assert (was_rst_q || (from_part_o == was_byte_q) ||
              (was_strobe_q && was_wr_n_q && !strobe));
      takes_that_of_the_selected_part :
      assert (was_rst_q || !(was_strobe_q && was_wr_n_q && !strobe) ||
              from_part_o == (cs_x_n_o ? was_y_q : was_x_q));
      pins_follow_the_ports_at_rest :
      assert (was_rst_q || !was_rest_q || (ps_o == was_ports_q[8] && d_o == was_ports_q[7:0] &&
              (change_q || pins == was_ports_q)));
      quiescent_is_honest :
      assert (!was_quiescent_q || state == was_state_q);
      inv_strobes :
      assert (strobe == (state_q == 2'd2) && (!change_q || state_q < 2'd2));
      inv_count :
      assert (!exact_q || state_q != 2'd2 || 10'(count) + low_q + 10'd1 == Low);
      inv_hold :
      assert (!exact_q || state_q != 2'd3 || 10'(count) + rest_q == 10'd8);
      inv_setup :
      assert (state_q != 2'd1 || (count <= 9'd1 && (!change_q || count == 9'd1)));
      inv_still :
      assert (state_q != 2'd1 || change_q || count == 9'd1 ||
              (count == '0 && pins == was_pins_q));
      reaches_a_write : cover (!rst_i && was_strobe_q && !was_wr_n_q && !strobe);
      reaches_a_read : cover (was_strobe_q && was_wr_n_q && !strobe && from_part_o != '0);
      reaches_a_refusal : cover (refused_o && state_q == 2'd2);
    end
  end

  // breaks quiet_from_reset: byte_q <= rst_i ? d_x_i : next
  // breaks never_both_selected: cs_y_n_o = 1'b0
  // breaks never_both_drive: selector_o = read_i && !change_q
  // breaks off_for_a_clock_between: change_q <= next && read_i
  // breaks never_both_strobes: reads_q <= !rst_i && state_d == StPulse
  // breaks strobes_in_their_direction_only: writes_q <= !rst_i && state_d == StPulse && !read_i
  // breaks pulse_is_exact: Low = Low - 9'd1
  // breaks pulse_ends: Low = Low + 9'd1
  // breaks set_up_for_2_clocks: value = state_q == StSetup && change_q ? '0 : value
  // breaks set_up_for_2_clocks: Setup = 9'd0
  // breaks pins_stand_still_for_9_clocks_after: Hold = 9'd6
  // breaks pins_stand_still_for_9_clocks_after: pins_q <= state_q == StHold && !rst_i ? ports : next
  // breaks every_strobe_starts_or_is_refused, refuses_what_it_does_not_start: refused_o = (write_rises && read_i) || (read_rises && !(start && read_i))
  // breaks starts_at_rest_by_its_own_strobe: write_rises = write_strobe_i
  // breaks busy_from_start_to_end: busy_o = state_q != StRest
  // breaks no_pulse_at_rest: reads_q <= next || (state_q == StHold && pins_q.read && !rst_i)
  // breaks takes_the_byte_at_the_end_of_rd: byte_q <= last && pins_q.read && !rst_i ? (pins_q.y ? d_y_i : d_x_i) : next
  // breaks takes_that_of_the_selected_part: byte_q <= reads_q && last && !rst_i ? (y_i ? d_y_i : d_x_i) : next
  // breaks pins_follow_the_ports_at_rest: pins_q <= start || rst_i ? next : pins_q
  // breaks quiescent_is_honest: quiescent_o = !change_q && write_strobe_i == write_was_q && read_strobe_i == read_was_q && (state_q == StRest || !last)

  // prove: set Pulse=275
  // prove: leap inv_strobes strobes_in_their_direction_only

endmodule

bind lm628_bridge lm628_bridge_props #(.Pulse(Pulse)) u_lm628_bridge_props (
    .*,
    .state_q(2'(state_q))
);
