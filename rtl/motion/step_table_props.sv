// SPDX-License-Identifier: Apache-2.0
//
// Properties of step_table for any input.

module step_table_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic        write_i,
    input logic        y_i,
    input logic [ 3:0] bytes_i,
    input logic [31:0] data_i,
    input logic        grant_i,

    input logic [ 1:0] step_o,
    input logic [31:0] x_o,
    input logic [31:0] y_o,
    input logic [15:0] err_byte_o,
    input logic        irq_o,
    input logic [ 7:0] vector_o,
    input gap_t        next_o,
    input logic        quiescent_o,

    input logic [1:0] irq,
    input gap_t       next_x,
    input gap_t       next_y
);

  logic live_q = 1'b0;
  logic was_rst_q, was_write_q, was_y_q, was_grant_q;
  logic was_quiescent_q;  // and no event of a timer
  logic [66:0] was_held_q;
  logic [3:0] was_bytes_q;
  logic [31:0] was_data_q, was_x_q, was_y_word_q;
  logic [15:0] was_err_q;
  logic [1:0] was_irq_q;

  localparam logic [31:0] Kept = 32'hAFFF_0000;  // moved by writes only: enable, direction, rate

  function automatic logic half(logic [3:0] bytes);
    return bytes[0] != bytes[1] || bytes[2] != bytes[3];
  endfunction

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_quiescent_q <= !rst_i && quiescent_o && leap_i < next_o;
    was_held_q      <= {x_o, y_o, step_o, irq_o};
    was_rst_q       <= rst_i;
    was_write_q     <= !rst_i && write_i;
    was_y_q         <= y_i;
    was_grant_q     <= !rst_i && grant_i;
    was_bytes_q     <= bytes_i;
    was_data_q      <= data_i;
    was_x_q         <= x_o;
    was_y_word_q    <= y_o;
    was_err_q       <= err_byte_o;
    was_irq_q       <= rst_i ? '0 : irq;
    if (live_q) begin
      counts_rest_at_minus_zero :
      assert (!was_rst_q || (x_o[15:0] == '1 && y_o[15:0] == '1 && !irq_o && step_o == '0));
      whole_status_words_only :
      assert (was_rst_q ||
              (((x_o ^ (was_write_q && !was_y_q && was_bytes_q[3:2] == '1 ?
                        was_data_q : was_x_q)) & Kept) == '0 &&
               ((y_o ^ (was_write_q && was_y_q && was_bytes_q[3:2] == '1 ?
                        was_data_q : was_y_word_q)) & Kept) == '0));
      whole_counts_are_written :
      assert (!was_write_q || was_bytes_q[1:0] != '1 ||
              (was_y_q ? y_o[15:0] : x_o[15:0]) == was_data_q[15:0]);
      halves_are_counted :
      assert (was_rst_q || err_byte_o == (was_err_q == '1 ? was_err_q :
              was_err_q + 16'(was_write_q && half(was_bytes_q))));
      irq_names_its_vector :
      assert (irq_o == (vector_o != '0) && irq_o == (irq != '0));
      x_goes_first : assert (vector_o == (irq[0] ? 8'o340 : irq[1] ? 8'o344 : 8'd0));
      y_waits_for_x :
      assert (!was_grant_q || was_irq_q != '1 || was_write_q || irq[1]);
      next_is_the_least :
      assert (next_o <= next_x && next_o <= next_y && (next_o == next_x || next_o == next_y));
      quiescent_is_honest :
      assert (!was_quiescent_q || {x_o, y_o, step_o, irq_o} == was_held_q);
      reaches_both_requests : cover (irq == '1 && !was_rst_q);
      reaches_a_step : cover (step_o == 2'b10);
      reaches_an_error : cover (err_byte_o == 16'd2);
    end
  end

  // breaks counts_rest_at_minus_zero (step_channel): count_q <= rst_i ? '0 : next
  // breaks whole_status_words_only: status_whole = bytes_i[3]
  // breaks whole_counts_are_written: count_whole = bytes_i == '1
  // breaks halves_are_counted: broken = bytes_i[0] != bytes_i[1]
  // breaks irq_names_its_vector: irq_o = irq[0]
  // breaks x_goes_first: vector_o = irq[1] ? VectorY : irq[0] ? VectorX : '0
  // breaks y_waits_for_x: grant = {grant_i, grant_i}
  // breaks next_is_the_least: next_o = next[0] > next[1] ? next[0] : next[1]
  // breaks quiescent_is_honest: quiescent_o = channel_quiescent[0] && !write_i

endmodule

bind step_table step_table_props u_step_table_props (
    .*,
    .next_x(next[0]),
    .next_y(next[1])
);
