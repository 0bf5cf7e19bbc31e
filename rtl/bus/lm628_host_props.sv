// SPDX-License-Identifier: Apache-2.0
//
// Properties of lm628_host for any input.

module lm628_host_props #(
    parameter int unsigned ClockNs = 20
) (
    input logic clk_i,
    input logic rst_i,

    input logic       start_i,
    input logic       busy_o,
    input logic       done_o,
    input logic       write_i,
    input logic       ps_i,
    input logic [7:0] byte_i,
    input logic [7:0] byte_o,

    input logic       cs_n_o,
    input logic       rd_n_o,
    input logic       wr_n_o,
    input logic       ps_o,
    input logic [7:0] d_o,
    input logic       drive_o,
    input logic [7:0] d_i,
    input logic       quiescent_o,

    input logic [1:0] state_q,
    input logic [5:0] count_q,
    input logic       write_q
);

  // Nanoseconds in clocks, rounded up.
  function automatic logic [5:0] clocks(int unsigned ns);
    return 6'((ns + ClockNs - 1) / ClockNs);
  endfunction

  localparam logic [5:0] Setup = clocks(30), Write = clocks(100), Read = clocks(180);
  localparam logic [5:0] WriteHold = clocks(120), ReadHold = clocks(180), Long = 6'd63;

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, was_write_strobe_q, was_read_strobe_q, strobe, was_strobe;
  logic [10:0] pins, was_pins_q;  // what must not change around a strobe
  logic [7:0] was_byte_q, was_d_q;
  logic [5:0] low_q, still_q, rest_q;  // clocks of a strobe, of unchanged pins, since a strobe
  logic wrote_q;  // the last strobe was WR
  logic open_q, asked_write_q, asked_ps_q;  // an access was begun and is not yet done; by what
  logic [7:0] asked_byte_q;
  logic struck_q;  // its strobe has been

  assign strobe     = !rd_n_o || !wr_n_o;
  assign was_strobe = was_write_strobe_q || was_read_strobe_q;
  assign pins       = {cs_n_o, drive_o, ps_o, d_o};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q          <= rst_i;
    was_quiescent_q    <= !rst_i && quiescent_o;
    was_write_strobe_q <= !rst_i && !wr_n_o;
    was_read_strobe_q  <= !rst_i && !rd_n_o;
    was_pins_q         <= pins;
    was_byte_q         <= byte_o;
    was_d_q            <= d_i;
    low_q              <= rst_i || !strobe ? '0 : low_q == Long ? Long : low_q + 6'd1;
    rest_q             <= rst_i ? Long : strobe ? '0 : rest_q == Long ? Long : rest_q + 6'd1;
    still_q            <= rst_i || pins != was_pins_q ? '0 : still_q == Long ? Long :
        still_q + 6'd1;
    if (strobe) wrote_q <= !wr_n_o;
    if (start_i && !busy_o) begin
      asked_write_q <= write_i;
      asked_ps_q    <= ps_i;
      asked_byte_q  <= byte_i;
    end
    open_q   <= !rst_i && ((start_i && !busy_o) || (open_q && !done_o));
    struck_q <= !rst_i && open_q && !done_o && (struck_q || strobe);
    if (live_q) begin
      quiet_from_reset :
      assert (!was_rst_q || (!strobe && cs_n_o && !drive_o && !busy_o && byte_o == '0));
      never_both_strobes : assert (rd_n_o || wr_n_o);
      strobes_with_cs_in_an_access_only : assert (!strobe || (!cs_n_o && busy_o));
      drives_for_writes_only : assert ((wr_n_o || drive_o) && (rd_n_o || !drive_o));
      set_up_30_ns :
      assert (!strobe || was_strobe || (pins == was_pins_q && still_q + 6'd1 >= Setup));
      wr_100_ns : assert (was_rst_q || !was_write_strobe_q || !wr_n_o || low_q == Write);
      rd_180_ns : assert (was_rst_q || !was_read_strobe_q || !rd_n_o || low_q == Read);
      strobes_end : assert (!strobe || low_q < (wr_n_o ? Read : Write));
      pins_stand_still_after_a_strobe :
      assert (was_rst_q || pins == was_pins_q ||
              (!strobe && rest_q >= (wrote_q ? WriteHold : ReadHold)));
      takes_the_byte_at_the_end_of_rd :
      assert (was_rst_q || byte_o == ((was_read_strobe_q && rd_n_o) ? was_d_q : was_byte_q));
      puts_out_what_was_asked :
      assert (!open_q || (ps_o == asked_ps_q && drive_o == asked_write_q && d_o == asked_byte_q));
      done_ends_an_access : assert (rst_i || !done_o || open_q);
      busy_is_an_access : assert (busy_o == open_q);
      done_after_its_strobe :
      assert (rst_i || !done_o || (struck_q && wrote_q == asked_write_q));
      one_strobe_an_access :
      assert (!strobe || (open_q && (was_strobe || !struck_q) && wr_n_o != asked_write_q));
      quiescent_is_honest :
      assert (!was_quiescent_q || (pins == was_pins_q && !strobe && !busy_o));
      inv_strobe : assert (strobe == (state_q == 2'd2) && busy_o == (state_q != 2'd0));
      inv_pins : assert (cs_n_o == !busy_o && drive_o == (busy_o && write_q));
      inv_write : assert (!open_q || write_q == asked_write_q);
      inv_setup :
      assert (state_q != 2'd1 || (count_q < Setup && (count_q + 6'd1 == Setup ||
              (pins == was_pins_q && still_q + 6'd2 + count_q >= Setup))));
      inv_low :
      assert (state_q != 2'd2 || count_q + low_q + 6'd1 == (write_q ? Write : Read));
      inv_rest :
      assert (state_q != 2'd3 || (wrote_q == write_q && struck_q &&
              count_q + rest_q + 6'd1 == (write_q ? WriteHold : ReadHold)));
      inv_struck : assert (state_q != 2'd1 || !struck_q);
      reaches_a_write : cover (done_o && asked_write_q);
      reaches_a_read : cover (done_o && !asked_write_q && byte_o != '0);
    end
  end

  // breaks quiet_from_reset: byte_q <= rst_i ? d_i : next
  // breaks never_both_strobes: reads_q <= !rst_i && state_d == StStrobe
  // breaks strobes_with_cs_in_an_access_only: cs_q <= next && state_d != StStrobe
  // breaks drives_for_writes_only: drive_q <= next && state_d != StStrobe
  // breaks set_up_30_ns: Setup = Setup - 6'd1
  // breaks wr_100_ns: Write = Write - 6'd1
  // breaks rd_180_ns: Read = Read - 6'd1
  // breaks strobes_end: Read = Read + 6'd1
  // breaks pins_stand_still_after_a_strobe: WriteHold = WriteHold - 6'd2
  // breaks pins_stand_still_after_a_strobe: d_q <= rst_i ? next : start_i ? byte_i : d_q
  // breaks takes_the_byte_at_the_end_of_rd: byte_q <= !rst_i && last && !write_q ? d_i : next
  // breaks puts_out_what_was_asked: ps_q <= next || (start_i && !rst_i)
  // breaks done_ends_an_access: done_o = last && state_q != StStrobe
  // breaks busy_is_an_access: busy_o = state_q != StIdle && !done_o
  // breaks done_after_its_strobe: done_o = state_q == StSetup && last
  // breaks one_strobe_an_access: writes_q <= next || (state_q == StHold && !last && write_q && !rst_i && count_q == 6'd2)
  // breaks quiescent_is_honest: quiescent_o = state_q == StIdle

  // prove: set ClockNs=20
  // prove: set ClockNs=50

endmodule

bind lm628_host lm628_host_props #(.ClockNs(ClockNs)) u_lm628_host_props (
    .*,
    .state_q(2'(state_q))
);
