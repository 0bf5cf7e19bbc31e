// SPDX-License-Identifier: Apache-2.0
//
// Properties of kung_xy for any input, on its bus and its pins. The blocks that compute are cut:
// what they give is free. What the bus accepts is tracked in registers of the properties; only the
// clock in which it is served is taken from the register block.

module kung_xy_props
  import trammel_pkg::*;
  import kung_xy_regs_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic        s_axil_awvalid_i, s_axil_awready_o,
    input logic [ 9:0] s_axil_awaddr_i,
    input logic        s_axil_wvalid_i, s_axil_wready_o,
    input logic [31:0] s_axil_wdata_i,
    input logic [ 3:0] s_axil_wstrb_i,
    input logic        s_axil_bvalid_o, s_axil_bready_i,
    input logic [ 1:0] s_axil_bresp_o,
    input logic        s_axil_arvalid_i, s_axil_arready_o,
    input logic [ 9:0] s_axil_araddr_i,
    input logic        s_axil_rvalid_o, s_axil_rready_i,
    input logic [31:0] s_axil_rdata_o,
    input logic [ 1:0] s_axil_rresp_o,
    input logic [5:0]  gate_hi_o, gate_lo_o,
    input logic        trip_i, irq_o, sample_o, quiescent_o,
    input gap_t        next_o, timebase_next, next_x, next_y,
    input kung_xy__out_t hwif_out,
    input logic [31:0] tick_count, fault,  // as the register shows it
    input logic [6:0]  causes,             // of a trip, except the pin
    input logic        tick_irq, trip, trip_q, locked_q,
    input logic [2:0]  open_q,
    input logic [1:0]  done, done_q,
    // of the register block and of kung_precision
    input logic        serves_write, serves_read, pending, read_was_last, slow_ack, slow_waits,
    input logic [1:0]  in_flight, write_pointer, read_pointer, slot_errors,
    input logic [32:0] slot_even, slot_odd,  // is a write; data
    input logic [10:0] held_address, held_read,
    input logic [36:0] held_word,
    input logic [2:0]  slow_held,  // is a write; of PREC_DATA, by axis
    // of the supervisor and the axes
    input logic [1:0]  pin_stages,
    input logic [11:0] axis_events,  // Y overrun, encoder, saturated, limited, underrun, clipped; X
    input logic [1:0]  busy, table_waits,
    input logic [19:0] dead_time,
    input logic [23:0] current_limit
);

  typedef struct packed {logic is_read, known; logic [31:0] data;} answer_t;

  logic live_q = 1'b0, was_rst_q;
  logic [25:0] limits, was_limits_q;  // and rates

  // ---- what the bus has accepted and not yet answered ----
  logic aw_q, w_q, ar_q;  // accepted, not yet served
  logic [9:0] awaddr_q, araddr_q;
  logic [31:0] wdata_q;
  logic [3:0] wstrb_q;
  logic [2:0] addresses_q, words_q, reads_q;  // accepted, not yet answered
  logic [1:0] served_q, answered_q, owes;  // requests; responses are due in the order of serving
  answer_t even_q, odd_q, first, second;  // answers owed: by their number; in their order
  logic write_first, write_second, read_first, read_second;  // are owed
  logic [32:0] first_slot, second_slot;
  logic address, word, read, b_taken, r_taken, held_up, nothing;
  logic [2:0] write_wait_q, read_wait_q;  // clocks the oldest request has waited
  logic [2:0] write_left, read_left;  // and how many more it may have to
  logic [3:0] lone_q;  // with nothing else open: a read 2 and 1 clocks ago; a write
  logic [1:0] table_q;  // a served write of TAB_DATA waits for its controller
  logic table_write;  // the next write is one
  logic slow_q, slow_read, slow_write;  // a served request waits for the precision controller
  logic [1:0] data_q, counts_q;  // what waits is an access of PREC_DATA, by axis; it ended just now

  assign address = s_axil_awvalid_i && s_axil_awready_o;
  assign word    = s_axil_wvalid_i && s_axil_wready_o;
  assign read    = s_axil_arvalid_i && s_axil_arready_o;
  assign b_taken = s_axil_bvalid_o && s_axil_bready_i;
  assign r_taken = s_axil_rvalid_o && s_axil_rready_i;
  assign held_up = s_axil_bvalid_o && !b_taken || s_axil_rvalid_o && !r_taken ||
      (table_q & busy) != '0 || slow_q;
  assign nothing = addresses_q == '0 && reads_q == '0;
  assign owes    = served_q - answered_q;
  assign first   = answered_q[0] ? odd_q : even_q;
  assign second  = answered_q[0] ? even_q : odd_q;
  assign {write_first, read_first}   = {!first.is_read, first.is_read} & {2{owes > 2'd0}};
  assign {write_second, read_second} = {!second.is_read, second.is_read} & {2{owes > 2'd1}};
  assign first_slot  = answered_q[0] ? slot_odd : slot_even;
  assign second_slot = answered_q[0] ? slot_even : slot_odd;
  assign slow_read   = araddr_q[9:2] == 8'h8c ||
      !araddr_q[9] && araddr_q[7:2] inside {[6'h25 : 6'h29]};
  assign slow_write  = !awaddr_q[9] && awaddr_q[7:2] == 6'h25 && wstrb_q == '1;
  assign table_write = !awaddr_q[9] && awaddr_q[7:2] == 6'h1d && wstrb_q == '1;

  // A read is served before a write if the last request served was a write.
  assign write_left = write_first ? 3'd1 + 3'(table_q != '0 && owes == 2'd1) :
      write_second ? 3'd2 : 3'd2 + 3'(table_write) +
      3'(owes == 2'd2 || owes == 2'd0 && ar_q && !read_was_last);
  assign read_left  = read_first ? 3'd1 : read_second ? 3'd2 :
      owes == 2'd0 && aw_q && w_q && read_was_last ? 3'd3 + 3'(table_write) :
      3'd2 + 3'(owes == 2'd2 || table_q != '0);
  function automatic logic holds(logic [32:0] slot_of, answer_t answer);
    return slot_of[32] == !answer.is_read &&
        (!answer.is_read || !answer.known || slot_of[31:0] == answer.data);
  endfunction

  // What a read that is served now must return, where that is known here.
  logic knows;
  logic [31:0] shown;
  always_comb begin
    knows = 1'b1;
    shown = '0;
    case ({araddr_q[9:2], 2'b00})
      10'h0b0, 10'h1b0: shown = araddr_q[8] ? hwif_out.y.angle_step : hwif_out.x.angle_step;
      10'h200: shown = 32'h4b58_0005;
      10'h208: shown = {30'd0, hwif_out.irq_en.fault.value, hwif_out.irq_en.tick.value};
      10'h20c: shown = {30'd0, hwif_out.irq_stat.fault.value, hwif_out.irq_stat.tick.value};
      10'h210: shown = tick_count;
      10'h214: shown = fault;
      10'h21c: shown = {16'd0, hwif_out.watchdog.limit.value};
      10'h220: shown = {31'd0, locked_q};
      10'h224: shown = {20'd0, hwif_out.current_limit.value.value};
      10'h228: shown = {22'd0, hwif_out.deadtime_min.clk.value};
      10'h22c: shown = {24'd0, hwif_out.irq_period.ticks.value};
      10'h230: knows = 1'b0;
      10'h240: shown = {26'd0, limits[25:24], 2'd0, limits[23:22]};
      default:  // no register, or nothing to read
      knows = araddr_q[9] || araddr_q[7:2] inside {[6'hd : 6'hf], 6'h17, 6'h1e, [6'h2a : 6'h2b],
                                                   [6'h30 : 6'h3f]};
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      {aw_q, w_q, ar_q, table_q, slow_q, data_q, lone_q} <= '0;
      {addresses_q, words_q, reads_q, served_q, answered_q, write_wait_q, read_wait_q} <= '0;
    end else begin
      aw_q        <= address || aw_q && !serves_write;
      w_q         <= word || w_q && !serves_write;
      ar_q        <= read || ar_q && !serves_read;
      addresses_q <= addresses_q + 3'(address) - 3'(b_taken);
      words_q     <= words_q + 3'(word) - 3'(b_taken);
      reads_q     <= reads_q + 3'(read) - 3'(r_taken);
      served_q    <= served_q + 2'(serves_write) + 2'(serves_read);
      answered_q  <= answered_q + 2'(b_taken) + 2'(r_taken);
      table_q     <= table_q & busy;
      slow_q      <= serves_write && slow_write || serves_read && slow_read ||
          slow_q && !slow_ack;
      if (slow_ack) data_q <= '0;
      if (serves_write && slow_write) data_q[awaddr_q[8]] <= 1'b1;
      if (serves_read && !araddr_q[9] && araddr_q[7:2] == 6'h25) data_q[araddr_q[8]] <= 1'b1;
      if (serves_write && table_write) table_q[awaddr_q[8]] <= 1'b1;
      lone_q[3:2] <= {lone_q[2] && !slow_read, nothing && read && !s_axil_awvalid_i};
      lone_q[1:0] <= {lone_q[0] && !table_write && !slow_write,
                      nothing && address && (word || w_q) && !s_axil_arvalid_i};
      if (addresses_q == '0 || words_q == '0 || b_taken) write_wait_q <= '0;
      else if (!held_up && write_wait_q != '1) write_wait_q <= write_wait_q + 3'd1;
      if (reads_q == '0 || r_taken) read_wait_q <= '0;
      else if (!held_up && read_wait_q != '1) read_wait_q <= read_wait_q + 3'd1;
    end
    if (address) awaddr_q <= s_axil_awaddr_i;
    if (word) {wstrb_q, wdata_q} <= {s_axil_wstrb_i, s_axil_wdata_i};
    if (read) araddr_q <= s_axil_araddr_i;
    if (serves_write || serves_read) begin
      if (served_q[0]) odd_q <= '{serves_read, serves_read && knows, shown};
      else even_q <= '{serves_read, serves_read && knows, shown};
    end
  end

  // ---- the previous clock ----
  logic was_bvalid_q, was_rvalid_q;  // and not taken
  logic [31:0] was_rdata_q, word_q;
  logic [3:0] was_resp_q, strobes_q, pin_q;  // strobes of word_q; the trip pin 1..4 clocks ago
  logic wrote_q;  // a write was served, of word_q
  logic [7:0] at_q;  // its word address
  logic [1:0][4:0] place, was_place_q, place_due;  // PREC_ADDR
  logic [1:0] enabled, was_enabled_q, seen_q;  // seen: dones since the last sample
  logic was_quiescent_q, was_locked_q, was_trip_q, cause, was_cause_q;
  logic unlocked, lock_key, unlock_key, clear_key;  // a write: while unlocked; of one of the keys
  logic [13:0] sticky, events, was_sticky_q, was_events_q, written, ones;
  logic [11:0] gates, was_gates_q;
  logic [10:0] held, was_held_q;  // registers that are visible nowhere else
  kung_xy__out_t lasting, was_lasting_q;  // registers of the map, without STATUS
  wire [117:0] guarded_x = {hwif_out.x.angle_step, hwif_out.x.deadtime.clk, hwif_out.x.stroke_min,
      hwif_out.x.stroke_max, hwif_out.x.stroke_en, hwif_out.x.current_offset, hwif_out.x.adc_frame};
  wire [117:0] guarded_y = {hwif_out.y.angle_step, hwif_out.y.deadtime.clk, hwif_out.y.stroke_min,
      hwif_out.y.stroke_max, hwif_out.y.stroke_en, hwif_out.y.current_offset, hwif_out.y.adc_frame};
  logic [277:0] guarded, was_guarded_q;

  assign enabled    = {hwif_out.y.ctrl.enable.value, hwif_out.x.ctrl.enable.value};
  assign cause      = pin_q[1] || causes != '0;
  assign unlocked   = wrote_q && !was_locked_q;
  assign lock_key   = wrote_q && at_q == 8'h88 && word_q == 32'h4c4f_434b && strobes_q == '1;
  assign unlock_key = wrote_q && at_q == 8'h88 && word_q == 32'h554e_4c4b && strobes_q == '1;
  assign clear_key  = wrote_q && at_q == 8'h86 && word_q == 32'h434c_5246 && strobes_q == '1;
  assign sticky     = {hwif_out.y.status, hwif_out.x.status, hwif_out.irq_stat};
  assign events     = {axis_events, tick_irq, trip && !was_trip_q};
  assign written    = {{6{wrote_q && at_q == 8'h41}}, {6{wrote_q && at_q == 8'h01}},
                       {2{wrote_q && at_q == 8'h83}}};
  assign ones       = written & {14{strobes_q[0]}} &
      {{2{word_q[1], word_q[2], word_q[3], word_q[4], word_q[5], word_q[6]}}, word_q[0], word_q[1]};
  assign gates      = {gate_hi_o, gate_lo_o};
  assign held       = {locked_q, trip_q, done_q, open_q, in_flight, pending, aw_q};
  assign guarded    = {guarded_x, guarded_y, hwif_out.watchdog.limit.value, limits};
  assign limits     = {hwif_out.rates.position.value, hwif_out.rates.carrier.value,
      hwif_out.current_limit.value.value, hwif_out.deadtime_min.clk.value};

  assign place = {hwif_out.y.prec_addr.word.value, hwif_out.x.prec_addr.word.value};
  for (genvar n = 0; n < 2; n++) begin : gen_place
    assign place_due[n] = wrote_q && at_q == {1'b0, n[0], 6'h24} && strobes_q[0] ? word_q[4:0] :
        was_place_q[n] + 5'(counts_q[n]);
  end

  always_comb begin
    lasting          = hwif_out;
    lasting.x.status = '0;
    lasting.y.status = '0;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    {was_rst_q, at_q, word_q, strobes_q} <= {rst_i, awaddr_q[9:2], wdata_q, wstrb_q};
    {was_rdata_q, was_resp_q} <= {s_axil_rdata_o, s_axil_bresp_o, s_axil_rresp_o};
    {was_gates_q, was_held_q, was_guarded_q, was_limits_q} <= {gates, held, guarded, limits};
    {was_lasting_q, was_place_q} <= {lasting, place};
    counts_q <= rst_i || !slow_ack ? '0 : data_q;
    {was_bvalid_q, was_rvalid_q, wrote_q, was_quiescent_q} <= rst_i ? '0 :
        {s_axil_bvalid_o && !s_axil_bready_i, s_axil_rvalid_o && !s_axil_rready_i, serves_write,
         quiescent_o};
    {was_locked_q, was_trip_q, was_cause_q, was_enabled_q, was_sticky_q, was_events_q} <=
        rst_i ? '0 : {locked_q, trip, cause, enabled, sticky, events};
    pin_q  <= rst_i ? '0 : {pin_q[2:0], trip_i};
    seen_q <= rst_i || sample_o ? '0 : seen_q | done;
    if (live_q) begin
      no_response_from_reset : assert (!was_rst_q || !s_axil_bvalid_o && !s_axil_rvalid_o);
      write_response_stays :
      assert (!was_bvalid_q || s_axil_bvalid_o && s_axil_bresp_o == was_resp_q[3:2]);
      read_response_stays :
      assert (!was_rvalid_q || s_axil_rvalid_o && s_axil_rdata_o == was_rdata_q &&
              s_axil_rresp_o == was_resp_q[1:0]);
      no_write_response_without_request :
      assert (!s_axil_bvalid_o || addresses_q != '0 && words_q != '0);
      no_read_response_without_request : assert (!s_axil_rvalid_o || reads_q != '0);
      responses_in_order :
      assert (!(s_axil_bvalid_o || s_axil_rvalid_o) || owes != '0 &&
              s_axil_rvalid_o == first.is_read && s_axil_bvalid_o != s_axil_rvalid_o);
      every_response_is_okay : assert ({s_axil_bresp_o, s_axil_rresp_o} == '0);
      lone_request_answered_after_2_clocks :
      assert ((!lone_q[1] || s_axil_bvalid_o) && (!lone_q[3] || s_axil_rvalid_o));
      write_answered_within_4_clocks : assert (write_wait_q < 3'd4);
      read_answered_within_4_clocks : assert (read_wait_q < 3'd4);
      reads_show_the_register :
      assert (!s_axil_rvalid_o || !first.known || s_axil_rdata_o == first.data);
      unlocked_from_reset : assert (!was_rst_q || !locked_q);
      locks_by_its_key_only : assert (was_locked_q || locked_q == lock_key);
      unlocks_by_its_key_disabled_only :
      assert (!was_locked_q || locked_q == !(unlock_key && was_enabled_q == '0));
      locked_registers_hold : assert (!was_locked_q || guarded == was_guarded_q);
      rates_hold_while_enabled :
      assert (was_enabled_q == '0 || limits[25:22] == was_limits_q[25:22]);
      limits_move_by_unlocked_writes_only :
      assert (was_rst_q || (limits[21:10] == was_limits_q[21:10] || unlocked && at_q == 8'h89) &&
              (limits[9:0] == was_limits_q[9:0] || unlocked && at_q == 8'h8a));
      limits_reach_both_axes :
      assert (current_limit == {2{limits[21:10]}} &&
              dead_time[19:10] >= limits[9:0] && dead_time[9:0] >= limits[9:0]);
      sticky_bits_rise_by_their_event_only :
      assert ((sticky & ~was_sticky_q & ~was_events_q) == '0);
      sticky_bits_fall_by_a_written_one_only :
      assert ((was_sticky_q & ~sticky & ~ones) == '0);
      a_written_one_clears : assert ((sticky & ones & ~was_events_q) == '0);
      no_event_is_lost : assert ((was_events_q & ~sticky) == '0);
      prec_addr_counts_behind_its_data_only : assert (was_rst_q || place == place_due);
      irq_is_its_enabled_causes : assert (irq_o == ((sticky[1:0] & hwif_out.irq_en) != '0));
      trips_at_the_next_clock : assert (!was_cause_q || trip);
      trips_for_a_cause_only : assert (!trip || was_trip_q || was_cause_q);
      trip_stays_until_cleared :
      assert (!was_trip_q || trip == !(clear_key && was_enabled_q == '0 && !was_cause_q));
      gates_off_from_reset : assert (!was_rst_q || gates == '0);
      trip_3_clocks_after_the_pin : assert (!pin_q[2] || trip);
      gates_off_4_clocks_after_the_pin : assert (!pin_q[3] || gates == '0);
      gates_off_while_tripped : assert (!was_trip_q || gates == '0);
      gates_off_unless_enabled :
      assert ((gates & ~{2{{3{was_enabled_q[1]}}, {3{was_enabled_q[0]}}}}) == '0);
      no_shoot_through : assert ((gate_hi_o & gate_lo_o) == '0);
      sample_once_both_are_done : assert (sample_o == ((seen_q | done) == '1));
      open_transfers_are_counted : assert (open_q == addresses_q + reads_q);
      next_is_the_least :
      assert (next_o <= timebase_next && next_o <= next_x && next_o <= next_y &&
              (next_o == timebase_next || next_o == next_x || next_o == next_y));
      quiescent_only_if_nothing_is_open : assert (!quiescent_o || open_q == '0);
      quiescent_is_honest :
      assert (!was_quiescent_q || held == was_held_q && lasting == was_lasting_q &&
              gates == was_gates_q && sticky == (was_sticky_q | {was_events_q[13:2], 2'b00}));
      inv_held :
      assert (held_address[10] == aw_q && (!aw_q || held_address[9:0] == awaddr_q) &&
              held_word[36] == w_q && (!w_q || held_word[35:0] == {wstrb_q, wdata_q}) &&
              held_read[10] == ar_q && (!ar_q || held_read[9:0] == araddr_q));
      inv_pointers :
      assert (owes <= 2'd2 && in_flight == owes && read_pointer == answered_q &&
              write_pointer == served_q - 2'(pending) && (!pending || owes != '0));
      inv_table :
      assert (pending == (table_q != '0 || slow_q) && table_waits == table_q &&
              table_q != 2'b11 && !(table_q != '0 && (read_was_last || slow_q)) &&
              slow_waits == slow_q && slot_errors == '0 &&
              (slow_q ? slow_held == {!read_was_last, data_q} &&
               !(owes[1] ? second.known : first.known) : data_q == '0));
      inv_counts :
      assert (addresses_q == 3'(aw_q) + 3'(write_first) + 3'(write_second) &&
              words_q + 3'(aw_q) == addresses_q + 3'(w_q) &&
              reads_q == 3'(ar_q) + 3'(read_first) + 3'(read_second));
      inv_slots :
      assert ((owes == 2'(pending) || owes == 2'd0 || holds(first_slot, first)) &&
              (owes != 2'd2 || pending || holds(second_slot, second)));
      inv_last :
      assert (owes == 2'd0 || read_was_last == (read_second || read_first && !write_second));
      inv_waits :
      assert ((addresses_q == '0 || words_q == '0 || write_wait_q + write_left <= 3'd4) &&
              (reads_q == '0 || read_wait_q + read_left <= 3'd4));
      inv_pulse :
      assert (!hwif_out.commit.take.value && !hwif_out.x.ctrl.reset_table.value &&
              !hwif_out.y.ctrl.reset_table.value || owes != '0);
      inv_rest :
      assert (trip_q == was_trip_q && seen_q == done_q && done_q != '1 && pin_stages == pin_q[1:0]);
      reaches_a_write_response : cover (s_axil_bvalid_o && write_wait_q == 3'd1);
      reaches_a_read_response : cover (s_axil_rvalid_o && s_axil_rdata_o == 32'h4b58_0005);
      reaches_a_trip_by_the_pin : cover (trip && pin_q == 4'b0111 && enabled == '1);
      reaches_gates_on : cover (gate_hi_o[0] && gate_hi_o[5]);
      reaches_locked : cover (locked_q && enabled != '0);
      reaches_an_unlock : cover (was_locked_q && !locked_q && !was_rst_q);
    end
  end
  // prove: cut afc current_loop adc_if qep command pwm precision edge_time
  // prove: leap inv_held inv_pointers inv_table inv_counts inv_pulse inv_rest
  // prove: leap open_transfers_are_counted
  // breaks no_response_from_reset (kung_xy_regs): axil_resp_wptr <= rst_i ? 2'd1 : next
  // breaks write_response_stays (kung_xy_regs): axil_resp_acked = axil_resp_acked || s_axil_bvalid_o
  // breaks read_response_stays, responses_in_order (kung_xy_regs): axil_n_in_flight <= next == 2'd2 ? 2'd1 : next
  // breaks no_write_response_without_request (kung_xy_regs): axil_wvalid = axil_awvalid
  // breaks no_read_response_without_request (kung_xy_regs): axil_arvalid = axil_arvalid || !axil_prev_was_rd
  // breaks every_response_is_okay (kung_xy_regs): readback_err = rd_mux_addr > 10'h240
  // breaks lone_request_answered_after_2_clocks, read_answered_within_4_clocks (kung_xy_regs): axil_arvalid = axil_arvalid && (!axil_prev_was_rd || axil_awvalid)
  // breaks write_answered_within_4_clocks (kung_xy_regs): axil_wvalid = axil_wvalid && !axil_arvalid
  // breaks write_answered_within_4_clocks (kung_axis): tab_write = tab_write && tick_cur_i
  // breaks reads_show_the_register (kung_xy_regs): rd_mux_addr = external_pending ? pending_rd_addr : cpuif_addr & 10'h1ff
  // breaks reads_show_the_register: u_regs.hwif_in_lock_rd_data = {31'd0, trip_q}
  // breaks unlocked_from_reset: locked_q <= rst_i || next
  // breaks locks_by_its_key_only: lock_write = hwif_out.lock.req
  // breaks unlocks_by_its_key_disabled_only: locked_d = lock_write && lock_key == kung_xy_regs_pkg::KeyUnlock && enabled != '1 ? 1'b0 : locked_d
  // breaks locked_registers_hold: u_regs.hwif_in_watchdog_limit_swwel = trip_q
  // breaks locked_registers_hold (kung_xy_regs): hwif_in_x_angle_step_value_swwel = 1'b0
  // breaks locked_registers_hold (kung_xy_regs): hwif_in_y_deadtime_clk_swwel = 1'b0
  // breaks rates_hold_while_enabled: rates_hold = locked_q
  // breaks limits_move_by_unlocked_writes_only (kung_xy_regs): field_storage_current_limit_value_value <= decoded_req && decoded_req_is_wr && decoded_addr == 10'h124 && !hwif_in_current_limit_value_swwel ? decoded_wr_data[11:0] : next
  // breaks limits_reach_both_axes (kung_axis): dead_time = regs_i.deadtime.clk.value < dead_time_min_i ? 10'd25 : regs_i.deadtime.clk.value
  // breaks limits_reach_both_axes: gen_axis[1].u_axis.current_limit_i = hwif_out.current_limit.value.value >> 1
  // breaks sticky_bits_rise_by_their_event_only, no_event_is_lost: u_regs.hwif_in_irq_stat_tick_hwset = trip
  // breaks sticky_bits_fall_by_a_written_one_only, a_written_one_clears (kung_xy_regs): field_storage_y_status_limited_value <= decoded_reg_strb_y_status && decoded_req_is_wr && !hwif_in_y_status_limited_hwset && !rst_i ? field_storage_y_status_limited_value & ~(decoded_wr_data[3] & decoded_wr_biten[4]) : next
  // breaks prec_addr_counts_behind_its_data_only: gen_axis[1].u_axis.precision_i = precision_axis[0]
  // breaks prec_addr_counts_behind_its_data_only (kung_precision): counts_d = '1
  // breaks write_answered_within_4_clocks (kung_precision): waits_q <= request && !rst_i
  // breaks irq_is_its_enabled_causes: irq_o = (hwif_out.irq_stat.tick.value && hwif_out.irq_en.tick.value) || (tick_irq && hwif_out.irq_en.fault.value)
  // breaks trips_at_the_next_clock: u_supervisor.stroke_i = stroke & enabled
  // breaks trips_for_a_cause_only: u_supervisor.watchdog_i = tick_pos
  // breaks trip_stays_until_cleared: u_supervisor.enabled_i = enabled & 2'b01
  // breaks trip_3_clocks_after_the_pin (supervisor): pin_q <= next && pin_q
  // breaks gates_off_4_clocks_after_the_pin, gates_off_while_tripped: gen_axis[0].u_axis.trip_i = trip && trip_q
  // breaks gates_off_from_reset (gate_leg): hi_q <= rst_i ? on_i : next
  // breaks gates_off_unless_enabled: gen_axis[1].u_axis.regs_i = hwif_out.x
  // breaks no_shoot_through (gate_leg): lo_d = ready
  // breaks sample_once_both_are_done: done_q <= rst_i ? next : all_done
  // breaks open_transfers_are_counted: open_d = open_q + 3'(s_axil_awvalid_i && s_axil_awready_o) + 3'(s_axil_arvalid_i) - 3'(s_axil_bvalid_o && s_axil_bready_i) - 3'(s_axil_rvalid_o && s_axil_rready_i)
  // breaks next_is_the_least: next_o = axis_next[1] > next_o ? axis_next[1] : next_o
  // breaks quiescent_only_if_nothing_is_open, quiescent_is_honest: bus_idle = !s_axil_awvalid_i && !s_axil_wvalid_i && !s_axil_arvalid_i
  // breaks quiescent_is_honest: quiescent_o = bus_idle && timebase_quiescent && watchdog_quiescent && supervisor_quiescent && done == '0 && unused_axis_quiescent == '1

endmodule

bind kung_xy kung_xy_props u_kung_xy_props (
    .*,
    .fault        ({fault_tick[23:0], 3'd0, fault_axis, fault_code}),
    .causes       ({bite, over_current, encoder, stroke}),
    .serves_write(u_regs.axil_aw_accept), .serves_read(u_regs.axil_ar_accept),
    .pending(u_regs.external_pending), .in_flight(u_regs.axil_n_in_flight),
    .write_pointer(u_regs.axil_resp_wptr), .read_pointer(u_regs.axil_resp_rptr),
    .slot_even    ({u_regs.axil_resp_buffer_is_wr[0], u_regs.axil_resp_buffer_rdata[0]}),
    .slot_odd     ({u_regs.axil_resp_buffer_is_wr[1], u_regs.axil_resp_buffer_rdata[1]}),
    .slot_errors  ({u_regs.axil_resp_buffer_err[1], u_regs.axil_resp_buffer_err[0]}),
    .held_address ({u_regs.axil_awvalid, u_regs.axil_awaddr}),
    .held_word    ({u_regs.axil_wvalid, u_regs.axil_wstrb, u_regs.axil_wdata}),
    .held_read    ({u_regs.axil_arvalid, u_regs.axil_araddr}),
    .read_was_last(u_regs.axil_prev_was_rd),
    .pin_stages   ({u_supervisor.pin_q, u_supervisor.meta_q}),
    .busy         ({axis_in[1].status.busy.next, axis_in[0].status.busy.next}),
    .axis_events  ({axis_in[1].status[12:7], axis_in[0].status[12:7]}),
    .table_waits  ({gen_axis[1].u_axis.tab_pending_q, gen_axis[0].u_axis.tab_pending_q}),
    .slow_ack(u_precision.law_ack), .slow_waits(u_precision.waits_q), .next_x(axis_next[0]),
    .slow_held({u_precision.we_q, u_precision.counts_q}), .next_y(axis_next[1]),
    .dead_time    ({gen_axis[1].u_axis.dead_time, gen_axis[0].u_axis.dead_time}),
    .current_limit({gen_axis[1].u_axis.current_limit_i, gen_axis[0].u_axis.current_limit_i})
);
