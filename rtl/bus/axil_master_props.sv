// SPDX-License-Identifier: Apache-2.0
//
// Properties of axil_master for any input. A request must be held until its answer and a slave
// answers what it has accepted; where one did not since the reset, the promises that rest on it are
// not asked (fair_q).

module axil_master_props #(
    parameter int unsigned AddrBits = 10
) (
    input logic clk_i,
    input logic rst_i,

    input logic                valid_i,
    input logic                ready_o,
    input logic [AddrBits-1:0] addr_i,
    input logic [         3:0] wstrb_i,
    input logic [        31:0] wdata_i,

    input logic                m_axil_awvalid_o,
    input logic                m_axil_awready_i,
    input logic                m_axil_wvalid_o,
    input logic                m_axil_wready_i,
    input logic                m_axil_bvalid_i,
    input logic                m_axil_arvalid_o,
    input logic                m_axil_arready_i,
    input logic                m_axil_rvalid_i,

    input logic aw_done_q,
    input logic w_done_q,
    input logic ar_done_q
);

  logic live_q = 1'b0;
  logic fair_q;
  logic was_rst_q, was_held_q, was_aw_q, was_w_q, was_ar_q;  // offered, and not accepted
  logic [AddrBits-1:0] was_addr_q;
  logic [3:0] was_wstrb_q;
  logic [31:0] was_wdata_q;
  logic aw_q, w_q, ar_q;  // accepted since the last answer
  logic same, takes_aw, takes_w, takes_ar, write, unasked;

  assign write    = wstrb_i != '0;
  assign same     = valid_i && addr_i == was_addr_q && wstrb_i == was_wstrb_q &&
      wdata_i == was_wdata_q;
  assign takes_aw = m_axil_awvalid_o && m_axil_awready_i;
  assign takes_w  = m_axil_wvalid_o && m_axil_wready_i;
  assign takes_ar = m_axil_arvalid_o && m_axil_arready_i;
  // A response to what was not accepted in a clock before.
  assign unasked  = (m_axil_bvalid_i && !(aw_q && w_q)) || (m_axil_rvalid_i && !ar_q);

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q   <= rst_i;
    was_held_q  <= !rst_i && valid_i && !ready_o;
    was_aw_q    <= !rst_i && m_axil_awvalid_o && !m_axil_awready_i;
    was_w_q     <= !rst_i && m_axil_wvalid_o && !m_axil_wready_i;
    was_ar_q    <= !rst_i && m_axil_arvalid_o && !m_axil_arready_i;
    was_addr_q  <= addr_i;
    was_wstrb_q <= wstrb_i;
    was_wdata_q <= wdata_i;
    fair_q      <= rst_i || (fair_q && (!was_held_q || same) && !unasked);
    aw_q        <= !rst_i && !ready_o && (aw_q || takes_aw);
    w_q         <= !rst_i && !ready_o && (w_q || takes_w);
    ar_q        <= !rst_i && !ready_o && (ar_q || takes_ar);
    if (live_q) begin
      offers_nothing_unasked :
      assert (valid_i || !(m_axil_awvalid_o || m_axil_wvalid_o || m_axil_arvalid_o));
      offers_one_direction :
      assert (!(m_axil_awvalid_o || m_axil_wvalid_o) || (write && !m_axil_arvalid_o));
      offers_at_once :
      assert (rst_i || !valid_i || was_held_q || !fair_q ||
              (write ? m_axil_awvalid_o && m_axil_wvalid_o : m_axil_arvalid_o));
      offer_stays_until_accepted :
      assert (was_rst_q || !fair_q || !same ||
              ((!was_aw_q || m_axil_awvalid_o) && (!was_w_q || m_axil_wvalid_o) &&
               (!was_ar_q || m_axil_arvalid_o)));
      accepted_once :
      assert (!(m_axil_awvalid_o && aw_q) && !(m_axil_wvalid_o && w_q) &&
              !(m_axil_arvalid_o && ar_q));
      answers_what_was_accepted :
      assert (!fair_q || unasked || !ready_o || (write ? aw_q && w_q : ar_q));
      inv_done : assert (aw_done_q == aw_q && w_done_q == w_q && ar_done_q == ar_q);
      inv_idle : assert (was_rst_q || !fair_q || was_held_q || !(aw_q || w_q || ar_q));
      reaches_a_write : cover (fair_q && ready_o && write && aw_q && w_q);
      reaches_a_read : cover (fair_q && ready_o && !write && ar_q);
      reaches_data_before_address : cover (fair_q && m_axil_awvalid_o && w_q);
    end
  end

  // breaks offers_nothing_unasked: m_axil_arvalid_o = !write && !ar_done_q
  // breaks offers_one_direction: m_axil_wvalid_o = valid_i && !w_done_q
  // breaks offers_at_once: m_axil_wvalid_o = valid_i && write && !w_done_q && aw_done_q
  // breaks offer_stays_until_accepted: w_done_q <= next || (m_axil_awvalid_o && m_axil_awready_i && !rst_i && !ready_o)
  // breaks accepted_once: aw_done_q <= next && m_axil_wready_i
  // breaks answers_what_was_accepted: ready_o = valid_i && (m_axil_bvalid_i || m_axil_rvalid_i || m_axil_awready_i)

  // prove: set AddrBits=10

endmodule

bind axil_master axil_master_props #(.AddrBits(AddrBits)) u_axil_master_props (.*);
