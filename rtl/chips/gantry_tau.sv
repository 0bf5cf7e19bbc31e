// SPDX-License-Identifier: Apache-2.0
//
// The IC of the gantry-tau track (Brochier 2006): sine/cosine observer with a converter of 8
// channels, two motor outputs, Serial2002 at 115,200 baud, over-temperature inputs, calibration
// data with a non-volatile memory behind a port, an interrupt each control pass; 50 MHz fabric.
//
//   tick -> whose turn, channel -> frame of the converter -> code -> observer, registers
//
// Clock, in Hz, sets ticks and baud rate; the carrier is that of force_pwm.

module gantry_tau
  import trammel_pkg::*;
#(
    parameter int unsigned Clock = 50_000_000,
    parameter int unsigned TickRate = 4612,
    parameter int unsigned Baud = 115_200
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input  logic        s_axil_awvalid_i,
    output logic        s_axil_awready_o,
    input  logic [ 6:0] s_axil_awaddr_i,
    input  logic [ 2:0] s_axil_awprot_i,
    input  logic        s_axil_wvalid_i,
    output logic        s_axil_wready_o,
    input  logic [31:0] s_axil_wdata_i,
    input  logic [ 3:0] s_axil_wstrb_i,
    output logic        s_axil_bvalid_o,
    input  logic        s_axil_bready_i,
    output logic [ 1:0] s_axil_bresp_o,
    input  logic        s_axil_arvalid_i,
    output logic        s_axil_arready_o,
    input  logic [ 6:0] s_axil_araddr_i,
    input  logic [ 2:0] s_axil_arprot_i,
    output logic        s_axil_rvalid_o,
    input  logic        s_axil_rready_i,
    output logic [31:0] s_axil_rdata_o,
    output logic [ 1:0] s_axil_rresp_o,

    input  logic adc_dout_i,
    output logic adc_cs_n_o,
    output logic adc_sclk_o,
    output logic adc_din_o,

    output logic        nv_valid_o,
    output logic        nv_write_o,
    output logic [ 5:0] nv_addr_o,
    output logic [15:0] nv_data_o,
    input  logic        nv_ready_i,
    input  logic [15:0] nv_data_i,

    input  logic [1:0] overtemp_i,
    input  logic       rx_i,
    output logic       tx_o,
    output logic [1:0] pwm_o,
    output logic [1:0] negative_o,

    output logic pass_o,
    output logic irq_o,
    output gap_t next_o,
    output logic quiescent_o
);

  gantry_tau_regs_pkg::gantry_tau__in_t hwif_in;
  gantry_tau_regs_pkg::gantry_tau__out_t hwif_out;

  gantry_tau_regs u_regs (
      .clk_i           (clk_i),
      .rst_i           (rst_i),
      .s_axil_awready_o(s_axil_awready_o),
      .s_axil_awvalid_i(s_axil_awvalid_i),
      .s_axil_awaddr_i (s_axil_awaddr_i),
      .s_axil_awprot_i (s_axil_awprot_i),
      .s_axil_wready_o (s_axil_wready_o),
      .s_axil_wvalid_i (s_axil_wvalid_i),
      .s_axil_wdata_i  (s_axil_wdata_i),
      .s_axil_wstrb_i  (s_axil_wstrb_i),
      .s_axil_bready_i (s_axil_bready_i),
      .s_axil_bvalid_o (s_axil_bvalid_o),
      .s_axil_bresp_o  (s_axil_bresp_o),
      .s_axil_arready_o(s_axil_arready_o),
      .s_axil_arvalid_i(s_axil_arvalid_i),
      .s_axil_araddr_i (s_axil_araddr_i),
      .s_axil_arprot_i (s_axil_arprot_i),
      .s_axil_rready_i (s_axil_rready_i),
      .s_axil_rvalid_o (s_axil_rvalid_o),
      .s_axil_rdata_o  (s_axil_rdata_o),
      .s_axil_rresp_o  (s_axil_rresp_o),
      .hwif_in         (hwif_in),
      .hwif_out        (hwif_out)
  );

  // Busy where a request is there, one came in the previous clock or its response is waiting.
  logic asked, asked_q, bus_idle;

  assign asked    = s_axil_awvalid_i || s_axil_wvalid_i || s_axil_arvalid_i;
  assign bus_idle = !asked && !asked_q && !s_axil_bvalid_o && !s_axil_rvalid_o;

  // Writes that act a clock later, when the register holds what was written.
  logic restart_q, pass_restart_q, send_q, calibrate_q;

  // ---- ticks: whose turn it is, the converter's frame ----

  logic tick, rate_quiescent, slots_quiescent, adc_quiescent;
  logic observer_turn, requester_turn, wants, served;
  logic [2:0] requested, observed, converted;
  logic [6:0] ask, pending;
  logic asked_channel, sample;
  logic [9:0] code, a, a_dot, b, b_dot, current;
  logic [31:0] ticks_q;
  gap_t rate_next, adc_next;

  rate_tick #(
      .Clock(Clock),
      .Rate (TickRate)
  ) u_rate (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .leap_i     (leap_i),
      .tick_o     (tick),
      .next_o     (rate_next),
      .quiescent_o(rate_quiescent)
  );

  assign ask = {
    hwif_out.request.current.value,
    2'b00,
    hwif_out.request.b_dot.value,
    hwif_out.request.b.value,
    hwif_out.request.a_dot.value,
    hwif_out.request.a.value
  };

  conversion_slots u_slots (
      .clk_i            (clk_i),
      .rst_i            (rst_i),
      .pick_i           (tick),
      .observer_slots_i (hwif_out.slots.observer.value),
      .requester_slots_i(hwif_out.slots.requester.value),
      .wants_i          (wants),
      .ask_i            (ask),
      .done_i           (sample),
      .channel_i        (converted),
      .code_i           (code),
      .observer_o       (observer_turn),
      .requester_o      (requester_turn),
      .channel_o        (requested),
      .pending_o        (pending),
      .served_o         (served),
      .a_o              (a),
      .a_dot_o          (a_dot),
      .b_o              (b),
      .b_dot_o          (b_dot),
      .current_o        (current),
      .quiescent_o      (slots_quiescent)
  );

  adc_serial u_adc (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .leap_i     (leap_i),
      .start_i    (requester_turn || asked_channel),
      .channel_i  (requester_turn ? requested : observed),
      .dout_i     (adc_dout_i),
      .cs_n_o     (adc_cs_n_o),
      .sclk_o     (adc_sclk_o),
      .din_o      (adc_din_o),
      .valid_o    (sample),
      .channel_o  (converted),
      .code_o     (code),
      .next_o     (adc_next),
      .quiescent_o(adc_quiescent)
  );

  // ---- observer and its calibration ----

  sincos_pkg::calib_addr_t calib_addr;
  sincos_pkg::calib_t calib_word;
  logic calib_valid, observer_busy, observer_quiescent, calib_quiescent;
  logic signed [31:0] position;
  logic signed [22:0] velocity;
  logic [13:0] phase;
  logic [1:0] region;
  logic known;

  assign wants = hwif_out.observer.active.value && calib_valid;

  sincos_observer u_observer (
      .clk_i       (clk_i),
      .rst_i       (rst_i),
      .tick_i      (tick),
      .restart_i   (restart_q),
      .active_i    (wants),
      .velocity_i  (hwif_out.observer.velocity.value),
      .ask_i       (observer_turn),
      .sample_i    (sample),
      .channel_i   (converted),
      .code_i      (code),
      .calib_addr_o(calib_addr),
      .calib_i     (calib_word),
      .asked_o     (asked_channel),
      .channel_o   (observed),
      .position_o  (position),
      .velocity_o  (velocity),
      .phase_o     (phase),
      .region_o    (region),
      .known_o     (known),
      .busy_o      (observer_busy),
      .quiescent_o (observer_quiescent)
  );

  calibration u_calibration (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .write_i    (calibrate_q),
      .command_i  (hwif_out.calibrate.command.value),
      .word_i     (hwif_out.calibrate.word.value),
      .reads_i    (observer_busy || tick || sample),
      .addr_i     (calib_addr),
      .data_o     (calib_word),
      .nv_valid_o (nv_valid_o),
      .nv_write_o (nv_write_o),
      .nv_addr_o  (nv_addr_o),
      .nv_data_o  (nv_data_o),
      .nv_ready_i (nv_ready_i),
      .nv_data_i  (nv_data_i),
      .valid_o    (calib_valid),
      .busy_o     (hwif_in.calibration.busy.next),
      .count_o    (hwif_in.calibration.count.next),
      .stored_o   (hwif_in.status.stored.hwset),
      .refused_o  (hwif_in.status.refused.hwset),
      .quiescent_o(calib_quiescent)
  );

  // ---- motors ----

  logic pwm_quiescent;
  logic signed [10:0] force_1, force_2;
  gap_t pwm_next;

  assign force_1 = hwif_out.force_1.value.value;
  assign force_2 = hwif_out.force_2.value.value;

  force_pwm u_pwm (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .leap_i     (leap_i),
      .force_1_i  (force_1),
      .force_2_i  (force_2),
      .pwm_o      (pwm_o),
      .negative_o (negative_o),
      .next_o     (pwm_next),
      .quiescent_o(pwm_quiescent)
  );

  // ---- serial line ----

  logic serial_quiescent, in_waits;
  logic [15:0] lost, malformed;
  serial2002_pkg::frame_t in_frame, out_frame;
  gap_t serial_next;

  assign out_frame = '{
          kind: hwif_out.send.kind.value,
          channel: hwif_out.send.channel.value,
          value: hwif_out.send_value.value.value
      };

  serial2002_port #(
      .ClocksPerBit((Clock + Baud / 2) / Baud)
  ) u_serial (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .leap_i     (leap_i),
      .rx_i       (rx_i),
      .tx_o       (tx_o),
      .send_i     (send_q),
      .frame_i    (out_frame),
      .room_o     (hwif_in.send_state.room.next),
      .refused_o  (hwif_in.send_state.lost.next),
      .idle_o     (hwif_in.send_state.idle.next),
      .gap_i      (hwif_out.receive_gap.clocks.value),
      .take_i     (hwif_out.receive.take.value),
      .waits_o    (in_waits),
      .frame_o    (in_frame),
      .lost_o     (lost),
      .malformed_o(malformed),
      .next_o     (serial_next),
      .quiescent_o(serial_quiescent)
  );

  // ---- control pass ----

  localparam logic [23:0] LeastPass = 24'd16;

  logic [23:0] pass_count, pass_clocks;
  gap_t pass_next;
  logic pass, pass_q;

  assign pass_clocks = hwif_out.pass_period.clocks.value;
  assign pass        = pass_count == 24'd1;
  assign pass_o      = pass_q;

  timer #(
      .Width(24)
  ) u_pass (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (pass_restart_q || pass),
      .value_i(pass_clocks < LeastPass ? '0 : pass_clocks),
      .count_o(pass_count),
      .next_o (pass_next)
  );

  // ---- over-temperature, registers ----

  logic [1:0] hot_meta_q, hot_q;

  always_ff @(posedge clk_i) begin
    hot_meta_q <= overtemp_i;
    hot_q      <= hot_meta_q;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      asked_q        <= 1'b0;
      pass_q         <= 1'b0;
      restart_q      <= 1'b0;
      pass_restart_q <= 1'b1;
      send_q         <= 1'b0;
      calibrate_q    <= 1'b0;
      ticks_q        <= '0;
    end else begin
      asked_q        <= asked;
      pass_q         <= pass;
      restart_q      <= hwif_out.observer.active.swmod;
      pass_restart_q <= hwif_out.pass_period.clocks.swmod;
      send_q         <= hwif_out.send.channel.swmod;
      calibrate_q    <= hwif_out.calibrate.word.swmod;
      if (tick) ticks_q <= ticks_q + 32'd1;
    end
  end

  assign hwif_in.position.value.next           = position;
  assign hwif_in.velocity.value.next           = 32'(velocity);
  assign hwif_in.angle.phase.next              = phase;
  assign hwif_in.angle.region.next             = region;
  assign hwif_in.angle.known.next              = known;
  assign hwif_in.ticks.value.next              = ticks_q;
  assign hwif_in.encoder_a.code.next          = a;
  assign hwif_in.encoder_a.dot.next            = a_dot;
  assign hwif_in.encoder_b.code.next           = b;
  assign hwif_in.encoder_b.dot.next            = b_dot;
  assign hwif_in.current.code.next             = current;
  assign hwif_in.receive_errors.lost.next      = lost;
  assign hwif_in.receive_errors.malformed.next = malformed;
  assign hwif_in.request.pending.next          = pending;
  assign hwif_in.overtemp.motor_1.next         = hot_q[0];
  assign hwif_in.overtemp.motor_2.next         = hot_q[1];
  assign hwif_in.status.pass.hwset             = pass;
  assign hwif_in.status.overrun.hwset          = pass && hwif_out.status.pass.value;
  assign hwif_in.status.sample.hwset           = served;
  assign hwif_in.status.frame.next             = in_waits;
  assign hwif_in.receive.channel.next          = in_frame.channel;
  assign hwif_in.receive.kind.next             = in_frame.kind;
  assign hwif_in.receive.waits.next            = in_waits;
  assign hwif_in.receive_value.value.next      = in_frame.value;
  assign hwif_in.calibration.valid.next        = calib_valid;

  assign irq_o = (hwif_out.status.pass.value && hwif_out.irq_enable.pass.value) ||
      (in_waits && hwif_out.irq_enable.frame.value) ||
      (hwif_out.status.sample.value && hwif_out.irq_enable.sample.value);

  always_comb begin
    next_o = rate_next;
    if (adc_next < next_o) next_o = adc_next;
    if (pwm_next < next_o) next_o = pwm_next;
    if (serial_next < next_o) next_o = serial_next;
    if (pass_next < next_o) next_o = pass_next;
  end

  assign quiescent_o = bus_idle && rate_quiescent && slots_quiescent && adc_quiescent &&
      observer_quiescent && calib_quiescent && pwm_quiescent && serial_quiescent && !pass &&
      !pass_q && !pass_restart_q && overtemp_i == hot_meta_q && hot_meta_q == hot_q;

  logic unused_bits;
  assign unused_bits = ^hwif_out.status;

endmodule
