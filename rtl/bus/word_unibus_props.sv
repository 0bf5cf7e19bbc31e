// SPDX-License-Identifier: Apache-2.0
//
// Properties of word_unibus for any input.

module word_unibus_props (
    input logic clk_i,
    input logic rst_i,

    input logic [ 2:0] a,      // the lower bits of the address
    input logic [ 1:0] c_i,
    input logic [15:0] d_i,
    input logic [15:0] d_o,
    input logic        d_oe_o,
    input logic        ssyn_o,
    input logic        br_o,
    input logic        bg_o,
    input logic        sack_o,
    input logic        bbsy_o,
    input logic        intr_o,
    input logic        write_o,
    input logic        y_o,
    input logic [ 3:0] bytes_o,
    input logic [31:0] data_o,
    input logic [31:0] x_i,
    input logic [31:0] y_i,
    input logic        irq_i,
    input logic [ 7:0] vector_i,
    input logic        grant_o,
    input logic        quiescent_o,

    input logic ours,         // the address
    input logic msyn_q,
    input logic bg_q,
    input logic bg_was_q,
    input logic bbsy_q,
    input logic ssyn_in_q,
    input logic answered_q,
    input logic reading_q,
    input logic passing_q,
    input logic [7:0] vector_q,
    input logic [1:0] state,
    input logic msyn_meta_q,
    input logic bg_meta_q,
    input logic bbsy_meta_q,
    input logic ssyn_meta_q,
    input logic msyn_i,
    input logic bg_i,
    input logic bbsy_i,
    input logic ssyn_i
);

  logic live_q = 1'b0;
  logic was_rst_q, was_msyn_q, was_ours_q, was_ssyn_q, was_write_q, was_bg_q, was_bbsy_in_q;
  logic was_ssyn_in_q, was_grant_q, was_sack_q, was_intr_q, was_quiescent_q, was_read_q, was_oe_q;
  logic [7:0] kept_q;
  logic [15:0] was_word_q, was_d_q, shown_word;
  logic [37:0] kept, was_kept_q;  // all that the block remembers
  logic [5:0] pins, was_pins_q;   // what may change that

  assign shown_word = a[2] ? (a[1] ? y_i[31:16] : y_i[15:0])
                             : (a[1] ? x_i[31:16] : x_i[15:0]);
  assign kept = {state, answered_q, reading_q, passing_q, bg_was_q, vector_q, d_o, msyn_meta_q,
                 msyn_q, bg_meta_q, bg_q, bbsy_meta_q, bbsy_q, ssyn_meta_q, ssyn_in_q};
  assign pins = {msyn_i, bg_i, bbsy_i, ssyn_i, irq_i, ours};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_msyn_q      <= !rst_i && msyn_q;
    was_ours_q      <= ours;
    was_ssyn_q      <= !rst_i && ssyn_o;
    was_write_q     <= !rst_i && write_o;
    was_read_q      <= !rst_i && ours && msyn_q && !ssyn_o && !c_i[1];
    was_word_q      <= shown_word;
    was_bg_q        <= !rst_i && bg_q;
    was_bbsy_in_q   <= bbsy_q;
    was_ssyn_in_q   <= ssyn_in_q;
    was_grant_q     <= !rst_i && grant_o;
    was_sack_q      <= !rst_i && sack_o;
    was_intr_q      <= !rst_i && intr_o;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_oe_q        <= !rst_i && d_oe_o;
    was_d_q         <= d_o;
    was_kept_q      <= kept;
    was_pins_q      <= pins;
    if (grant_o) kept_q <= vector_i;
    if (live_q) begin
      quiet_from_reset :
      assert (!was_rst_q || (!ssyn_o && !d_oe_o && !sack_o && !bbsy_o && !intr_o && !bg_o));
      answers_its_own_addresses_only : assert (!ssyn_o || was_ssyn_q || was_ours_q);
      answers_msyn_only : assert (!ssyn_o || was_msyn_q);
      answers_until_msyn_falls : assert (!was_ssyn_q || !was_msyn_q || was_rst_q || ssyn_o);
      one_write_a_transfer : assert (!write_o || (msyn_q && !ssyn_o && ours && c_i[1]));
      a_write_is_answered : assert (!was_write_q || was_rst_q || ssyn_o);
      a_write_drives_no_data : assert (!was_write_q || was_rst_q || intr_o || !d_oe_o);
      writes_the_word_or_byte_of_its_address :
      assert (!write_o || (y_o == a[2] && data_o == {d_i, d_i} &&
              bytes_o == (c_i[0] ? 4'd1 << a[1:0] : 4'd3 << {a[1], 1'b0})));
      reads_the_word_of_its_address :
      assert (!was_read_q || was_rst_q || intr_o || (d_oe_o && d_o == was_word_q));
      data_of_a_read_stand_until_msyn_falls :
      assert (!was_oe_q || was_intr_q || intr_o || was_rst_q || !was_msyn_q ||
              (d_oe_o && d_o == was_d_q));
      drives_data_where_it_answers : assert (!d_oe_o || ssyn_o || intr_o);
      no_request_without_an_interrupt : assert (!br_o || irq_i);
      a_grant_is_taken_or_passed : assert (!(sack_o && bg_o));
      passes_a_grant_only : assert (!bg_o || was_bg_q);
      takes_a_request_only : assert (!grant_o || (irq_i && bg_q && !sack_o && !intr_o));
      sack_after_a_grant : assert (!sack_o || was_sack_q || was_grant_q);
      becomes_master_of_a_free_bus :
      assert (!bbsy_o || was_intr_q ||
              (was_sack_q && !was_bbsy_in_q && !was_ssyn_in_q && !was_bg_q));
      shows_the_vector_of_its_grant : assert (!intr_o || (bbsy_o && d_oe_o && d_o == 16'(kept_q)));
      vector_until_the_processor_has_it :
      assert (!was_intr_q || was_rst_q || was_ssyn_in_q || intr_o);
      no_vector_of_nothing : assert (!intr_o || d_o != '0);
      quiescent_is_honest : assert (!was_quiescent_q || kept == was_kept_q);
      quiescent_where_nothing_changes :
      assert (was_rst_q || kept != was_kept_q || pins != was_pins_q || quiescent_o);
      inv_answer : assert (answered_q == ssyn_o && (was_rst_q || !answered_q || was_msyn_q));
      inv_bg : assert (was_rst_q || bg_was_q == was_bg_q);
      inv_passing : assert (!passing_q || bg_was_q);
      inv_vector : assert (!(sack_o || intr_o) || vector_q == kept_q);
      inv_reading : assert (!was_read_q || was_rst_q || reading_q);
      reaches_a_vector : cover (intr_o && d_o == 16'o340);
      reaches_a_byte : cover (write_o && bytes_o == 4'd8);
      reaches_a_read : cover (ssyn_o && d_oe_o && d_o != '0);
      reaches_a_passed_grant : cover (bg_o);
    end
  end

  // breaks quiet_from_reset: answered_q <= next || (rst_i && msyn_q)
  // breaks answers_its_own_addresses_only: match = 1'b1
  // breaks answers_msyn_only: answered_q <= !rst_i && (answered_q || acts)
  // breaks answers_until_msyn_falls: answered_q <= next && !answered_q
  // breaks one_write_a_transfer: write_o = msyn_q && match && writes
  // breaks a_write_is_answered: answered_q <= next && !(acts && c_i[0])
  // breaks a_write_drives_no_data: d_oe_o = intr_o || answered_q
  // breaks writes_the_word_or_byte_of_its_address: bytes_o = a_i[1] ? 4'b1100 : 4'b0011
  // breaks reads_the_word_of_its_address: axis = a_i[1] ? y_i : x_i
  // breaks data_of_a_read_stand_until_msyn_falls: read_q <= rst_i ? next : a_i[1] ? axis[31:16] : axis[15:0]
  // breaks drives_data_where_it_answers: d_oe_o = intr_o || reading_q
  // breaks no_request_without_an_interrupt: br_o = state_q == StIdle
  // breaks a_grant_is_taken_or_passed: passing_q <= !rst_i && bg_q
  // breaks passes_a_grant_only: bg_o = passing_q || !bg_q
  // breaks takes_a_request_only: takes = bg_q && !bg_was_q && state_q == StIdle
  // breaks sack_after_a_grant: state_d = state_q == StIdle && bg_q ? StTaken : state_d
  // breaks becomes_master_of_a_free_bus: state_d = state_q == StTaken && !bg_q ? StVector : state_d
  // breaks shows_the_vector_of_its_grant: vector_q <= rst_i ? next : vector_i
  // breaks vector_until_the_processor_has_it: state_d = state_q == StVector ? StRelease : state_d
  // breaks no_vector_of_nothing: empty = 1'b0
  // breaks quiescent_is_honest: quiescent_o = 1'b1
  // breaks quiescent_where_nothing_changes: quiescent_o = quiescent_o && !ssyn_i

endmodule

bind word_unibus word_unibus_props u_word_unibus_props (
    .*,
    .ours(a_i[17:3] == Base[17:3]),
    .a   (a_i[2:0]),
    .state(2'(state_q))
);
