// Generated from rtl/chips/mcafee_xy.rdl by scripts/tool gen-register-map; do not edit.
// SPDX-License-Identifier: Apache-2.0
// verilator lint_off UNUSEDSIGNAL
// verilator lint_off UNUSEDPARAM

module mcafee_xy_regs (
        input wire clk_i,
        input wire rst_i,

        output logic s_axil_awready_o,
        input wire s_axil_awvalid_i,
        input wire [5:0] s_axil_awaddr_i,
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
        input wire [5:0] s_axil_araddr_i,
        input wire [2:0] s_axil_arprot_i,
        input wire s_axil_rready_i,
        output logic s_axil_rvalid_o,
        output logic [31:0] s_axil_rdata_o,
        output logic [1:0] s_axil_rresp_o,

        input mcafee_xy_regs_pkg::mcafee_xy__in_t hwif_in,
        output mcafee_xy_regs_pkg::mcafee_xy__out_t hwif_out
    );

    wire hwif_in_status_refused_hwset = hwif_in.status.refused.hwset;
    wire hwif_in_status_sample_hwset = hwif_in.status.sample.hwset;
    wire [7:0] hwif_in_port_c_from_part_next = hwif_in.port_c.from_part.next;
    wire hwif_in_status_busy_next = hwif_in.status.busy.next;
    wire [7:0] hwif_in_feed_out_v_next = hwif_in.feed_out.v.next;
    wire hwif_in_feed_out_ready_next = hwif_in.feed_out.ready.next;
    wire hwif_in_irq_x_next = hwif_in.irq.x.next;
    wire hwif_in_irq_y_next = hwif_in.irq.y.next;
    wire hwif_in_limits_x_low_next = hwif_in.limits.x_low.next;
    wire hwif_in_limits_x_high_next = hwif_in.limits.x_high.next;
    wire hwif_in_limits_y_low_next = hwif_in.limits.y_low.next;
    wire hwif_in_limits_y_high_next = hwif_in.limits.y_high.next;

    // CPU Bus interface logic
    logic cpuif_req, cpuif_req_is_wr;
    logic [5:0] cpuif_addr;
    logic [31:0] cpuif_wr_data, cpuif_wr_biten;
    logic cpuif_req_stall_wr, cpuif_req_stall_rd;

    logic cpuif_rd_ack, cpuif_rd_err;
    logic [31:0] cpuif_rd_data;

    logic cpuif_wr_ack, cpuif_wr_err;

    // Max Outstanding Transactions: 2
    logic [1:0] axil_n_in_flight;
    logic axil_prev_was_rd, axil_arvalid;
    logic [5:0] axil_araddr;
    logic axil_ar_accept, axil_awvalid;
    logic [5:0] axil_awaddr;
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
                cpuif_addr = {axil_araddr[5:2], 2'b0};
                if(!cpuif_req_stall_rd) axil_ar_accept = '1;
            end else if(axil_awvalid && axil_wvalid) begin
                cpuif_req = '1; cpuif_req_is_wr = '1;
                cpuif_addr = {axil_awaddr[5:2], 2'b0};
                if(!cpuif_req_stall_wr) axil_aw_accept = '1;
            end else if(axil_arvalid) begin
                cpuif_req = '1; cpuif_req_is_wr = '0;
                cpuif_addr = {axil_araddr[5:2], 2'b0};
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
    logic decoded_reg_strb_status, decoded_reg_strb_feed_in, decoded_reg_strb_reset, decoded_err;
    logic [5:0] decoded_addr;
    logic decoded_req, decoded_req_is_wr;
    logic [31:0] decoded_wr_data, decoded_wr_biten;

    always_comb begin
        automatic logic is_valid_addr;
        automatic logic is_valid_rw;
        is_valid_addr = '1; // No valid address check
        is_valid_rw = '1; // No valid RW check
        decoded_reg_strb_status = cpuif_req_masked & (cpuif_addr == 6'hc);
        decoded_reg_strb_feed_in = cpuif_req_masked & (cpuif_addr == 6'h10);
        decoded_reg_strb_reset = cpuif_req_masked & (cpuif_addr == 6'h20) & cpuif_req_is_wr;
        decoded_err = '0;
    end

    // Pass down signals to next stage
    assign decoded_addr = cpuif_addr;
    assign decoded_req = cpuif_req_masked;
    assign decoded_req_is_wr = cpuif_req_is_wr;
    assign decoded_wr_data = cpuif_wr_data;
    assign decoded_wr_biten = cpuif_wr_biten;

    // Field logic

    logic field_storage_port_b_write_strobe_value, field_storage_port_b_read_strobe_value;
    logic field_storage_port_b_ps_value, field_storage_port_b_read_value;
    logic field_storage_port_b_y_value;
    logic [7:0] field_storage_port_c_to_part_value;
    logic field_storage_status_refused_value, field_storage_status_sample_value;
    logic [7:0] field_storage_feed_in_c_value, field_storage_feed_in_cc_value;
    logic field_storage_reset_strobe_value;

    // Fields that software alone writes
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_port_b_write_strobe_value <= 1'h0;
            field_storage_port_b_read_strobe_value <= 1'h0; field_storage_port_b_ps_value <= 1'h0;
            field_storage_port_b_read_value <= 1'h0; field_storage_port_b_y_value <= 1'h0;
            field_storage_port_c_to_part_value <= 8'h0; field_storage_feed_in_c_value <= 8'h0;
            field_storage_feed_in_cc_value <= 8'h0;
        end else if(decoded_req && decoded_req_is_wr) begin
            if(decoded_addr == 6'h4) begin
                if(decoded_wr_biten[0]) field_storage_port_b_write_strobe_value <= decoded_wr_data[0:0];
                if(decoded_wr_biten[1]) field_storage_port_b_read_strobe_value <= decoded_wr_data[1:1];
                if(decoded_wr_biten[2]) field_storage_port_b_ps_value <= decoded_wr_data[2:2];
                if(decoded_wr_biten[3]) field_storage_port_b_read_value <= decoded_wr_data[3:3];
                if(decoded_wr_biten[4]) field_storage_port_b_y_value <= decoded_wr_data[4:4];
            end
            if(decoded_addr == 6'h8) if(decoded_wr_biten[0]) field_storage_port_c_to_part_value[7:0] <= decoded_wr_data[7:0];
            if(decoded_addr == 6'h10) begin
                if(decoded_wr_biten[0]) field_storage_feed_in_c_value[7:0] <= decoded_wr_data[7:0];
                if(decoded_wr_biten[8]) field_storage_feed_in_cc_value[7:0] <= decoded_wr_data[15:8];
            end
        end
    end
    assign hwif_out.port_b.write_strobe.value = field_storage_port_b_write_strobe_value;
    assign hwif_out.port_b.read_strobe.value = field_storage_port_b_read_strobe_value;
    assign hwif_out.port_b.ps.value = field_storage_port_b_ps_value;
    assign hwif_out.port_b.read.value = field_storage_port_b_read_value;
    assign hwif_out.port_b.y.value = field_storage_port_b_y_value;
    assign hwif_out.port_c.to_part.value = field_storage_port_c_to_part_value;
    // Field: mcafee_xy.status.refused
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_status_refused_value <= 1'h0;
        end else if(hwif_in_status_refused_hwset) begin // HW Set
            field_storage_status_refused_value <= '1;
        end else if(decoded_reg_strb_status && decoded_req_is_wr) begin // SW write 1 clear
            field_storage_status_refused_value <= field_storage_status_refused_value & ~(decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
        end
    end
    assign hwif_out.status.refused.value = field_storage_status_refused_value;
    // Field: mcafee_xy.status.sample
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
    assign hwif_out.feed_in.c.value = field_storage_feed_in_c_value;
    assign hwif_out.feed_in.c.swmod = decoded_reg_strb_feed_in && decoded_req_is_wr && |(decoded_wr_biten[7:0]);
    assign hwif_out.feed_in.cc.value = field_storage_feed_in_cc_value;
    // Field: mcafee_xy.reset.strobe
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage_reset_strobe_value <= 1'h0;
        end else if(decoded_reg_strb_reset && decoded_req_is_wr) begin // SW write
            field_storage_reset_strobe_value <= (field_storage_reset_strobe_value & ~decoded_wr_biten[0:0]) | (decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
        end else begin // singlepulse clears back to 0
            field_storage_reset_strobe_value <= '0;
        end
    end
    assign hwif_out.reset.strobe.value = field_storage_reset_strobe_value;

    // Write response
    assign cpuif_wr_ack = decoded_req & decoded_req_is_wr;
    // Writes are always granted with no error response
    assign cpuif_wr_err = '0;

    // Readback

    logic [5:0] rd_mux_addr;
    assign rd_mux_addr = decoded_addr;

    logic readback_err, readback_done;
    assign readback_done = decoded_req & ~decoded_req_is_wr;
    logic [31:0] readback_data;
    always_comb begin
        automatic logic [31:0] readback_data_var;
        readback_data_var = '0;
        if(cpuif_rd_ack) begin
            unique case(rd_mux_addr)
                6'h0: begin
                    readback_data_var[15:0] = 16'h1; readback_data_var[31:16] = 16'h4d43;
                end
                6'h4: begin
                    readback_data_var[0] = field_storage_port_b_write_strobe_value;
                    readback_data_var[1] = field_storage_port_b_read_strobe_value;
                    readback_data_var[2] = field_storage_port_b_ps_value;
                    readback_data_var[3] = field_storage_port_b_read_value;
                    readback_data_var[4] = field_storage_port_b_y_value;
                end
                6'h8: readback_data_var[7:0] = hwif_in_port_c_from_part_next;
                6'hc: begin
                    readback_data_var[0] = hwif_in_status_busy_next;
                    readback_data_var[1] = field_storage_status_refused_value;
                    readback_data_var[2] = field_storage_status_sample_value;
                end
                6'h10: begin
                    readback_data_var[7:0] = field_storage_feed_in_c_value;
                    readback_data_var[15:8] = field_storage_feed_in_cc_value;
                end
                6'h14: begin
                    readback_data_var[7:0] = hwif_in_feed_out_v_next;
                    readback_data_var[31] = hwif_in_feed_out_ready_next;
                end
                6'h18: begin
                    readback_data_var[0] = hwif_in_irq_x_next;
                    readback_data_var[1] = hwif_in_irq_y_next;
                end
                6'h1c: begin
                    readback_data_var[0] = hwif_in_limits_x_low_next;
                    readback_data_var[1] = hwif_in_limits_x_high_next;
                    readback_data_var[2] = hwif_in_limits_y_low_next;
                    readback_data_var[3] = hwif_in_limits_y_high_next;
                end
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
