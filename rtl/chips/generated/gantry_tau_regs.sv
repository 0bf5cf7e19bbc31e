// Generated from rtl/chips/gantry_tau.rdl by scripts/tool gen-register-map; do not edit.
// SPDX-License-Identifier: Apache-2.0
// verilator lint_off UNUSEDSIGNAL
// verilator lint_off UNUSEDPARAM

module gantry_tau_regs (
        input wire clk_i,
        input wire rst_i,

        output logic s_axil_awready_o,
        input wire s_axil_awvalid_i,
        input wire [6:0] s_axil_awaddr_i,
        input wire [2:0] s_axil_awprot_i,
        output logic s_axil_wready_o,
        input wire s_axil_wvalid_i,
        input wire [31:0] s_axil_wdata_i,
        input wire [3:0]s_axil_wstrb_i,
        input wire s_axil_bready_i,
        output logic s_axil_bvalid_o,
        output logic [1:0] s_axil_bresp_o,
        output logic s_axil_arready_o,
        input wire s_axil_arvalid_i,
        input wire [6:0] s_axil_araddr_i,
        input wire [2:0] s_axil_arprot_i,
        input wire s_axil_rready_i,
        output logic s_axil_rvalid_o,
        output logic [31:0] s_axil_rdata_o,
        output logic [1:0] s_axil_rresp_o,

        input gantry_tau_regs_pkg::gantry_tau__in_t hwif_in,
        output gantry_tau_regs_pkg::gantry_tau__out_t hwif_out
    );

    wire hwif_in_status_pass_hwset = hwif_in.status.pass.hwset;
    wire hwif_in_status_sample_hwset = hwif_in.status.sample.hwset;
    wire hwif_in_status_overrun_hwset = hwif_in.status.overrun.hwset;
    wire hwif_in_status_refused_hwset = hwif_in.status.refused.hwset;
    wire hwif_in_status_stored_hwset = hwif_in.status.stored.hwset;
    wire [31:0] hwif_in_position_value_next = hwif_in.position.value.next;
    wire [31:0] hwif_in_velocity_value_next = hwif_in.velocity.value.next;
    wire [13:0] hwif_in_angle_phase_next = hwif_in.angle.phase.next;
    wire [1:0] hwif_in_angle_region_next = hwif_in.angle.region.next;
    wire hwif_in_angle_known_next = hwif_in.angle.known.next;
    wire [31:0] hwif_in_ticks_value_next = hwif_in.ticks.value.next;
    wire [6:0] hwif_in_request_pending_next = hwif_in.request.pending.next;
    wire [9:0] hwif_in_encoder_a_code_next = hwif_in.encoder_a.code.next;
    wire [9:0] hwif_in_encoder_a_dot_next = hwif_in.encoder_a.dot.next;
    wire [9:0] hwif_in_encoder_b_code_next = hwif_in.encoder_b.code.next;
    wire [9:0] hwif_in_encoder_b_dot_next = hwif_in.encoder_b.dot.next;
    wire [9:0] hwif_in_current_code_next = hwif_in.current.code.next;
    wire hwif_in_overtemp_motor_1_next = hwif_in.overtemp.motor_1.next;
    wire hwif_in_overtemp_motor_2_next = hwif_in.overtemp.motor_2.next;
    wire hwif_in_status_frame_next = hwif_in.status.frame.next;
    wire [4:0] hwif_in_receive_channel_next = hwif_in.receive.channel.next;
    wire [2:0] hwif_in_receive_kind_next = hwif_in.receive.kind.next;
    wire hwif_in_receive_waits_next = hwif_in.receive.waits.next;
    wire [31:0] hwif_in_receive_value_value_next = hwif_in.receive_value.value.next;
    wire [15:0] hwif_in_receive_errors_malformed_next = hwif_in.receive_errors.malformed.next;
    wire [15:0] hwif_in_receive_errors_lost_next = hwif_in.receive_errors.lost.next;
    wire [5:0] hwif_in_send_state_room_next = hwif_in.send_state.room.next;
    wire hwif_in_send_state_idle_next = hwif_in.send_state.idle.next;
    wire [15:0] hwif_in_send_state_lost_next = hwif_in.send_state.lost.next;
    wire hwif_in_calibration_valid_next = hwif_in.calibration.valid.next;
    wire hwif_in_calibration_busy_next = hwif_in.calibration.busy.next;
    wire [5:0] hwif_in_calibration_count_next = hwif_in.calibration.count.next;

    // CPU Bus interface logic
    logic cpuif_req, cpuif_req_is_wr;
    logic [6:0] cpuif_addr;
    logic [31:0] cpuif_wr_data, cpuif_wr_biten;
    logic cpuif_req_stall_wr, cpuif_req_stall_rd;

    logic cpuif_rd_ack, cpuif_rd_err;
    logic [31:0] cpuif_rd_data;

    logic cpuif_wr_ack, cpuif_wr_err;

    // Max Outstanding Transactions: 2
    logic [1:0] axil_n_in_flight;
    logic axil_prev_was_rd, axil_arvalid;
    logic [6:0] axil_araddr;
    logic axil_ar_accept, axil_awvalid;
    logic [6:0] axil_awaddr;
    logic axil_wvalid;
    logic [31:0] axil_wdata;
    logic [3:0] axil_wstrb;
    logic axil_aw_accept, axil_resp_acked;

    // Transaction request acceptance
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            axil_prev_was_rd <= '0; axil_arvalid <= '0; axil_araddr <= '0; axil_awvalid <= '0;
            axil_awaddr <= '0; axil_wvalid <= '0; axil_wdata <= '0; axil_wstrb <= '0;
            axil_n_in_flight <= '0;
        end else begin
            // AR* acceptance register
            if(axil_ar_accept) begin
                axil_prev_was_rd <= '1; axil_arvalid <= '0;
            end
            if(s_axil_arvalid_i && s_axil_arready_o) begin
                axil_arvalid <= '1; axil_araddr <= s_axil_araddr_i;
            end

            // AW* & W* acceptance registers
            if(axil_aw_accept) begin
                axil_prev_was_rd <= '0; axil_awvalid <= '0; axil_wvalid <= '0;
            end
            if(s_axil_awvalid_i && s_axil_awready_o) begin
                axil_awvalid <= '1; axil_awaddr <= s_axil_awaddr_i;
            end
            if(s_axil_wvalid_i && s_axil_wready_o) begin
                axil_wvalid <= '1; axil_wdata <= s_axil_wdata_i; axil_wstrb <= s_axil_wstrb_i;
            end

            // Keep track of in-flight transactions
            if((axil_ar_accept || axil_aw_accept) && !axil_resp_acked) begin
                axil_n_in_flight <= axil_n_in_flight + 1'b1;
            end else if(!(axil_ar_accept || axil_aw_accept) && axil_resp_acked) axil_n_in_flight <= axil_n_in_flight - 1'b1;
        end
    end

    always_comb begin
        s_axil_arready_o = (!axil_arvalid || axil_ar_accept);
        s_axil_awready_o = (!axil_awvalid || axil_aw_accept);
        s_axil_wready_o = (!axil_wvalid || axil_aw_accept);
    end

    // Request dispatch
    always_comb begin
        cpuif_wr_data = axil_wdata;
        for(int i=0; i<4; i++) cpuif_wr_biten[i*8 +: 8] = {8{axil_wstrb[i]}};
        cpuif_req = '0; cpuif_req_is_wr = '0; cpuif_addr = '0; axil_ar_accept = '0;
        axil_aw_accept = '0;

        if(axil_n_in_flight < 2'd2) begin
            // Can safely issue more transactions without overwhelming response buffer
            if(axil_arvalid && !axil_prev_was_rd) begin
                cpuif_req = '1; cpuif_req_is_wr = '0;
                cpuif_addr = {axil_araddr[6:2], 2'b0};
                if(!cpuif_req_stall_rd) axil_ar_accept = '1;
            end else if(axil_awvalid && axil_wvalid) begin
                cpuif_req = '1; cpuif_req_is_wr = '1;
                cpuif_addr = {axil_awaddr[6:2], 2'b0};
                if(!cpuif_req_stall_wr) axil_aw_accept = '1;
            end else if(axil_arvalid) begin
                cpuif_req = '1; cpuif_req_is_wr = '0;
                cpuif_addr = {axil_araddr[6:2], 2'b0};
                if(!cpuif_req_stall_rd) axil_ar_accept = '1;
            end
        end
    end


    // AXI4-Lite Response Logic
    logic axil_resp_buffer_is_wr[2];
    logic axil_resp_buffer_err[2];
    logic [31:0] axil_resp_buffer_rdata[2];

    logic [1:0] axil_resp_wptr, axil_resp_rptr;

    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            for(int i=0; i<2; i++) begin
                axil_resp_buffer_is_wr[i] <= '0; axil_resp_buffer_err[i] <= '0;
                axil_resp_buffer_rdata[i] <= '0;
            end
            axil_resp_wptr <= '0; axil_resp_rptr <= '0;
        end else begin
            // Store responses in buffer until AXI response channel accepts them
            if(cpuif_rd_ack || cpuif_wr_ack) begin
                if(cpuif_rd_ack) begin
                    axil_resp_buffer_is_wr[axil_resp_wptr[0:0]] <= '0;
                    axil_resp_buffer_err[axil_resp_wptr[0:0]] <= cpuif_rd_err;
                    axil_resp_buffer_rdata[axil_resp_wptr[0:0]] <= cpuif_rd_data;

                end else if(cpuif_wr_ack) begin
                    axil_resp_buffer_is_wr[axil_resp_wptr[0:0]] <= '1;
                    axil_resp_buffer_err[axil_resp_wptr[0:0]] <= cpuif_wr_err;
                end
                axil_resp_wptr <= axil_resp_wptr + 1'b1;
            end

            // Advance read pointer when acknowledged
            if(axil_resp_acked) axil_resp_rptr <= axil_resp_rptr + 1'b1;
        end
    end

    always_comb begin
        axil_resp_acked = '0; s_axil_bvalid_o = '0; s_axil_rvalid_o = '0;
        if(axil_resp_rptr != axil_resp_wptr) begin
            if(axil_resp_buffer_is_wr[axil_resp_rptr[0:0]]) begin
                s_axil_bvalid_o = '1;
                if(s_axil_bready_i) axil_resp_acked = '1;
            end else begin
                s_axil_rvalid_o = '1;
                if(s_axil_rready_i) axil_resp_acked = '1;
            end
        end

        s_axil_rdata_o = axil_resp_buffer_rdata[axil_resp_rptr[0:0]];
        if(axil_resp_buffer_err[axil_resp_rptr[0:0]]) begin
            s_axil_bresp_o = 2'b10; s_axil_rresp_o = 2'b10;
        end else begin
            s_axil_bresp_o = 2'b00; s_axil_rresp_o = 2'b00;
        end
    end

    logic cpuif_req_masked;

    // Read & write latencies are balanced. Stalls not required
    assign cpuif_req_stall_rd = '0;
    assign cpuif_req_stall_wr = '0;
    assign cpuif_req_masked = cpuif_req
                            & !(!cpuif_req_is_wr & cpuif_req_stall_rd)
                            & !(cpuif_req_is_wr & cpuif_req_stall_wr);

    // Address Decode
    logic decoded_reg_strb_observer, decoded_reg_strb_request, decoded_reg_strb_pass_period;
    logic decoded_reg_strb_status, decoded_reg_strb_receive, decoded_reg_strb_send;
    logic decoded_reg_strb_calibrate, decoded_err;
    logic [6:0] decoded_addr;
    logic decoded_req, decoded_req_is_wr;
    logic [31:0] decoded_wr_data, decoded_wr_biten;

    always_comb begin
        automatic logic is_valid_addr;
        automatic logic is_valid_rw;
        is_valid_addr = '1; // No valid address check
        is_valid_rw = '1; // No valid RW check
        decoded_reg_strb_observer = cpuif_req_masked & (cpuif_addr == 7'h4);
        decoded_reg_strb_request = cpuif_req_masked & (cpuif_addr == 7'h1c);
        decoded_reg_strb_pass_period = cpuif_req_masked & (cpuif_addr == 7'h38);
        decoded_reg_strb_status = cpuif_req_masked & (cpuif_addr == 7'h3c);
        decoded_reg_strb_receive = cpuif_req_masked & (cpuif_addr == 7'h44);
        decoded_reg_strb_send = cpuif_req_masked & (cpuif_addr == 7'h54);
        decoded_reg_strb_calibrate = cpuif_req_masked & (cpuif_addr == 7'h5c);
        decoded_err = '0;
    end

    // Pass down signals to next stage
    assign decoded_addr = cpuif_addr;
    assign decoded_req = cpuif_req_masked;
    assign decoded_req_is_wr = cpuif_req_is_wr;
    assign decoded_wr_data = cpuif_wr_data;
    assign decoded_wr_biten = cpuif_wr_biten;

    // Field logic

    logic field_storage_observer_active_value, field_storage_observer_velocity_value;
    logic [7:0] field_storage_slots_observer_value, field_storage_slots_requester_value;
    logic field_storage_request_a_value, field_storage_request_a_dot_value;
    logic field_storage_request_b_value, field_storage_request_b_dot_value;
    logic field_storage_request_current_value;
    logic [10:0] field_storage_force_1_value_value, field_storage_force_2_value_value;
    logic [23:0] field_storage_pass_period_clocks_value;
    logic field_storage_status_pass_value, field_storage_status_sample_value;
    logic field_storage_status_overrun_value, field_storage_status_refused_value;
    logic field_storage_status_stored_value, field_storage_irq_enable_pass_value;
    logic field_storage_irq_enable_frame_value, field_storage_irq_enable_sample_value;
    logic field_storage_receive_take_value;
    logic [31:0] field_storage_send_value_value_value;
    logic [4:0] field_storage_send_channel_value;
    logic [2:0] field_storage_send_kind_value;
    logic [15:0] field_storage_calibrate_word_value;
    logic [2:0] field_storage_calibrate_command_value;
    logic [23:0] field_storage_receive_gap_clocks_value;

    // Fields that software alone writes
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_observer_active_value <= 1'h0;
            field_storage_observer_velocity_value <= 1'h0;
            field_storage_slots_observer_value <= 8'h2; field_storage_slots_requester_value <= 8'h1;
            field_storage_force_1_value_value <= 11'h0; field_storage_force_2_value_value <= 11'h0;
            field_storage_pass_period_clocks_value <= 24'h186a0;
            field_storage_irq_enable_pass_value <= 1'h0;
            field_storage_irq_enable_frame_value <= 1'h0;
            field_storage_irq_enable_sample_value <= 1'h0;
            field_storage_send_value_value_value <= 32'h0; field_storage_send_channel_value <= 5'h0;
            field_storage_send_kind_value <= 3'h4; field_storage_calibrate_word_value <= 16'h0;
            field_storage_calibrate_command_value <= 3'h0;
            field_storage_receive_gap_clocks_value <= 24'h7b3c6;
        end else if(decoded_req && decoded_req_is_wr) begin
            if(decoded_addr == 7'h4) begin
                if(decoded_wr_biten[0]) field_storage_observer_active_value <= decoded_wr_data[0:0];
                if(decoded_wr_biten[4]) field_storage_observer_velocity_value <= decoded_wr_data[4:4];
            end
            if(decoded_addr == 7'h18) begin
                if(decoded_wr_biten[0]) field_storage_slots_observer_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[16]) field_storage_slots_requester_value[7:0] <= decoded_wr_data[23:16];
            end
            if(decoded_addr == 7'h2c) begin
                if(decoded_wr_biten[0]) field_storage_force_1_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_force_1_value_value[10:8] <= decoded_wr_data[10:8];
            end
            if(decoded_addr == 7'h30) begin
                if(decoded_wr_biten[0]) field_storage_force_2_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_force_2_value_value[10:8] <= decoded_wr_data[10:8];
            end
            if(decoded_addr == 7'h38) begin
                if(decoded_wr_biten[0]) field_storage_pass_period_clocks_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_pass_period_clocks_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_pass_period_clocks_value[23:16] <= decoded_wr_data[23:16];
            end
            if(decoded_addr == 7'h40) begin
                if(decoded_wr_biten[0]) field_storage_irq_enable_pass_value <= decoded_wr_data[0:0];
                if(decoded_wr_biten[1]) field_storage_irq_enable_frame_value <= decoded_wr_data[1:1];
                if(decoded_wr_biten[2]) field_storage_irq_enable_sample_value <= decoded_wr_data[2:2];
            end
            if(decoded_addr == 7'h50) begin
                if(decoded_wr_biten[0]) field_storage_send_value_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_send_value_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_send_value_value_value[23:16] <= decoded_wr_data[23:16];
                if(decoded_wr_biten[24]) field_storage_send_value_value_value[31:24] <= decoded_wr_data[31:24];
            end
            if(decoded_addr == 7'h54) begin
                if(decoded_wr_biten[0]) field_storage_send_channel_value[4:0] <= decoded_wr_data[4:0];
                if(decoded_wr_biten[8]) field_storage_send_kind_value[2:0] <= decoded_wr_data[10:8];
            end
            if(decoded_addr == 7'h5c) begin
                if(decoded_wr_biten[0]) field_storage_calibrate_word_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_calibrate_word_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_calibrate_command_value[2:0] <= decoded_wr_data[18:16];
            end
            if(decoded_addr == 7'h64) begin
                if(decoded_wr_biten[0]) field_storage_receive_gap_clocks_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_receive_gap_clocks_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_receive_gap_clocks_value[23:16] <= decoded_wr_data[23:16];
            end
        end
    end
    assign hwif_out.observer.active.value = field_storage_observer_active_value;
    assign hwif_out.observer.active.swmod = decoded_reg_strb_observer && decoded_req_is_wr && |(decoded_wr_biten[0:0]);
    assign hwif_out.observer.velocity.value = field_storage_observer_velocity_value;
    assign hwif_out.slots.observer.value = field_storage_slots_observer_value;
    assign hwif_out.slots.requester.value = field_storage_slots_requester_value;
    // Field: gantry_tau.request.a
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_request_a_value <= 1'h0;
        end else if(decoded_reg_strb_request && decoded_req_is_wr) begin // SW write
            field_storage_request_a_value <= (field_storage_request_a_value & ~decoded_wr_biten[0:0]) | (decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
        end else begin // singlepulse clears back to 0
            field_storage_request_a_value <= '0;
        end
    end
    assign hwif_out.request.a.value = field_storage_request_a_value;
    // Field: gantry_tau.request.a_dot
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_request_a_dot_value <= 1'h0;
        end else if(decoded_reg_strb_request && decoded_req_is_wr) begin // SW write
            field_storage_request_a_dot_value <= (field_storage_request_a_dot_value & ~decoded_wr_biten[1:1]) | (decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
        end else begin // singlepulse clears back to 0
            field_storage_request_a_dot_value <= '0;
        end
    end
    assign hwif_out.request.a_dot.value = field_storage_request_a_dot_value;
    // Field: gantry_tau.request.b
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_request_b_value <= 1'h0;
        end else if(decoded_reg_strb_request && decoded_req_is_wr) begin // SW write
            field_storage_request_b_value <= (field_storage_request_b_value & ~decoded_wr_biten[2:2]) | (decoded_wr_data[2:2] & decoded_wr_biten[2:2]);
        end else begin // singlepulse clears back to 0
            field_storage_request_b_value <= '0;
        end
    end
    assign hwif_out.request.b.value = field_storage_request_b_value;
    // Field: gantry_tau.request.b_dot
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_request_b_dot_value <= 1'h0;
        end else if(decoded_reg_strb_request && decoded_req_is_wr) begin // SW write
            field_storage_request_b_dot_value <= (field_storage_request_b_dot_value & ~decoded_wr_biten[3:3]) | (decoded_wr_data[3:3] & decoded_wr_biten[3:3]);
        end else begin // singlepulse clears back to 0
            field_storage_request_b_dot_value <= '0;
        end
    end
    assign hwif_out.request.b_dot.value = field_storage_request_b_dot_value;
    // Field: gantry_tau.request.current
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_request_current_value <= 1'h0;
        end else if(decoded_reg_strb_request && decoded_req_is_wr) begin // SW write
            field_storage_request_current_value <= (field_storage_request_current_value & ~decoded_wr_biten[6:6]) | (decoded_wr_data[6:6] & decoded_wr_biten[6:6]);
        end else begin // singlepulse clears back to 0
            field_storage_request_current_value <= '0;
        end
    end
    assign hwif_out.request.current.value = field_storage_request_current_value;
    assign hwif_out.force_1.value.value = field_storage_force_1_value_value;
    assign hwif_out.force_2.value.value = field_storage_force_2_value_value;
    assign hwif_out.pass_period.clocks.value = field_storage_pass_period_clocks_value;
    assign hwif_out.pass_period.clocks.swmod = decoded_reg_strb_pass_period && decoded_req_is_wr && |(decoded_wr_biten[23:0]);
    // Field: gantry_tau.status.pass
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_status_pass_value <= 1'h0;
        end else if(hwif_in_status_pass_hwset) begin // HW Set
            field_storage_status_pass_value <= '1;
        end else if(decoded_reg_strb_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_status_pass_value <= field_storage_status_pass_value & ~(decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
        end
    end
    assign hwif_out.status.pass.value = field_storage_status_pass_value;
    // Field: gantry_tau.status.sample
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_status_sample_value <= 1'h0;
        end else if(hwif_in_status_sample_hwset) begin // HW Set
            field_storage_status_sample_value <= '1;
        end else if(decoded_reg_strb_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_status_sample_value <= field_storage_status_sample_value & ~(decoded_wr_data[2:2] & decoded_wr_biten[2:2]);
        end
    end
    assign hwif_out.status.sample.value = field_storage_status_sample_value;
    // Field: gantry_tau.status.overrun
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_status_overrun_value <= 1'h0;
        end else if(hwif_in_status_overrun_hwset) begin // HW Set
            field_storage_status_overrun_value <= '1;
        end else if(decoded_reg_strb_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_status_overrun_value <= field_storage_status_overrun_value & ~(decoded_wr_data[3:3] & decoded_wr_biten[3:3]);
        end
    end
    assign hwif_out.status.overrun.value = field_storage_status_overrun_value;
    // Field: gantry_tau.status.refused
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_status_refused_value <= 1'h0;
        end else if(hwif_in_status_refused_hwset) begin // HW Set
            field_storage_status_refused_value <= '1;
        end else if(decoded_reg_strb_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_status_refused_value <= field_storage_status_refused_value & ~(decoded_wr_data[4:4] & decoded_wr_biten[4:4]);
        end
    end
    assign hwif_out.status.refused.value = field_storage_status_refused_value;
    // Field: gantry_tau.status.stored
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_status_stored_value <= 1'h0;
        end else if(hwif_in_status_stored_hwset) begin // HW Set
            field_storage_status_stored_value <= '1;
        end else if(decoded_reg_strb_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_status_stored_value <= field_storage_status_stored_value & ~(decoded_wr_data[5:5] & decoded_wr_biten[5:5]);
        end
    end
    assign hwif_out.status.stored.value = field_storage_status_stored_value;
    assign hwif_out.irq_enable.pass.value = field_storage_irq_enable_pass_value;
    assign hwif_out.irq_enable.frame.value = field_storage_irq_enable_frame_value;
    assign hwif_out.irq_enable.sample.value = field_storage_irq_enable_sample_value;
    // Field: gantry_tau.receive.take
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_receive_take_value <= 1'h0;
        end else if(decoded_reg_strb_receive && decoded_req_is_wr) begin // SW write
            field_storage_receive_take_value <= (field_storage_receive_take_value & ~decoded_wr_biten[0:0]) | (decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
        end else begin // singlepulse clears back to 0
            field_storage_receive_take_value <= '0;
        end
    end
    assign hwif_out.receive.take.value = field_storage_receive_take_value;
    assign hwif_out.send_value.value.value = field_storage_send_value_value_value;
    assign hwif_out.send.channel.value = field_storage_send_channel_value;
    assign hwif_out.send.channel.swmod = decoded_reg_strb_send && decoded_req_is_wr && |(decoded_wr_biten[4:0]);
    assign hwif_out.send.kind.value = field_storage_send_kind_value;
    assign hwif_out.calibrate.word.value = field_storage_calibrate_word_value;
    assign hwif_out.calibrate.word.swmod = decoded_reg_strb_calibrate && decoded_req_is_wr && |(decoded_wr_biten[15:0]);
    assign hwif_out.calibrate.command.value = field_storage_calibrate_command_value;
    assign hwif_out.receive_gap.clocks.value = field_storage_receive_gap_clocks_value;

    // Write response
    assign cpuif_wr_ack = decoded_req & decoded_req_is_wr;
    // Writes are always granted with no error response
    assign cpuif_wr_err = '0;

    // Readback

    logic [6:0] rd_mux_addr;
    assign rd_mux_addr = decoded_addr;

    logic readback_err, readback_done;
    assign readback_done = decoded_req & ~decoded_req_is_wr;
    logic [31:0] readback_data;
    always_comb begin
        automatic logic [31:0] readback_data_var;
        readback_data_var = '0;
        if(cpuif_rd_ack) begin
            unique case(rd_mux_addr)
                7'h0: begin
                    readback_data_var[15:0] = 16'h1; readback_data_var[31:16] = 16'h4754;
                end
                7'h4: begin
                    readback_data_var[0] = field_storage_observer_active_value;
                    readback_data_var[4] = field_storage_observer_velocity_value;
                end
                7'h8: readback_data_var[31:0] = hwif_in_position_value_next;
                7'hc: begin
                    readback_data_var[31:0] = hwif_in_velocity_value_next;
                end
                7'h10: begin
                    readback_data_var[13:0] = hwif_in_angle_phase_next;
                    readback_data_var[17:16] = hwif_in_angle_region_next;
                    readback_data_var[31] = hwif_in_angle_known_next;
                end
                7'h14: readback_data_var[31:0] = hwif_in_ticks_value_next;
                7'h18: begin
                    readback_data_var[7:0] = field_storage_slots_observer_value;
                    readback_data_var[23:16] = field_storage_slots_requester_value;
                end
                7'h1c: begin
                    readback_data_var[6:0] = hwif_in_request_pending_next;
                end
                7'h20: begin
                    readback_data_var[9:0] = hwif_in_encoder_a_code_next;
                    readback_data_var[25:16] = hwif_in_encoder_a_dot_next;
                end
                7'h24: begin
                    readback_data_var[9:0] = hwif_in_encoder_b_code_next;
                    readback_data_var[25:16] = hwif_in_encoder_b_dot_next;
                end
                7'h28: readback_data_var[9:0] = hwif_in_current_code_next;
                7'h2c: begin
                    readback_data_var[10:0] = field_storage_force_1_value_value;
                end
                7'h30: readback_data_var[10:0] = field_storage_force_2_value_value;
                7'h34: begin
                    readback_data_var[0] = hwif_in_overtemp_motor_1_next;
                    readback_data_var[1] = hwif_in_overtemp_motor_2_next;
                end
                7'h38: readback_data_var[23:0] = field_storage_pass_period_clocks_value;
                7'h3c: begin
                    readback_data_var[0] = field_storage_status_pass_value;
                    readback_data_var[1] = hwif_in_status_frame_next;
                    readback_data_var[2] = field_storage_status_sample_value;
                    readback_data_var[3] = field_storage_status_overrun_value;
                    readback_data_var[4] = field_storage_status_refused_value;
                    readback_data_var[5] = field_storage_status_stored_value;
                end
                7'h40: begin
                    readback_data_var[0] = field_storage_irq_enable_pass_value;
                    readback_data_var[1] = field_storage_irq_enable_frame_value;
                    readback_data_var[2] = field_storage_irq_enable_sample_value;
                end
                7'h44: begin
                    readback_data_var[4:0] = hwif_in_receive_channel_next;
                    readback_data_var[10:8] = hwif_in_receive_kind_next;
                    readback_data_var[31] = hwif_in_receive_waits_next;
                end
                7'h48: readback_data_var[31:0] = hwif_in_receive_value_value_next;
                7'h4c: begin
                    readback_data_var[15:0] = hwif_in_receive_errors_malformed_next;
                    readback_data_var[31:16] = hwif_in_receive_errors_lost_next;
                end
                7'h50: readback_data_var[31:0] = field_storage_send_value_value_value;
                7'h54: begin
                    readback_data_var[4:0] = field_storage_send_channel_value;
                    readback_data_var[10:8] = field_storage_send_kind_value;
                end
                7'h58: begin
                    readback_data_var[5:0] = hwif_in_send_state_room_next;
                    readback_data_var[8] = hwif_in_send_state_idle_next;
                    readback_data_var[31:16] = hwif_in_send_state_lost_next;
                end
                7'h5c: begin
                    readback_data_var[15:0] = field_storage_calibrate_word_value;
                    readback_data_var[18:16] = field_storage_calibrate_command_value;
                end
                7'h60: begin
                    readback_data_var[0] = hwif_in_calibration_valid_next;
                    readback_data_var[1] = hwif_in_calibration_busy_next;
                    readback_data_var[13:8] = hwif_in_calibration_count_next;
                end
                7'h64: readback_data_var[23:0] = field_storage_receive_gap_clocks_value;
                default: ;
            endcase
        end
        readback_data = readback_data_var; readback_err = '0;
    end

    assign cpuif_rd_ack = readback_done;
    assign cpuif_rd_data = readback_data;
    assign cpuif_rd_err = readback_err;
endmodule
// verilator lint_on UNUSEDSIGNAL
// verilator lint_on UNUSEDPARAM
