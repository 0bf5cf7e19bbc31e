// SPDX-License-Identifier: Apache-2.0
//
// The precision controller of both axes with the times of their encoder edges, behind its registers
// (docs/precision.md). Axis 0 is X, axis 1 is Y.
//
//   edges after that of a tick of the carrier
//   0          count and edge times taken, the law starts if CTRL.precision of an axis is set
//   229, 277   i_q* of both; done_o if the tick was one of the position too
//
// A register whose word the law keeps is read or written while the law rests: one clock after the
// request, acknowledged in the next.

module kung_precision
  import trammel_pkg::*;
  import kung_xy_regs_pkg::axis_regs__out_t;
(
    input logic clk_i,
    input logic clock_en_i,
    input logic [1:0] sense_en_i,  // of the domains of the encoders
    input logic rst_i,

    input logic   tick_cur_i,
    input logic   tick_pos_i,
    input phase_t phase_i,
    input logic   commit_i,

    input axis_regs__out_t [1:0] regs_i,
    input logic                  knot_read_i,
    output logic                 knot_ack_o,

    input logic   [1:0] edge_i,   // the count changes at this clock edge,
    input logic   [1:0] up_i,     // this way
    input count_t [1:0] count_i,  // of the last tick

    output kung_pkg::precision_t [1:0] axis_o,

    output logic       awake_o,
    output logic [1:0] sense_awake_o,
    output logic       timed_o,  // an edge is timed in this clock
    output logic       wake_regs_o
);

  logic clk;
  assign clk = clk_i & clock_en_i;

  // ---- encoders ----

  logic [1:0] enable, reset, timed, up, sense_quiescent;
  logic [1:0][3:0] ticks;
  logic [1:0][15:0] age;

  for (genvar n = 0; n < 2; n++) begin : gen_edge
    logic clk_sense;
    assign clk_sense = clk_i & sense_en_i[n];
    assign enable[n] = regs_i[n].ctrl.precision.value;
    assign reset[n]  = regs_i[n].ctrl.reset_model.value;
    assign timed[n]  = edge_i[n] && enable[n];

    edge_time u_edge_time (
        .clk_i      (clk_sense),
        .rst_i      (rst_i),
        .tick_i     (tick_cur_i),
        .phase_i    (phase_i),
        .filter_i   (regs_i[n].deadtime.qep_filter.value),
        .edge_i     (timed[n]),
        .up_i       (up_i[n]),
        .ticks_o    (ticks[n]),
        .age_o      (age[n]),
        .up_o       (up[n]),
        .quiescent_o(sense_quiescent[n])
    );
  end

  // ---- registers: one request at a time ----

  logic [1:0] part, data, counts_q, counts_d;
  logic request, we, we_q, waits_q, law_ack, ack;
  precision_pkg::address_t address;
  logic [31:0] wdata, rdata;

  // X answers for both, unless Y alone is on.
  always_comb begin
    request  = knot_read_i;
    address  = {!enable[0], precision_pkg::Knots};
    we       = 1'b0;
    wdata    = regs_i[0].prec_data.wr_data.value;
    for (int unsigned n = 0; n < 2; n++) begin
      part[n] = regs_i[n].prec_data.req && regs_i[n].prec_data.req_is_wr &&
          !(&regs_i[n].prec_data.wr_biten.value);
      data[n] = regs_i[n].prec_data.req && !part[n];
      if (data[n] || regs_i[n].prec_err.req || regs_i[n].err_sum.req || regs_i[n].iq_sum.req ||
          regs_i[n].prec_dist.req) begin
        request      = 1'b1;
        address[6]   = n[0];
        address[5:0] = data[n] ? {1'b0, regs_i[n].prec_addr.word.value} :
            regs_i[n].prec_err.req ? precision_pkg::E :
            regs_i[n].err_sum.req ? precision_pkg::ErrLast :
            regs_i[n].iq_sum.req ? precision_pkg::IqLast : precision_pkg::Dist;
      end
      if (data[n]) begin
        we    = regs_i[n].prec_data.req_is_wr;
        wdata = regs_i[n].prec_data.wr_data.value;
      end
    end
  end

  assign counts_d = request ? data : counts_q;
  assign ack      = law_ack && waits_q;

  // ---- law ----

  word_t [1:0] i_q;
  logic [1:0] saturated, clipped;
  logic busy, done, overrun, underrun, law_quiescent, pos_q;

  precision u_precision (
      .clk_i         (clk),
      .rst_i         (rst_i),
      .tick_i        (tick_cur_i),
      .tick_pos_i    (tick_pos_i),
      .enable_i      (enable),
      .reset_i       (reset),
      .commit_i      (commit_i),
      .count_i       (count_i),
      .ticks_i       (ticks),
      .age_i         (age),
      .up_i          (up),
      .request_i     (request),
      .request_we_i  (we),
      .request_addr_i(address),
      .request_data_i(wdata),
      .ack_o         (law_ack),
      .rdata_o       (rdata),
      .busy_o        (busy),
      .done_o        (done),
      .overrun_o     (overrun),
      .underrun_o    (underrun),
      .saturated_o   (saturated),
      .clipped_o     (clipped),
      .i_q_ref_o     (i_q),
      .quiescent_o   (law_quiescent)
  );

  always_ff @(posedge clk) begin
    if (rst_i) begin
      counts_q <= '0;
      waits_q  <= 1'b0;
      pos_q    <= 1'b0;
    end else begin
      counts_q <= counts_d;
      waits_q  <= request || waits_q && !law_ack;
      if (tick_cur_i && enable != '0 && !busy) pos_q <= tick_pos_i;
    end
  end

  always_ff @(posedge clk) if (request) we_q <= we;

  for (genvar n = 0; n < 2; n++) begin : gen_axis
    assign axis_o[n].enable    = enable[n];
    assign axis_o[n].done      = done && pos_q;
    assign axis_o[n].i_q_ref   = i_q[n];
    assign axis_o[n].saturated = saturated[n] && enable[n];
    assign axis_o[n].clipped   = clipped[n] && enable[n];
    assign axis_o[n].overrun   = overrun && enable[n];
    assign axis_o[n].underrun  = underrun && enable[n];
    assign axis_o[n].read      = ack && !we_q;
    assign axis_o[n].written   = ack && we_q || part[n];
    assign axis_o[n].counts    = ack && counts_q[n];
    assign axis_o[n].data      = rdata;
  end

  assign knot_ack_o    = ack && !we_q;
  assign awake_o       = !law_quiescent;
  assign sense_awake_o = ~sense_quiescent;
  assign timed_o       = timed != '0;
  assign wake_regs_o   = saturated != '0 || clipped != '0 || overrun || underrun;

  logic unused_regs;
  assign unused_regs = ^{regs_i[0], regs_i[1]};

endmodule
