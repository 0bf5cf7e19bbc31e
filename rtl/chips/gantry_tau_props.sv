// SPDX-License-Identifier: Apache-2.0
//
// Properties of gantry_tau for any input, on its bus and its pins. Observer, calibration and the
// frames that wait are cut: what they give is free. Clocks passed by leaps count.

module gantry_tau_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic        s_axil_awvalid_i,
    input logic        s_axil_wvalid_i,
    input logic        s_axil_bvalid_o,
    input logic        s_axil_arvalid_i,
    input logic        s_axil_rvalid_o,
    input logic [31:0] s_axil_rdata_o,
    input logic [ 1:0] overtemp_i,
    input logic        adc_cs_n_o,
    input logic        adc_sclk_o,
    input logic        adc_din_o,
    input logic        tx_o,
    input logic [ 1:0] pwm_o,
    input logic [ 1:0] negative_o,
    input logic        pass_o,
    input logic        pass,
    input logic        irq_o,
    input gap_t        next_o,
    input logic        quiescent_o,

    input logic        tick,
    input logic        observer_turn,
    input logic        requester_turn,
    input logic        calib_valid,
    input logic        in_waits,
    input logic        asked_q,
    input logic [ 1:0] hot_q,
    input logic [31:0] ticks_q,
    input gap_t        rate_next,
    input gap_t        adc_next,
    input gap_t        pwm_next,
    input gap_t        serial_next,
    input gap_t        pass_next,
    // of the registers
    input logic        active,
    input logic [ 2:0] status,       // pass, frame, sample
    input logic [ 2:0] enabled,
    input logic        overrun,
    input logic        read_waits,
    input logic        write_waits,
    input logic [ 1:0] in_flight,
    input logic [ 1:0] unanswered,
    input logic        pulses        // a single pulse of a register
);

  logic live_q = 1'b0;
  logic was_rst_q, was_asked_q, was_quiescent_q, was_pass_q, was_due_q, was_tick_q, was_plain_q;
  logic [1:0] hot_then_q, hot_late_q, history_q;
  logic [31:0] was_ticks_q;
  logic [8:0] shown, was_shown_q;
  gap_t was_next_q, was_leap_q;

  assign shown = {pass_o, adc_cs_n_o, adc_sclk_o, adc_din_o, tx_o, pwm_o, negative_o};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_asked_q     <= !rst_i && (s_axil_awvalid_i || s_axil_wvalid_i || s_axil_arvalid_i);
    was_quiescent_q <= !rst_i && quiescent_o;
    was_pass_q      <= !rst_i && pass;
    was_due_q       <= status[0];
    was_tick_q      <= tick;
    was_plain_q     <= !rst_i;
    was_ticks_q     <= ticks_q;
    was_shown_q     <= shown;
    was_next_q      <= next_o;
    was_leap_q      <= leap_i;
    hot_then_q      <= overtemp_i;
    hot_late_q      <= hot_then_q;
    if (!live_q) history_q <= '0;
    else if (history_q != 2'd3) history_q <= history_q + 2'd1;
    if (live_q) begin
      quiet_from_reset :
      assert (!was_rst_q || (pwm_o == '0 && negative_o == '0 && tx_o && adc_cs_n_o && !irq_o &&
              !s_axil_bvalid_o && !s_axil_rvalid_o) || in_waits);
      irq_is_an_enabled_event : assert (irq_o == ((status & enabled) != '0));
      pass_is_shown : assert (!was_pass_q || status[0]);
      overrun_of_a_pass_that_was_due : assert (!was_pass_q || !was_due_q || overrun);
      observes_with_a_calibration_only :
      assert (!observer_turn || (active && calib_valid));
      never_both_turns : assert (!(observer_turn && requester_turn));
      turns_at_ticks_only : assert (tick || (!observer_turn && !requester_turn));
      ticks_are_counted :
      assert (!was_plain_q || ticks_q == was_ticks_q + 32'(was_tick_q));
      overtemp_shown_2_clocks_later : assert (history_q != 2'd3 || hot_q == hot_late_q);
      next_is_the_least :
      assert (next_o <= rate_next && next_o <= adc_next && next_o <= pwm_next &&
              next_o <= serial_next && next_o <= pass_next &&
              (next_o == rate_next || next_o == adc_next || next_o == pwm_next ||
               next_o == serial_next || next_o == pass_next));
      quiescent_without_transfers_only :
      assert (!quiescent_o || (in_flight == '0 && !read_waits && !write_waits));
      quiescent_holds_the_pins :
      assert (!was_quiescent_q || rst_i || was_leap_q >= was_next_q || shown == was_shown_q);
      inv_asked : assert (was_rst_q || asked_q == was_asked_q);
      inv_in_flight :
      assert (in_flight == unanswered && in_flight <= 2'd2 &&
              (in_flight != '0) == (s_axil_bvalid_o || s_axil_rvalid_o));
      inv_waits : assert (!(read_waits || write_waits) || asked_q || in_flight != '0);
      inv_pulses : assert (!pulses || in_flight != '0);
      reaches_an_answer : cover (s_axil_rvalid_o && s_axil_rdata_o == 32'h4754_0001);
      reaches_a_turn_of_the_observer : cover (observer_turn);
      reaches_an_interrupt : cover (irq_o && !in_waits);
    end
  end

  // breaks quiet_from_reset (force_pwm): negative_q <= rst_i ? taken_q : next
  // breaks irq_is_an_enabled_event: irq_o = in_waits
  // breaks pass_is_shown: hwset             = pass; => hwset             = served;
  // breaks overrun_of_a_pass_that_was_due: hwset          = pass && => hwset          = served &&
  // breaks observes_with_a_calibration_only: wants = hwif_out.observer.active.value
  // breaks never_both_turns (conversion_slots): requester_o = take
  // breaks turns_at_ticks_only: u_slots.pick_i = 1'b1
  // breaks ticks_are_counted: ticks_q <= next + 32'(pass && !rst_i)
  // breaks overtemp_shown_2_clocks_later: hot_q <= overtemp_i
  // breaks next_is_the_least: next_o = pass_next
  // breaks quiescent_without_transfers_only: bus_idle = !asked && !s_axil_bvalid_o && !s_axil_rvalid_o
  // breaks quiescent_holds_the_pins: pwm_quiescent = 1'b1

  // prove: cut sincos_observer calibration frame_fifo
  // prove: leap inv_in_flight inv_waits inv_pulses

endmodule

bind gantry_tau gantry_tau_props u_gantry_tau_props (
    .*,
    .active     (hwif_out.observer.active.value),
    .status     ({hwif_out.status.sample.value, in_waits, hwif_out.status.pass.value}),
    .enabled    ({hwif_out.irq_enable.sample.value, hwif_out.irq_enable.frame.value,
                  hwif_out.irq_enable.pass.value}),
    .overrun    (hwif_out.status.overrun.value),
    .read_waits (u_regs.axil_arvalid),
    .write_waits(u_regs.axil_awvalid && u_regs.axil_wvalid),
    .in_flight  (u_regs.axil_n_in_flight),
    .unanswered (u_regs.axil_resp_wptr - u_regs.axil_resp_rptr),
    .pulses     (ask != '0 || hwif_out.receive.take.value)
);
