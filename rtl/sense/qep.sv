// SPDX-License-Identifier: Apache-2.0
//
// Quadrature encoder: synchroniser, filter, x4 decoder, 24-bit counter (specification section 9).
//
//   clocks  stage
//   2       synchroniser: two flip-flops per line
//   N       a line changes after N equal samples, N = filter_i, 0 acts as 1
//   1       decoder and counter: A leads B counts up, 00 10 11 01
//
// For three clocks after reset the lines are adopted as they stand: no count, no error.

module qep
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic [3:0] filter_i,
    input logic       preset_i,
    input count_t     preset_value_i,
    input logic       clear_error_i,

    input logic enc_a_i,
    input logic enc_b_i,
    input logic enc_z_i,

    output count_t count_o,
    output logic   dir_o,
    output logic   edge_o,         // the count goes on by one at this clock edge,
    output logic   up_o,           // this way
    output count_t index_latch_o,
    output logic   index_seen_o,
    output logic   error_o,
    output logic   quiescent_o
);

  // Bit order of all line vectors: Z, B, A.
  localparam int unsigned A = 0;
  localparam int unsigned B = 1;
  localparam int unsigned Z = 2;

  logic [2:0] pin, meta_q, sync_q, line_q, prev_q;
  logic [2:0] start_q, held;
  logic [3:0] last;
  logic       live;

  assign pin  = {enc_z_i, enc_b_i, enc_a_i};
  assign last = filter_i == 4'd0 ? 4'd0 : filter_i - 4'd1;
  assign live = start_q[2];

  always_ff @(posedge clk_i) begin
    meta_q <= pin;
    sync_q <= meta_q;
    if (rst_i) start_q <= '0;
    else start_q <= {start_q[1:0], 1'b1};
  end

  for (genvar i = 0; i < 3; i++) begin : gen_line
    logic [3:0] same_q;  // samples so far that differ from line_q

    always_ff @(posedge clk_i) begin
      if (rst_i || !live) begin
        line_q[i] <= sync_q[i];
        same_q    <= '0;
      end else if (sync_q[i] == line_q[i]) begin
        same_q <= '0;
      end else if (same_q >= last) begin
        line_q[i] <= sync_q[i];
        same_q    <= '0;
      end else begin
        same_q <= same_q + 4'd1;
      end
    end

    assign held[i] = same_q != '0;
  end

  logic step, both, up, index;
  count_t count_d, count_q, latch_q;
  logic dir_q, seen_q, error_q;

  assign step  = live && (line_q[A] != prev_q[A]) != (line_q[B] != prev_q[B]);
  assign both  = live && line_q[A] != prev_q[A] && line_q[B] != prev_q[B];
  assign up    = line_q[A] != prev_q[B];
  assign index = live && line_q[Z] && !prev_q[Z];

  always_comb begin
    count_d = count_q;
    if (preset_i) count_d = preset_value_i;
    else if (step) count_d = count_q + {{23{!up}}, 1'b1};
  end

  always_ff @(posedge clk_i) begin
    prev_q <= live ? line_q : sync_q;
    if (rst_i) begin
      count_q <= '0;
      latch_q <= '0;
      dir_q   <= 1'b0;
      seen_q  <= 1'b0;
      error_q <= 1'b0;
    end else begin
      count_q <= count_d;
      if (step) dir_q <= up;
      if (index) latch_q <= count_d;
      // An event is not lost to a clear in the same clock.
      seen_q  <= index || (seen_q && !clear_error_i);
      error_q <= both || (error_q && !clear_error_i);
    end
  end

  assign count_o       = count_q;
  assign dir_o         = dir_q;
  assign edge_o        = step && !preset_i;
  assign up_o          = up;
  assign index_latch_o = latch_q;
  assign index_seen_o  = seen_q;
  assign error_o       = error_q;

  assign quiescent_o = live && pin == meta_q && meta_q == sync_q && sync_q == line_q &&
      line_q == prev_q && held == '0 && !preset_i && !(clear_error_i && (seen_q || error_q));

endmodule
