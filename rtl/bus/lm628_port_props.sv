// SPDX-License-Identifier: Apache-2.0
//
// Properties of lm628_port for any input; clocks passed by leaps count.

module lm628_port_props
  import trammel_pkg::*;
  import lm628_pkg::*;
#(
    parameter int unsigned Inc = 4
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic commit_i,
    input logic open_i,
    input logic ready_i,

    input logic [7:0] d_o,
    input logic       hi_o,

    input logic restart_o,
    input logic start_o,
    input logic end_o,
    input logic arm_o,

    input logic    [7:0] opcode_o,
    input events_t       sample_events_i,
    input logic          sample_off_i,
    input events_t       command_events_i,
    input logic          command_off_i,
    input gap_t          next_o,
    input logic          quiescent_o,

    input logic        written,
    input logic        read,
    input logic        port_q,      // ps of the strobe that ends
    input logic        read_port,   // ps of the one that begins
    input logic [ 7:0] code,
    input logic [ 7:0] last_q,
    input logic [ 7:0] status,
    input logic [10:0] count,
    input logic [ 1:0] state_q,
    input logic        executes_q,
    input logic [ 2:0] due_q,
    input logic [ 1:0] left_q,
    input logic        half_written_q,
    input logic        half_read_q,
    input logic [ 7:0] high_q,
    input events_t     status_q,
    input events_t     mask_q,
    input events_t     operand_q,
    input logic        off_q
);

  localparam logic [15:0] Busy = 16'(lm628_clocks(Inc, 160));
  localparam logic [15:0] Run  = 16'(Lm628Run);
  localparam logic [15:0] Long = 16'h7FFF;

  logic live_q = 1'b0;
  logic was_rst_q, was_end_q, was_commit_q, was_quiescent_q, was_read_q, was_busy_q;
  logic was_port_q, was_hi_q, was_off_q;
  logic [7:0] was_d_q, was_last_q, was_opcode_q, was_status_byte_q;
  events_t was_status_q, was_mask_q, was_operand_q, was_sample_q, was_command_q, published;
  logic [9:0] was_state_q, state;
  logic [14:0] was_transfer_q, transfer;
  logic was_sample_off_q, was_command_off_q;
  logic [12:0] passed;
  logic busy, allowed;
  logic exact_q;            // no leap beyond next_o since busy_q began to count
  logic [15:0] busy_q, run_q;  // clocks busy, and since a start; at most Long

  assign busy    = state_q != 2'd0;
  assign passed  = 13'(leap_i) + 13'd1;
  assign allowed = leap_i == '0 || leap_i < next_o;
  assign transfer = {due_q, left_q, half_written_q, half_read_q, high_q};
  assign state   = {state_q, executes_q, due_q, left_q, half_written_q, half_read_q};

  always_comb begin
    published = '0;
    if (was_commit_q) published |= was_sample_q;
    if (was_end_q) published |= was_command_q;
  end

  function automatic logic [15:0] more(logic [15:0] clocks, logic [12:0] by);
    return clocks + 16'(by) > Long ? Long : clocks + 16'(by);
  endfunction

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q         <= rst_i;
    was_end_q         <= !rst_i && end_o;
    was_commit_q      <= !rst_i && commit_i;
    was_quiescent_q   <= !rst_i && quiescent_o;
    was_busy_q        <= !rst_i && busy;
    was_read_q        <= !rst_i && read;
    was_port_q        <= read_port;
    was_hi_q          <= hi_o;
    was_off_q         <= off_q;
    was_sample_off_q  <= sample_off_i;
    was_command_off_q <= command_off_i;
    was_d_q           <= d_o;
    was_last_q        <= last_q;
    was_opcode_q      <= opcode_o;
    was_status_byte_q <= status;
    was_status_q      <= status_q;
    was_mask_q        <= mask_q;
    was_operand_q     <= operand_q;
    was_sample_q      <= sample_events_i;
    was_command_q     <= command_events_i;
    was_state_q       <= state;
    was_transfer_q    <= transfer;
    busy_q            <= busy ? more(busy_q, passed) : '0;
    run_q             <= start_o ? '0 : more(run_q, passed);
    exact_q           <= !busy || (exact_q && allowed);
    if (live_q) begin
      quiet_from_reset :
      assert (!was_rst_q || (!busy && !hi_o && off_q && status_q == 6'b000010));
      routine_reads_0_or_busy :
      assert (ready_i || was_rst_q || status[7:1] == '0);
      nothing_is_taken_while_busy :
      assert (was_rst_q || !was_busy_q || was_end_q || opcode_o == was_opcode_q);
      busy_160_ticks : assert (!exact_q || rst_i || !busy || busy_q <= Busy - 16'd1 ||
                               executes_q);
      busy_not_shorter :
      assert (was_rst_q || !was_busy_q || busy || !exact_q || busy_q >= Busy);
      starts_only_where_open : assert (!start_o || open_i);
      ends_128_clocks_after_its_start : assert (!exact_q || !end_o || run_q == Run - 16'd1);
      no_start_before_the_end : assert (!start_o || state_q != 2'd3);
      restarts_by_its_opcode_only :
      assert (!restart_o || (written && !port_q && code == CmdReset && !busy && ready_i));
      events_are_never_lost :
      assert (was_rst_q || (was_end_q && was_opcode_q == CmdRsti) ||
              ((was_status_q | published) & ~status_q) == '0);
      rsti_clears_the_zero_bits :
      assert (was_rst_q || !was_end_q || was_opcode_q != CmdRsti ||
              (status_q & ~events_t'(6'd1)) ==
              ((was_status_q | published) & was_operand_q & ~events_t'(6'd1)));
      only_events_set_bits :
      assert (was_rst_q || (status_q & ~(was_status_q | published) & ~events_t'(6'd1)) == '0);
      irq_by_a_new_unmasked_event_only :
      assert (was_rst_q || !hi_o || was_hi_q ||
              ((published | events_t'(status_q[1])) & was_mask_q) != '0);
      irq_of_every_unmasked_event :
      assert (was_rst_q || (was_end_q && was_opcode_q == CmdRsti) ||
              (published & was_mask_q) == '0 || hi_o);
      irq_falls_by_rsti_only :
      assert (was_rst_q || !was_hi_q || hi_o || (was_end_q && was_opcode_q == CmdRsti));
      mask_moves_by_mski_only :
      assert (was_rst_q || mask_q == (was_end_q && was_opcode_q == CmdMski ? was_operand_q :
                                      was_mask_q));
      off_is_that_of_the_last_end :
      assert (was_rst_q || off_q == (was_end_q ? was_command_off_q :
                                     was_commit_q ? was_sample_off_q : was_off_q));
      data_hold_from_read_to_read : assert (was_rst_q || was_read_q || d_o == was_d_q);
      status_is_that_of_the_read :
      assert (was_rst_q || !was_read_q || was_port_q || d_o == was_status_byte_q);
      transfers_pass_over_status_reads :
      assert (was_rst_q || !was_read_q || was_port_q || was_end_q ||
              transfer == was_transfer_q);
      busy_reads_repeat_the_last_byte :
      assert (was_rst_q || !was_read_q || !was_port_q || !was_busy_q || d_o == was_last_q);
      arms_with_sip_only : assert (!arm_o || (end_o && opcode_o == CmdSip));
      quiescent_is_honest :
      assert (!was_quiescent_q || (state == was_state_q && status_q == was_status_q &&
                                   hi_o == was_hi_q && d_o == was_d_q));
      inv_count : assert (!exact_q || state_q != 2'd1 || 16'(count) + busy_q + Run + 16'd1 == Busy);
      inv_wait : assert (!exact_q || state_q != 2'd2 || (busy_q + Run >= Busy && executes_q));
      inv_run :
      assert (!exact_q || state_q != 2'd3 || 16'(count) < Run &&
              (executes_q || 16'(count) + busy_q + 16'd1 == Busy) &&
              (16'(count) + busy_q + 16'd1 >= Busy || busy_q == Long));
      inv_start : assert (!exact_q || state_q != 2'd3 || !executes_q ||
                          16'(count) + run_q + 16'd1 == Run);
      inv_left : assert (left_q != 2'd3);
      reaches_end : cover (!rst_i && end_o && !was_rst_q && passed == 13'd1);
      reaches_irq : cover (!was_rst_q && hi_o);
    end
  end

  // breaks quiet_from_reset: off_q <= next && !rst_i
  // breaks routine_reads_0_or_busy: status = ready_i ? status : {off_q, 6'd0, by_command_q}
  // breaks nothing_is_taken_while_busy: command = written && !prev_q.ps && ready_i
  // breaks busy_160_ticks: Busy = Busy + 11'd1
  // breaks busy_not_shorter: Busy = Busy - 11'd1
  // breaks starts_only_where_open: runs = (state_q == StBusy && last && (open_i || executes_q)) || (state_q == StWait && open_i)
  // breaks ends_128_clocks_after_its_start: Run = Run - 11'd1
  // breaks no_start_before_the_end: runs = (state_q == StBusy && last && (open_i || !executes_q)) || (state_q >= StWait && open_i)
  // breaks restarts_by_its_opcode_only: restart_o = command && code[7:1] == '0
  // breaks events_are_never_lost: raised = commit_i ? sample_events_i : raised
  // breaks rsti_clears_the_zero_bits: kept = resets ? ~operand_q : '1
  // breaks only_events_set_bits: raised = raised | sample_events_i
  // breaks irq_by_a_new_unmasked_event_only: hi_q <= !rst_i && !resets && (hi_q || (raised | events_t'(wrong) | mask_q) != '0)
  // breaks irq_of_every_unmasked_event: hi_q <= !rst_i && !resets && (hi_q || ((status_q | events_t'(wrong)) & mask_q) != '0)
  // breaks irq_falls_by_rsti_only: hi_q <= next && !(hi_q && commit_i && ((raised | events_t'(wrong)) & mask_q) == '0)
  // breaks mask_moves_by_mski_only: mask_q <= !rst_i && end_o && opcode_q[7:1] == CmdMski[7:1] ? operand_q : next
  // breaks off_is_that_of_the_last_end: off_q <= !rst_i && end_o && commit_i ? sample_off_i : next
  // breaks data_hold_from_read_to_read: d_q <= !rst_i && reading && !sync_q.ps ? status : next
  // breaks status_is_that_of_the_read: d_q <= read && !rst_i ? (prev_q.ps ? (give ? byte_out : last_q) : status) : next
  // breaks transfers_pass_over_status_reads: half_written_q <= !rst_i && read && !sync_q.ps ? 1'b0 : next
  // breaks busy_reads_repeat_the_last_byte: give = read && sync_q.ps && ready_i && left_q != '0
  // breaks arms_with_sip_only: arm_o = end_o && opcode_q[1:0] == CmdSip[1:0]
  // breaks quiescent_is_honest: quiescent_o = pins == meta_q && meta_q == sync_q && sync_q == prev_q && (state_q == StIdle || (state_q == StWait ? !open_i : !last))

  // prove: set Inc=4
  // prove: set Inc=3
  // prove: set Inc=10

endmodule

bind lm628_port lm628_port_props #(.Inc(Inc)) u_lm628_port_props (
    .*,
    .port_q(prev_q.ps),
    .read_port(sync_q.ps),
    .opcode_o(opcode_q),
    .d_o(d_q),
    .state_q(2'(state_q))
);
