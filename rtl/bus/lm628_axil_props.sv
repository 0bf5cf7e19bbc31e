// SPDX-License-Identifier: Apache-2.0
//
// Properties of lm628_axil for any input. What was taken and not yet answered is kept beside the
// block, two transfers of each direction at most: the oldest is the one that an access of the part
// and a response are of.

module lm628_axil_props (
    input logic clk_i,
    input logic rst_i,

    input logic        s_axil_awvalid_i,
    input logic        s_axil_awready_o,
    input logic        s_axil_wvalid_i,
    input logic        s_axil_wready_o,
    input logic        s_axil_bvalid_o,
    input logic        s_axil_bready_i,
    input logic        s_axil_arvalid_i,
    input logic        s_axil_arready_o,
    input logic        s_axil_rvalid_o,
    input logic        s_axil_rready_i,
    input logic [31:0] s_axil_rdata_o,
    input logic        irq_o,

    input logic       rd_n_o,
    input logic       wr_n_o,
    input logic       ps_o,
    input logic [7:0] d_o,
    input logic [7:0] d_i,
    input logic       hi_i,
    input logic       quiescent_o,

    input logic       aw_ps,  // of the address
    input logic       ar_ps,
    input logic       lane,   // byte 0 of a write
    input logic [7:0] data,

    input logic aw_q,
    input logic w_q,
    input logic ar_q,
    input logic b_q,
    input logic r_q,
    input logic aw_ps_q,
    input logic ar_ps_q,
    input logic w_lane_q,
    input logic [7:0] w_byte_q,
    input logic writing_q,
    input logic can_write,
    input logic can_read,
    input logic begins_write,
    input logic begins_read,
    input logic busy,
    input logic [1:0] state,  // of u_host
    input logic host_write,
    input logic host_ps,
    input logic [7:0] host_d
);

  typedef struct packed {
    logic lane;
    logic [7:0] data;
  } write_t;

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, was_irq_q, was_wr_q, was_rd_q;
  logic was_b_q, was_r_q;  // a response was not taken
  logic [7:0] was_d_q, was_data_q;
  logic [1:0] was_hi_q, history_q;
  logic [1:0] aws_q, ws_q, ars_q;  // taken and not answered
  logic aw_first_q, aw_second_q, ar_first_q, ar_second_q;
  write_t w_first_q, w_second_q;
  logic takes_aw, takes_w, takes_ar, answers_write, answers_read;
  logic writes, reads;  // a strobe of the part ends
  logic written_q, read_q;  // that of the oldest has
  logic [7:0] byte_q;
  logic write_passed_q, read_passed_q;  // by an access of the other direction, while it could begin

  assign takes_aw      = s_axil_awvalid_i && s_axil_awready_o;
  assign takes_w       = s_axil_wvalid_i && s_axil_wready_o;
  assign takes_ar      = s_axil_arvalid_i && s_axil_arready_o;
  assign answers_write = s_axil_bvalid_o && s_axil_bready_i;
  assign answers_read  = s_axil_rvalid_o && s_axil_rready_i;
  assign writes        = was_wr_q && wr_n_o;
  assign reads         = was_rd_q && rd_n_o;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_irq_q       <= irq_o;
    was_wr_q        <= !rst_i && !wr_n_o;
    was_rd_q        <= !rst_i && !rd_n_o;
    was_b_q         <= !rst_i && s_axil_bvalid_o && !s_axil_bready_i;
    was_r_q         <= !rst_i && s_axil_rvalid_o && !s_axil_rready_i;
    was_d_q         <= d_i;
    was_data_q      <= s_axil_rdata_o[7:0];
    was_hi_q        <= {was_hi_q[0], hi_i};
    if (history_q != 2'd3) history_q <= history_q + 2'd1;
    if (!live_q) history_q <= '0;

    aws_q <= aws_q + 2'(takes_aw) - 2'(answers_write);
    ws_q  <= ws_q + 2'(takes_w) - 2'(answers_write);
    ars_q <= ars_q + 2'(takes_ar) - 2'(answers_read);
    if (answers_write) begin
      aw_first_q <= aw_second_q;
      w_first_q  <= w_second_q;
    end
    if (answers_read) ar_first_q <= ar_second_q;
    if (takes_aw && aws_q == 2'(answers_write)) aw_first_q <= aw_ps;
    if (takes_aw && aws_q != 2'(answers_write)) aw_second_q <= aw_ps;
    if (takes_w && ws_q == 2'(answers_write)) w_first_q <= '{lane: lane, data: data};
    if (takes_w && ws_q != 2'(answers_write)) w_second_q <= '{lane: lane, data: data};
    if (takes_ar && ars_q == 2'(answers_read)) ar_first_q <= ar_ps;
    if (takes_ar && ars_q != 2'(answers_read)) ar_second_q <= ar_ps;

    written_q <= !answers_write && (written_q || writes);
    read_q    <= !answers_read && (read_q || reads);
    if (reads) byte_q <= was_d_q;
    write_passed_q <= !begins_write && (write_passed_q || (begins_read && can_write));
    read_passed_q  <= !begins_read && (read_passed_q || (begins_write && can_read));
    if (rst_i) begin
      {aws_q, ws_q, ars_q, written_q, read_q, write_passed_q, read_passed_q} <= '0;
    end
    if (live_q) begin
      quiet_from_reset :
      assert (!was_rst_q || (!s_axil_bvalid_o && !s_axil_rvalid_o && rd_n_o && wr_n_o));
      response_of_a_write_stays_until_taken : assert (!was_b_q || was_rst_q || s_axil_bvalid_o);
      response_of_a_read_stays_until_taken :
      assert (!was_r_q || was_rst_q || (s_axil_rvalid_o && s_axil_rdata_o[7:0] == was_data_q));
      responds_to_a_whole_write_only : assert (!s_axil_bvalid_o || (aws_q != '0 && ws_q != '0));
      responds_to_a_read_only : assert (!s_axil_rvalid_o || ars_q != '0);
      writes_what_was_asked :
      assert (was_rst_q || !writes || (aws_q != '0 && ws_q != '0 && w_first_q.lane &&
              ps_o == aw_first_q && d_o == w_first_q.data));
      no_write_is_lost : assert (!s_axil_bvalid_o || written_q == w_first_q.lane);
      no_write_twice : assert (was_rst_q || !writes || !written_q);
      reads_where_it_was_asked :
      assert (was_rst_q || !reads || (ars_q != '0 && ps_o == ar_first_q));
      no_read_twice : assert (was_rst_q || !reads || !read_q);
      gives_what_the_part_gave :
      assert (!s_axil_rvalid_o || (read_q && s_axil_rdata_o == {24'd0, byte_q}));
      one_transfer_waits_beside_the_oldest :
      assert (aws_q != 2'd3 && ws_q != 2'd3 && ars_q != 2'd3);
      directions_take_turns :
      assert (rst_i || !((begins_write && can_read && read_passed_q) ||
                         (begins_read && can_write && write_passed_q)));
      interrupt_is_hi_2_clocks_later : assert (history_q != 2'd3 || irq_o == was_hi_q[1]);
      quiescent_is_honest :
      assert (!was_quiescent_q || (!busy && !s_axil_bvalid_o && !s_axil_rvalid_o &&
              irq_o == was_irq_q && s_axil_rdata_o[7:0] == was_data_q));
      inv_counts :
      assert (aws_q == 2'(aw_q) + 2'(busy && writing_q) + 2'(b_q) &&
              ws_q == 2'(w_q) + 2'(busy && writing_q) + 2'(b_q) &&
              ars_q == 2'(ar_q) + 2'(busy && !writing_q) + 2'(r_q));
      inv_one_of_each : assert (!busy || (writing_q ? !b_q : !r_q));
      inv_waits :
      assert ((!aw_q || aw_ps_q == (aws_q == 2'd1 ? aw_first_q : aw_second_q)) &&
              (!w_q || {w_lane_q, w_byte_q} == (ws_q == 2'd1 ? w_first_q : w_second_q)) &&
              (!ar_q || ar_ps_q == (ars_q == 2'd1 ? ar_first_q : ar_second_q)));
      inv_runs :
      assert (!busy || (host_write == writing_q &&
              (writing_q ? w_first_q == {1'b1, host_d} && aw_first_q == host_ps
                         : ar_first_q == host_ps)));
      inv_pins :
      assert (wr_n_o != (state == 2'd2 && host_write) && ps_o == host_ps && d_o == host_d &&
              rd_n_o != (state == 2'd2 && !host_write));
      inv_written :
      assert ((written_q || (writes && !was_rst_q)) ==
              ((busy && writing_q && state == 2'd3) || (b_q && w_first_q.lane)));
      inv_read :
      assert ((read_q || (reads && !was_rst_q)) == ((busy && !writing_q && state == 2'd3) || r_q));
      inv_byte :
      assert (was_rst_q || !(read_q || reads) ||
              s_axil_rdata_o[7:0] == (reads ? was_d_q : byte_q));
      inv_passed :
      assert ((!read_passed_q || (can_read && ((busy && writing_q) || b_q))) &&
              (!write_passed_q || (can_write && ((busy && !writing_q) || r_q))));
      reaches_a_write : cover (answers_write && written_q);
      reaches_a_write_of_nothing : cover (answers_write && !written_q);
      reaches_a_read : cover (answers_read && byte_q != '0);
      reaches_both_waiting : cover (begins_read && aw_q && w_q);
    end
  end

  // breaks quiet_from_reset: b_q <= next || (rst_i && w_q)
  // breaks response_of_a_write_stays_until_taken: b_q <= next && !b_q
  // breaks response_of_a_read_stays_until_taken: r_q <= next && !r_q
  // breaks response_of_a_read_stays_until_taken: can_read = ar_q
  // breaks responds_to_a_whole_write_only: can_write = w_q && !b_q
  // breaks responds_to_a_read_only: r_q <= next || (!rst_i && done)
  // breaks writes_what_was_asked: w_byte_q <= rst_i || !s_axil_wvalid_i ? next : s_axil_wdata_i[7:0]
  // breaks writes_what_was_asked: start = begins_write || begins_read
  // breaks no_write_is_lost: b_q <= next || (begins_write && !rst_i)
  // breaks no_write_twice: done = done && !(writing_q && s_axil_wvalid_i)
  // breaks reads_where_it_was_asked: ar_ps_q <= rst_i || !s_axil_arvalid_i ? next : s_axil_araddr_i[2]
  // breaks no_read_twice: done = done && (writing_q || !s_axil_wvalid_i)
  // breaks gives_what_the_part_gave (lm628_host): byte_q <= rst_i ? next : d_i
  // breaks one_transfer_waits_beside_the_oldest: s_axil_awready_o = 1'b1
  // breaks directions_take_turns: can_write = aw_q && w_q
  // breaks interrupt_is_hi_2_clocks_later: hi_q <= hi_i
  // breaks quiescent_is_honest: quiescent_o = !b_q && !r_q && host_quiescent && hi_i == hi_meta_q && hi_meta_q == hi_q

  // prove: set ClockNs=20
  // prove: set ClockNs=50

endmodule

bind lm628_axil lm628_axil_props u_lm628_axil_props (
    .*,
    .aw_ps     (s_axil_awaddr_i[2]),
    .ar_ps     (s_axil_araddr_i[2]),
    .lane      (s_axil_wstrb_i[0]),
    .data      (s_axil_wdata_i[7:0]),
    .state     (2'(u_host.state_q)),
    .host_write(u_host.write_q),
    .host_ps   (u_host.ps_q),
    .host_d    (u_host.d_q)
);
