// SPDX-License-Identifier: Apache-2.0
//
// Properties of word_axil for any input. Transfers taken and not yet answered are kept beside the
// block, two of each direction at most.

module word_axil_props (
    input logic clk_i,
    input logic rst_i,

    input logic        s_axil_awvalid_i,
    input logic        s_axil_awready_o,
    input logic        s_axil_wvalid_i,
    input logic        s_axil_wready_o,
    input logic [31:0] s_axil_wdata_i,
    input logic [ 3:0] s_axil_wstrb_i,
    input logic        s_axil_bvalid_o,
    input logic        s_axil_bready_i,
    input logic        s_axil_arvalid_i,
    input logic        s_axil_arready_o,
    input logic        s_axil_rvalid_o,
    input logic        s_axil_rready_i,
    input logic [31:0] s_axil_rdata_o,

    input logic        write_o,
    input logic        read_o,
    input logic [31:0] data_o,
    input logic [ 3:0] bytes_o,
    input logic [31:0] data_i,
    input logic        quiescent_o,

    input logic [7:0] aw_word,  // of the pins, and of the words, widened
    input logic [7:0] ar_word,
    input logic [7:0] word,
    input logic [7:0] aw_kept,
    input logic [7:0] ar_kept,

    input logic aw_q,
    input logic w_q,
    input logic ar_q,
    input logic b_q,
    input logic r_q
);

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, was_b_q, was_r_q, was_write_q, was_read_q, was_takes_q;
  logic [31:0] was_data_q, was_rdata_q;
  logic [7:0] aw_word_q, ar_word_q;  // of the last address taken
  logic [35:0] w_q_q;  // of the last data taken
  logic [1:0] aws_q, ws_q, ars_q;  // taken and not answered
  logic takes_aw, takes_w, takes_ar, answers_write, answers_read;
  logic [3:0] waits, was_waits_q;

  assign takes_aw      = s_axil_awvalid_i && s_axil_awready_o;
  assign takes_w       = s_axil_wvalid_i && s_axil_wready_o;
  assign takes_ar      = s_axil_arvalid_i && s_axil_arready_o;
  assign answers_write = s_axil_bvalid_o && s_axil_bready_i;
  assign answers_read  = s_axil_rvalid_o && s_axil_rready_i;
  assign waits         = {s_axil_awready_o, s_axil_wready_o, s_axil_bvalid_o, s_axil_rvalid_o};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_b_q         <= !rst_i && s_axil_bvalid_o && !s_axil_bready_i;
    was_r_q         <= !rst_i && s_axil_rvalid_o && !s_axil_rready_i;
    was_write_q     <= !rst_i && write_o;
    was_read_q      <= !rst_i && read_o;
    was_takes_q     <= !rst_i && (takes_aw || takes_w || takes_ar);
    was_data_q      <= data_i;
    was_rdata_q     <= s_axil_rdata_o;
    was_waits_q     <= waits;
    if (takes_aw) aw_word_q <= aw_word;
    if (takes_ar) ar_word_q <= ar_word;
    if (takes_w) w_q_q <= {s_axil_wstrb_i, s_axil_wdata_i};
    aws_q <= aws_q + 2'(takes_aw) - 2'(answers_write);
    ws_q  <= ws_q + 2'(takes_w) - 2'(answers_write);
    ars_q <= ars_q + 2'(takes_ar) - 2'(answers_read);
    if (rst_i) {aws_q, ws_q, ars_q} <= '0;
    if (live_q) begin
      quiet_from_reset :
      assert (!was_rst_q || (!s_axil_bvalid_o && !s_axil_rvalid_o && !write_o && !read_o));
      response_of_a_write_stays_until_taken : assert (!was_b_q || was_rst_q || s_axil_bvalid_o);
      response_of_a_read_stays_until_taken :
      assert (!was_r_q || was_rst_q || (s_axil_rvalid_o && s_axil_rdata_o == was_rdata_q));
      responds_to_a_whole_write_only : assert (!s_axil_bvalid_o || (aws_q != '0 && ws_q != '0));
      responds_to_a_read_only : assert (!s_axil_rvalid_o || ars_q != '0);
      a_write_is_answered : assert (!was_write_q || was_rst_q || s_axil_bvalid_o);
      writes_what_was_asked :
      assert (!write_o || (word == aw_word_q && {bytes_o, data_o} == w_q_q));
      reads_where_it_was_asked : assert (!read_o || word == ar_word_q);
      gives_what_was_read :
      assert (!was_read_q || was_rst_q || (s_axil_rvalid_o && s_axil_rdata_o == was_data_q));
      one_access_at_a_time : assert (!(write_o && read_o));
      one_transfer_waits_beside_the_answer :
      assert (aws_q != 2'd3 && ws_q != 2'd3 && ars_q != 2'd3);
      quiescent_is_honest :
      assert (!was_quiescent_q || (waits == was_waits_q && s_axil_rdata_o == was_rdata_q &&
              !write_o && !read_o && !was_takes_q));
      inv_counts :
      assert (aws_q == 2'(aw_q) + 2'(b_q) && ws_q == 2'(w_q) + 2'(b_q) &&
              ars_q == 2'(ar_q) + 2'(r_q));
      inv_kept :
      assert ((!aw_q || aw_kept == aw_word_q) && (!ar_q || ar_kept == ar_word_q) &&
              (!w_q || {bytes_o, data_o} == w_q_q));
      reaches_a_write : cover (answers_write && bytes_o == 4'hc);
      reaches_a_read : cover (answers_read && s_axil_rdata_o != '0);
      reaches_both_waiting : cover (aw_q && w_q && ar_q && b_q && r_q);
    end
  end

  // breaks quiet_from_reset: b_q <= next || (rst_i && w_q)
  // breaks response_of_a_write_stays_until_taken: b_q <= next && !b_q
  // breaks response_of_a_read_stays_until_taken: rdata_q <= rst_i ? next : data_i
  // breaks responds_to_a_whole_write_only: write_o = w_q && !b_q
  // breaks responds_to_a_read_only: r_q <= next || (!rst_i && write_o)
  // breaks a_write_is_answered: b_q <= next && bytes_q != '0
  // breaks writes_what_was_asked: data_q <= rst_i || !s_axil_wvalid_i ? next : s_axil_wdata_i
  // breaks reads_where_it_was_asked: word_o = aw_q ? aw_word_q : ar_word_q
  // breaks gives_what_was_read: rdata_q <= read_o && b_q ? rdata_q : next
  // breaks one_access_at_a_time: read_o = ar_q && !r_q
  // breaks one_transfer_waits_beside_the_answer: s_axil_awready_o = 1'b1
  // breaks quiescent_is_honest: quiescent_o = !s_axil_awvalid_i && !s_axil_arvalid_i && !b_q && !r_q && !ar_q

endmodule

bind word_axil word_axil_props u_word_axil_props (
    .*,
    .aw_word(8'(s_axil_awaddr_i[Bits+1:2])),
    .ar_word(8'(s_axil_araddr_i[Bits+1:2])),
    .word   (8'(word_o)),
    .aw_kept(8'(aw_word_q)),
    .ar_kept(8'(ar_word_q))
);
