// Generated from rtl/chips/kung_xy.rdl by scripts/tool gen-register-map; do not edit.
// SPDX-License-Identifier: Apache-2.0
// verilator lint_off UNUSEDSIGNAL
// verilator lint_off UNUSEDPARAM

module kung_xy_regs (
        input wire clk_i,
        input wire rst_i,

        output logic s_axil_awready_o,
        input wire s_axil_awvalid_i,
        input wire [9:0] s_axil_awaddr_i,
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
        input wire [9:0] s_axil_araddr_i,
        input wire [2:0] s_axil_arprot_i,
        input wire s_axil_rready_i,
        output logic s_axil_rvalid_o,
        output logic [31:0] s_axil_rdata_o,
        output logic [1:0] s_axil_rresp_o,

        input kung_xy_regs_pkg::kung_xy__in_t hwif_in,
        output kung_xy_regs_pkg::kung_xy__out_t hwif_out
    );

    wire hwif_in_x_deadtime_clk_swwel = hwif_in.x.deadtime.clk.swwel;
    wire hwif_in_x_stroke_min_value_swwel = hwif_in.x.stroke_min.value.swwel;
    wire hwif_in_x_stroke_max_value_swwel = hwif_in.x.stroke_max.value.swwel;
    wire hwif_in_x_stroke_en_enable_swwel = hwif_in.x.stroke_en.enable.swwel;
    wire hwif_in_x_angle_step_value_swwel = hwif_in.x.angle_step.value.swwel;
    wire hwif_in_x_current_offset_a_swwel = hwif_in.x.current_offset.a.swwel;
    wire hwif_in_x_current_offset_b_swwel = hwif_in.x.current_offset.b.swwel;
    wire hwif_in_x_adc_frame_zeros_swwel = hwif_in.x.adc_frame.zeros.swwel;
    wire hwif_in_y_deadtime_clk_swwel = hwif_in.y.deadtime.clk.swwel;
    wire hwif_in_y_stroke_min_value_swwel = hwif_in.y.stroke_min.value.swwel;
    wire hwif_in_y_stroke_max_value_swwel = hwif_in.y.stroke_max.value.swwel;
    wire hwif_in_y_stroke_en_enable_swwel = hwif_in.y.stroke_en.enable.swwel;
    wire hwif_in_y_angle_step_value_swwel = hwif_in.y.angle_step.value.swwel;
    wire hwif_in_y_current_offset_a_swwel = hwif_in.y.current_offset.a.swwel;
    wire hwif_in_y_current_offset_b_swwel = hwif_in.y.current_offset.b.swwel;
    wire hwif_in_y_adc_frame_zeros_swwel = hwif_in.y.adc_frame.zeros.swwel;
    wire hwif_in_watchdog_limit_swwel = hwif_in.watchdog.limit.swwel;
    wire hwif_in_current_limit_value_swwel = hwif_in.current_limit.value.swwel;
    wire hwif_in_deadtime_min_clk_swwel = hwif_in.deadtime_min.clk.swwel;
    wire hwif_in_rates_carrier_swwel = hwif_in.rates.carrier.swwel;
    wire hwif_in_rates_position_swwel = hwif_in.rates.position.swwel;
    wire hwif_in_x_status_overrun_hwset = hwif_in.x.status.overrun.hwset;
    wire hwif_in_x_status_qep_error_hwset = hwif_in.x.status.qep_error.hwset;
    wire hwif_in_x_status_saturated_hwset = hwif_in.x.status.saturated.hwset;
    wire hwif_in_x_status_limited_hwset = hwif_in.x.status.limited.hwset;
    wire hwif_in_x_status_underrun_hwset = hwif_in.x.status.underrun.hwset;
    wire hwif_in_x_status_clipped_hwset = hwif_in.x.status.clipped.hwset;
    wire hwif_in_x_prec_addr_word_we = hwif_in.x.prec_addr.word.we;
    wire [4:0] hwif_in_x_prec_addr_word_next = hwif_in.x.prec_addr.word.next;
    wire hwif_in_y_status_overrun_hwset = hwif_in.y.status.overrun.hwset;
    wire hwif_in_y_status_qep_error_hwset = hwif_in.y.status.qep_error.hwset;
    wire hwif_in_y_status_saturated_hwset = hwif_in.y.status.saturated.hwset;
    wire hwif_in_y_status_limited_hwset = hwif_in.y.status.limited.hwset;
    wire hwif_in_y_status_underrun_hwset = hwif_in.y.status.underrun.hwset;
    wire hwif_in_y_status_clipped_hwset = hwif_in.y.status.clipped.hwset;
    wire hwif_in_y_prec_addr_word_we = hwif_in.y.prec_addr.word.we;
    wire [4:0] hwif_in_y_prec_addr_word_next = hwif_in.y.prec_addr.word.next;
    wire hwif_in_irq_stat_tick_hwset = hwif_in.irq_stat.tick.hwset;
    wire hwif_in_irq_stat_fault_hwset = hwif_in.irq_stat.fault.hwset;
    wire hwif_in_x_tab_data_wr_ack = hwif_in.x.tab_data.wr_ack;
    wire hwif_in_x_pos_preset_wr_ack = hwif_in.x.pos_preset.wr_ack;
    wire hwif_in_x_prec_data_wr_ack = hwif_in.x.prec_data.wr_ack;
    wire hwif_in_y_tab_data_wr_ack = hwif_in.y.tab_data.wr_ack;
    wire hwif_in_y_pos_preset_wr_ack = hwif_in.y.pos_preset.wr_ack;
    wire hwif_in_y_prec_data_wr_ack = hwif_in.y.prec_data.wr_ack;
    wire hwif_in_fault_clear_wr_ack = hwif_in.fault_clear.wr_ack;
    wire hwif_in_lock_wr_ack = hwif_in.lock.wr_ack;
    wire hwif_in_x_tab_data_rd_ack = hwif_in.x.tab_data.rd_ack;
    wire hwif_in_x_prec_data_rd_ack = hwif_in.x.prec_data.rd_ack;
    wire hwif_in_x_prec_err_rd_ack = hwif_in.x.prec_err.rd_ack;
    wire hwif_in_x_err_sum_rd_ack = hwif_in.x.err_sum.rd_ack;
    wire hwif_in_x_iq_sum_rd_ack = hwif_in.x.iq_sum.rd_ack;
    wire hwif_in_x_prec_dist_rd_ack = hwif_in.x.prec_dist.rd_ack;
    wire hwif_in_y_tab_data_rd_ack = hwif_in.y.tab_data.rd_ack;
    wire hwif_in_y_prec_data_rd_ack = hwif_in.y.prec_data.rd_ack;
    wire hwif_in_y_prec_err_rd_ack = hwif_in.y.prec_err.rd_ack;
    wire hwif_in_y_err_sum_rd_ack = hwif_in.y.err_sum.rd_ack;
    wire hwif_in_y_iq_sum_rd_ack = hwif_in.y.iq_sum.rd_ack;
    wire hwif_in_y_prec_dist_rd_ack = hwif_in.y.prec_dist.rd_ack;
    wire hwif_in_lock_rd_ack = hwif_in.lock.rd_ack;
    wire hwif_in_knot_rd_ack = hwif_in.knot.rd_ack;
    wire hwif_in_x_status_busy_next = hwif_in.x.status.busy.next;
    wire [6:0] hwif_in_x_status_step_next = hwif_in.x.status.step.next;
    wire [31:0] hwif_in_x_pos_value_next = hwif_in.x.pos.value.next;
    wire [31:0] hwif_in_x_pos_model_value_next = hwif_in.x.pos_model.value.next;
    wire [31:0] hwif_in_x_err_value_next = hwif_in.x.err.value.next;
    wire [31:0] hwif_in_x_derr_value_next = hwif_in.x.derr.value.next;
    wire [31:0] hwif_in_x_u_value_next = hwif_in.x.u.value.next;
    wire [31:0] hwif_in_x_vstar_value_next = hwif_in.x.vstar.value.next;
    wire [31:0] hwif_in_x_iq_cmd_value_next = hwif_in.x.iq_cmd.value.next;
    wire [31:0] hwif_in_x_speed_value_next = hwif_in.x.speed.value.next;
    wire [15:0] hwif_in_x_id_iq_i_d_next = hwif_in.x.id_iq.i_d.next;
    wire [15:0] hwif_in_x_id_iq_i_q_next = hwif_in.x.id_iq.i_q.next;
    wire [15:0] hwif_in_x_vd_vq_v_d_next = hwif_in.x.vd_vq.v_d.next;
    wire [15:0] hwif_in_x_vd_vq_v_q_next = hwif_in.x.vd_vq.v_q.next;
    wire [31:0] hwif_in_x_tab_data_rd_data = hwif_in.x.tab_data.rd_data;
    wire [31:0] hwif_in_x_index_latch_value_next = hwif_in.x.index_latch.value.next;
    wire [31:0] hwif_in_x_prec_data_rd_data = hwif_in.x.prec_data.rd_data;
    wire [31:0] hwif_in_x_prec_err_rd_data = hwif_in.x.prec_err.rd_data;
    wire [31:0] hwif_in_x_err_sum_rd_data = hwif_in.x.err_sum.rd_data;
    wire [31:0] hwif_in_x_iq_sum_rd_data = hwif_in.x.iq_sum.rd_data;
    wire [31:0] hwif_in_x_prec_dist_rd_data = hwif_in.x.prec_dist.rd_data;
    wire [15:0] hwif_in_x_phase_currents_i_a_next = hwif_in.x.phase_currents.i_a.next;
    wire [15:0] hwif_in_x_phase_currents_i_b_next = hwif_in.x.phase_currents.i_b.next;
    wire hwif_in_y_status_busy_next = hwif_in.y.status.busy.next;
    wire [6:0] hwif_in_y_status_step_next = hwif_in.y.status.step.next;
    wire [31:0] hwif_in_y_pos_value_next = hwif_in.y.pos.value.next;
    wire [31:0] hwif_in_y_pos_model_value_next = hwif_in.y.pos_model.value.next;
    wire [31:0] hwif_in_y_err_value_next = hwif_in.y.err.value.next;
    wire [31:0] hwif_in_y_derr_value_next = hwif_in.y.derr.value.next;
    wire [31:0] hwif_in_y_u_value_next = hwif_in.y.u.value.next;
    wire [31:0] hwif_in_y_vstar_value_next = hwif_in.y.vstar.value.next;
    wire [31:0] hwif_in_y_iq_cmd_value_next = hwif_in.y.iq_cmd.value.next;
    wire [31:0] hwif_in_y_speed_value_next = hwif_in.y.speed.value.next;
    wire [15:0] hwif_in_y_id_iq_i_d_next = hwif_in.y.id_iq.i_d.next;
    wire [15:0] hwif_in_y_id_iq_i_q_next = hwif_in.y.id_iq.i_q.next;
    wire [15:0] hwif_in_y_vd_vq_v_d_next = hwif_in.y.vd_vq.v_d.next;
    wire [15:0] hwif_in_y_vd_vq_v_q_next = hwif_in.y.vd_vq.v_q.next;
    wire [31:0] hwif_in_y_tab_data_rd_data = hwif_in.y.tab_data.rd_data;
    wire [31:0] hwif_in_y_index_latch_value_next = hwif_in.y.index_latch.value.next;
    wire [31:0] hwif_in_y_prec_data_rd_data = hwif_in.y.prec_data.rd_data;
    wire [31:0] hwif_in_y_prec_err_rd_data = hwif_in.y.prec_err.rd_data;
    wire [31:0] hwif_in_y_err_sum_rd_data = hwif_in.y.err_sum.rd_data;
    wire [31:0] hwif_in_y_iq_sum_rd_data = hwif_in.y.iq_sum.rd_data;
    wire [31:0] hwif_in_y_prec_dist_rd_data = hwif_in.y.prec_dist.rd_data;
    wire [15:0] hwif_in_y_phase_currents_i_a_next = hwif_in.y.phase_currents.i_a.next;
    wire [15:0] hwif_in_y_phase_currents_i_b_next = hwif_in.y.phase_currents.i_b.next;
    wire [31:0] hwif_in_tick_value_next = hwif_in.tick.value.next;
    wire [3:0] hwif_in_fault_code_next = hwif_in.fault.code.next;
    wire hwif_in_fault_axis_next = hwif_in.fault.axis.next;
    wire [23:0] hwif_in_fault_tick_next = hwif_in.fault.tick.next;
    wire [31:0] hwif_in_lock_rd_data = hwif_in.lock.rd_data;
    wire [31:0] hwif_in_knot_rd_data = hwif_in.knot.rd_data;

    // CPU Bus interface logic
    logic cpuif_req, cpuif_req_is_wr;
    logic [9:0] cpuif_addr;
    logic [31:0] cpuif_wr_data, cpuif_wr_biten;
    logic cpuif_req_stall_wr, cpuif_req_stall_rd;

    logic cpuif_rd_ack, cpuif_rd_err;
    logic [31:0] cpuif_rd_data;

    logic cpuif_wr_ack, cpuif_wr_err;

    // Max Outstanding Transactions: 2
    logic [1:0] axil_n_in_flight;
    logic axil_prev_was_rd, axil_arvalid;
    logic [9:0] axil_araddr;
    logic axil_ar_accept, axil_awvalid;
    logic [9:0] axil_awaddr;
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
                cpuif_addr = {axil_araddr[9:2], 2'b0};
                if(!cpuif_req_stall_rd) axil_ar_accept = '1;
            end else if(axil_awvalid && axil_wvalid) begin
                cpuif_req = '1; cpuif_req_is_wr = '1;
                cpuif_addr = {axil_awaddr[9:2], 2'b0};
                if(!cpuif_req_stall_wr) axil_aw_accept = '1;
            end else if(axil_arvalid) begin
                cpuif_req = '1; cpuif_req_is_wr = '0;
                cpuif_addr = {axil_araddr[9:2], 2'b0};
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

    logic cpuif_req_masked, external_pending;

    // Read & write latencies are balanced. Stalls not required
    // except if external
    assign cpuif_req_stall_rd = external_pending;
    assign cpuif_req_stall_wr = external_pending;
    assign cpuif_req_masked = cpuif_req
                            & !(!cpuif_req_is_wr & cpuif_req_stall_rd)
                            & !(cpuif_req_is_wr & cpuif_req_stall_wr);

    // Address Decode
    logic decoded_reg_strb_x_ctrl, decoded_reg_strb_x_status, decoded_reg_strb_x_tab_data;
    logic decoded_reg_strb_x_pos_preset, decoded_reg_strb_x_prec_addr, decoded_reg_strb_x_prec_data;
    logic decoded_reg_strb_x_prec_err, decoded_reg_strb_x_err_sum, decoded_reg_strb_x_iq_sum;
    logic decoded_reg_strb_x_prec_dist, decoded_reg_strb_y_ctrl, decoded_reg_strb_y_status;
    logic decoded_reg_strb_y_tab_data, decoded_reg_strb_y_pos_preset, decoded_reg_strb_y_prec_addr;
    logic decoded_reg_strb_y_prec_data, decoded_reg_strb_y_prec_err, decoded_reg_strb_y_err_sum;
    logic decoded_reg_strb_y_iq_sum, decoded_reg_strb_y_prec_dist, decoded_reg_strb_commit;
    logic decoded_reg_strb_irq_stat, decoded_reg_strb_fault_clear, decoded_reg_strb_lock;
    logic decoded_reg_strb_knot, decoded_err, decoded_req_is_external;

    logic [9:0] decoded_addr;
    logic decoded_req, decoded_req_is_wr;
    logic [31:0] decoded_wr_data, decoded_wr_biten;

    always_comb begin
        automatic logic is_valid_addr;
        automatic logic is_valid_rw;
        automatic logic is_external;
        is_external = '0;
        is_valid_addr = '1; // No valid address check
        is_valid_rw = '1; // No valid RW check
        decoded_reg_strb_x_ctrl = cpuif_req_masked & (cpuif_addr == 10'h0);
        decoded_reg_strb_x_status = cpuif_req_masked & (cpuif_addr == 10'h4);
        decoded_reg_strb_x_tab_data = cpuif_req_masked & (cpuif_addr == 10'h74);
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h74);
        decoded_reg_strb_x_pos_preset = cpuif_req_masked & (cpuif_addr == 10'h78) & cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h78) & cpuif_req_is_wr;
        decoded_reg_strb_x_prec_addr = cpuif_req_masked & (cpuif_addr == 10'h90);
        decoded_reg_strb_x_prec_data = cpuif_req_masked & (cpuif_addr == 10'h94);
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h94);
        decoded_reg_strb_x_prec_err = cpuif_req_masked & (cpuif_addr == 10'h98) & !cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h98) & !cpuif_req_is_wr;
        decoded_reg_strb_x_err_sum = cpuif_req_masked & (cpuif_addr == 10'h9c) & !cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h9c) & !cpuif_req_is_wr;
        decoded_reg_strb_x_iq_sum = cpuif_req_masked & (cpuif_addr == 10'ha0) & !cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'ha0) & !cpuif_req_is_wr;
        decoded_reg_strb_x_prec_dist = cpuif_req_masked & (cpuif_addr == 10'ha4) & !cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'ha4) & !cpuif_req_is_wr;
        decoded_reg_strb_y_ctrl = cpuif_req_masked & (cpuif_addr == 10'h100);
        decoded_reg_strb_y_status = cpuif_req_masked & (cpuif_addr == 10'h104);
        decoded_reg_strb_y_tab_data = cpuif_req_masked & (cpuif_addr == 10'h174);
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h174);
        decoded_reg_strb_y_pos_preset = cpuif_req_masked & (cpuif_addr == 10'h178) & cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h178) & cpuif_req_is_wr;
        decoded_reg_strb_y_prec_addr = cpuif_req_masked & (cpuif_addr == 10'h190);
        decoded_reg_strb_y_prec_data = cpuif_req_masked & (cpuif_addr == 10'h194);
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h194);
        decoded_reg_strb_y_prec_err = cpuif_req_masked & (cpuif_addr == 10'h198) & !cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h198) & !cpuif_req_is_wr;
        decoded_reg_strb_y_err_sum = cpuif_req_masked & (cpuif_addr == 10'h19c) & !cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h19c) & !cpuif_req_is_wr;
        decoded_reg_strb_y_iq_sum = cpuif_req_masked & (cpuif_addr == 10'h1a0) & !cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h1a0) & !cpuif_req_is_wr;
        decoded_reg_strb_y_prec_dist = cpuif_req_masked & (cpuif_addr == 10'h1a4) & !cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h1a4) & !cpuif_req_is_wr;
        decoded_reg_strb_commit = cpuif_req_masked & (cpuif_addr == 10'h204) & cpuif_req_is_wr;
        decoded_reg_strb_irq_stat = cpuif_req_masked & (cpuif_addr == 10'h20c);
        decoded_reg_strb_fault_clear = cpuif_req_masked & (cpuif_addr == 10'h218) & cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h218) & cpuif_req_is_wr;
        decoded_reg_strb_lock = cpuif_req_masked & (cpuif_addr == 10'h220);
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h220);
        decoded_reg_strb_knot = cpuif_req_masked & (cpuif_addr == 10'h230) & !cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h230) & !cpuif_req_is_wr;
        decoded_err = '0; decoded_req_is_external = is_external;
    end
    logic external_wr_ack, external_rd_ack;
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            external_pending <= '0;
        end else begin
            if(decoded_req_is_external & ~external_wr_ack & ~external_rd_ack) external_pending <= '1;
            else if(external_wr_ack | external_rd_ack) external_pending <= '0;
            `ifndef SYNTHESIS
                assert_bad_ext_wr_ack: assert(!external_wr_ack || (external_pending | decoded_req_is_external))
                    else $error("An external wr_ack strobe was asserted when no external request was active");
                assert_bad_ext_rd_ack: assert(!external_rd_ack || (external_pending | decoded_req_is_external))
                    else $error("An external rd_ack strobe was asserted when no external request was active");
            `endif
        end
    end

    // Pass down signals to next stage
    assign decoded_addr = cpuif_addr;
    assign decoded_req = cpuif_req_masked;
    assign decoded_req_is_wr = cpuif_req_is_wr;
    assign decoded_wr_data = cpuif_wr_data;
    assign decoded_wr_biten = cpuif_wr_biten;

    // Field logic

    logic field_storage_x_ctrl_enable_value, field_storage_x_ctrl_current_loop_value;
    logic field_storage_x_ctrl_position_loop_value, field_storage_x_ctrl_adapt_value;
    logic field_storage_x_ctrl_reset_model_value, field_storage_x_ctrl_reset_table_value;
    logic field_storage_x_ctrl_interpolate_value, field_storage_x_ctrl_feedforward_value;
    logic field_storage_x_ctrl_precision_value, field_storage_x_status_overrun_value;
    logic field_storage_x_status_qep_error_value, field_storage_x_status_saturated_value;
    logic field_storage_x_status_limited_value, field_storage_x_status_underrun_value;
    logic field_storage_x_status_clipped_value;
    logic [23:0] field_storage_x_pos_cmd_value_value;
    logic [10:0] field_storage_x_kp_mant_value;
    logic [4:0] field_storage_x_kp_exp_value;
    logic [10:0] field_storage_x_ki_mant_value;
    logic [4:0] field_storage_x_ki_exp_value;
    logic [10:0] field_storage_x_kv_mant_value;
    logic [4:0] field_storage_x_kv_exp_value;
    logic [10:0] field_storage_x_eta_mant_value;
    logic [4:0] field_storage_x_eta_exp_value, field_storage_x_shift_e_value;
    logic [4:0] field_storage_x_shift_de_value;
    logic [17:0] field_storage_x_a0_value_value;
    logic [1:0] field_storage_x_a0_scale_value;
    logic [23:0] field_storage_x_b2_value_value;
    logic [10:0] field_storage_x_kp_cur_mant_value;
    logic [4:0] field_storage_x_kp_cur_exp_value;
    logic [10:0] field_storage_x_ki_cur_mant_value;
    logic [4:0] field_storage_x_ki_cur_exp_value;
    logic [31:0] field_storage_x_theta_ofs_value_value;
    logic [9:0] field_storage_x_deadtime_clk_value;
    logic [3:0] field_storage_x_deadtime_qep_filter_value;
    logic [5:0] field_storage_x_tab_addr_index_value;
    logic [23:0] field_storage_x_stroke_min_value_value, field_storage_x_stroke_max_value_value;
    logic field_storage_x_stroke_en_enable_value;
    logic [11:0] field_storage_x_iq_manual_value_value;
    logic [4:0] field_storage_x_prec_addr_word_value;
    logic [31:0] field_storage_x_angle_step_value_value;
    logic [11:0] field_storage_x_current_offset_a_value, field_storage_x_current_offset_b_value;
    logic [2:0] field_storage_x_adc_frame_zeros_value;
    logic field_storage_y_ctrl_enable_value, field_storage_y_ctrl_current_loop_value;
    logic field_storage_y_ctrl_position_loop_value, field_storage_y_ctrl_adapt_value;
    logic field_storage_y_ctrl_reset_model_value, field_storage_y_ctrl_reset_table_value;
    logic field_storage_y_ctrl_interpolate_value, field_storage_y_ctrl_feedforward_value;
    logic field_storage_y_ctrl_precision_value, field_storage_y_status_overrun_value;
    logic field_storage_y_status_qep_error_value, field_storage_y_status_saturated_value;
    logic field_storage_y_status_limited_value, field_storage_y_status_underrun_value;
    logic field_storage_y_status_clipped_value;
    logic [23:0] field_storage_y_pos_cmd_value_value;
    logic [10:0] field_storage_y_kp_mant_value;
    logic [4:0] field_storage_y_kp_exp_value;
    logic [10:0] field_storage_y_ki_mant_value;
    logic [4:0] field_storage_y_ki_exp_value;
    logic [10:0] field_storage_y_kv_mant_value;
    logic [4:0] field_storage_y_kv_exp_value;
    logic [10:0] field_storage_y_eta_mant_value;
    logic [4:0] field_storage_y_eta_exp_value, field_storage_y_shift_e_value;
    logic [4:0] field_storage_y_shift_de_value;
    logic [17:0] field_storage_y_a0_value_value;
    logic [1:0] field_storage_y_a0_scale_value;
    logic [23:0] field_storage_y_b2_value_value;
    logic [10:0] field_storage_y_kp_cur_mant_value;
    logic [4:0] field_storage_y_kp_cur_exp_value;
    logic [10:0] field_storage_y_ki_cur_mant_value;
    logic [4:0] field_storage_y_ki_cur_exp_value;
    logic [31:0] field_storage_y_theta_ofs_value_value;
    logic [9:0] field_storage_y_deadtime_clk_value;
    logic [3:0] field_storage_y_deadtime_qep_filter_value;
    logic [5:0] field_storage_y_tab_addr_index_value;
    logic [23:0] field_storage_y_stroke_min_value_value, field_storage_y_stroke_max_value_value;
    logic field_storage_y_stroke_en_enable_value;
    logic [11:0] field_storage_y_iq_manual_value_value;
    logic [4:0] field_storage_y_prec_addr_word_value;
    logic [31:0] field_storage_y_angle_step_value_value;
    logic [11:0] field_storage_y_current_offset_a_value, field_storage_y_current_offset_b_value;
    logic [2:0] field_storage_y_adc_frame_zeros_value;
    logic field_storage_commit_take_value, field_storage_irq_en_tick_value;
    logic field_storage_irq_en_fault_value, field_storage_irq_stat_tick_value;
    logic field_storage_irq_stat_fault_value;
    logic [15:0] field_storage_watchdog_limit_value;
    logic [11:0] field_storage_current_limit_value_value;
    logic [9:0] field_storage_deadtime_min_clk_value;
    logic [7:0] field_storage_irq_period_ticks_value;
    logic [1:0] field_storage_rates_carrier_value, field_storage_rates_position_value;

    // Fields that software alone writes
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_x_ctrl_enable_value <= 1'h0;
            field_storage_x_ctrl_current_loop_value <= 1'h0;
            field_storage_x_ctrl_position_loop_value <= 1'h0;
            field_storage_x_ctrl_adapt_value <= 1'h0;
            field_storage_x_ctrl_reset_model_value <= 1'h0;
            field_storage_x_ctrl_interpolate_value <= 1'h0;
            field_storage_x_ctrl_feedforward_value <= 1'h0;
            field_storage_x_ctrl_precision_value <= 1'h0;
            field_storage_x_pos_cmd_value_value <= 24'h0; field_storage_x_kp_mant_value <= 11'h300;
            field_storage_x_kp_exp_value <= 5'h0; field_storage_x_ki_mant_value <= 11'h347;
            field_storage_x_ki_exp_value <= 5'h19; field_storage_x_kv_mant_value <= 11'h75c;
            field_storage_x_kv_exp_value <= 5'h1; field_storage_x_eta_mant_value <= 11'h474;
            field_storage_x_eta_exp_value <= 5'h18; field_storage_x_shift_e_value <= 5'h0;
            field_storage_x_shift_de_value <= 5'h2; field_storage_x_a0_value_value <= 18'h3a1b8;
            field_storage_x_a0_scale_value <= 2'h0; field_storage_x_b2_value_value <= 24'h7c378b;
            field_storage_x_kp_cur_mant_value <= 11'h4fb; field_storage_x_kp_cur_exp_value <= 5'h2;
            field_storage_x_ki_cur_mant_value <= 11'h5c6; field_storage_x_ki_cur_exp_value <= 5'h1e;
            field_storage_x_theta_ofs_value_value <= 32'h0;
            field_storage_x_deadtime_clk_value <= 10'h64;
            field_storage_x_deadtime_qep_filter_value <= 4'h3;
            field_storage_x_tab_addr_index_value <= 6'h0;
            field_storage_x_stroke_min_value_value <= 24'h0;
            field_storage_x_stroke_max_value_value <= 24'h1d4c0;
            field_storage_x_stroke_en_enable_value <= 1'h0;
            field_storage_x_iq_manual_value_value <= 12'h0;
            field_storage_x_angle_step_value_value <= 32'h55f2f;
            field_storage_x_current_offset_a_value <= 12'h0;
            field_storage_x_current_offset_b_value <= 12'h0;
            field_storage_x_adc_frame_zeros_value <= 3'h4;
            field_storage_y_ctrl_enable_value <= 1'h0;
            field_storage_y_ctrl_current_loop_value <= 1'h0;
            field_storage_y_ctrl_position_loop_value <= 1'h0;
            field_storage_y_ctrl_adapt_value <= 1'h0;
            field_storage_y_ctrl_reset_model_value <= 1'h0;
            field_storage_y_ctrl_interpolate_value <= 1'h0;
            field_storage_y_ctrl_feedforward_value <= 1'h0;
            field_storage_y_ctrl_precision_value <= 1'h0;
            field_storage_y_pos_cmd_value_value <= 24'h0; field_storage_y_kp_mant_value <= 11'h300;
            field_storage_y_kp_exp_value <= 5'h0; field_storage_y_ki_mant_value <= 11'h347;
            field_storage_y_ki_exp_value <= 5'h19; field_storage_y_kv_mant_value <= 11'h75c;
            field_storage_y_kv_exp_value <= 5'h1; field_storage_y_eta_mant_value <= 11'h474;
            field_storage_y_eta_exp_value <= 5'h18; field_storage_y_shift_e_value <= 5'h0;
            field_storage_y_shift_de_value <= 5'h2; field_storage_y_a0_value_value <= 18'h3a1b8;
            field_storage_y_a0_scale_value <= 2'h0; field_storage_y_b2_value_value <= 24'h7c378b;
            field_storage_y_kp_cur_mant_value <= 11'h4fb; field_storage_y_kp_cur_exp_value <= 5'h2;
            field_storage_y_ki_cur_mant_value <= 11'h5c6; field_storage_y_ki_cur_exp_value <= 5'h1e;
            field_storage_y_theta_ofs_value_value <= 32'h0;
            field_storage_y_deadtime_clk_value <= 10'h64;
            field_storage_y_deadtime_qep_filter_value <= 4'h3;
            field_storage_y_tab_addr_index_value <= 6'h0;
            field_storage_y_stroke_min_value_value <= 24'h0;
            field_storage_y_stroke_max_value_value <= 24'h1d4c0;
            field_storage_y_stroke_en_enable_value <= 1'h0;
            field_storage_y_iq_manual_value_value <= 12'h0;
            field_storage_y_angle_step_value_value <= 32'h55f2f;
            field_storage_y_current_offset_a_value <= 12'h0;
            field_storage_y_current_offset_b_value <= 12'h0;
            field_storage_y_adc_frame_zeros_value <= 3'h4; field_storage_irq_en_tick_value <= 1'h0;
            field_storage_irq_en_fault_value <= 1'h0; field_storage_watchdog_limit_value <= 16'h0;
            field_storage_current_limit_value_value <= 12'h500;
            field_storage_deadtime_min_clk_value <= 10'h19;
            field_storage_irq_period_ticks_value <= 8'h4; field_storage_rates_carrier_value <= 2'h0;
            field_storage_rates_position_value <= 2'h1;
        end else if(decoded_req && decoded_req_is_wr) begin
            if(decoded_addr == 10'h0) begin
                if(decoded_wr_biten[0]) field_storage_x_ctrl_enable_value <= decoded_wr_data[0:0];
                if(decoded_wr_biten[1]) field_storage_x_ctrl_current_loop_value <= decoded_wr_data[1:1];
                if(decoded_wr_biten[2]) field_storage_x_ctrl_position_loop_value <= decoded_wr_data[2:2];
                if(decoded_wr_biten[3]) field_storage_x_ctrl_adapt_value <= decoded_wr_data[3:3];
                if(decoded_wr_biten[4]) field_storage_x_ctrl_reset_model_value <= decoded_wr_data[4:4];
                if(decoded_wr_biten[6]) field_storage_x_ctrl_interpolate_value <= decoded_wr_data[6:6];
                if(decoded_wr_biten[7]) field_storage_x_ctrl_feedforward_value <= decoded_wr_data[7:7];
                if(decoded_wr_biten[8]) field_storage_x_ctrl_precision_value <= decoded_wr_data[8:8];
            end
            if(decoded_addr == 10'h8) begin
                if(decoded_wr_biten[0]) field_storage_x_pos_cmd_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_pos_cmd_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_x_pos_cmd_value_value[23:16] <= decoded_wr_data[23:16];
            end
            if(decoded_addr == 10'h40) begin
                if(decoded_wr_biten[0]) field_storage_x_kp_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_kp_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_x_kp_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h44) begin
                if(decoded_wr_biten[0]) field_storage_x_ki_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_ki_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_x_ki_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h48) begin
                if(decoded_wr_biten[0]) field_storage_x_kv_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_kv_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_x_kv_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h4c) begin
                if(decoded_wr_biten[0]) field_storage_x_eta_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_eta_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_x_eta_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h50) begin
                if(decoded_wr_biten[0]) field_storage_x_shift_e_value[4:0] <= decoded_wr_data[4:0];
                if(decoded_wr_biten[8]) field_storage_x_shift_de_value[4:0] <= decoded_wr_data[12:8];
            end
            if(decoded_addr == 10'h54) begin
                if(decoded_wr_biten[0]) field_storage_x_a0_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_a0_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_x_a0_value_value[17:16] <= decoded_wr_data[17:16];
                if(decoded_wr_biten[20]) field_storage_x_a0_scale_value[1:0] <= decoded_wr_data[21:20];
            end
            if(decoded_addr == 10'h58) begin
                if(decoded_wr_biten[0]) field_storage_x_b2_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_b2_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_x_b2_value_value[23:16] <= decoded_wr_data[23:16];
            end
            if(decoded_addr == 10'h60) begin
                if(decoded_wr_biten[0]) field_storage_x_kp_cur_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_kp_cur_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_x_kp_cur_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h64) begin
                if(decoded_wr_biten[0]) field_storage_x_ki_cur_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_ki_cur_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_x_ki_cur_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h68) begin
                if(decoded_wr_biten[0]) field_storage_x_theta_ofs_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_theta_ofs_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_x_theta_ofs_value_value[23:16] <= decoded_wr_data[23:16];
                if(decoded_wr_biten[24]) field_storage_x_theta_ofs_value_value[31:24] <= decoded_wr_data[31:24];
            end
            if(decoded_addr == 10'h6c && !(hwif_in_x_deadtime_clk_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_x_deadtime_clk_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_deadtime_clk_value[9:8] <= decoded_wr_data[9:8];
            end
            if(decoded_addr == 10'h6c) if(decoded_wr_biten[16]) field_storage_x_deadtime_qep_filter_value[3:0] <= decoded_wr_data[19:16];
            if(decoded_addr == 10'h70) if(decoded_wr_biten[0]) field_storage_x_tab_addr_index_value[5:0] <= decoded_wr_data[5:0];
            if(decoded_addr == 10'h80 && !(hwif_in_x_stroke_min_value_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_x_stroke_min_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_stroke_min_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_x_stroke_min_value_value[23:16] <= decoded_wr_data[23:16];
            end
            if(decoded_addr == 10'h84 && !(hwif_in_x_stroke_max_value_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_x_stroke_max_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_stroke_max_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_x_stroke_max_value_value[23:16] <= decoded_wr_data[23:16];
            end
            if(decoded_addr == 10'h88 && !(hwif_in_x_stroke_en_enable_swwel)) if(decoded_wr_biten[0]) field_storage_x_stroke_en_enable_value <= decoded_wr_data[0:0];
            if(decoded_addr == 10'h8c) begin
                if(decoded_wr_biten[0]) field_storage_x_iq_manual_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_iq_manual_value_value[11:8] <= decoded_wr_data[11:8];
            end
            if(decoded_addr == 10'hb0 && !(hwif_in_x_angle_step_value_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_x_angle_step_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_angle_step_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_x_angle_step_value_value[23:16] <= decoded_wr_data[23:16];
                if(decoded_wr_biten[24]) field_storage_x_angle_step_value_value[31:24] <= decoded_wr_data[31:24];
            end
            if(decoded_addr == 10'hb4 && !(hwif_in_x_current_offset_a_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_x_current_offset_a_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_x_current_offset_a_value[11:8] <= decoded_wr_data[11:8];
            end
            if(decoded_addr == 10'hb4 && !(hwif_in_x_current_offset_b_swwel)) begin
                if(decoded_wr_biten[16]) field_storage_x_current_offset_b_value[7:0] <= decoded_wr_data[23:16];
                if(decoded_wr_biten[24]) field_storage_x_current_offset_b_value[11:8] <= decoded_wr_data[27:24];
            end
            if(decoded_addr == 10'hbc && !(hwif_in_x_adc_frame_zeros_swwel)) if(decoded_wr_biten[0]) field_storage_x_adc_frame_zeros_value[2:0] <= decoded_wr_data[2:0];
            if(decoded_addr == 10'h100) begin
                if(decoded_wr_biten[0]) field_storage_y_ctrl_enable_value <= decoded_wr_data[0:0];
                if(decoded_wr_biten[1]) field_storage_y_ctrl_current_loop_value <= decoded_wr_data[1:1];
                if(decoded_wr_biten[2]) field_storage_y_ctrl_position_loop_value <= decoded_wr_data[2:2];
                if(decoded_wr_biten[3]) field_storage_y_ctrl_adapt_value <= decoded_wr_data[3:3];
                if(decoded_wr_biten[4]) field_storage_y_ctrl_reset_model_value <= decoded_wr_data[4:4];
                if(decoded_wr_biten[6]) field_storage_y_ctrl_interpolate_value <= decoded_wr_data[6:6];
                if(decoded_wr_biten[7]) field_storage_y_ctrl_feedforward_value <= decoded_wr_data[7:7];
                if(decoded_wr_biten[8]) field_storage_y_ctrl_precision_value <= decoded_wr_data[8:8];
            end
            if(decoded_addr == 10'h108) begin
                if(decoded_wr_biten[0]) field_storage_y_pos_cmd_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_pos_cmd_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_y_pos_cmd_value_value[23:16] <= decoded_wr_data[23:16];
            end
            if(decoded_addr == 10'h140) begin
                if(decoded_wr_biten[0]) field_storage_y_kp_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_kp_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_y_kp_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h144) begin
                if(decoded_wr_biten[0]) field_storage_y_ki_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_ki_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_y_ki_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h148) begin
                if(decoded_wr_biten[0]) field_storage_y_kv_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_kv_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_y_kv_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h14c) begin
                if(decoded_wr_biten[0]) field_storage_y_eta_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_eta_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_y_eta_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h150) begin
                if(decoded_wr_biten[0]) field_storage_y_shift_e_value[4:0] <= decoded_wr_data[4:0];
                if(decoded_wr_biten[8]) field_storage_y_shift_de_value[4:0] <= decoded_wr_data[12:8];
            end
            if(decoded_addr == 10'h154) begin
                if(decoded_wr_biten[0]) field_storage_y_a0_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_a0_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_y_a0_value_value[17:16] <= decoded_wr_data[17:16];
                if(decoded_wr_biten[20]) field_storage_y_a0_scale_value[1:0] <= decoded_wr_data[21:20];
            end
            if(decoded_addr == 10'h158) begin
                if(decoded_wr_biten[0]) field_storage_y_b2_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_b2_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_y_b2_value_value[23:16] <= decoded_wr_data[23:16];
            end
            if(decoded_addr == 10'h160) begin
                if(decoded_wr_biten[0]) field_storage_y_kp_cur_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_kp_cur_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_y_kp_cur_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h164) begin
                if(decoded_wr_biten[0]) field_storage_y_ki_cur_mant_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_ki_cur_mant_value[10:8] <= decoded_wr_data[10:8];
                if(decoded_wr_biten[16]) field_storage_y_ki_cur_exp_value[4:0] <= decoded_wr_data[20:16];
            end
            if(decoded_addr == 10'h168) begin
                if(decoded_wr_biten[0]) field_storage_y_theta_ofs_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_theta_ofs_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_y_theta_ofs_value_value[23:16] <= decoded_wr_data[23:16];
                if(decoded_wr_biten[24]) field_storage_y_theta_ofs_value_value[31:24] <= decoded_wr_data[31:24];
            end
            if(decoded_addr == 10'h16c && !(hwif_in_y_deadtime_clk_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_y_deadtime_clk_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_deadtime_clk_value[9:8] <= decoded_wr_data[9:8];
            end
            if(decoded_addr == 10'h16c) if(decoded_wr_biten[16]) field_storage_y_deadtime_qep_filter_value[3:0] <= decoded_wr_data[19:16];
            if(decoded_addr == 10'h170) if(decoded_wr_biten[0]) field_storage_y_tab_addr_index_value[5:0] <= decoded_wr_data[5:0];
            if(decoded_addr == 10'h180 && !(hwif_in_y_stroke_min_value_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_y_stroke_min_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_stroke_min_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_y_stroke_min_value_value[23:16] <= decoded_wr_data[23:16];
            end
            if(decoded_addr == 10'h184 && !(hwif_in_y_stroke_max_value_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_y_stroke_max_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_stroke_max_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_y_stroke_max_value_value[23:16] <= decoded_wr_data[23:16];
            end
            if(decoded_addr == 10'h188 && !(hwif_in_y_stroke_en_enable_swwel)) if(decoded_wr_biten[0]) field_storage_y_stroke_en_enable_value <= decoded_wr_data[0:0];
            if(decoded_addr == 10'h18c) begin
                if(decoded_wr_biten[0]) field_storage_y_iq_manual_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_iq_manual_value_value[11:8] <= decoded_wr_data[11:8];
            end
            if(decoded_addr == 10'h1b0 && !(hwif_in_y_angle_step_value_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_y_angle_step_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_angle_step_value_value[15:8] <= decoded_wr_data[15:8];
                if(decoded_wr_biten[16]) field_storage_y_angle_step_value_value[23:16] <= decoded_wr_data[23:16];
                if(decoded_wr_biten[24]) field_storage_y_angle_step_value_value[31:24] <= decoded_wr_data[31:24];
            end
            if(decoded_addr == 10'h1b4 && !(hwif_in_y_current_offset_a_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_y_current_offset_a_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_y_current_offset_a_value[11:8] <= decoded_wr_data[11:8];
            end
            if(decoded_addr == 10'h1b4 && !(hwif_in_y_current_offset_b_swwel)) begin
                if(decoded_wr_biten[16]) field_storage_y_current_offset_b_value[7:0] <= decoded_wr_data[23:16];
                if(decoded_wr_biten[24]) field_storage_y_current_offset_b_value[11:8] <= decoded_wr_data[27:24];
            end
            if(decoded_addr == 10'h1bc && !(hwif_in_y_adc_frame_zeros_swwel)) if(decoded_wr_biten[0]) field_storage_y_adc_frame_zeros_value[2:0] <= decoded_wr_data[2:0];
            if(decoded_addr == 10'h208) begin
                if(decoded_wr_biten[0]) field_storage_irq_en_tick_value <= decoded_wr_data[0:0];
                if(decoded_wr_biten[1]) field_storage_irq_en_fault_value <= decoded_wr_data[1:1];
            end
            if(decoded_addr == 10'h21c && !(hwif_in_watchdog_limit_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_watchdog_limit_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_watchdog_limit_value[15:8] <= decoded_wr_data[15:8];
            end
            if(decoded_addr == 10'h224 && !(hwif_in_current_limit_value_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_current_limit_value_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_current_limit_value_value[11:8] <= decoded_wr_data[11:8];
            end
            if(decoded_addr == 10'h228 && !(hwif_in_deadtime_min_clk_swwel)) begin
                if(decoded_wr_biten[0]) field_storage_deadtime_min_clk_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_deadtime_min_clk_value[9:8] <= decoded_wr_data[9:8];
            end
            if(decoded_addr == 10'h22c) if(decoded_wr_biten[0]) field_storage_irq_period_ticks_value[7:0] <= decoded_wr_data[7:0];
            if(decoded_addr == 10'h240 && !(hwif_in_rates_carrier_swwel)) if(decoded_wr_biten[0]) field_storage_rates_carrier_value[1:0] <= decoded_wr_data[1:0];
            if(decoded_addr == 10'h240 && !(hwif_in_rates_position_swwel)) if(decoded_wr_biten[4]) field_storage_rates_position_value[1:0] <= decoded_wr_data[5:4];
        end
    end
    assign hwif_out.x.ctrl.enable.value = field_storage_x_ctrl_enable_value;
    assign hwif_out.x.ctrl.current_loop.value = field_storage_x_ctrl_current_loop_value;
    assign hwif_out.x.ctrl.position_loop.value = field_storage_x_ctrl_position_loop_value;
    assign hwif_out.x.ctrl.adapt.value = field_storage_x_ctrl_adapt_value;
    assign hwif_out.x.ctrl.reset_model.value = field_storage_x_ctrl_reset_model_value;
    // Field: kung_xy.x.ctrl.reset_table
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_x_ctrl_reset_table_value <= 1'h0;
        end else if(decoded_reg_strb_x_ctrl && decoded_req_is_wr) begin // SW write
            field_storage_x_ctrl_reset_table_value <= (field_storage_x_ctrl_reset_table_value & ~decoded_wr_biten[5:5]) | (decoded_wr_data[5:5] & decoded_wr_biten[5:5]);
        end else begin // singlepulse clears back to 0
            field_storage_x_ctrl_reset_table_value <= '0;
        end
    end
    assign hwif_out.x.ctrl.reset_table.value = field_storage_x_ctrl_reset_table_value;
    assign hwif_out.x.ctrl.interpolate.value = field_storage_x_ctrl_interpolate_value;
    assign hwif_out.x.ctrl.feedforward.value = field_storage_x_ctrl_feedforward_value;
    assign hwif_out.x.ctrl.precision.value = field_storage_x_ctrl_precision_value;
    // Field: kung_xy.x.status.overrun
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_x_status_overrun_value <= 1'h0;
        end else if(hwif_in_x_status_overrun_hwset) begin // HW Set
            field_storage_x_status_overrun_value <= '1;
        end else if(decoded_reg_strb_x_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_x_status_overrun_value <= field_storage_x_status_overrun_value & ~(decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
        end
    end
    assign hwif_out.x.status.overrun.value = field_storage_x_status_overrun_value;
    // Field: kung_xy.x.status.qep_error
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_x_status_qep_error_value <= 1'h0;
        end else if(hwif_in_x_status_qep_error_hwset) begin // HW Set
            field_storage_x_status_qep_error_value <= '1;
        end else if(decoded_reg_strb_x_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_x_status_qep_error_value <= field_storage_x_status_qep_error_value & ~(decoded_wr_data[2:2] & decoded_wr_biten[2:2]);
        end
    end
    assign hwif_out.x.status.qep_error.value = field_storage_x_status_qep_error_value;
    // Field: kung_xy.x.status.saturated
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_x_status_saturated_value <= 1'h0;
        end else if(hwif_in_x_status_saturated_hwset) begin // HW Set
            field_storage_x_status_saturated_value <= '1;
        end else if(decoded_reg_strb_x_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_x_status_saturated_value <= field_storage_x_status_saturated_value & ~(decoded_wr_data[3:3] & decoded_wr_biten[3:3]);
        end
    end
    assign hwif_out.x.status.saturated.value = field_storage_x_status_saturated_value;
    // Field: kung_xy.x.status.limited
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_x_status_limited_value <= 1'h0;
        end else if(hwif_in_x_status_limited_hwset) begin // HW Set
            field_storage_x_status_limited_value <= '1;
        end else if(decoded_reg_strb_x_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_x_status_limited_value <= field_storage_x_status_limited_value & ~(decoded_wr_data[4:4] & decoded_wr_biten[4:4]);
        end
    end
    assign hwif_out.x.status.limited.value = field_storage_x_status_limited_value;
    // Field: kung_xy.x.status.underrun
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_x_status_underrun_value <= 1'h0;
        end else if(hwif_in_x_status_underrun_hwset) begin // HW Set
            field_storage_x_status_underrun_value <= '1;
        end else if(decoded_reg_strb_x_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_x_status_underrun_value <= field_storage_x_status_underrun_value & ~(decoded_wr_data[5:5] & decoded_wr_biten[5:5]);
        end
    end
    assign hwif_out.x.status.underrun.value = field_storage_x_status_underrun_value;
    // Field: kung_xy.x.status.clipped
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_x_status_clipped_value <= 1'h0;
        end else if(hwif_in_x_status_clipped_hwset) begin // HW Set
            field_storage_x_status_clipped_value <= '1;
        end else if(decoded_reg_strb_x_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_x_status_clipped_value <= field_storage_x_status_clipped_value & ~(decoded_wr_data[6:6] & decoded_wr_biten[6:6]);
        end
    end
    assign hwif_out.x.status.clipped.value = field_storage_x_status_clipped_value;
    assign hwif_out.x.pos_cmd.value.value = field_storage_x_pos_cmd_value_value;
    assign hwif_out.x.kp.mant.value = field_storage_x_kp_mant_value;
    assign hwif_out.x.kp.exp.value = field_storage_x_kp_exp_value;
    assign hwif_out.x.ki.mant.value = field_storage_x_ki_mant_value;
    assign hwif_out.x.ki.exp.value = field_storage_x_ki_exp_value;
    assign hwif_out.x.kv.mant.value = field_storage_x_kv_mant_value;
    assign hwif_out.x.kv.exp.value = field_storage_x_kv_exp_value;
    assign hwif_out.x.eta.mant.value = field_storage_x_eta_mant_value;
    assign hwif_out.x.eta.exp.value = field_storage_x_eta_exp_value;
    assign hwif_out.x.shift.e.value = field_storage_x_shift_e_value;
    assign hwif_out.x.shift.de.value = field_storage_x_shift_de_value;
    assign hwif_out.x.a0.value.value = field_storage_x_a0_value_value;
    assign hwif_out.x.a0.scale.value = field_storage_x_a0_scale_value;
    assign hwif_out.x.b2.value.value = field_storage_x_b2_value_value;
    assign hwif_out.x.kp_cur.mant.value = field_storage_x_kp_cur_mant_value;
    assign hwif_out.x.kp_cur.exp.value = field_storage_x_kp_cur_exp_value;
    assign hwif_out.x.ki_cur.mant.value = field_storage_x_ki_cur_mant_value;
    assign hwif_out.x.ki_cur.exp.value = field_storage_x_ki_cur_exp_value;
    assign hwif_out.x.theta_ofs.value.value = field_storage_x_theta_ofs_value_value;
    assign hwif_out.x.deadtime.clk.value = field_storage_x_deadtime_clk_value;
    assign hwif_out.x.deadtime.qep_filter.value = field_storage_x_deadtime_qep_filter_value;
    assign hwif_out.x.tab_addr.index.value = field_storage_x_tab_addr_index_value;
    // External register: kung_xy.x.tab_data
    assign hwif_out.x.tab_data.req = decoded_reg_strb_x_tab_data;
    assign hwif_out.x.tab_data.req_is_wr = decoded_req_is_wr;
    assign hwif_out.x.tab_data.wr_data = decoded_wr_data;
    assign hwif_out.x.tab_data.wr_biten = decoded_wr_biten;
    // External register: kung_xy.x.pos_preset

    assign hwif_out.x.pos_preset.req = decoded_req_is_wr ? decoded_reg_strb_x_pos_preset : '0;
    assign hwif_out.x.pos_preset.req_is_wr = decoded_req_is_wr;
    assign hwif_out.x.pos_preset.wr_data = decoded_wr_data;
    assign hwif_out.x.pos_preset.wr_biten = decoded_wr_biten;
    assign hwif_out.x.stroke_min.value.value = field_storage_x_stroke_min_value_value;
    assign hwif_out.x.stroke_max.value.value = field_storage_x_stroke_max_value_value;
    assign hwif_out.x.stroke_en.enable.value = field_storage_x_stroke_en_enable_value;
    assign hwif_out.x.iq_manual.value.value = field_storage_x_iq_manual_value_value;
    // Field: kung_xy.x.prec_addr.word
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_x_prec_addr_word_value <= 5'h0;
        end else if(decoded_reg_strb_x_prec_addr && decoded_req_is_wr) begin // SW write
            field_storage_x_prec_addr_word_value <= (field_storage_x_prec_addr_word_value & ~decoded_wr_biten[4:0]) | (decoded_wr_data[4:0] & decoded_wr_biten[4:0]);
        end else if(hwif_in_x_prec_addr_word_we) begin // HW Write - we
            field_storage_x_prec_addr_word_value <= hwif_in_x_prec_addr_word_next;
        end
    end
    assign hwif_out.x.prec_addr.word.value = field_storage_x_prec_addr_word_value;
    // External register: kung_xy.x.prec_data
    assign hwif_out.x.prec_data.req = decoded_reg_strb_x_prec_data;
    assign hwif_out.x.prec_data.req_is_wr = decoded_req_is_wr;
    assign hwif_out.x.prec_data.wr_data = decoded_wr_data;
    assign hwif_out.x.prec_data.wr_biten = decoded_wr_biten;
    // External register: kung_xy.x.prec_err

    assign hwif_out.x.prec_err.req = !decoded_req_is_wr ? decoded_reg_strb_x_prec_err : '0;
    assign hwif_out.x.prec_err.req_is_wr = decoded_req_is_wr;
    // External register: kung_xy.x.err_sum

    assign hwif_out.x.err_sum.req = !decoded_req_is_wr ? decoded_reg_strb_x_err_sum : '0;
    assign hwif_out.x.err_sum.req_is_wr = decoded_req_is_wr;
    // External register: kung_xy.x.iq_sum

    assign hwif_out.x.iq_sum.req = !decoded_req_is_wr ? decoded_reg_strb_x_iq_sum : '0;
    assign hwif_out.x.iq_sum.req_is_wr = decoded_req_is_wr;
    // External register: kung_xy.x.prec_dist

    assign hwif_out.x.prec_dist.req = !decoded_req_is_wr ? decoded_reg_strb_x_prec_dist : '0;
    assign hwif_out.x.prec_dist.req_is_wr = decoded_req_is_wr;
    assign hwif_out.x.angle_step.value.value = field_storage_x_angle_step_value_value;
    assign hwif_out.x.current_offset.a.value = field_storage_x_current_offset_a_value;
    assign hwif_out.x.current_offset.b.value = field_storage_x_current_offset_b_value;
    assign hwif_out.x.adc_frame.zeros.value = field_storage_x_adc_frame_zeros_value;
    assign hwif_out.y.ctrl.enable.value = field_storage_y_ctrl_enable_value;
    assign hwif_out.y.ctrl.current_loop.value = field_storage_y_ctrl_current_loop_value;
    assign hwif_out.y.ctrl.position_loop.value = field_storage_y_ctrl_position_loop_value;
    assign hwif_out.y.ctrl.adapt.value = field_storage_y_ctrl_adapt_value;
    assign hwif_out.y.ctrl.reset_model.value = field_storage_y_ctrl_reset_model_value;
    // Field: kung_xy.y.ctrl.reset_table
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_y_ctrl_reset_table_value <= 1'h0;
        end else if(decoded_reg_strb_y_ctrl && decoded_req_is_wr) begin // SW write
            field_storage_y_ctrl_reset_table_value <= (field_storage_y_ctrl_reset_table_value & ~decoded_wr_biten[5:5]) | (decoded_wr_data[5:5] & decoded_wr_biten[5:5]);
        end else begin // singlepulse clears back to 0
            field_storage_y_ctrl_reset_table_value <= '0;
        end
    end
    assign hwif_out.y.ctrl.reset_table.value = field_storage_y_ctrl_reset_table_value;
    assign hwif_out.y.ctrl.interpolate.value = field_storage_y_ctrl_interpolate_value;
    assign hwif_out.y.ctrl.feedforward.value = field_storage_y_ctrl_feedforward_value;
    assign hwif_out.y.ctrl.precision.value = field_storage_y_ctrl_precision_value;
    // Field: kung_xy.y.status.overrun
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_y_status_overrun_value <= 1'h0;
        end else if(hwif_in_y_status_overrun_hwset) begin // HW Set
            field_storage_y_status_overrun_value <= '1;
        end else if(decoded_reg_strb_y_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_y_status_overrun_value <= field_storage_y_status_overrun_value & ~(decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
        end
    end
    assign hwif_out.y.status.overrun.value = field_storage_y_status_overrun_value;
    // Field: kung_xy.y.status.qep_error
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_y_status_qep_error_value <= 1'h0;
        end else if(hwif_in_y_status_qep_error_hwset) begin // HW Set
            field_storage_y_status_qep_error_value <= '1;
        end else if(decoded_reg_strb_y_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_y_status_qep_error_value <= field_storage_y_status_qep_error_value & ~(decoded_wr_data[2:2] & decoded_wr_biten[2:2]);
        end
    end
    assign hwif_out.y.status.qep_error.value = field_storage_y_status_qep_error_value;
    // Field: kung_xy.y.status.saturated
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_y_status_saturated_value <= 1'h0;
        end else if(hwif_in_y_status_saturated_hwset) begin // HW Set
            field_storage_y_status_saturated_value <= '1;
        end else if(decoded_reg_strb_y_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_y_status_saturated_value <= field_storage_y_status_saturated_value & ~(decoded_wr_data[3:3] & decoded_wr_biten[3:3]);
        end
    end
    assign hwif_out.y.status.saturated.value = field_storage_y_status_saturated_value;
    // Field: kung_xy.y.status.limited
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_y_status_limited_value <= 1'h0;
        end else if(hwif_in_y_status_limited_hwset) begin // HW Set
            field_storage_y_status_limited_value <= '1;
        end else if(decoded_reg_strb_y_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_y_status_limited_value <= field_storage_y_status_limited_value & ~(decoded_wr_data[4:4] & decoded_wr_biten[4:4]);
        end
    end
    assign hwif_out.y.status.limited.value = field_storage_y_status_limited_value;
    // Field: kung_xy.y.status.underrun
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_y_status_underrun_value <= 1'h0;
        end else if(hwif_in_y_status_underrun_hwset) begin // HW Set
            field_storage_y_status_underrun_value <= '1;
        end else if(decoded_reg_strb_y_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_y_status_underrun_value <= field_storage_y_status_underrun_value & ~(decoded_wr_data[5:5] & decoded_wr_biten[5:5]);
        end
    end
    assign hwif_out.y.status.underrun.value = field_storage_y_status_underrun_value;
    // Field: kung_xy.y.status.clipped
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_y_status_clipped_value <= 1'h0;
        end else if(hwif_in_y_status_clipped_hwset) begin // HW Set
            field_storage_y_status_clipped_value <= '1;
        end else if(decoded_reg_strb_y_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_y_status_clipped_value <= field_storage_y_status_clipped_value & ~(decoded_wr_data[6:6] & decoded_wr_biten[6:6]);
        end
    end
    assign hwif_out.y.status.clipped.value = field_storage_y_status_clipped_value;
    assign hwif_out.y.pos_cmd.value.value = field_storage_y_pos_cmd_value_value;
    assign hwif_out.y.kp.mant.value = field_storage_y_kp_mant_value;
    assign hwif_out.y.kp.exp.value = field_storage_y_kp_exp_value;
    assign hwif_out.y.ki.mant.value = field_storage_y_ki_mant_value;
    assign hwif_out.y.ki.exp.value = field_storage_y_ki_exp_value;
    assign hwif_out.y.kv.mant.value = field_storage_y_kv_mant_value;
    assign hwif_out.y.kv.exp.value = field_storage_y_kv_exp_value;
    assign hwif_out.y.eta.mant.value = field_storage_y_eta_mant_value;
    assign hwif_out.y.eta.exp.value = field_storage_y_eta_exp_value;
    assign hwif_out.y.shift.e.value = field_storage_y_shift_e_value;
    assign hwif_out.y.shift.de.value = field_storage_y_shift_de_value;
    assign hwif_out.y.a0.value.value = field_storage_y_a0_value_value;
    assign hwif_out.y.a0.scale.value = field_storage_y_a0_scale_value;
    assign hwif_out.y.b2.value.value = field_storage_y_b2_value_value;
    assign hwif_out.y.kp_cur.mant.value = field_storage_y_kp_cur_mant_value;
    assign hwif_out.y.kp_cur.exp.value = field_storage_y_kp_cur_exp_value;
    assign hwif_out.y.ki_cur.mant.value = field_storage_y_ki_cur_mant_value;
    assign hwif_out.y.ki_cur.exp.value = field_storage_y_ki_cur_exp_value;
    assign hwif_out.y.theta_ofs.value.value = field_storage_y_theta_ofs_value_value;
    assign hwif_out.y.deadtime.clk.value = field_storage_y_deadtime_clk_value;
    assign hwif_out.y.deadtime.qep_filter.value = field_storage_y_deadtime_qep_filter_value;
    assign hwif_out.y.tab_addr.index.value = field_storage_y_tab_addr_index_value;
    // External register: kung_xy.y.tab_data
    assign hwif_out.y.tab_data.req = decoded_reg_strb_y_tab_data;
    assign hwif_out.y.tab_data.req_is_wr = decoded_req_is_wr;
    assign hwif_out.y.tab_data.wr_data = decoded_wr_data;
    assign hwif_out.y.tab_data.wr_biten = decoded_wr_biten;
    // External register: kung_xy.y.pos_preset

    assign hwif_out.y.pos_preset.req = decoded_req_is_wr ? decoded_reg_strb_y_pos_preset : '0;
    assign hwif_out.y.pos_preset.req_is_wr = decoded_req_is_wr;
    assign hwif_out.y.pos_preset.wr_data = decoded_wr_data;
    assign hwif_out.y.pos_preset.wr_biten = decoded_wr_biten;
    assign hwif_out.y.stroke_min.value.value = field_storage_y_stroke_min_value_value;
    assign hwif_out.y.stroke_max.value.value = field_storage_y_stroke_max_value_value;
    assign hwif_out.y.stroke_en.enable.value = field_storage_y_stroke_en_enable_value;
    assign hwif_out.y.iq_manual.value.value = field_storage_y_iq_manual_value_value;
    // Field: kung_xy.y.prec_addr.word
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_y_prec_addr_word_value <= 5'h0;
        end else if(decoded_reg_strb_y_prec_addr && decoded_req_is_wr) begin // SW write
            field_storage_y_prec_addr_word_value <= (field_storage_y_prec_addr_word_value & ~decoded_wr_biten[4:0]) | (decoded_wr_data[4:0] & decoded_wr_biten[4:0]);
        end else if(hwif_in_y_prec_addr_word_we) begin // HW Write - we
            field_storage_y_prec_addr_word_value <= hwif_in_y_prec_addr_word_next;
        end
    end
    assign hwif_out.y.prec_addr.word.value = field_storage_y_prec_addr_word_value;
    // External register: kung_xy.y.prec_data
    assign hwif_out.y.prec_data.req = decoded_reg_strb_y_prec_data;
    assign hwif_out.y.prec_data.req_is_wr = decoded_req_is_wr;
    assign hwif_out.y.prec_data.wr_data = decoded_wr_data;
    assign hwif_out.y.prec_data.wr_biten = decoded_wr_biten;
    // External register: kung_xy.y.prec_err

    assign hwif_out.y.prec_err.req = !decoded_req_is_wr ? decoded_reg_strb_y_prec_err : '0;
    assign hwif_out.y.prec_err.req_is_wr = decoded_req_is_wr;
    // External register: kung_xy.y.err_sum

    assign hwif_out.y.err_sum.req = !decoded_req_is_wr ? decoded_reg_strb_y_err_sum : '0;
    assign hwif_out.y.err_sum.req_is_wr = decoded_req_is_wr;
    // External register: kung_xy.y.iq_sum

    assign hwif_out.y.iq_sum.req = !decoded_req_is_wr ? decoded_reg_strb_y_iq_sum : '0;
    assign hwif_out.y.iq_sum.req_is_wr = decoded_req_is_wr;
    // External register: kung_xy.y.prec_dist

    assign hwif_out.y.prec_dist.req = !decoded_req_is_wr ? decoded_reg_strb_y_prec_dist : '0;
    assign hwif_out.y.prec_dist.req_is_wr = decoded_req_is_wr;
    assign hwif_out.y.angle_step.value.value = field_storage_y_angle_step_value_value;
    assign hwif_out.y.current_offset.a.value = field_storage_y_current_offset_a_value;
    assign hwif_out.y.current_offset.b.value = field_storage_y_current_offset_b_value;
    assign hwif_out.y.adc_frame.zeros.value = field_storage_y_adc_frame_zeros_value;
    // Field: kung_xy.commit.take
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_commit_take_value <= 1'h0;
        end else if(decoded_reg_strb_commit && decoded_req_is_wr) begin // SW write
            field_storage_commit_take_value <= (field_storage_commit_take_value & ~decoded_wr_biten[0:0]) | (decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
        end else begin // singlepulse clears back to 0
            field_storage_commit_take_value <= '0;
        end
    end
    assign hwif_out.commit.take.value = field_storage_commit_take_value;
    assign hwif_out.irq_en.tick.value = field_storage_irq_en_tick_value;
    assign hwif_out.irq_en.fault.value = field_storage_irq_en_fault_value;
    // Field: kung_xy.irq_stat.tick
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_irq_stat_tick_value <= 1'h0;
        end else if(hwif_in_irq_stat_tick_hwset) begin // HW Set
            field_storage_irq_stat_tick_value <= '1;
        end else if(decoded_reg_strb_irq_stat && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_irq_stat_tick_value <= field_storage_irq_stat_tick_value & ~(decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
        end
    end
    assign hwif_out.irq_stat.tick.value = field_storage_irq_stat_tick_value;
    // Field: kung_xy.irq_stat.fault
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_irq_stat_fault_value <= 1'h0;
        end else if(hwif_in_irq_stat_fault_hwset) begin // HW Set
            field_storage_irq_stat_fault_value <= '1;
        end else if(decoded_reg_strb_irq_stat && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_irq_stat_fault_value <= field_storage_irq_stat_fault_value & ~(decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
        end
    end
    assign hwif_out.irq_stat.fault.value = field_storage_irq_stat_fault_value;
    // External register: kung_xy.fault_clear

    assign hwif_out.fault_clear.req = decoded_req_is_wr ? decoded_reg_strb_fault_clear : '0;
    assign hwif_out.fault_clear.req_is_wr = decoded_req_is_wr;
    assign hwif_out.fault_clear.wr_data = decoded_wr_data;
    assign hwif_out.fault_clear.wr_biten = decoded_wr_biten;
    assign hwif_out.watchdog.limit.value = field_storage_watchdog_limit_value;
    // External register: kung_xy.lock
    assign hwif_out.lock.req = decoded_reg_strb_lock;
    assign hwif_out.lock.req_is_wr = decoded_req_is_wr;
    assign hwif_out.lock.wr_data = decoded_wr_data;
    assign hwif_out.lock.wr_biten = decoded_wr_biten;
    assign hwif_out.current_limit.value.value = field_storage_current_limit_value_value;
    assign hwif_out.deadtime_min.clk.value = field_storage_deadtime_min_clk_value;
    assign hwif_out.irq_period.ticks.value = field_storage_irq_period_ticks_value;
    // External register: kung_xy.knot

    assign hwif_out.knot.req = !decoded_req_is_wr ? decoded_reg_strb_knot : '0;
    assign hwif_out.knot.req_is_wr = decoded_req_is_wr;
    assign hwif_out.rates.carrier.value = field_storage_rates_carrier_value;
    assign hwif_out.rates.position.value = field_storage_rates_position_value;

    // Write response
    always_comb begin
        automatic logic wr_ack;
        wr_ack = '0; wr_ack |= hwif_in_x_tab_data_wr_ack; wr_ack |= hwif_in_x_pos_preset_wr_ack;
        wr_ack |= hwif_in_x_prec_data_wr_ack; wr_ack |= hwif_in_y_tab_data_wr_ack;
        wr_ack |= hwif_in_y_pos_preset_wr_ack; wr_ack |= hwif_in_y_prec_data_wr_ack;
        wr_ack |= hwif_in_fault_clear_wr_ack; wr_ack |= hwif_in_lock_wr_ack;
        external_wr_ack = wr_ack;
    end
    assign cpuif_wr_ack = external_wr_ack | (decoded_req & decoded_req_is_wr & ~decoded_req_is_external);
    // Writes are always granted with no error response
    assign cpuif_wr_err = '0;

    // Readback
    logic readback_external_rd_ack_c;
    always_comb begin
        automatic logic rd_ack;
        rd_ack = '0; rd_ack |= hwif_in_x_tab_data_rd_ack; rd_ack |= hwif_in_x_prec_data_rd_ack;
        rd_ack |= hwif_in_x_prec_err_rd_ack; rd_ack |= hwif_in_x_err_sum_rd_ack;
        rd_ack |= hwif_in_x_iq_sum_rd_ack; rd_ack |= hwif_in_x_prec_dist_rd_ack;
        rd_ack |= hwif_in_y_tab_data_rd_ack; rd_ack |= hwif_in_y_prec_data_rd_ack;
        rd_ack |= hwif_in_y_prec_err_rd_ack; rd_ack |= hwif_in_y_err_sum_rd_ack;
        rd_ack |= hwif_in_y_iq_sum_rd_ack; rd_ack |= hwif_in_y_prec_dist_rd_ack;
        rd_ack |= hwif_in_lock_rd_ack; rd_ack |= hwif_in_knot_rd_ack;
        readback_external_rd_ack_c = rd_ack;
    end

    logic readback_external_rd_ack;

    assign readback_external_rd_ack = readback_external_rd_ack_c;

    logic [9:0] rd_mux_addr, pending_rd_addr;
    // Hold read mux address to guarantee it is stable throughout any external accesses
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            pending_rd_addr <= '0;
        end else begin
            if(decoded_req) pending_rd_addr <= decoded_addr;
        end
    end
    assign rd_mux_addr = external_pending ? pending_rd_addr : {axil_araddr[9:2], 2'b0};

    logic readback_err, readback_done;
    assign readback_done = decoded_req & ~decoded_req_is_wr & ~decoded_req_is_external;
    logic [31:0] readback_data;
    always_comb begin
        automatic logic [31:0] readback_data_var;
        readback_data_var = '0;
        if(cpuif_rd_ack) begin
            unique case(rd_mux_addr)
                10'h0: begin
                    readback_data_var[0] = field_storage_x_ctrl_enable_value;
                    readback_data_var[1] = field_storage_x_ctrl_current_loop_value;
                    readback_data_var[2] = field_storage_x_ctrl_position_loop_value;
                    readback_data_var[3] = field_storage_x_ctrl_adapt_value;
                    readback_data_var[4] = field_storage_x_ctrl_reset_model_value;
                    readback_data_var[5] = field_storage_x_ctrl_reset_table_value;
                    readback_data_var[6] = field_storage_x_ctrl_interpolate_value;
                    readback_data_var[7] = field_storage_x_ctrl_feedforward_value;
                    readback_data_var[8] = field_storage_x_ctrl_precision_value;
                end
                10'h4: begin
                    readback_data_var[0] = hwif_in_x_status_busy_next;
                    readback_data_var[1] = field_storage_x_status_overrun_value;
                    readback_data_var[2] = field_storage_x_status_qep_error_value;
                    readback_data_var[3] = field_storage_x_status_saturated_value;
                    readback_data_var[4] = field_storage_x_status_limited_value;
                    readback_data_var[5] = field_storage_x_status_underrun_value;
                    readback_data_var[6] = field_storage_x_status_clipped_value;
                    readback_data_var[14:8] = hwif_in_x_status_step_next;
                end
                10'h8: readback_data_var[23:0] = field_storage_x_pos_cmd_value_value;
                10'hc: begin
                    readback_data_var[31:0] = hwif_in_x_pos_value_next;
                end
                10'h10: readback_data_var[31:0] = hwif_in_x_pos_model_value_next;
                10'h14: readback_data_var[31:0] = hwif_in_x_err_value_next;
                10'h18: readback_data_var[31:0] = hwif_in_x_derr_value_next;
                10'h1c: begin
                    readback_data_var[31:0] = hwif_in_x_u_value_next;
                end
                10'h20: readback_data_var[31:0] = hwif_in_x_vstar_value_next;
                10'h24: readback_data_var[31:0] = hwif_in_x_iq_cmd_value_next;
                10'h28: readback_data_var[31:0] = hwif_in_x_speed_value_next;
                10'h2c: begin
                    readback_data_var[15:0] = hwif_in_x_id_iq_i_d_next;
                    readback_data_var[31:16] = hwif_in_x_id_iq_i_q_next;
                end
                10'h30: begin
                    readback_data_var[15:0] = hwif_in_x_vd_vq_v_d_next;
                    readback_data_var[31:16] = hwif_in_x_vd_vq_v_q_next;
                end
                10'h40: begin
                    readback_data_var[10:0] = field_storage_x_kp_mant_value;
                    readback_data_var[20:16] = field_storage_x_kp_exp_value;
                end
                10'h44: begin
                    readback_data_var[10:0] = field_storage_x_ki_mant_value;
                    readback_data_var[20:16] = field_storage_x_ki_exp_value;
                end
                10'h48: begin
                    readback_data_var[10:0] = field_storage_x_kv_mant_value;
                    readback_data_var[20:16] = field_storage_x_kv_exp_value;
                end
                10'h4c: begin
                    readback_data_var[10:0] = field_storage_x_eta_mant_value;
                    readback_data_var[20:16] = field_storage_x_eta_exp_value;
                end
                10'h50: begin
                    readback_data_var[4:0] = field_storage_x_shift_e_value;
                    readback_data_var[12:8] = field_storage_x_shift_de_value;
                end
                10'h54: begin
                    readback_data_var[17:0] = field_storage_x_a0_value_value;
                    readback_data_var[21:20] = field_storage_x_a0_scale_value;
                end
                10'h58: readback_data_var[23:0] = field_storage_x_b2_value_value;
                10'h60: begin
                    readback_data_var[10:0] = field_storage_x_kp_cur_mant_value;
                    readback_data_var[20:16] = field_storage_x_kp_cur_exp_value;
                end
                10'h64: begin
                    readback_data_var[10:0] = field_storage_x_ki_cur_mant_value;
                    readback_data_var[20:16] = field_storage_x_ki_cur_exp_value;
                end
                10'h68: readback_data_var[31:0] = field_storage_x_theta_ofs_value_value;
                10'h6c: begin
                    readback_data_var[9:0] = field_storage_x_deadtime_clk_value;
                    readback_data_var[19:16] = field_storage_x_deadtime_qep_filter_value;
                end
                10'h70: readback_data_var[5:0] = field_storage_x_tab_addr_index_value;
                10'h74: readback_data_var = hwif_in_x_tab_data_rd_data;
                10'h7c: begin
                    readback_data_var[31:0] = hwif_in_x_index_latch_value_next;
                end
                10'h80: readback_data_var[23:0] = field_storage_x_stroke_min_value_value;
                10'h84: readback_data_var[23:0] = field_storage_x_stroke_max_value_value;
                10'h88: readback_data_var[0] = field_storage_x_stroke_en_enable_value;
                10'h8c: begin
                    readback_data_var[11:0] = field_storage_x_iq_manual_value_value;
                end
                10'h90: readback_data_var[4:0] = field_storage_x_prec_addr_word_value;
                10'h94: readback_data_var = hwif_in_x_prec_data_rd_data;
                10'h98: readback_data_var = hwif_in_x_prec_err_rd_data;
                10'h9c: begin
                    readback_data_var = hwif_in_x_err_sum_rd_data;
                end
                10'ha0: readback_data_var = hwif_in_x_iq_sum_rd_data;
                10'ha4: readback_data_var = hwif_in_x_prec_dist_rd_data;
                10'hb0: readback_data_var[31:0] = field_storage_x_angle_step_value_value;
                10'hb4: begin
                    readback_data_var[11:0] = field_storage_x_current_offset_a_value;
                    readback_data_var[27:16] = field_storage_x_current_offset_b_value;
                end
                10'hb8: begin
                    readback_data_var[15:0] = hwif_in_x_phase_currents_i_a_next;
                    readback_data_var[31:16] = hwif_in_x_phase_currents_i_b_next;
                end
                10'hbc: begin
                    readback_data_var[2:0] = field_storage_x_adc_frame_zeros_value;
                end
                10'h100: begin
                    readback_data_var[0] = field_storage_y_ctrl_enable_value;
                    readback_data_var[1] = field_storage_y_ctrl_current_loop_value;
                    readback_data_var[2] = field_storage_y_ctrl_position_loop_value;
                    readback_data_var[3] = field_storage_y_ctrl_adapt_value;
                    readback_data_var[4] = field_storage_y_ctrl_reset_model_value;
                    readback_data_var[5] = field_storage_y_ctrl_reset_table_value;
                    readback_data_var[6] = field_storage_y_ctrl_interpolate_value;
                    readback_data_var[7] = field_storage_y_ctrl_feedforward_value;
                    readback_data_var[8] = field_storage_y_ctrl_precision_value;
                end
                10'h104: begin
                    readback_data_var[0] = hwif_in_y_status_busy_next;
                    readback_data_var[1] = field_storage_y_status_overrun_value;
                    readback_data_var[2] = field_storage_y_status_qep_error_value;
                    readback_data_var[3] = field_storage_y_status_saturated_value;
                    readback_data_var[4] = field_storage_y_status_limited_value;
                    readback_data_var[5] = field_storage_y_status_underrun_value;
                    readback_data_var[6] = field_storage_y_status_clipped_value;
                    readback_data_var[14:8] = hwif_in_y_status_step_next;
                end
                10'h108: readback_data_var[23:0] = field_storage_y_pos_cmd_value_value;
                10'h10c: begin
                    readback_data_var[31:0] = hwif_in_y_pos_value_next;
                end
                10'h110: readback_data_var[31:0] = hwif_in_y_pos_model_value_next;
                10'h114: readback_data_var[31:0] = hwif_in_y_err_value_next;
                10'h118: readback_data_var[31:0] = hwif_in_y_derr_value_next;
                10'h11c: begin
                    readback_data_var[31:0] = hwif_in_y_u_value_next;
                end
                10'h120: readback_data_var[31:0] = hwif_in_y_vstar_value_next;
                10'h124: readback_data_var[31:0] = hwif_in_y_iq_cmd_value_next;
                10'h128: readback_data_var[31:0] = hwif_in_y_speed_value_next;
                10'h12c: begin
                    readback_data_var[15:0] = hwif_in_y_id_iq_i_d_next;
                    readback_data_var[31:16] = hwif_in_y_id_iq_i_q_next;
                end
                10'h130: begin
                    readback_data_var[15:0] = hwif_in_y_vd_vq_v_d_next;
                    readback_data_var[31:16] = hwif_in_y_vd_vq_v_q_next;
                end
                10'h140: begin
                    readback_data_var[10:0] = field_storage_y_kp_mant_value;
                    readback_data_var[20:16] = field_storage_y_kp_exp_value;
                end
                10'h144: begin
                    readback_data_var[10:0] = field_storage_y_ki_mant_value;
                    readback_data_var[20:16] = field_storage_y_ki_exp_value;
                end
                10'h148: begin
                    readback_data_var[10:0] = field_storage_y_kv_mant_value;
                    readback_data_var[20:16] = field_storage_y_kv_exp_value;
                end
                10'h14c: begin
                    readback_data_var[10:0] = field_storage_y_eta_mant_value;
                    readback_data_var[20:16] = field_storage_y_eta_exp_value;
                end
                10'h150: begin
                    readback_data_var[4:0] = field_storage_y_shift_e_value;
                    readback_data_var[12:8] = field_storage_y_shift_de_value;
                end
                10'h154: begin
                    readback_data_var[17:0] = field_storage_y_a0_value_value;
                    readback_data_var[21:20] = field_storage_y_a0_scale_value;
                end
                10'h158: readback_data_var[23:0] = field_storage_y_b2_value_value;
                10'h160: begin
                    readback_data_var[10:0] = field_storage_y_kp_cur_mant_value;
                    readback_data_var[20:16] = field_storage_y_kp_cur_exp_value;
                end
                10'h164: begin
                    readback_data_var[10:0] = field_storage_y_ki_cur_mant_value;
                    readback_data_var[20:16] = field_storage_y_ki_cur_exp_value;
                end
                10'h168: readback_data_var[31:0] = field_storage_y_theta_ofs_value_value;
                10'h16c: begin
                    readback_data_var[9:0] = field_storage_y_deadtime_clk_value;
                    readback_data_var[19:16] = field_storage_y_deadtime_qep_filter_value;
                end
                10'h170: readback_data_var[5:0] = field_storage_y_tab_addr_index_value;
                10'h174: readback_data_var = hwif_in_y_tab_data_rd_data;
                10'h17c: begin
                    readback_data_var[31:0] = hwif_in_y_index_latch_value_next;
                end
                10'h180: readback_data_var[23:0] = field_storage_y_stroke_min_value_value;
                10'h184: readback_data_var[23:0] = field_storage_y_stroke_max_value_value;
                10'h188: readback_data_var[0] = field_storage_y_stroke_en_enable_value;
                10'h18c: begin
                    readback_data_var[11:0] = field_storage_y_iq_manual_value_value;
                end
                10'h190: readback_data_var[4:0] = field_storage_y_prec_addr_word_value;
                10'h194: readback_data_var = hwif_in_y_prec_data_rd_data;
                10'h198: readback_data_var = hwif_in_y_prec_err_rd_data;
                10'h19c: begin
                    readback_data_var = hwif_in_y_err_sum_rd_data;
                end
                10'h1a0: readback_data_var = hwif_in_y_iq_sum_rd_data;
                10'h1a4: readback_data_var = hwif_in_y_prec_dist_rd_data;
                10'h1b0: readback_data_var[31:0] = field_storage_y_angle_step_value_value;
                10'h1b4: begin
                    readback_data_var[11:0] = field_storage_y_current_offset_a_value;
                    readback_data_var[27:16] = field_storage_y_current_offset_b_value;
                end
                10'h1b8: begin
                    readback_data_var[15:0] = hwif_in_y_phase_currents_i_a_next;
                    readback_data_var[31:16] = hwif_in_y_phase_currents_i_b_next;
                end
                10'h1bc: begin
                    readback_data_var[2:0] = field_storage_y_adc_frame_zeros_value;
                end
                10'h200: begin
                    readback_data_var[15:0] = 16'h5; readback_data_var[31:16] = 16'h4b58;
                end
                10'h208: begin
                    readback_data_var[0] = field_storage_irq_en_tick_value;
                    readback_data_var[1] = field_storage_irq_en_fault_value;
                end
                10'h20c: begin
                    readback_data_var[0] = field_storage_irq_stat_tick_value;
                    readback_data_var[1] = field_storage_irq_stat_fault_value;
                end
                10'h210: readback_data_var[31:0] = hwif_in_tick_value_next;
                10'h214: begin
                    readback_data_var[3:0] = hwif_in_fault_code_next;
                    readback_data_var[4] = hwif_in_fault_axis_next;
                    readback_data_var[31:8] = hwif_in_fault_tick_next;
                end
                10'h21c: begin
                    readback_data_var[15:0] = field_storage_watchdog_limit_value;
                end
                10'h220: readback_data_var = hwif_in_lock_rd_data;
                10'h224: readback_data_var[11:0] = field_storage_current_limit_value_value;
                10'h228: readback_data_var[9:0] = field_storage_deadtime_min_clk_value;
                10'h22c: begin
                    readback_data_var[7:0] = field_storage_irq_period_ticks_value;
                end
                10'h230: readback_data_var = hwif_in_knot_rd_data;
                10'h240: begin
                    readback_data_var[1:0] = field_storage_rates_carrier_value;
                    readback_data_var[5:4] = field_storage_rates_position_value;
                end
                default: ;
            endcase
        end
        readback_data = readback_data_var; readback_err = '0;
    end

    assign external_rd_ack = readback_external_rd_ack;
    assign cpuif_rd_ack = readback_done | readback_external_rd_ack;
    assign cpuif_rd_data = readback_data;
    assign cpuif_rd_err = readback_err;
endmodule
// verilator lint_on UNUSEDSIGNAL
// verilator lint_on UNUSEDPARAM
