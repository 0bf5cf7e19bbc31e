// SPDX-License-Identifier: Apache-2.0
//
// Properties of larson_xy for any input, on its bus and its pins; clocks passed by leaps count.

module larson_xy_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic        s_axil_bvalid_o,
    input logic        s_axil_rvalid_o,
    input logic [31:0] s_axil_rdata_o,
    input logic [ 1:0] limit_low_i,
    input logic [ 1:0] limit_high_i,
    input logic [ 1:0] step_o,
    input logic [ 1:0] forward_o,
    input logic [ 1:0] flush_o,
    input logic        irq_o,
    input gap_t        next_o,
    input logic        quiescent_o,

    input logic        write,
    input logic        read,
    input logic [ 1:0] word,
    input logic [ 3:0] bytes,
    input logic [31:0] written,
    input logic [31:0] x,
    input logic [31:0] y,
    input logic [15:0] err_byte,
    input logic [ 7:0] vector
);

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, was_read_q, was_busy_q;  // of X
  logic [1:0] was_word_q, was_step_q;
  logic [1:0] closed_q, closed_qq, closed_qqq;  // both switches, at the edges before
  logic [1:0] history_q;  // edges since live, up to 3
  logic [31:0] was_shown_q;
  logic [6:0] pins, was_pins_q;
  gap_t was_next_q, was_leap_q;

  assign pins = {step_o, forward_o, flush_o, irq_o};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_read_q      <= !rst_i && read;
    was_busy_q      <= x[28];
    was_word_q      <= word;
    was_step_q      <= step_o;
    was_shown_q     <= word == 2'd0 ? x : word == 2'd1 ? y : word == 2'd2 ? 32'(vector) :
        32'(err_byte);
    was_pins_q      <= pins;
    was_next_q      <= next_o;
    was_leap_q      <= leap_i;
    closed_q        <= limit_low_i & limit_high_i;
    closed_qq       <= closed_q;
    closed_qqq      <= closed_qq;
    if (!live_q) history_q <= '0;
    else if (history_q != 2'd3) history_q <= history_q + 2'd1;
    if (live_q) begin
      quiet_from_reset :
      assert (!was_rst_q || (!s_axil_bvalid_o && !s_axil_rvalid_o && !irq_o && step_o == '0 &&
              flush_o == '0));
      reads_the_word_of_its_address :
      assert (!was_read_q || was_rst_q || s_axil_rdata_o == was_shown_q);
      read_of_the_vector_is_the_grant :
      assert (!was_read_q || was_word_q != 2'd2 || was_rst_q || was_busy_q || vector != 8'o340);
      no_step_between_two_closed_switches :
      assert (history_q != 2'd3 || was_rst_q || (step_o & ~was_step_q & closed_qqq) == '0);
      latch_means_not_busy : assert (!(flush_o[0] && x[28]) && !(flush_o[1] && y[28]));
      quiescent_holds_the_pins :
      assert (!was_quiescent_q || was_next_q == '0 || was_leap_q >= was_next_q || rst_i ||
              pins == was_pins_q);
      reaches_a_step_of_y : cover (step_o[1]);
      reaches_an_interrupt : cover (irq_o);
      reaches_a_byte_write : cover (write && bytes == 4'd1 && written != '0);
    end
  end

  // breaks quiet_from_reset (step_channel): latch_q <= latch_d || rst_i
  // breaks reads_the_word_of_its_address: shown = word == 2'd1 ? x : shown
  // breaks read_of_the_vector_is_the_grant: u_table.grant_i = read && word == WordErrByte
  // breaks no_step_between_two_closed_switches (step_channel): trip = busy_q && forward_q && high_q
  // breaks latch_means_not_busy (step_channel): busy_d = busy_d || (trip && forward_q)
  // breaks quiescent_holds_the_pins: quiescent_o = bus_quiescent

endmodule

bind larson_xy larson_xy_props u_larson_xy_props (.*);
