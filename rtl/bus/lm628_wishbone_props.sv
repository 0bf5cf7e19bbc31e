// SPDX-License-Identifier: Apache-2.0
//
// Properties of lm628_wishbone for any input. A master that keeps a cycle as it is until its
// acknowledge is an antecedent (kept_q), not an assumption.

module lm628_wishbone_props (
    input logic clk_i,
    input logic rst_i,

    input logic        cyc_i,
    input logic        stb_i,
    input logic        we_i,
    input logic        adr_i,
    input logic        sel,  // of byte 0
    input logic [ 7:0] dat,
    input logic [31:0] dat_o,
    input logic        ack_o,
    input logic        irq_o,

    input logic       rd_n_o,
    input logic       wr_n_o,
    input logic       ps_o,
    input logic [7:0] d_o,
    input logic [7:0] d_i,
    input logic       hi_i,
    input logic       quiescent_o,

    input logic asks,
    input logic starts,
    input logic busy,
    input logic open_q,
    input logic ack_q,
    input logic [1:0] state,  // of u_host
    input logic host_write,
    input logic host_ps,
    input logic [7:0] host_d,
    input logic [5:0] count
);

  typedef struct packed {
    logic we;
    logic adr;
    logic sel;
    logic [7:0] dat;
  } cycle_t;

  cycle_t cycle, was_cycle_q;
  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, was_asks_q, was_ack_q, was_wr_q, was_rd_q, was_irq_q;
  logic kept_q;  // the cycle is as it was in the clock before, and has been from its first one on
  logic kept;
  logic given_up_q;  // the cycle of the last access was
  logic writes, reads;  // a strobe of the part ends
  logic [1:0] strobes_q;  // ended since the last acknowledge or begin of a cycle, up to 3
  logic wrote_q, wrote_ps_q;  // the last of them
  logic [7:0] byte_q, was_d_q, was_byte_q;
  logic [1:0] was_hi_q;
  logic [1:0] history_q;

  assign cycle  = '{we: we_i, adr: adr_i, sel: sel, dat: dat};
  // At its first clock, or as at its clock before.
  assign kept   = asks && (!was_asks_q || was_ack_q || (kept_q && cycle == was_cycle_q));
  assign writes = was_wr_q && wr_n_o;
  assign reads  = was_rd_q && rd_n_o;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_asks_q      <= !rst_i && asks;
    was_ack_q       <= !rst_i && ack_o;
    was_cycle_q     <= cycle;
    kept_q          <= !rst_i && kept;
    given_up_q      <= !rst_i && ((open_q && !asks) || (given_up_q && !ack_o));
    was_wr_q        <= !rst_i && !wr_n_o;
    was_rd_q        <= !rst_i && !rd_n_o;
    was_d_q         <= d_i;
    was_hi_q        <= {was_hi_q[0], hi_i};
    was_irq_q       <= irq_o;
    was_byte_q      <= dat_o[7:0];
    if (history_q != 2'd3) history_q <= history_q + 2'd1;
    if (!live_q) history_q <= '0;
    // Counts of a cycle: those of an earlier one that was given up end before it starts its own.
    if (rst_i || !asks || ack_o || starts) strobes_q <= '0;
    else if ((writes || reads) && open_q && strobes_q != 2'd3) strobes_q <= strobes_q + 2'd1;
    if (writes || reads) begin
      wrote_q    <= writes;
      wrote_ps_q <= ps_o;
      byte_q     <= writes ? d_o : was_d_q;
    end
    if (live_q) begin
      quiet_from_reset : assert (!was_rst_q || (!ack_o && rd_n_o && wr_n_o && dat_o == '0));
      acknowledges_a_cycle_only : assert (!ack_o || (cyc_i && stb_i));
      one_clock_of_acknowledge : assert (!ack_o || !was_ack_q);
      acknowledges_no_cycle_at_once : assert (!ack_o || was_asks_q);
      one_strobe_a_cycle :
      assert (!ack_o || !kept || strobes_q == (sel ? 2'd1 : 2'd0));
      no_write_is_lost :
      assert (!ack_o || !kept || !we_i || !sel ||
              (wrote_q && wrote_ps_q == adr_i && byte_q == dat));
      reads_what_the_part_gave :
      assert (!ack_o || !kept || we_i || !sel ||
              (!wrote_q && wrote_ps_q == adr_i && byte_q == dat_o[7:0]));
      upper_bytes_are_0 : assert (dat_o[31:8] == '0);
      starts_for_a_cycle_only : assert (!starts || (cyc_i && stb_i && sel && !busy));
      interrupt_is_hi_2_clocks_later : assert (history_q != 2'd3 || irq_o == was_hi_q[1]);
      quiescent_is_honest :
      assert (!was_quiescent_q || (!busy && !ack_q && irq_o == was_irq_q &&
                                   dat_o[7:0] == was_byte_q));
      inv_open : assert (!open_q || (busy && was_asks_q && !ack_q));
      inv_ack : assert (!ack_q || was_asks_q);
      inv_kept :
      assert (!kept_q || !open_q || (was_cycle_q.sel && host_write == was_cycle_q.we &&
              host_ps == was_cycle_q.adr && host_d == was_cycle_q.dat));
      inv_pins :
      assert (wr_n_o != (state == 2'd2 && host_write) && ps_o == host_ps && d_o == host_d &&
              rd_n_o != (state == 2'd2 && !host_write));
      inv_count : assert (state != 2'd3 || !(was_wr_q || was_rd_q) || count != '0);
      reaches_a_write : cover (ack_o && kept && we_i && sel);
      reaches_a_read : cover (ack_o && kept && !we_i && dat_o != '0);
      reaches_a_cycle_after_one_given_up : cover (starts && given_up_q);
    end
  end

  // breaks quiet_from_reset: ack_q <= next || (rst_i && asks)
  // breaks acknowledges_a_cycle_only: ack_o = ack_q
  // breaks one_clock_of_acknowledge: empty = asks && !open_q && !sel_i[0]
  // breaks acknowledges_no_cycle_at_once: ack_o = asks && (ack_q || (!open_q && !sel_i[0]))
  // breaks one_strobe_a_cycle: ack_q <= !rst_i && (empty || (open_q && asks && !rd_n_o))
  // breaks one_strobe_a_cycle: empty = asks && !open_q && !ack_q
  // breaks no_write_is_lost (lm628_host): d_q <= rst_i ? next : d_q
  // breaks no_write_is_lost: u_host.ps_i = 1'b0
  // breaks reads_what_the_part_gave (lm628_host): byte_q <= rst_i ? next : d_i
  // breaks upper_bytes_are_0: dat_o = {from_part, 16'd0, from_part}
  // breaks starts_for_a_cycle_only: starts = asks && !open_q && !ack_q && sel_i[0]
  // breaks interrupt_is_hi_2_clocks_later: hi_q <= hi_i
  // breaks quiescent_is_honest: quiescent_o = !ack_q && host_quiescent

  // prove: set ClockNs=20
  // prove: set ClockNs=50

endmodule

bind lm628_wishbone lm628_wishbone_props u_lm628_wishbone_props (
    .*,
    .sel       (sel_i[0]),
    .dat       (dat_i[7:0]),
    .state     (2'(u_host.state_q)),
    .host_write(u_host.write_q),
    .host_ps   (u_host.ps_q),
    .host_d    (u_host.d_q),
    .count     (u_host.count_q)
);
