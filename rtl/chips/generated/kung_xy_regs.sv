// Generated from rtl/chips/kung_xy.rdl by scripts/gen_regs.py; do not edit.
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

    //--------------------------------------------------------------------------
    // CPU Bus interface logic
    //--------------------------------------------------------------------------
    logic cpuif_req;
    logic cpuif_req_is_wr;
    logic [9:0] cpuif_addr;
    logic [31:0] cpuif_wr_data;
    logic [31:0] cpuif_wr_biten;
    logic cpuif_req_stall_wr;
    logic cpuif_req_stall_rd;

    logic cpuif_rd_ack;
    logic cpuif_rd_err;
    logic [31:0] cpuif_rd_data;

    logic cpuif_wr_ack;
    logic cpuif_wr_err;

    // Max Outstanding Transactions: 2
    logic [1:0] axil_n_in_flight;
    logic axil_prev_was_rd;
    logic axil_arvalid;
    logic [9:0] axil_araddr;
    logic axil_ar_accept;
    logic axil_awvalid;
    logic [9:0] axil_awaddr;
    logic axil_wvalid;
    logic [31:0] axil_wdata;
    logic [3:0] axil_wstrb;
    logic axil_aw_accept;
    logic axil_resp_acked;

    // Transaction request acceptance
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            axil_prev_was_rd <= '0;
            axil_arvalid <= '0;
            axil_araddr <= '0;
            axil_awvalid <= '0;
            axil_awaddr <= '0;
            axil_wvalid <= '0;
            axil_wdata <= '0;
            axil_wstrb <= '0;
            axil_n_in_flight <= '0;
        end else begin
            // AR* acceptance register
            if(axil_ar_accept) begin
                axil_prev_was_rd <= '1;
                axil_arvalid <= '0;
            end
            if(s_axil_arvalid_i && s_axil_arready_o) begin
                axil_arvalid <= '1;
                axil_araddr <= s_axil_araddr_i;
            end

            // AW* & W* acceptance registers
            if(axil_aw_accept) begin
                axil_prev_was_rd <= '0;
                axil_awvalid <= '0;
                axil_wvalid <= '0;
            end
            if(s_axil_awvalid_i && s_axil_awready_o) begin
                axil_awvalid <= '1;
                axil_awaddr <= s_axil_awaddr_i;
            end
            if(s_axil_wvalid_i && s_axil_wready_o) begin
                axil_wvalid <= '1;
                axil_wdata <= s_axil_wdata_i;
                axil_wstrb <= s_axil_wstrb_i;
            end

            // Keep track of in-flight transactions
            if((axil_ar_accept || axil_aw_accept) && !axil_resp_acked) begin
                axil_n_in_flight <= axil_n_in_flight + 1'b1;
            end else if(!(axil_ar_accept || axil_aw_accept) && axil_resp_acked) begin
                axil_n_in_flight <= axil_n_in_flight - 1'b1;
            end
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
        for(int i=0; i<4; i++) begin
            cpuif_wr_biten[i*8 +: 8] = {8{axil_wstrb[i]}};
        end
        cpuif_req = '0;
        cpuif_req_is_wr = '0;
        cpuif_addr = '0;
        axil_ar_accept = '0;
        axil_aw_accept = '0;

        if(axil_n_in_flight < 2'd2) begin
            // Can safely issue more transactions without overwhelming response buffer
            if(axil_arvalid && !axil_prev_was_rd) begin
                cpuif_req = '1;
                cpuif_req_is_wr = '0;
                cpuif_addr = {axil_araddr[9:2], 2'b0};
                if(!cpuif_req_stall_rd) axil_ar_accept = '1;
            end else if(axil_awvalid && axil_wvalid) begin
                cpuif_req = '1;
                cpuif_req_is_wr = '1;
                cpuif_addr = {axil_awaddr[9:2], 2'b0};
                if(!cpuif_req_stall_wr) axil_aw_accept = '1;
            end else if(axil_arvalid) begin
                cpuif_req = '1;
                cpuif_req_is_wr = '0;
                cpuif_addr = {axil_araddr[9:2], 2'b0};
                if(!cpuif_req_stall_rd) axil_ar_accept = '1;
            end
        end
    end


    // AXI4-Lite Response Logic
    logic axil_resp_buffer_is_wr[2];
    logic axil_resp_buffer_err[2];
    logic [31:0] axil_resp_buffer_rdata[2];

    logic [1:0] axil_resp_wptr;
    logic [1:0] axil_resp_rptr;

    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            for(int i=0; i<2; i++) begin
                axil_resp_buffer_is_wr[i] <= '0;
                axil_resp_buffer_err[i] <= '0;
                axil_resp_buffer_rdata[i] <= '0;
            end
            axil_resp_wptr <= '0;
            axil_resp_rptr <= '0;
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
            if(axil_resp_acked) begin
                axil_resp_rptr <= axil_resp_rptr + 1'b1;
            end
        end
    end

    always_comb begin
        axil_resp_acked = '0;
        s_axil_bvalid_o = '0;
        s_axil_rvalid_o = '0;
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
            s_axil_bresp_o = 2'b10;
            s_axil_rresp_o = 2'b10;
        end else begin
            s_axil_bresp_o = 2'b00;
            s_axil_rresp_o = 2'b00;
        end
    end

    logic cpuif_req_masked;
    logic external_pending;

    // Read & write latencies are balanced. Stalls not required
    // except if external
    assign cpuif_req_stall_rd = external_pending;
    assign cpuif_req_stall_wr = external_pending;
    assign cpuif_req_masked = cpuif_req
                            & !(!cpuif_req_is_wr & cpuif_req_stall_rd)
                            & !(cpuif_req_is_wr & cpuif_req_stall_wr);

    //--------------------------------------------------------------------------
    // Address Decode
    //--------------------------------------------------------------------------
    typedef struct packed {
        struct packed {
            logic ctrl;
            logic status;
            logic pos_cmd;
            logic pos;
            logic pos_model;
            logic err;
            logic derr;
            logic u;
            logic vstar;
            logic iq_cmd;
            logic speed;
            logic id_iq;
            logic vd_vq;
            logic kp;
            logic ki;
            logic kv;
            logic eta;
            logic shift;
            logic a0;
            logic b2;
            logic kp_cur;
            logic ki_cur;
            logic theta_ofs;
            logic deadtime;
            logic tab_addr;
            logic tab_data;
            logic pos_preset;
            logic index_latch;
            logic stroke_min;
            logic stroke_max;
            logic stroke_en;
            logic iq_manual;
        } x;
        struct packed {
            logic ctrl;
            logic status;
            logic pos_cmd;
            logic pos;
            logic pos_model;
            logic err;
            logic derr;
            logic u;
            logic vstar;
            logic iq_cmd;
            logic speed;
            logic id_iq;
            logic vd_vq;
            logic kp;
            logic ki;
            logic kv;
            logic eta;
            logic shift;
            logic a0;
            logic b2;
            logic kp_cur;
            logic ki_cur;
            logic theta_ofs;
            logic deadtime;
            logic tab_addr;
            logic tab_data;
            logic pos_preset;
            logic index_latch;
            logic stroke_min;
            logic stroke_max;
            logic stroke_en;
            logic iq_manual;
        } y;
        logic id;
        logic commit;
        logic irq_en;
        logic irq_stat;
        logic tick;
        logic fault;
        logic fault_clear;
        logic watchdog;
        logic lock;
        logic current_limit;
        logic deadtime_min;
        logic irq_period;
    } decoded_reg_strb_t;
    decoded_reg_strb_t decoded_reg_strb;
    logic decoded_err;
    logic decoded_req_is_external;

    logic [9:0] decoded_addr;
    logic decoded_req;
    logic decoded_req_is_wr;
    logic [31:0] decoded_wr_data;
    logic [31:0] decoded_wr_biten;

    always_comb begin
        automatic logic is_valid_addr;
        automatic logic is_valid_rw;
        automatic logic is_external;
        is_external = '0;
        is_valid_addr = '1; // No valid address check
        is_valid_rw = '1; // No valid RW check
        decoded_reg_strb.x.ctrl = cpuif_req_masked & (cpuif_addr == 10'h0);
        decoded_reg_strb.x.status = cpuif_req_masked & (cpuif_addr == 10'h4);
        decoded_reg_strb.x.pos_cmd = cpuif_req_masked & (cpuif_addr == 10'h8);
        decoded_reg_strb.x.pos = cpuif_req_masked & (cpuif_addr == 10'hc) & !cpuif_req_is_wr;
        decoded_reg_strb.x.pos_model = cpuif_req_masked & (cpuif_addr == 10'h10) & !cpuif_req_is_wr;
        decoded_reg_strb.x.err = cpuif_req_masked & (cpuif_addr == 10'h14) & !cpuif_req_is_wr;
        decoded_reg_strb.x.derr = cpuif_req_masked & (cpuif_addr == 10'h18) & !cpuif_req_is_wr;
        decoded_reg_strb.x.u = cpuif_req_masked & (cpuif_addr == 10'h1c) & !cpuif_req_is_wr;
        decoded_reg_strb.x.vstar = cpuif_req_masked & (cpuif_addr == 10'h20) & !cpuif_req_is_wr;
        decoded_reg_strb.x.iq_cmd = cpuif_req_masked & (cpuif_addr == 10'h24) & !cpuif_req_is_wr;
        decoded_reg_strb.x.speed = cpuif_req_masked & (cpuif_addr == 10'h28) & !cpuif_req_is_wr;
        decoded_reg_strb.x.id_iq = cpuif_req_masked & (cpuif_addr == 10'h2c) & !cpuif_req_is_wr;
        decoded_reg_strb.x.vd_vq = cpuif_req_masked & (cpuif_addr == 10'h30) & !cpuif_req_is_wr;
        decoded_reg_strb.x.kp = cpuif_req_masked & (cpuif_addr == 10'h40);
        decoded_reg_strb.x.ki = cpuif_req_masked & (cpuif_addr == 10'h44);
        decoded_reg_strb.x.kv = cpuif_req_masked & (cpuif_addr == 10'h48);
        decoded_reg_strb.x.eta = cpuif_req_masked & (cpuif_addr == 10'h4c);
        decoded_reg_strb.x.shift = cpuif_req_masked & (cpuif_addr == 10'h50);
        decoded_reg_strb.x.a0 = cpuif_req_masked & (cpuif_addr == 10'h54);
        decoded_reg_strb.x.b2 = cpuif_req_masked & (cpuif_addr == 10'h58);
        decoded_reg_strb.x.kp_cur = cpuif_req_masked & (cpuif_addr == 10'h60);
        decoded_reg_strb.x.ki_cur = cpuif_req_masked & (cpuif_addr == 10'h64);
        decoded_reg_strb.x.theta_ofs = cpuif_req_masked & (cpuif_addr == 10'h68);
        decoded_reg_strb.x.deadtime = cpuif_req_masked & (cpuif_addr == 10'h6c);
        decoded_reg_strb.x.tab_addr = cpuif_req_masked & (cpuif_addr == 10'h70);
        decoded_reg_strb.x.tab_data = cpuif_req_masked & (cpuif_addr == 10'h74);
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h74);
        decoded_reg_strb.x.pos_preset = cpuif_req_masked & (cpuif_addr == 10'h78) & cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h78) & cpuif_req_is_wr;
        decoded_reg_strb.x.index_latch = cpuif_req_masked & (cpuif_addr == 10'h7c) & !cpuif_req_is_wr;
        decoded_reg_strb.x.stroke_min = cpuif_req_masked & (cpuif_addr == 10'h80);
        decoded_reg_strb.x.stroke_max = cpuif_req_masked & (cpuif_addr == 10'h84);
        decoded_reg_strb.x.stroke_en = cpuif_req_masked & (cpuif_addr == 10'h88);
        decoded_reg_strb.x.iq_manual = cpuif_req_masked & (cpuif_addr == 10'h8c);
        decoded_reg_strb.y.ctrl = cpuif_req_masked & (cpuif_addr == 10'h100);
        decoded_reg_strb.y.status = cpuif_req_masked & (cpuif_addr == 10'h104);
        decoded_reg_strb.y.pos_cmd = cpuif_req_masked & (cpuif_addr == 10'h108);
        decoded_reg_strb.y.pos = cpuif_req_masked & (cpuif_addr == 10'h10c) & !cpuif_req_is_wr;
        decoded_reg_strb.y.pos_model = cpuif_req_masked & (cpuif_addr == 10'h110) & !cpuif_req_is_wr;
        decoded_reg_strb.y.err = cpuif_req_masked & (cpuif_addr == 10'h114) & !cpuif_req_is_wr;
        decoded_reg_strb.y.derr = cpuif_req_masked & (cpuif_addr == 10'h118) & !cpuif_req_is_wr;
        decoded_reg_strb.y.u = cpuif_req_masked & (cpuif_addr == 10'h11c) & !cpuif_req_is_wr;
        decoded_reg_strb.y.vstar = cpuif_req_masked & (cpuif_addr == 10'h120) & !cpuif_req_is_wr;
        decoded_reg_strb.y.iq_cmd = cpuif_req_masked & (cpuif_addr == 10'h124) & !cpuif_req_is_wr;
        decoded_reg_strb.y.speed = cpuif_req_masked & (cpuif_addr == 10'h128) & !cpuif_req_is_wr;
        decoded_reg_strb.y.id_iq = cpuif_req_masked & (cpuif_addr == 10'h12c) & !cpuif_req_is_wr;
        decoded_reg_strb.y.vd_vq = cpuif_req_masked & (cpuif_addr == 10'h130) & !cpuif_req_is_wr;
        decoded_reg_strb.y.kp = cpuif_req_masked & (cpuif_addr == 10'h140);
        decoded_reg_strb.y.ki = cpuif_req_masked & (cpuif_addr == 10'h144);
        decoded_reg_strb.y.kv = cpuif_req_masked & (cpuif_addr == 10'h148);
        decoded_reg_strb.y.eta = cpuif_req_masked & (cpuif_addr == 10'h14c);
        decoded_reg_strb.y.shift = cpuif_req_masked & (cpuif_addr == 10'h150);
        decoded_reg_strb.y.a0 = cpuif_req_masked & (cpuif_addr == 10'h154);
        decoded_reg_strb.y.b2 = cpuif_req_masked & (cpuif_addr == 10'h158);
        decoded_reg_strb.y.kp_cur = cpuif_req_masked & (cpuif_addr == 10'h160);
        decoded_reg_strb.y.ki_cur = cpuif_req_masked & (cpuif_addr == 10'h164);
        decoded_reg_strb.y.theta_ofs = cpuif_req_masked & (cpuif_addr == 10'h168);
        decoded_reg_strb.y.deadtime = cpuif_req_masked & (cpuif_addr == 10'h16c);
        decoded_reg_strb.y.tab_addr = cpuif_req_masked & (cpuif_addr == 10'h170);
        decoded_reg_strb.y.tab_data = cpuif_req_masked & (cpuif_addr == 10'h174);
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h174);
        decoded_reg_strb.y.pos_preset = cpuif_req_masked & (cpuif_addr == 10'h178) & cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h178) & cpuif_req_is_wr;
        decoded_reg_strb.y.index_latch = cpuif_req_masked & (cpuif_addr == 10'h17c) & !cpuif_req_is_wr;
        decoded_reg_strb.y.stroke_min = cpuif_req_masked & (cpuif_addr == 10'h180);
        decoded_reg_strb.y.stroke_max = cpuif_req_masked & (cpuif_addr == 10'h184);
        decoded_reg_strb.y.stroke_en = cpuif_req_masked & (cpuif_addr == 10'h188);
        decoded_reg_strb.y.iq_manual = cpuif_req_masked & (cpuif_addr == 10'h18c);
        decoded_reg_strb.id = cpuif_req_masked & (cpuif_addr == 10'h200) & !cpuif_req_is_wr;
        decoded_reg_strb.commit = cpuif_req_masked & (cpuif_addr == 10'h204) & cpuif_req_is_wr;
        decoded_reg_strb.irq_en = cpuif_req_masked & (cpuif_addr == 10'h208);
        decoded_reg_strb.irq_stat = cpuif_req_masked & (cpuif_addr == 10'h20c);
        decoded_reg_strb.tick = cpuif_req_masked & (cpuif_addr == 10'h210) & !cpuif_req_is_wr;
        decoded_reg_strb.fault = cpuif_req_masked & (cpuif_addr == 10'h214) & !cpuif_req_is_wr;
        decoded_reg_strb.fault_clear = cpuif_req_masked & (cpuif_addr == 10'h218) & cpuif_req_is_wr;
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h218) & cpuif_req_is_wr;
        decoded_reg_strb.watchdog = cpuif_req_masked & (cpuif_addr == 10'h21c);
        decoded_reg_strb.lock = cpuif_req_masked & (cpuif_addr == 10'h220);
        is_external |= cpuif_req_masked & (cpuif_addr == 10'h220);
        decoded_reg_strb.current_limit = cpuif_req_masked & (cpuif_addr == 10'h224);
        decoded_reg_strb.deadtime_min = cpuif_req_masked & (cpuif_addr == 10'h228);
        decoded_reg_strb.irq_period = cpuif_req_masked & (cpuif_addr == 10'h22c);
        decoded_err = '0;
        decoded_req_is_external = is_external;
    end
    logic external_wr_ack;
    logic external_rd_ack;
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

    //--------------------------------------------------------------------------
    // Field logic
    //--------------------------------------------------------------------------
    typedef struct packed {
        struct packed {
            struct packed {
                struct packed {
                    logic next;
                    logic load_next;
                } enable;
                struct packed {
                    logic next;
                    logic load_next;
                } current_loop;
                struct packed {
                    logic next;
                    logic load_next;
                } position_loop;
                struct packed {
                    logic next;
                    logic load_next;
                } adapt;
                struct packed {
                    logic next;
                    logic load_next;
                } reset_model;
                struct packed {
                    logic next;
                    logic load_next;
                } reset_table;
                struct packed {
                    logic next;
                    logic load_next;
                } interpolate;
                struct packed {
                    logic next;
                    logic load_next;
                } feedforward;
            } ctrl;
            struct packed {
                struct packed {
                    logic next;
                    logic load_next;
                } overrun;
                struct packed {
                    logic next;
                    logic load_next;
                } qep_error;
                struct packed {
                    logic next;
                    logic load_next;
                } saturated;
                struct packed {
                    logic next;
                    logic load_next;
                } limited;
            } status;
            struct packed {
                struct packed {
                    logic [23:0] next;
                    logic load_next;
                } value;
            } pos_cmd;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } kp;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } ki;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } kv;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } eta;
            struct packed {
                struct packed {
                    logic [3:0] next;
                    logic load_next;
                } e;
                struct packed {
                    logic [3:0] next;
                    logic load_next;
                } de;
            } shift;
            struct packed {
                struct packed {
                    logic [17:0] next;
                    logic load_next;
                } value;
            } a0;
            struct packed {
                struct packed {
                    logic [23:0] next;
                    logic load_next;
                } value;
            } b2;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } kp_cur;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } ki_cur;
            struct packed {
                struct packed {
                    logic [31:0] next;
                    logic load_next;
                } value;
            } theta_ofs;
            struct packed {
                struct packed {
                    logic [9:0] next;
                    logic load_next;
                } clk;
                struct packed {
                    logic [3:0] next;
                    logic load_next;
                } qep_filter;
            } deadtime;
            struct packed {
                struct packed {
                    logic [5:0] next;
                    logic load_next;
                } index;
            } tab_addr;
            struct packed {
                struct packed {
                    logic [23:0] next;
                    logic load_next;
                } value;
            } stroke_min;
            struct packed {
                struct packed {
                    logic [23:0] next;
                    logic load_next;
                } value;
            } stroke_max;
            struct packed {
                struct packed {
                    logic next;
                    logic load_next;
                } enable;
            } stroke_en;
            struct packed {
                struct packed {
                    logic [11:0] next;
                    logic load_next;
                } value;
            } iq_manual;
        } x;
        struct packed {
            struct packed {
                struct packed {
                    logic next;
                    logic load_next;
                } enable;
                struct packed {
                    logic next;
                    logic load_next;
                } current_loop;
                struct packed {
                    logic next;
                    logic load_next;
                } position_loop;
                struct packed {
                    logic next;
                    logic load_next;
                } adapt;
                struct packed {
                    logic next;
                    logic load_next;
                } reset_model;
                struct packed {
                    logic next;
                    logic load_next;
                } reset_table;
                struct packed {
                    logic next;
                    logic load_next;
                } interpolate;
                struct packed {
                    logic next;
                    logic load_next;
                } feedforward;
            } ctrl;
            struct packed {
                struct packed {
                    logic next;
                    logic load_next;
                } overrun;
                struct packed {
                    logic next;
                    logic load_next;
                } qep_error;
                struct packed {
                    logic next;
                    logic load_next;
                } saturated;
                struct packed {
                    logic next;
                    logic load_next;
                } limited;
            } status;
            struct packed {
                struct packed {
                    logic [23:0] next;
                    logic load_next;
                } value;
            } pos_cmd;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } kp;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } ki;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } kv;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } eta;
            struct packed {
                struct packed {
                    logic [3:0] next;
                    logic load_next;
                } e;
                struct packed {
                    logic [3:0] next;
                    logic load_next;
                } de;
            } shift;
            struct packed {
                struct packed {
                    logic [17:0] next;
                    logic load_next;
                } value;
            } a0;
            struct packed {
                struct packed {
                    logic [23:0] next;
                    logic load_next;
                } value;
            } b2;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } kp_cur;
            struct packed {
                struct packed {
                    logic [10:0] next;
                    logic load_next;
                } mant;
                struct packed {
                    logic [4:0] next;
                    logic load_next;
                } exp;
            } ki_cur;
            struct packed {
                struct packed {
                    logic [31:0] next;
                    logic load_next;
                } value;
            } theta_ofs;
            struct packed {
                struct packed {
                    logic [9:0] next;
                    logic load_next;
                } clk;
                struct packed {
                    logic [3:0] next;
                    logic load_next;
                } qep_filter;
            } deadtime;
            struct packed {
                struct packed {
                    logic [5:0] next;
                    logic load_next;
                } index;
            } tab_addr;
            struct packed {
                struct packed {
                    logic [23:0] next;
                    logic load_next;
                } value;
            } stroke_min;
            struct packed {
                struct packed {
                    logic [23:0] next;
                    logic load_next;
                } value;
            } stroke_max;
            struct packed {
                struct packed {
                    logic next;
                    logic load_next;
                } enable;
            } stroke_en;
            struct packed {
                struct packed {
                    logic [11:0] next;
                    logic load_next;
                } value;
            } iq_manual;
        } y;
        struct packed {
            struct packed {
                logic next;
                logic load_next;
            } take;
        } commit;
        struct packed {
            struct packed {
                logic next;
                logic load_next;
            } tick;
            struct packed {
                logic next;
                logic load_next;
            } fault;
        } irq_en;
        struct packed {
            struct packed {
                logic next;
                logic load_next;
            } tick;
            struct packed {
                logic next;
                logic load_next;
            } fault;
        } irq_stat;
        struct packed {
            struct packed {
                logic [15:0] next;
                logic load_next;
            } limit;
        } watchdog;
        struct packed {
            struct packed {
                logic [11:0] next;
                logic load_next;
            } value;
        } current_limit;
        struct packed {
            struct packed {
                logic [9:0] next;
                logic load_next;
            } clk;
        } deadtime_min;
        struct packed {
            struct packed {
                logic [7:0] next;
                logic load_next;
            } ticks;
        } irq_period;
    } field_combo_t;
    field_combo_t field_combo;

    typedef struct packed {
        struct packed {
            struct packed {
                struct packed {
                    logic value;
                } enable;
                struct packed {
                    logic value;
                } current_loop;
                struct packed {
                    logic value;
                } position_loop;
                struct packed {
                    logic value;
                } adapt;
                struct packed {
                    logic value;
                } reset_model;
                struct packed {
                    logic value;
                } reset_table;
                struct packed {
                    logic value;
                } interpolate;
                struct packed {
                    logic value;
                } feedforward;
            } ctrl;
            struct packed {
                struct packed {
                    logic value;
                } overrun;
                struct packed {
                    logic value;
                } qep_error;
                struct packed {
                    logic value;
                } saturated;
                struct packed {
                    logic value;
                } limited;
            } status;
            struct packed {
                struct packed {
                    logic [23:0] value;
                } value;
            } pos_cmd;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } kp;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } ki;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } kv;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } eta;
            struct packed {
                struct packed {
                    logic [3:0] value;
                } e;
                struct packed {
                    logic [3:0] value;
                } de;
            } shift;
            struct packed {
                struct packed {
                    logic [17:0] value;
                } value;
            } a0;
            struct packed {
                struct packed {
                    logic [23:0] value;
                } value;
            } b2;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } kp_cur;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } ki_cur;
            struct packed {
                struct packed {
                    logic [31:0] value;
                } value;
            } theta_ofs;
            struct packed {
                struct packed {
                    logic [9:0] value;
                } clk;
                struct packed {
                    logic [3:0] value;
                } qep_filter;
            } deadtime;
            struct packed {
                struct packed {
                    logic [5:0] value;
                } index;
            } tab_addr;
            struct packed {
                struct packed {
                    logic [23:0] value;
                } value;
            } stroke_min;
            struct packed {
                struct packed {
                    logic [23:0] value;
                } value;
            } stroke_max;
            struct packed {
                struct packed {
                    logic value;
                } enable;
            } stroke_en;
            struct packed {
                struct packed {
                    logic [11:0] value;
                } value;
            } iq_manual;
        } x;
        struct packed {
            struct packed {
                struct packed {
                    logic value;
                } enable;
                struct packed {
                    logic value;
                } current_loop;
                struct packed {
                    logic value;
                } position_loop;
                struct packed {
                    logic value;
                } adapt;
                struct packed {
                    logic value;
                } reset_model;
                struct packed {
                    logic value;
                } reset_table;
                struct packed {
                    logic value;
                } interpolate;
                struct packed {
                    logic value;
                } feedforward;
            } ctrl;
            struct packed {
                struct packed {
                    logic value;
                } overrun;
                struct packed {
                    logic value;
                } qep_error;
                struct packed {
                    logic value;
                } saturated;
                struct packed {
                    logic value;
                } limited;
            } status;
            struct packed {
                struct packed {
                    logic [23:0] value;
                } value;
            } pos_cmd;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } kp;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } ki;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } kv;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } eta;
            struct packed {
                struct packed {
                    logic [3:0] value;
                } e;
                struct packed {
                    logic [3:0] value;
                } de;
            } shift;
            struct packed {
                struct packed {
                    logic [17:0] value;
                } value;
            } a0;
            struct packed {
                struct packed {
                    logic [23:0] value;
                } value;
            } b2;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } kp_cur;
            struct packed {
                struct packed {
                    logic [10:0] value;
                } mant;
                struct packed {
                    logic [4:0] value;
                } exp;
            } ki_cur;
            struct packed {
                struct packed {
                    logic [31:0] value;
                } value;
            } theta_ofs;
            struct packed {
                struct packed {
                    logic [9:0] value;
                } clk;
                struct packed {
                    logic [3:0] value;
                } qep_filter;
            } deadtime;
            struct packed {
                struct packed {
                    logic [5:0] value;
                } index;
            } tab_addr;
            struct packed {
                struct packed {
                    logic [23:0] value;
                } value;
            } stroke_min;
            struct packed {
                struct packed {
                    logic [23:0] value;
                } value;
            } stroke_max;
            struct packed {
                struct packed {
                    logic value;
                } enable;
            } stroke_en;
            struct packed {
                struct packed {
                    logic [11:0] value;
                } value;
            } iq_manual;
        } y;
        struct packed {
            struct packed {
                logic value;
            } take;
        } commit;
        struct packed {
            struct packed {
                logic value;
            } tick;
            struct packed {
                logic value;
            } fault;
        } irq_en;
        struct packed {
            struct packed {
                logic value;
            } tick;
            struct packed {
                logic value;
            } fault;
        } irq_stat;
        struct packed {
            struct packed {
                logic [15:0] value;
            } limit;
        } watchdog;
        struct packed {
            struct packed {
                logic [11:0] value;
            } value;
        } current_limit;
        struct packed {
            struct packed {
                logic [9:0] value;
            } clk;
        } deadtime_min;
        struct packed {
            struct packed {
                logic [7:0] value;
            } ticks;
        } irq_period;
    } field_storage_t;
    field_storage_t field_storage;

    // Field: kung_xy.x.ctrl.enable
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ctrl.enable.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ctrl.enable.value & ~decoded_wr_biten[0:0]) | (decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
            load_next_c = '1;
        end
        field_combo.x.ctrl.enable.next = next_c;
        field_combo.x.ctrl.enable.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ctrl.enable.value <= 1'h0;
        end else begin
            if(field_combo.x.ctrl.enable.load_next) begin
                field_storage.x.ctrl.enable.value <= field_combo.x.ctrl.enable.next;
            end
        end
    end
    assign hwif_out.x.ctrl.enable.value = field_storage.x.ctrl.enable.value;
    // Field: kung_xy.x.ctrl.current_loop
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ctrl.current_loop.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ctrl.current_loop.value & ~decoded_wr_biten[1:1]) | (decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
            load_next_c = '1;
        end
        field_combo.x.ctrl.current_loop.next = next_c;
        field_combo.x.ctrl.current_loop.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ctrl.current_loop.value <= 1'h0;
        end else begin
            if(field_combo.x.ctrl.current_loop.load_next) begin
                field_storage.x.ctrl.current_loop.value <= field_combo.x.ctrl.current_loop.next;
            end
        end
    end
    assign hwif_out.x.ctrl.current_loop.value = field_storage.x.ctrl.current_loop.value;
    // Field: kung_xy.x.ctrl.position_loop
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ctrl.position_loop.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ctrl.position_loop.value & ~decoded_wr_biten[2:2]) | (decoded_wr_data[2:2] & decoded_wr_biten[2:2]);
            load_next_c = '1;
        end
        field_combo.x.ctrl.position_loop.next = next_c;
        field_combo.x.ctrl.position_loop.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ctrl.position_loop.value <= 1'h0;
        end else begin
            if(field_combo.x.ctrl.position_loop.load_next) begin
                field_storage.x.ctrl.position_loop.value <= field_combo.x.ctrl.position_loop.next;
            end
        end
    end
    assign hwif_out.x.ctrl.position_loop.value = field_storage.x.ctrl.position_loop.value;
    // Field: kung_xy.x.ctrl.adapt
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ctrl.adapt.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ctrl.adapt.value & ~decoded_wr_biten[3:3]) | (decoded_wr_data[3:3] & decoded_wr_biten[3:3]);
            load_next_c = '1;
        end
        field_combo.x.ctrl.adapt.next = next_c;
        field_combo.x.ctrl.adapt.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ctrl.adapt.value <= 1'h0;
        end else begin
            if(field_combo.x.ctrl.adapt.load_next) begin
                field_storage.x.ctrl.adapt.value <= field_combo.x.ctrl.adapt.next;
            end
        end
    end
    assign hwif_out.x.ctrl.adapt.value = field_storage.x.ctrl.adapt.value;
    // Field: kung_xy.x.ctrl.reset_model
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ctrl.reset_model.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ctrl.reset_model.value & ~decoded_wr_biten[4:4]) | (decoded_wr_data[4:4] & decoded_wr_biten[4:4]);
            load_next_c = '1;
        end
        field_combo.x.ctrl.reset_model.next = next_c;
        field_combo.x.ctrl.reset_model.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ctrl.reset_model.value <= 1'h0;
        end else begin
            if(field_combo.x.ctrl.reset_model.load_next) begin
                field_storage.x.ctrl.reset_model.value <= field_combo.x.ctrl.reset_model.next;
            end
        end
    end
    assign hwif_out.x.ctrl.reset_model.value = field_storage.x.ctrl.reset_model.value;
    // Field: kung_xy.x.ctrl.reset_table
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ctrl.reset_table.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ctrl.reset_table.value & ~decoded_wr_biten[5:5]) | (decoded_wr_data[5:5] & decoded_wr_biten[5:5]);
            load_next_c = '1;
        end else begin // singlepulse clears back to 0
            next_c = '0;
            load_next_c = '1;
        end
        field_combo.x.ctrl.reset_table.next = next_c;
        field_combo.x.ctrl.reset_table.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ctrl.reset_table.value <= 1'h0;
        end else begin
            if(field_combo.x.ctrl.reset_table.load_next) begin
                field_storage.x.ctrl.reset_table.value <= field_combo.x.ctrl.reset_table.next;
            end
        end
    end
    assign hwif_out.x.ctrl.reset_table.value = field_storage.x.ctrl.reset_table.value;
    // Field: kung_xy.x.ctrl.interpolate
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ctrl.interpolate.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ctrl.interpolate.value & ~decoded_wr_biten[6:6]) | (decoded_wr_data[6:6] & decoded_wr_biten[6:6]);
            load_next_c = '1;
        end
        field_combo.x.ctrl.interpolate.next = next_c;
        field_combo.x.ctrl.interpolate.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ctrl.interpolate.value <= 1'h0;
        end else begin
            if(field_combo.x.ctrl.interpolate.load_next) begin
                field_storage.x.ctrl.interpolate.value <= field_combo.x.ctrl.interpolate.next;
            end
        end
    end
    assign hwif_out.x.ctrl.interpolate.value = field_storage.x.ctrl.interpolate.value;
    // Field: kung_xy.x.ctrl.feedforward
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ctrl.feedforward.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ctrl.feedforward.value & ~decoded_wr_biten[7:7]) | (decoded_wr_data[7:7] & decoded_wr_biten[7:7]);
            load_next_c = '1;
        end
        field_combo.x.ctrl.feedforward.next = next_c;
        field_combo.x.ctrl.feedforward.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ctrl.feedforward.value <= 1'h0;
        end else begin
            if(field_combo.x.ctrl.feedforward.load_next) begin
                field_storage.x.ctrl.feedforward.value <= field_combo.x.ctrl.feedforward.next;
            end
        end
    end
    assign hwif_out.x.ctrl.feedforward.value = field_storage.x.ctrl.feedforward.value;
    // Field: kung_xy.x.status.overrun
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.status.overrun.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.status && decoded_req_is_wr) begin // SW write 1 clear
            next_c = field_storage.x.status.overrun.value & ~(decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
            load_next_c = '1;
        end else if(hwif_in.x.status.overrun.hwset) begin // HW Set
            next_c = '1;
            load_next_c = '1;
        end
        field_combo.x.status.overrun.next = next_c;
        field_combo.x.status.overrun.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.status.overrun.value <= 1'h0;
        end else begin
            if(field_combo.x.status.overrun.load_next) begin
                field_storage.x.status.overrun.value <= field_combo.x.status.overrun.next;
            end
        end
    end
    assign hwif_out.x.status.overrun.value = field_storage.x.status.overrun.value;
    // Field: kung_xy.x.status.qep_error
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.status.qep_error.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.status && decoded_req_is_wr) begin // SW write 1 clear
            next_c = field_storage.x.status.qep_error.value & ~(decoded_wr_data[2:2] & decoded_wr_biten[2:2]);
            load_next_c = '1;
        end else if(hwif_in.x.status.qep_error.hwset) begin // HW Set
            next_c = '1;
            load_next_c = '1;
        end
        field_combo.x.status.qep_error.next = next_c;
        field_combo.x.status.qep_error.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.status.qep_error.value <= 1'h0;
        end else begin
            if(field_combo.x.status.qep_error.load_next) begin
                field_storage.x.status.qep_error.value <= field_combo.x.status.qep_error.next;
            end
        end
    end
    assign hwif_out.x.status.qep_error.value = field_storage.x.status.qep_error.value;
    // Field: kung_xy.x.status.saturated
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.status.saturated.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.status && decoded_req_is_wr) begin // SW write 1 clear
            next_c = field_storage.x.status.saturated.value & ~(decoded_wr_data[3:3] & decoded_wr_biten[3:3]);
            load_next_c = '1;
        end else if(hwif_in.x.status.saturated.hwset) begin // HW Set
            next_c = '1;
            load_next_c = '1;
        end
        field_combo.x.status.saturated.next = next_c;
        field_combo.x.status.saturated.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.status.saturated.value <= 1'h0;
        end else begin
            if(field_combo.x.status.saturated.load_next) begin
                field_storage.x.status.saturated.value <= field_combo.x.status.saturated.next;
            end
        end
    end
    assign hwif_out.x.status.saturated.value = field_storage.x.status.saturated.value;
    // Field: kung_xy.x.status.limited
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.status.limited.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.status && decoded_req_is_wr) begin // SW write 1 clear
            next_c = field_storage.x.status.limited.value & ~(decoded_wr_data[4:4] & decoded_wr_biten[4:4]);
            load_next_c = '1;
        end else if(hwif_in.x.status.limited.hwset) begin // HW Set
            next_c = '1;
            load_next_c = '1;
        end
        field_combo.x.status.limited.next = next_c;
        field_combo.x.status.limited.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.status.limited.value <= 1'h0;
        end else begin
            if(field_combo.x.status.limited.load_next) begin
                field_storage.x.status.limited.value <= field_combo.x.status.limited.next;
            end
        end
    end
    assign hwif_out.x.status.limited.value = field_storage.x.status.limited.value;
    // Field: kung_xy.x.pos_cmd.value
    always_comb begin
        automatic logic [23:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.pos_cmd.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.pos_cmd && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.pos_cmd.value.value & ~decoded_wr_biten[23:0]) | (decoded_wr_data[23:0] & decoded_wr_biten[23:0]);
            load_next_c = '1;
        end
        field_combo.x.pos_cmd.value.next = next_c;
        field_combo.x.pos_cmd.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.pos_cmd.value.value <= 24'h0;
        end else begin
            if(field_combo.x.pos_cmd.value.load_next) begin
                field_storage.x.pos_cmd.value.value <= field_combo.x.pos_cmd.value.next;
            end
        end
    end
    assign hwif_out.x.pos_cmd.value.value = field_storage.x.pos_cmd.value.value;
    // Field: kung_xy.x.kp.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.kp.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.kp && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.kp.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.x.kp.mant.next = next_c;
        field_combo.x.kp.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.kp.mant.value <= 11'h300;
        end else begin
            if(field_combo.x.kp.mant.load_next) begin
                field_storage.x.kp.mant.value <= field_combo.x.kp.mant.next;
            end
        end
    end
    assign hwif_out.x.kp.mant.value = field_storage.x.kp.mant.value;
    // Field: kung_xy.x.kp.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.kp.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.kp && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.kp.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.x.kp.exp.next = next_c;
        field_combo.x.kp.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.kp.exp.value <= 5'h0;
        end else begin
            if(field_combo.x.kp.exp.load_next) begin
                field_storage.x.kp.exp.value <= field_combo.x.kp.exp.next;
            end
        end
    end
    assign hwif_out.x.kp.exp.value = field_storage.x.kp.exp.value;
    // Field: kung_xy.x.ki.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ki.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ki && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ki.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.x.ki.mant.next = next_c;
        field_combo.x.ki.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ki.mant.value <= 11'h347;
        end else begin
            if(field_combo.x.ki.mant.load_next) begin
                field_storage.x.ki.mant.value <= field_combo.x.ki.mant.next;
            end
        end
    end
    assign hwif_out.x.ki.mant.value = field_storage.x.ki.mant.value;
    // Field: kung_xy.x.ki.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ki.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ki && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ki.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.x.ki.exp.next = next_c;
        field_combo.x.ki.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ki.exp.value <= 5'h19;
        end else begin
            if(field_combo.x.ki.exp.load_next) begin
                field_storage.x.ki.exp.value <= field_combo.x.ki.exp.next;
            end
        end
    end
    assign hwif_out.x.ki.exp.value = field_storage.x.ki.exp.value;
    // Field: kung_xy.x.kv.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.kv.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.kv && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.kv.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.x.kv.mant.next = next_c;
        field_combo.x.kv.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.kv.mant.value <= 11'h75c;
        end else begin
            if(field_combo.x.kv.mant.load_next) begin
                field_storage.x.kv.mant.value <= field_combo.x.kv.mant.next;
            end
        end
    end
    assign hwif_out.x.kv.mant.value = field_storage.x.kv.mant.value;
    // Field: kung_xy.x.kv.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.kv.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.kv && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.kv.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.x.kv.exp.next = next_c;
        field_combo.x.kv.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.kv.exp.value <= 5'h1;
        end else begin
            if(field_combo.x.kv.exp.load_next) begin
                field_storage.x.kv.exp.value <= field_combo.x.kv.exp.next;
            end
        end
    end
    assign hwif_out.x.kv.exp.value = field_storage.x.kv.exp.value;
    // Field: kung_xy.x.eta.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.eta.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.eta && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.eta.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.x.eta.mant.next = next_c;
        field_combo.x.eta.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.eta.mant.value <= 11'h474;
        end else begin
            if(field_combo.x.eta.mant.load_next) begin
                field_storage.x.eta.mant.value <= field_combo.x.eta.mant.next;
            end
        end
    end
    assign hwif_out.x.eta.mant.value = field_storage.x.eta.mant.value;
    // Field: kung_xy.x.eta.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.eta.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.eta && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.eta.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.x.eta.exp.next = next_c;
        field_combo.x.eta.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.eta.exp.value <= 5'h18;
        end else begin
            if(field_combo.x.eta.exp.load_next) begin
                field_storage.x.eta.exp.value <= field_combo.x.eta.exp.next;
            end
        end
    end
    assign hwif_out.x.eta.exp.value = field_storage.x.eta.exp.value;
    // Field: kung_xy.x.shift.e
    always_comb begin
        automatic logic [3:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.shift.e.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.shift && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.shift.e.value & ~decoded_wr_biten[3:0]) | (decoded_wr_data[3:0] & decoded_wr_biten[3:0]);
            load_next_c = '1;
        end
        field_combo.x.shift.e.next = next_c;
        field_combo.x.shift.e.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.shift.e.value <= 4'h0;
        end else begin
            if(field_combo.x.shift.e.load_next) begin
                field_storage.x.shift.e.value <= field_combo.x.shift.e.next;
            end
        end
    end
    assign hwif_out.x.shift.e.value = field_storage.x.shift.e.value;
    // Field: kung_xy.x.shift.de
    always_comb begin
        automatic logic [3:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.shift.de.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.shift && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.shift.de.value & ~decoded_wr_biten[11:8]) | (decoded_wr_data[11:8] & decoded_wr_biten[11:8]);
            load_next_c = '1;
        end
        field_combo.x.shift.de.next = next_c;
        field_combo.x.shift.de.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.shift.de.value <= 4'h2;
        end else begin
            if(field_combo.x.shift.de.load_next) begin
                field_storage.x.shift.de.value <= field_combo.x.shift.de.next;
            end
        end
    end
    assign hwif_out.x.shift.de.value = field_storage.x.shift.de.value;
    // Field: kung_xy.x.a0.value
    always_comb begin
        automatic logic [17:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.a0.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.a0 && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.a0.value.value & ~decoded_wr_biten[17:0]) | (decoded_wr_data[17:0] & decoded_wr_biten[17:0]);
            load_next_c = '1;
        end
        field_combo.x.a0.value.next = next_c;
        field_combo.x.a0.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.a0.value.value <= 18'h3a1b8;
        end else begin
            if(field_combo.x.a0.value.load_next) begin
                field_storage.x.a0.value.value <= field_combo.x.a0.value.next;
            end
        end
    end
    assign hwif_out.x.a0.value.value = field_storage.x.a0.value.value;
    // Field: kung_xy.x.b2.value
    always_comb begin
        automatic logic [23:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.b2.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.b2 && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.b2.value.value & ~decoded_wr_biten[23:0]) | (decoded_wr_data[23:0] & decoded_wr_biten[23:0]);
            load_next_c = '1;
        end
        field_combo.x.b2.value.next = next_c;
        field_combo.x.b2.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.b2.value.value <= 24'h7c378b;
        end else begin
            if(field_combo.x.b2.value.load_next) begin
                field_storage.x.b2.value.value <= field_combo.x.b2.value.next;
            end
        end
    end
    assign hwif_out.x.b2.value.value = field_storage.x.b2.value.value;
    // Field: kung_xy.x.kp_cur.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.kp_cur.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.kp_cur && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.kp_cur.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.x.kp_cur.mant.next = next_c;
        field_combo.x.kp_cur.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.kp_cur.mant.value <= 11'h4fb;
        end else begin
            if(field_combo.x.kp_cur.mant.load_next) begin
                field_storage.x.kp_cur.mant.value <= field_combo.x.kp_cur.mant.next;
            end
        end
    end
    assign hwif_out.x.kp_cur.mant.value = field_storage.x.kp_cur.mant.value;
    // Field: kung_xy.x.kp_cur.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.kp_cur.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.kp_cur && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.kp_cur.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.x.kp_cur.exp.next = next_c;
        field_combo.x.kp_cur.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.kp_cur.exp.value <= 5'h2;
        end else begin
            if(field_combo.x.kp_cur.exp.load_next) begin
                field_storage.x.kp_cur.exp.value <= field_combo.x.kp_cur.exp.next;
            end
        end
    end
    assign hwif_out.x.kp_cur.exp.value = field_storage.x.kp_cur.exp.value;
    // Field: kung_xy.x.ki_cur.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ki_cur.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ki_cur && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ki_cur.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.x.ki_cur.mant.next = next_c;
        field_combo.x.ki_cur.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ki_cur.mant.value <= 11'h5c6;
        end else begin
            if(field_combo.x.ki_cur.mant.load_next) begin
                field_storage.x.ki_cur.mant.value <= field_combo.x.ki_cur.mant.next;
            end
        end
    end
    assign hwif_out.x.ki_cur.mant.value = field_storage.x.ki_cur.mant.value;
    // Field: kung_xy.x.ki_cur.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.ki_cur.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.ki_cur && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.ki_cur.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.x.ki_cur.exp.next = next_c;
        field_combo.x.ki_cur.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.ki_cur.exp.value <= 5'h1e;
        end else begin
            if(field_combo.x.ki_cur.exp.load_next) begin
                field_storage.x.ki_cur.exp.value <= field_combo.x.ki_cur.exp.next;
            end
        end
    end
    assign hwif_out.x.ki_cur.exp.value = field_storage.x.ki_cur.exp.value;
    // Field: kung_xy.x.theta_ofs.value
    always_comb begin
        automatic logic [31:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.theta_ofs.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.theta_ofs && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.theta_ofs.value.value & ~decoded_wr_biten[31:0]) | (decoded_wr_data[31:0] & decoded_wr_biten[31:0]);
            load_next_c = '1;
        end
        field_combo.x.theta_ofs.value.next = next_c;
        field_combo.x.theta_ofs.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.theta_ofs.value.value <= 32'h0;
        end else begin
            if(field_combo.x.theta_ofs.value.load_next) begin
                field_storage.x.theta_ofs.value.value <= field_combo.x.theta_ofs.value.next;
            end
        end
    end
    assign hwif_out.x.theta_ofs.value.value = field_storage.x.theta_ofs.value.value;
    // Field: kung_xy.x.deadtime.clk
    always_comb begin
        automatic logic [9:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.deadtime.clk.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.deadtime && decoded_req_is_wr && !(hwif_in.x.deadtime.clk.swwel)) begin // SW write
            next_c = (field_storage.x.deadtime.clk.value & ~decoded_wr_biten[9:0]) | (decoded_wr_data[9:0] & decoded_wr_biten[9:0]);
            load_next_c = '1;
        end
        field_combo.x.deadtime.clk.next = next_c;
        field_combo.x.deadtime.clk.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.deadtime.clk.value <= 10'h64;
        end else begin
            if(field_combo.x.deadtime.clk.load_next) begin
                field_storage.x.deadtime.clk.value <= field_combo.x.deadtime.clk.next;
            end
        end
    end
    assign hwif_out.x.deadtime.clk.value = field_storage.x.deadtime.clk.value;
    // Field: kung_xy.x.deadtime.qep_filter
    always_comb begin
        automatic logic [3:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.deadtime.qep_filter.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.deadtime && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.deadtime.qep_filter.value & ~decoded_wr_biten[19:16]) | (decoded_wr_data[19:16] & decoded_wr_biten[19:16]);
            load_next_c = '1;
        end
        field_combo.x.deadtime.qep_filter.next = next_c;
        field_combo.x.deadtime.qep_filter.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.deadtime.qep_filter.value <= 4'h3;
        end else begin
            if(field_combo.x.deadtime.qep_filter.load_next) begin
                field_storage.x.deadtime.qep_filter.value <= field_combo.x.deadtime.qep_filter.next;
            end
        end
    end
    assign hwif_out.x.deadtime.qep_filter.value = field_storage.x.deadtime.qep_filter.value;
    // Field: kung_xy.x.tab_addr.index
    always_comb begin
        automatic logic [5:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.tab_addr.index.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.tab_addr && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.tab_addr.index.value & ~decoded_wr_biten[5:0]) | (decoded_wr_data[5:0] & decoded_wr_biten[5:0]);
            load_next_c = '1;
        end
        field_combo.x.tab_addr.index.next = next_c;
        field_combo.x.tab_addr.index.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.tab_addr.index.value <= 6'h0;
        end else begin
            if(field_combo.x.tab_addr.index.load_next) begin
                field_storage.x.tab_addr.index.value <= field_combo.x.tab_addr.index.next;
            end
        end
    end
    assign hwif_out.x.tab_addr.index.value = field_storage.x.tab_addr.index.value;
    // External register: kung_xy.x.tab_data
    assign hwif_out.x.tab_data.req = decoded_reg_strb.x.tab_data;
    assign hwif_out.x.tab_data.req_is_wr = decoded_req_is_wr;
    assign hwif_out.x.tab_data.wr_data = decoded_wr_data;
    assign hwif_out.x.tab_data.wr_biten = decoded_wr_biten;
    // External register: kung_xy.x.pos_preset

    assign hwif_out.x.pos_preset.req = decoded_req_is_wr ? decoded_reg_strb.x.pos_preset : '0;
    assign hwif_out.x.pos_preset.req_is_wr = decoded_req_is_wr;
    assign hwif_out.x.pos_preset.wr_data = decoded_wr_data;
    assign hwif_out.x.pos_preset.wr_biten = decoded_wr_biten;
    // Field: kung_xy.x.stroke_min.value
    always_comb begin
        automatic logic [23:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.stroke_min.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.stroke_min && decoded_req_is_wr && !(hwif_in.x.stroke_min.value.swwel)) begin // SW write
            next_c = (field_storage.x.stroke_min.value.value & ~decoded_wr_biten[23:0]) | (decoded_wr_data[23:0] & decoded_wr_biten[23:0]);
            load_next_c = '1;
        end
        field_combo.x.stroke_min.value.next = next_c;
        field_combo.x.stroke_min.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.stroke_min.value.value <= 24'h0;
        end else begin
            if(field_combo.x.stroke_min.value.load_next) begin
                field_storage.x.stroke_min.value.value <= field_combo.x.stroke_min.value.next;
            end
        end
    end
    assign hwif_out.x.stroke_min.value.value = field_storage.x.stroke_min.value.value;
    // Field: kung_xy.x.stroke_max.value
    always_comb begin
        automatic logic [23:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.stroke_max.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.stroke_max && decoded_req_is_wr && !(hwif_in.x.stroke_max.value.swwel)) begin // SW write
            next_c = (field_storage.x.stroke_max.value.value & ~decoded_wr_biten[23:0]) | (decoded_wr_data[23:0] & decoded_wr_biten[23:0]);
            load_next_c = '1;
        end
        field_combo.x.stroke_max.value.next = next_c;
        field_combo.x.stroke_max.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.stroke_max.value.value <= 24'h1d4c0;
        end else begin
            if(field_combo.x.stroke_max.value.load_next) begin
                field_storage.x.stroke_max.value.value <= field_combo.x.stroke_max.value.next;
            end
        end
    end
    assign hwif_out.x.stroke_max.value.value = field_storage.x.stroke_max.value.value;
    // Field: kung_xy.x.stroke_en.enable
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.stroke_en.enable.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.stroke_en && decoded_req_is_wr && !(hwif_in.x.stroke_en.enable.swwel)) begin // SW write
            next_c = (field_storage.x.stroke_en.enable.value & ~decoded_wr_biten[0:0]) | (decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
            load_next_c = '1;
        end
        field_combo.x.stroke_en.enable.next = next_c;
        field_combo.x.stroke_en.enable.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.stroke_en.enable.value <= 1'h0;
        end else begin
            if(field_combo.x.stroke_en.enable.load_next) begin
                field_storage.x.stroke_en.enable.value <= field_combo.x.stroke_en.enable.next;
            end
        end
    end
    assign hwif_out.x.stroke_en.enable.value = field_storage.x.stroke_en.enable.value;
    // Field: kung_xy.x.iq_manual.value
    always_comb begin
        automatic logic [11:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.x.iq_manual.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.x.iq_manual && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.x.iq_manual.value.value & ~decoded_wr_biten[11:0]) | (decoded_wr_data[11:0] & decoded_wr_biten[11:0]);
            load_next_c = '1;
        end
        field_combo.x.iq_manual.value.next = next_c;
        field_combo.x.iq_manual.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.x.iq_manual.value.value <= 12'h0;
        end else begin
            if(field_combo.x.iq_manual.value.load_next) begin
                field_storage.x.iq_manual.value.value <= field_combo.x.iq_manual.value.next;
            end
        end
    end
    assign hwif_out.x.iq_manual.value.value = field_storage.x.iq_manual.value.value;
    // Field: kung_xy.y.ctrl.enable
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ctrl.enable.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ctrl.enable.value & ~decoded_wr_biten[0:0]) | (decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
            load_next_c = '1;
        end
        field_combo.y.ctrl.enable.next = next_c;
        field_combo.y.ctrl.enable.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ctrl.enable.value <= 1'h0;
        end else begin
            if(field_combo.y.ctrl.enable.load_next) begin
                field_storage.y.ctrl.enable.value <= field_combo.y.ctrl.enable.next;
            end
        end
    end
    assign hwif_out.y.ctrl.enable.value = field_storage.y.ctrl.enable.value;
    // Field: kung_xy.y.ctrl.current_loop
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ctrl.current_loop.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ctrl.current_loop.value & ~decoded_wr_biten[1:1]) | (decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
            load_next_c = '1;
        end
        field_combo.y.ctrl.current_loop.next = next_c;
        field_combo.y.ctrl.current_loop.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ctrl.current_loop.value <= 1'h0;
        end else begin
            if(field_combo.y.ctrl.current_loop.load_next) begin
                field_storage.y.ctrl.current_loop.value <= field_combo.y.ctrl.current_loop.next;
            end
        end
    end
    assign hwif_out.y.ctrl.current_loop.value = field_storage.y.ctrl.current_loop.value;
    // Field: kung_xy.y.ctrl.position_loop
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ctrl.position_loop.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ctrl.position_loop.value & ~decoded_wr_biten[2:2]) | (decoded_wr_data[2:2] & decoded_wr_biten[2:2]);
            load_next_c = '1;
        end
        field_combo.y.ctrl.position_loop.next = next_c;
        field_combo.y.ctrl.position_loop.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ctrl.position_loop.value <= 1'h0;
        end else begin
            if(field_combo.y.ctrl.position_loop.load_next) begin
                field_storage.y.ctrl.position_loop.value <= field_combo.y.ctrl.position_loop.next;
            end
        end
    end
    assign hwif_out.y.ctrl.position_loop.value = field_storage.y.ctrl.position_loop.value;
    // Field: kung_xy.y.ctrl.adapt
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ctrl.adapt.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ctrl.adapt.value & ~decoded_wr_biten[3:3]) | (decoded_wr_data[3:3] & decoded_wr_biten[3:3]);
            load_next_c = '1;
        end
        field_combo.y.ctrl.adapt.next = next_c;
        field_combo.y.ctrl.adapt.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ctrl.adapt.value <= 1'h0;
        end else begin
            if(field_combo.y.ctrl.adapt.load_next) begin
                field_storage.y.ctrl.adapt.value <= field_combo.y.ctrl.adapt.next;
            end
        end
    end
    assign hwif_out.y.ctrl.adapt.value = field_storage.y.ctrl.adapt.value;
    // Field: kung_xy.y.ctrl.reset_model
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ctrl.reset_model.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ctrl.reset_model.value & ~decoded_wr_biten[4:4]) | (decoded_wr_data[4:4] & decoded_wr_biten[4:4]);
            load_next_c = '1;
        end
        field_combo.y.ctrl.reset_model.next = next_c;
        field_combo.y.ctrl.reset_model.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ctrl.reset_model.value <= 1'h0;
        end else begin
            if(field_combo.y.ctrl.reset_model.load_next) begin
                field_storage.y.ctrl.reset_model.value <= field_combo.y.ctrl.reset_model.next;
            end
        end
    end
    assign hwif_out.y.ctrl.reset_model.value = field_storage.y.ctrl.reset_model.value;
    // Field: kung_xy.y.ctrl.reset_table
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ctrl.reset_table.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ctrl.reset_table.value & ~decoded_wr_biten[5:5]) | (decoded_wr_data[5:5] & decoded_wr_biten[5:5]);
            load_next_c = '1;
        end else begin // singlepulse clears back to 0
            next_c = '0;
            load_next_c = '1;
        end
        field_combo.y.ctrl.reset_table.next = next_c;
        field_combo.y.ctrl.reset_table.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ctrl.reset_table.value <= 1'h0;
        end else begin
            if(field_combo.y.ctrl.reset_table.load_next) begin
                field_storage.y.ctrl.reset_table.value <= field_combo.y.ctrl.reset_table.next;
            end
        end
    end
    assign hwif_out.y.ctrl.reset_table.value = field_storage.y.ctrl.reset_table.value;
    // Field: kung_xy.y.ctrl.interpolate
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ctrl.interpolate.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ctrl.interpolate.value & ~decoded_wr_biten[6:6]) | (decoded_wr_data[6:6] & decoded_wr_biten[6:6]);
            load_next_c = '1;
        end
        field_combo.y.ctrl.interpolate.next = next_c;
        field_combo.y.ctrl.interpolate.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ctrl.interpolate.value <= 1'h0;
        end else begin
            if(field_combo.y.ctrl.interpolate.load_next) begin
                field_storage.y.ctrl.interpolate.value <= field_combo.y.ctrl.interpolate.next;
            end
        end
    end
    assign hwif_out.y.ctrl.interpolate.value = field_storage.y.ctrl.interpolate.value;
    // Field: kung_xy.y.ctrl.feedforward
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ctrl.feedforward.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ctrl && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ctrl.feedforward.value & ~decoded_wr_biten[7:7]) | (decoded_wr_data[7:7] & decoded_wr_biten[7:7]);
            load_next_c = '1;
        end
        field_combo.y.ctrl.feedforward.next = next_c;
        field_combo.y.ctrl.feedforward.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ctrl.feedforward.value <= 1'h0;
        end else begin
            if(field_combo.y.ctrl.feedforward.load_next) begin
                field_storage.y.ctrl.feedforward.value <= field_combo.y.ctrl.feedforward.next;
            end
        end
    end
    assign hwif_out.y.ctrl.feedforward.value = field_storage.y.ctrl.feedforward.value;
    // Field: kung_xy.y.status.overrun
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.status.overrun.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.status && decoded_req_is_wr) begin // SW write 1 clear
            next_c = field_storage.y.status.overrun.value & ~(decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
            load_next_c = '1;
        end else if(hwif_in.y.status.overrun.hwset) begin // HW Set
            next_c = '1;
            load_next_c = '1;
        end
        field_combo.y.status.overrun.next = next_c;
        field_combo.y.status.overrun.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.status.overrun.value <= 1'h0;
        end else begin
            if(field_combo.y.status.overrun.load_next) begin
                field_storage.y.status.overrun.value <= field_combo.y.status.overrun.next;
            end
        end
    end
    assign hwif_out.y.status.overrun.value = field_storage.y.status.overrun.value;
    // Field: kung_xy.y.status.qep_error
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.status.qep_error.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.status && decoded_req_is_wr) begin // SW write 1 clear
            next_c = field_storage.y.status.qep_error.value & ~(decoded_wr_data[2:2] & decoded_wr_biten[2:2]);
            load_next_c = '1;
        end else if(hwif_in.y.status.qep_error.hwset) begin // HW Set
            next_c = '1;
            load_next_c = '1;
        end
        field_combo.y.status.qep_error.next = next_c;
        field_combo.y.status.qep_error.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.status.qep_error.value <= 1'h0;
        end else begin
            if(field_combo.y.status.qep_error.load_next) begin
                field_storage.y.status.qep_error.value <= field_combo.y.status.qep_error.next;
            end
        end
    end
    assign hwif_out.y.status.qep_error.value = field_storage.y.status.qep_error.value;
    // Field: kung_xy.y.status.saturated
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.status.saturated.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.status && decoded_req_is_wr) begin // SW write 1 clear
            next_c = field_storage.y.status.saturated.value & ~(decoded_wr_data[3:3] & decoded_wr_biten[3:3]);
            load_next_c = '1;
        end else if(hwif_in.y.status.saturated.hwset) begin // HW Set
            next_c = '1;
            load_next_c = '1;
        end
        field_combo.y.status.saturated.next = next_c;
        field_combo.y.status.saturated.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.status.saturated.value <= 1'h0;
        end else begin
            if(field_combo.y.status.saturated.load_next) begin
                field_storage.y.status.saturated.value <= field_combo.y.status.saturated.next;
            end
        end
    end
    assign hwif_out.y.status.saturated.value = field_storage.y.status.saturated.value;
    // Field: kung_xy.y.status.limited
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.status.limited.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.status && decoded_req_is_wr) begin // SW write 1 clear
            next_c = field_storage.y.status.limited.value & ~(decoded_wr_data[4:4] & decoded_wr_biten[4:4]);
            load_next_c = '1;
        end else if(hwif_in.y.status.limited.hwset) begin // HW Set
            next_c = '1;
            load_next_c = '1;
        end
        field_combo.y.status.limited.next = next_c;
        field_combo.y.status.limited.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.status.limited.value <= 1'h0;
        end else begin
            if(field_combo.y.status.limited.load_next) begin
                field_storage.y.status.limited.value <= field_combo.y.status.limited.next;
            end
        end
    end
    assign hwif_out.y.status.limited.value = field_storage.y.status.limited.value;
    // Field: kung_xy.y.pos_cmd.value
    always_comb begin
        automatic logic [23:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.pos_cmd.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.pos_cmd && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.pos_cmd.value.value & ~decoded_wr_biten[23:0]) | (decoded_wr_data[23:0] & decoded_wr_biten[23:0]);
            load_next_c = '1;
        end
        field_combo.y.pos_cmd.value.next = next_c;
        field_combo.y.pos_cmd.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.pos_cmd.value.value <= 24'h0;
        end else begin
            if(field_combo.y.pos_cmd.value.load_next) begin
                field_storage.y.pos_cmd.value.value <= field_combo.y.pos_cmd.value.next;
            end
        end
    end
    assign hwif_out.y.pos_cmd.value.value = field_storage.y.pos_cmd.value.value;
    // Field: kung_xy.y.kp.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.kp.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.kp && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.kp.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.y.kp.mant.next = next_c;
        field_combo.y.kp.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.kp.mant.value <= 11'h300;
        end else begin
            if(field_combo.y.kp.mant.load_next) begin
                field_storage.y.kp.mant.value <= field_combo.y.kp.mant.next;
            end
        end
    end
    assign hwif_out.y.kp.mant.value = field_storage.y.kp.mant.value;
    // Field: kung_xy.y.kp.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.kp.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.kp && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.kp.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.y.kp.exp.next = next_c;
        field_combo.y.kp.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.kp.exp.value <= 5'h0;
        end else begin
            if(field_combo.y.kp.exp.load_next) begin
                field_storage.y.kp.exp.value <= field_combo.y.kp.exp.next;
            end
        end
    end
    assign hwif_out.y.kp.exp.value = field_storage.y.kp.exp.value;
    // Field: kung_xy.y.ki.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ki.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ki && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ki.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.y.ki.mant.next = next_c;
        field_combo.y.ki.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ki.mant.value <= 11'h347;
        end else begin
            if(field_combo.y.ki.mant.load_next) begin
                field_storage.y.ki.mant.value <= field_combo.y.ki.mant.next;
            end
        end
    end
    assign hwif_out.y.ki.mant.value = field_storage.y.ki.mant.value;
    // Field: kung_xy.y.ki.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ki.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ki && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ki.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.y.ki.exp.next = next_c;
        field_combo.y.ki.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ki.exp.value <= 5'h19;
        end else begin
            if(field_combo.y.ki.exp.load_next) begin
                field_storage.y.ki.exp.value <= field_combo.y.ki.exp.next;
            end
        end
    end
    assign hwif_out.y.ki.exp.value = field_storage.y.ki.exp.value;
    // Field: kung_xy.y.kv.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.kv.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.kv && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.kv.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.y.kv.mant.next = next_c;
        field_combo.y.kv.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.kv.mant.value <= 11'h75c;
        end else begin
            if(field_combo.y.kv.mant.load_next) begin
                field_storage.y.kv.mant.value <= field_combo.y.kv.mant.next;
            end
        end
    end
    assign hwif_out.y.kv.mant.value = field_storage.y.kv.mant.value;
    // Field: kung_xy.y.kv.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.kv.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.kv && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.kv.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.y.kv.exp.next = next_c;
        field_combo.y.kv.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.kv.exp.value <= 5'h1;
        end else begin
            if(field_combo.y.kv.exp.load_next) begin
                field_storage.y.kv.exp.value <= field_combo.y.kv.exp.next;
            end
        end
    end
    assign hwif_out.y.kv.exp.value = field_storage.y.kv.exp.value;
    // Field: kung_xy.y.eta.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.eta.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.eta && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.eta.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.y.eta.mant.next = next_c;
        field_combo.y.eta.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.eta.mant.value <= 11'h474;
        end else begin
            if(field_combo.y.eta.mant.load_next) begin
                field_storage.y.eta.mant.value <= field_combo.y.eta.mant.next;
            end
        end
    end
    assign hwif_out.y.eta.mant.value = field_storage.y.eta.mant.value;
    // Field: kung_xy.y.eta.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.eta.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.eta && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.eta.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.y.eta.exp.next = next_c;
        field_combo.y.eta.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.eta.exp.value <= 5'h18;
        end else begin
            if(field_combo.y.eta.exp.load_next) begin
                field_storage.y.eta.exp.value <= field_combo.y.eta.exp.next;
            end
        end
    end
    assign hwif_out.y.eta.exp.value = field_storage.y.eta.exp.value;
    // Field: kung_xy.y.shift.e
    always_comb begin
        automatic logic [3:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.shift.e.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.shift && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.shift.e.value & ~decoded_wr_biten[3:0]) | (decoded_wr_data[3:0] & decoded_wr_biten[3:0]);
            load_next_c = '1;
        end
        field_combo.y.shift.e.next = next_c;
        field_combo.y.shift.e.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.shift.e.value <= 4'h0;
        end else begin
            if(field_combo.y.shift.e.load_next) begin
                field_storage.y.shift.e.value <= field_combo.y.shift.e.next;
            end
        end
    end
    assign hwif_out.y.shift.e.value = field_storage.y.shift.e.value;
    // Field: kung_xy.y.shift.de
    always_comb begin
        automatic logic [3:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.shift.de.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.shift && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.shift.de.value & ~decoded_wr_biten[11:8]) | (decoded_wr_data[11:8] & decoded_wr_biten[11:8]);
            load_next_c = '1;
        end
        field_combo.y.shift.de.next = next_c;
        field_combo.y.shift.de.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.shift.de.value <= 4'h2;
        end else begin
            if(field_combo.y.shift.de.load_next) begin
                field_storage.y.shift.de.value <= field_combo.y.shift.de.next;
            end
        end
    end
    assign hwif_out.y.shift.de.value = field_storage.y.shift.de.value;
    // Field: kung_xy.y.a0.value
    always_comb begin
        automatic logic [17:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.a0.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.a0 && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.a0.value.value & ~decoded_wr_biten[17:0]) | (decoded_wr_data[17:0] & decoded_wr_biten[17:0]);
            load_next_c = '1;
        end
        field_combo.y.a0.value.next = next_c;
        field_combo.y.a0.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.a0.value.value <= 18'h3a1b8;
        end else begin
            if(field_combo.y.a0.value.load_next) begin
                field_storage.y.a0.value.value <= field_combo.y.a0.value.next;
            end
        end
    end
    assign hwif_out.y.a0.value.value = field_storage.y.a0.value.value;
    // Field: kung_xy.y.b2.value
    always_comb begin
        automatic logic [23:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.b2.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.b2 && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.b2.value.value & ~decoded_wr_biten[23:0]) | (decoded_wr_data[23:0] & decoded_wr_biten[23:0]);
            load_next_c = '1;
        end
        field_combo.y.b2.value.next = next_c;
        field_combo.y.b2.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.b2.value.value <= 24'h7c378b;
        end else begin
            if(field_combo.y.b2.value.load_next) begin
                field_storage.y.b2.value.value <= field_combo.y.b2.value.next;
            end
        end
    end
    assign hwif_out.y.b2.value.value = field_storage.y.b2.value.value;
    // Field: kung_xy.y.kp_cur.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.kp_cur.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.kp_cur && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.kp_cur.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.y.kp_cur.mant.next = next_c;
        field_combo.y.kp_cur.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.kp_cur.mant.value <= 11'h4fb;
        end else begin
            if(field_combo.y.kp_cur.mant.load_next) begin
                field_storage.y.kp_cur.mant.value <= field_combo.y.kp_cur.mant.next;
            end
        end
    end
    assign hwif_out.y.kp_cur.mant.value = field_storage.y.kp_cur.mant.value;
    // Field: kung_xy.y.kp_cur.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.kp_cur.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.kp_cur && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.kp_cur.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.y.kp_cur.exp.next = next_c;
        field_combo.y.kp_cur.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.kp_cur.exp.value <= 5'h2;
        end else begin
            if(field_combo.y.kp_cur.exp.load_next) begin
                field_storage.y.kp_cur.exp.value <= field_combo.y.kp_cur.exp.next;
            end
        end
    end
    assign hwif_out.y.kp_cur.exp.value = field_storage.y.kp_cur.exp.value;
    // Field: kung_xy.y.ki_cur.mant
    always_comb begin
        automatic logic [10:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ki_cur.mant.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ki_cur && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ki_cur.mant.value & ~decoded_wr_biten[10:0]) | (decoded_wr_data[10:0] & decoded_wr_biten[10:0]);
            load_next_c = '1;
        end
        field_combo.y.ki_cur.mant.next = next_c;
        field_combo.y.ki_cur.mant.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ki_cur.mant.value <= 11'h5c6;
        end else begin
            if(field_combo.y.ki_cur.mant.load_next) begin
                field_storage.y.ki_cur.mant.value <= field_combo.y.ki_cur.mant.next;
            end
        end
    end
    assign hwif_out.y.ki_cur.mant.value = field_storage.y.ki_cur.mant.value;
    // Field: kung_xy.y.ki_cur.exp
    always_comb begin
        automatic logic [4:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.ki_cur.exp.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.ki_cur && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.ki_cur.exp.value & ~decoded_wr_biten[20:16]) | (decoded_wr_data[20:16] & decoded_wr_biten[20:16]);
            load_next_c = '1;
        end
        field_combo.y.ki_cur.exp.next = next_c;
        field_combo.y.ki_cur.exp.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.ki_cur.exp.value <= 5'h1e;
        end else begin
            if(field_combo.y.ki_cur.exp.load_next) begin
                field_storage.y.ki_cur.exp.value <= field_combo.y.ki_cur.exp.next;
            end
        end
    end
    assign hwif_out.y.ki_cur.exp.value = field_storage.y.ki_cur.exp.value;
    // Field: kung_xy.y.theta_ofs.value
    always_comb begin
        automatic logic [31:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.theta_ofs.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.theta_ofs && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.theta_ofs.value.value & ~decoded_wr_biten[31:0]) | (decoded_wr_data[31:0] & decoded_wr_biten[31:0]);
            load_next_c = '1;
        end
        field_combo.y.theta_ofs.value.next = next_c;
        field_combo.y.theta_ofs.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.theta_ofs.value.value <= 32'h0;
        end else begin
            if(field_combo.y.theta_ofs.value.load_next) begin
                field_storage.y.theta_ofs.value.value <= field_combo.y.theta_ofs.value.next;
            end
        end
    end
    assign hwif_out.y.theta_ofs.value.value = field_storage.y.theta_ofs.value.value;
    // Field: kung_xy.y.deadtime.clk
    always_comb begin
        automatic logic [9:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.deadtime.clk.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.deadtime && decoded_req_is_wr && !(hwif_in.y.deadtime.clk.swwel)) begin // SW write
            next_c = (field_storage.y.deadtime.clk.value & ~decoded_wr_biten[9:0]) | (decoded_wr_data[9:0] & decoded_wr_biten[9:0]);
            load_next_c = '1;
        end
        field_combo.y.deadtime.clk.next = next_c;
        field_combo.y.deadtime.clk.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.deadtime.clk.value <= 10'h64;
        end else begin
            if(field_combo.y.deadtime.clk.load_next) begin
                field_storage.y.deadtime.clk.value <= field_combo.y.deadtime.clk.next;
            end
        end
    end
    assign hwif_out.y.deadtime.clk.value = field_storage.y.deadtime.clk.value;
    // Field: kung_xy.y.deadtime.qep_filter
    always_comb begin
        automatic logic [3:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.deadtime.qep_filter.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.deadtime && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.deadtime.qep_filter.value & ~decoded_wr_biten[19:16]) | (decoded_wr_data[19:16] & decoded_wr_biten[19:16]);
            load_next_c = '1;
        end
        field_combo.y.deadtime.qep_filter.next = next_c;
        field_combo.y.deadtime.qep_filter.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.deadtime.qep_filter.value <= 4'h3;
        end else begin
            if(field_combo.y.deadtime.qep_filter.load_next) begin
                field_storage.y.deadtime.qep_filter.value <= field_combo.y.deadtime.qep_filter.next;
            end
        end
    end
    assign hwif_out.y.deadtime.qep_filter.value = field_storage.y.deadtime.qep_filter.value;
    // Field: kung_xy.y.tab_addr.index
    always_comb begin
        automatic logic [5:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.tab_addr.index.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.tab_addr && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.tab_addr.index.value & ~decoded_wr_biten[5:0]) | (decoded_wr_data[5:0] & decoded_wr_biten[5:0]);
            load_next_c = '1;
        end
        field_combo.y.tab_addr.index.next = next_c;
        field_combo.y.tab_addr.index.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.tab_addr.index.value <= 6'h0;
        end else begin
            if(field_combo.y.tab_addr.index.load_next) begin
                field_storage.y.tab_addr.index.value <= field_combo.y.tab_addr.index.next;
            end
        end
    end
    assign hwif_out.y.tab_addr.index.value = field_storage.y.tab_addr.index.value;
    // External register: kung_xy.y.tab_data
    assign hwif_out.y.tab_data.req = decoded_reg_strb.y.tab_data;
    assign hwif_out.y.tab_data.req_is_wr = decoded_req_is_wr;
    assign hwif_out.y.tab_data.wr_data = decoded_wr_data;
    assign hwif_out.y.tab_data.wr_biten = decoded_wr_biten;
    // External register: kung_xy.y.pos_preset

    assign hwif_out.y.pos_preset.req = decoded_req_is_wr ? decoded_reg_strb.y.pos_preset : '0;
    assign hwif_out.y.pos_preset.req_is_wr = decoded_req_is_wr;
    assign hwif_out.y.pos_preset.wr_data = decoded_wr_data;
    assign hwif_out.y.pos_preset.wr_biten = decoded_wr_biten;
    // Field: kung_xy.y.stroke_min.value
    always_comb begin
        automatic logic [23:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.stroke_min.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.stroke_min && decoded_req_is_wr && !(hwif_in.y.stroke_min.value.swwel)) begin // SW write
            next_c = (field_storage.y.stroke_min.value.value & ~decoded_wr_biten[23:0]) | (decoded_wr_data[23:0] & decoded_wr_biten[23:0]);
            load_next_c = '1;
        end
        field_combo.y.stroke_min.value.next = next_c;
        field_combo.y.stroke_min.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.stroke_min.value.value <= 24'h0;
        end else begin
            if(field_combo.y.stroke_min.value.load_next) begin
                field_storage.y.stroke_min.value.value <= field_combo.y.stroke_min.value.next;
            end
        end
    end
    assign hwif_out.y.stroke_min.value.value = field_storage.y.stroke_min.value.value;
    // Field: kung_xy.y.stroke_max.value
    always_comb begin
        automatic logic [23:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.stroke_max.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.stroke_max && decoded_req_is_wr && !(hwif_in.y.stroke_max.value.swwel)) begin // SW write
            next_c = (field_storage.y.stroke_max.value.value & ~decoded_wr_biten[23:0]) | (decoded_wr_data[23:0] & decoded_wr_biten[23:0]);
            load_next_c = '1;
        end
        field_combo.y.stroke_max.value.next = next_c;
        field_combo.y.stroke_max.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.stroke_max.value.value <= 24'h1d4c0;
        end else begin
            if(field_combo.y.stroke_max.value.load_next) begin
                field_storage.y.stroke_max.value.value <= field_combo.y.stroke_max.value.next;
            end
        end
    end
    assign hwif_out.y.stroke_max.value.value = field_storage.y.stroke_max.value.value;
    // Field: kung_xy.y.stroke_en.enable
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.stroke_en.enable.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.stroke_en && decoded_req_is_wr && !(hwif_in.y.stroke_en.enable.swwel)) begin // SW write
            next_c = (field_storage.y.stroke_en.enable.value & ~decoded_wr_biten[0:0]) | (decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
            load_next_c = '1;
        end
        field_combo.y.stroke_en.enable.next = next_c;
        field_combo.y.stroke_en.enable.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.stroke_en.enable.value <= 1'h0;
        end else begin
            if(field_combo.y.stroke_en.enable.load_next) begin
                field_storage.y.stroke_en.enable.value <= field_combo.y.stroke_en.enable.next;
            end
        end
    end
    assign hwif_out.y.stroke_en.enable.value = field_storage.y.stroke_en.enable.value;
    // Field: kung_xy.y.iq_manual.value
    always_comb begin
        automatic logic [11:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.y.iq_manual.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.y.iq_manual && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.y.iq_manual.value.value & ~decoded_wr_biten[11:0]) | (decoded_wr_data[11:0] & decoded_wr_biten[11:0]);
            load_next_c = '1;
        end
        field_combo.y.iq_manual.value.next = next_c;
        field_combo.y.iq_manual.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.y.iq_manual.value.value <= 12'h0;
        end else begin
            if(field_combo.y.iq_manual.value.load_next) begin
                field_storage.y.iq_manual.value.value <= field_combo.y.iq_manual.value.next;
            end
        end
    end
    assign hwif_out.y.iq_manual.value.value = field_storage.y.iq_manual.value.value;
    // Field: kung_xy.commit.take
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.commit.take.value;
        load_next_c = '0;
        if(decoded_reg_strb.commit && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.commit.take.value & ~decoded_wr_biten[0:0]) | (decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
            load_next_c = '1;
        end else begin // singlepulse clears back to 0
            next_c = '0;
            load_next_c = '1;
        end
        field_combo.commit.take.next = next_c;
        field_combo.commit.take.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.commit.take.value <= 1'h0;
        end else begin
            if(field_combo.commit.take.load_next) begin
                field_storage.commit.take.value <= field_combo.commit.take.next;
            end
        end
    end
    assign hwif_out.commit.take.value = field_storage.commit.take.value;
    // Field: kung_xy.irq_en.tick
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.irq_en.tick.value;
        load_next_c = '0;
        if(decoded_reg_strb.irq_en && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.irq_en.tick.value & ~decoded_wr_biten[0:0]) | (decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
            load_next_c = '1;
        end
        field_combo.irq_en.tick.next = next_c;
        field_combo.irq_en.tick.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.irq_en.tick.value <= 1'h0;
        end else begin
            if(field_combo.irq_en.tick.load_next) begin
                field_storage.irq_en.tick.value <= field_combo.irq_en.tick.next;
            end
        end
    end
    assign hwif_out.irq_en.tick.value = field_storage.irq_en.tick.value;
    // Field: kung_xy.irq_en.fault
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.irq_en.fault.value;
        load_next_c = '0;
        if(decoded_reg_strb.irq_en && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.irq_en.fault.value & ~decoded_wr_biten[1:1]) | (decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
            load_next_c = '1;
        end
        field_combo.irq_en.fault.next = next_c;
        field_combo.irq_en.fault.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.irq_en.fault.value <= 1'h0;
        end else begin
            if(field_combo.irq_en.fault.load_next) begin
                field_storage.irq_en.fault.value <= field_combo.irq_en.fault.next;
            end
        end
    end
    assign hwif_out.irq_en.fault.value = field_storage.irq_en.fault.value;
    // Field: kung_xy.irq_stat.tick
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.irq_stat.tick.value;
        load_next_c = '0;
        if(decoded_reg_strb.irq_stat && decoded_req_is_wr) begin // SW write 1 clear
            next_c = field_storage.irq_stat.tick.value & ~(decoded_wr_data[0:0] & decoded_wr_biten[0:0]);
            load_next_c = '1;
        end else if(hwif_in.irq_stat.tick.hwset) begin // HW Set
            next_c = '1;
            load_next_c = '1;
        end
        field_combo.irq_stat.tick.next = next_c;
        field_combo.irq_stat.tick.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.irq_stat.tick.value <= 1'h0;
        end else begin
            if(field_combo.irq_stat.tick.load_next) begin
                field_storage.irq_stat.tick.value <= field_combo.irq_stat.tick.next;
            end
        end
    end
    assign hwif_out.irq_stat.tick.value = field_storage.irq_stat.tick.value;
    // Field: kung_xy.irq_stat.fault
    always_comb begin
        automatic logic [0:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.irq_stat.fault.value;
        load_next_c = '0;
        if(decoded_reg_strb.irq_stat && decoded_req_is_wr) begin // SW write 1 clear
            next_c = field_storage.irq_stat.fault.value & ~(decoded_wr_data[1:1] & decoded_wr_biten[1:1]);
            load_next_c = '1;
        end else if(hwif_in.irq_stat.fault.hwset) begin // HW Set
            next_c = '1;
            load_next_c = '1;
        end
        field_combo.irq_stat.fault.next = next_c;
        field_combo.irq_stat.fault.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.irq_stat.fault.value <= 1'h0;
        end else begin
            if(field_combo.irq_stat.fault.load_next) begin
                field_storage.irq_stat.fault.value <= field_combo.irq_stat.fault.next;
            end
        end
    end
    assign hwif_out.irq_stat.fault.value = field_storage.irq_stat.fault.value;
    // External register: kung_xy.fault_clear

    assign hwif_out.fault_clear.req = decoded_req_is_wr ? decoded_reg_strb.fault_clear : '0;
    assign hwif_out.fault_clear.req_is_wr = decoded_req_is_wr;
    assign hwif_out.fault_clear.wr_data = decoded_wr_data;
    assign hwif_out.fault_clear.wr_biten = decoded_wr_biten;
    // Field: kung_xy.watchdog.limit
    always_comb begin
        automatic logic [15:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.watchdog.limit.value;
        load_next_c = '0;
        if(decoded_reg_strb.watchdog && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.watchdog.limit.value & ~decoded_wr_biten[15:0]) | (decoded_wr_data[15:0] & decoded_wr_biten[15:0]);
            load_next_c = '1;
        end
        field_combo.watchdog.limit.next = next_c;
        field_combo.watchdog.limit.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.watchdog.limit.value <= 16'h0;
        end else begin
            if(field_combo.watchdog.limit.load_next) begin
                field_storage.watchdog.limit.value <= field_combo.watchdog.limit.next;
            end
        end
    end
    assign hwif_out.watchdog.limit.value = field_storage.watchdog.limit.value;
    // External register: kung_xy.lock
    assign hwif_out.lock.req = decoded_reg_strb.lock;
    assign hwif_out.lock.req_is_wr = decoded_req_is_wr;
    assign hwif_out.lock.wr_data = decoded_wr_data;
    assign hwif_out.lock.wr_biten = decoded_wr_biten;
    // Field: kung_xy.current_limit.value
    always_comb begin
        automatic logic [11:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.current_limit.value.value;
        load_next_c = '0;
        if(decoded_reg_strb.current_limit && decoded_req_is_wr && !(hwif_in.current_limit.value.swwel)) begin // SW write
            next_c = (field_storage.current_limit.value.value & ~decoded_wr_biten[11:0]) | (decoded_wr_data[11:0] & decoded_wr_biten[11:0]);
            load_next_c = '1;
        end
        field_combo.current_limit.value.next = next_c;
        field_combo.current_limit.value.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.current_limit.value.value <= 12'h500;
        end else begin
            if(field_combo.current_limit.value.load_next) begin
                field_storage.current_limit.value.value <= field_combo.current_limit.value.next;
            end
        end
    end
    assign hwif_out.current_limit.value.value = field_storage.current_limit.value.value;
    // Field: kung_xy.deadtime_min.clk
    always_comb begin
        automatic logic [9:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.deadtime_min.clk.value;
        load_next_c = '0;
        if(decoded_reg_strb.deadtime_min && decoded_req_is_wr && !(hwif_in.deadtime_min.clk.swwel)) begin // SW write
            next_c = (field_storage.deadtime_min.clk.value & ~decoded_wr_biten[9:0]) | (decoded_wr_data[9:0] & decoded_wr_biten[9:0]);
            load_next_c = '1;
        end
        field_combo.deadtime_min.clk.next = next_c;
        field_combo.deadtime_min.clk.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.deadtime_min.clk.value <= 10'h19;
        end else begin
            if(field_combo.deadtime_min.clk.load_next) begin
                field_storage.deadtime_min.clk.value <= field_combo.deadtime_min.clk.next;
            end
        end
    end
    assign hwif_out.deadtime_min.clk.value = field_storage.deadtime_min.clk.value;
    // Field: kung_xy.irq_period.ticks
    always_comb begin
        automatic logic [7:0] next_c;
        automatic logic load_next_c;
        next_c = field_storage.irq_period.ticks.value;
        load_next_c = '0;
        if(decoded_reg_strb.irq_period && decoded_req_is_wr) begin // SW write
            next_c = (field_storage.irq_period.ticks.value & ~decoded_wr_biten[7:0]) | (decoded_wr_data[7:0] & decoded_wr_biten[7:0]);
            load_next_c = '1;
        end
        field_combo.irq_period.ticks.next = next_c;
        field_combo.irq_period.ticks.load_next = load_next_c;
    end
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            field_storage.irq_period.ticks.value <= 8'h4;
        end else begin
            if(field_combo.irq_period.ticks.load_next) begin
                field_storage.irq_period.ticks.value <= field_combo.irq_period.ticks.next;
            end
        end
    end
    assign hwif_out.irq_period.ticks.value = field_storage.irq_period.ticks.value;

    //--------------------------------------------------------------------------
    // Write response
    //--------------------------------------------------------------------------
    always_comb begin
        automatic logic wr_ack;
        wr_ack = '0;
        wr_ack |= hwif_in.x.tab_data.wr_ack;
        wr_ack |= hwif_in.x.pos_preset.wr_ack;
        wr_ack |= hwif_in.y.tab_data.wr_ack;
        wr_ack |= hwif_in.y.pos_preset.wr_ack;
        wr_ack |= hwif_in.fault_clear.wr_ack;
        wr_ack |= hwif_in.lock.wr_ack;
        external_wr_ack = wr_ack;
    end
    assign cpuif_wr_ack = external_wr_ack | (decoded_req & decoded_req_is_wr & ~decoded_req_is_external);
    // Writes are always granted with no error response
    assign cpuif_wr_err = '0;

    //--------------------------------------------------------------------------
    // Readback
    //--------------------------------------------------------------------------
    logic readback_external_rd_ack_c;
    always_comb begin
        automatic logic rd_ack;
        rd_ack = '0;
        rd_ack |= hwif_in.x.tab_data.rd_ack;
        rd_ack |= hwif_in.y.tab_data.rd_ack;
        rd_ack |= hwif_in.lock.rd_ack;
        readback_external_rd_ack_c = rd_ack;
    end

    logic readback_external_rd_ack;

    assign readback_external_rd_ack = readback_external_rd_ack_c;

    logic [9:0] rd_mux_addr;
    logic [9:0] pending_rd_addr;
    // Hold read mux address to guarantee it is stable throughout any external accesses
    always_ff @(posedge clk_i) begin
        if(rst_i) begin
            pending_rd_addr <= '0;
        end else begin
            if(decoded_req) pending_rd_addr <= decoded_addr;
        end
    end
    assign rd_mux_addr = decoded_req ? decoded_addr : pending_rd_addr;

    logic readback_err;
    logic readback_done;
    logic [31:0] readback_data;
    always_comb begin
        automatic logic [31:0] readback_data_var;
        readback_data_var = '0;
        if(rd_mux_addr == 10'h0) begin
            readback_data_var[0] = field_storage.x.ctrl.enable.value;
            readback_data_var[1] = field_storage.x.ctrl.current_loop.value;
            readback_data_var[2] = field_storage.x.ctrl.position_loop.value;
            readback_data_var[3] = field_storage.x.ctrl.adapt.value;
            readback_data_var[4] = field_storage.x.ctrl.reset_model.value;
            readback_data_var[5] = field_storage.x.ctrl.reset_table.value;
            readback_data_var[6] = field_storage.x.ctrl.interpolate.value;
            readback_data_var[7] = field_storage.x.ctrl.feedforward.value;
        end
        if(rd_mux_addr == 10'h4) begin
            readback_data_var[0] = hwif_in.x.status.busy.next;
            readback_data_var[1] = field_storage.x.status.overrun.value;
            readback_data_var[2] = field_storage.x.status.qep_error.value;
            readback_data_var[3] = field_storage.x.status.saturated.value;
            readback_data_var[4] = field_storage.x.status.limited.value;
            readback_data_var[14:8] = hwif_in.x.status.step.next;
        end
        if(rd_mux_addr == 10'h8) begin
            readback_data_var[23:0] = field_storage.x.pos_cmd.value.value;
        end
        if(rd_mux_addr == 10'hc) begin
            readback_data_var[31:0] = hwif_in.x.pos.value.next;
        end
        if(rd_mux_addr == 10'h10) begin
            readback_data_var[31:0] = hwif_in.x.pos_model.value.next;
        end
        if(rd_mux_addr == 10'h14) begin
            readback_data_var[31:0] = hwif_in.x.err.value.next;
        end
        if(rd_mux_addr == 10'h18) begin
            readback_data_var[31:0] = hwif_in.x.derr.value.next;
        end
        if(rd_mux_addr == 10'h1c) begin
            readback_data_var[31:0] = hwif_in.x.u.value.next;
        end
        if(rd_mux_addr == 10'h20) begin
            readback_data_var[31:0] = hwif_in.x.vstar.value.next;
        end
        if(rd_mux_addr == 10'h24) begin
            readback_data_var[31:0] = hwif_in.x.iq_cmd.value.next;
        end
        if(rd_mux_addr == 10'h28) begin
            readback_data_var[31:0] = hwif_in.x.speed.value.next;
        end
        if(rd_mux_addr == 10'h2c) begin
            readback_data_var[15:0] = hwif_in.x.id_iq.i_d.next;
            readback_data_var[31:16] = hwif_in.x.id_iq.i_q.next;
        end
        if(rd_mux_addr == 10'h30) begin
            readback_data_var[15:0] = hwif_in.x.vd_vq.v_d.next;
            readback_data_var[31:16] = hwif_in.x.vd_vq.v_q.next;
        end
        if(rd_mux_addr == 10'h40) begin
            readback_data_var[10:0] = field_storage.x.kp.mant.value;
            readback_data_var[20:16] = field_storage.x.kp.exp.value;
        end
        if(rd_mux_addr == 10'h44) begin
            readback_data_var[10:0] = field_storage.x.ki.mant.value;
            readback_data_var[20:16] = field_storage.x.ki.exp.value;
        end
        if(rd_mux_addr == 10'h48) begin
            readback_data_var[10:0] = field_storage.x.kv.mant.value;
            readback_data_var[20:16] = field_storage.x.kv.exp.value;
        end
        if(rd_mux_addr == 10'h4c) begin
            readback_data_var[10:0] = field_storage.x.eta.mant.value;
            readback_data_var[20:16] = field_storage.x.eta.exp.value;
        end
        if(rd_mux_addr == 10'h50) begin
            readback_data_var[3:0] = field_storage.x.shift.e.value;
            readback_data_var[11:8] = field_storage.x.shift.de.value;
        end
        if(rd_mux_addr == 10'h54) begin
            readback_data_var[17:0] = field_storage.x.a0.value.value;
        end
        if(rd_mux_addr == 10'h58) begin
            readback_data_var[23:0] = field_storage.x.b2.value.value;
        end
        if(rd_mux_addr == 10'h60) begin
            readback_data_var[10:0] = field_storage.x.kp_cur.mant.value;
            readback_data_var[20:16] = field_storage.x.kp_cur.exp.value;
        end
        if(rd_mux_addr == 10'h64) begin
            readback_data_var[10:0] = field_storage.x.ki_cur.mant.value;
            readback_data_var[20:16] = field_storage.x.ki_cur.exp.value;
        end
        if(rd_mux_addr == 10'h68) begin
            readback_data_var[31:0] = field_storage.x.theta_ofs.value.value;
        end
        if(rd_mux_addr == 10'h6c) begin
            readback_data_var[9:0] = field_storage.x.deadtime.clk.value;
            readback_data_var[19:16] = field_storage.x.deadtime.qep_filter.value;
        end
        if(rd_mux_addr == 10'h70) begin
            readback_data_var[5:0] = field_storage.x.tab_addr.index.value;
        end
        if(rd_mux_addr == 10'h74) begin
            readback_data_var = hwif_in.x.tab_data.rd_data;
        end
        if(rd_mux_addr == 10'h7c) begin
            readback_data_var[31:0] = hwif_in.x.index_latch.value.next;
        end
        if(rd_mux_addr == 10'h80) begin
            readback_data_var[23:0] = field_storage.x.stroke_min.value.value;
        end
        if(rd_mux_addr == 10'h84) begin
            readback_data_var[23:0] = field_storage.x.stroke_max.value.value;
        end
        if(rd_mux_addr == 10'h88) begin
            readback_data_var[0] = field_storage.x.stroke_en.enable.value;
        end
        if(rd_mux_addr == 10'h8c) begin
            readback_data_var[11:0] = field_storage.x.iq_manual.value.value;
        end
        if(rd_mux_addr == 10'h100) begin
            readback_data_var[0] = field_storage.y.ctrl.enable.value;
            readback_data_var[1] = field_storage.y.ctrl.current_loop.value;
            readback_data_var[2] = field_storage.y.ctrl.position_loop.value;
            readback_data_var[3] = field_storage.y.ctrl.adapt.value;
            readback_data_var[4] = field_storage.y.ctrl.reset_model.value;
            readback_data_var[5] = field_storage.y.ctrl.reset_table.value;
            readback_data_var[6] = field_storage.y.ctrl.interpolate.value;
            readback_data_var[7] = field_storage.y.ctrl.feedforward.value;
        end
        if(rd_mux_addr == 10'h104) begin
            readback_data_var[0] = hwif_in.y.status.busy.next;
            readback_data_var[1] = field_storage.y.status.overrun.value;
            readback_data_var[2] = field_storage.y.status.qep_error.value;
            readback_data_var[3] = field_storage.y.status.saturated.value;
            readback_data_var[4] = field_storage.y.status.limited.value;
            readback_data_var[14:8] = hwif_in.y.status.step.next;
        end
        if(rd_mux_addr == 10'h108) begin
            readback_data_var[23:0] = field_storage.y.pos_cmd.value.value;
        end
        if(rd_mux_addr == 10'h10c) begin
            readback_data_var[31:0] = hwif_in.y.pos.value.next;
        end
        if(rd_mux_addr == 10'h110) begin
            readback_data_var[31:0] = hwif_in.y.pos_model.value.next;
        end
        if(rd_mux_addr == 10'h114) begin
            readback_data_var[31:0] = hwif_in.y.err.value.next;
        end
        if(rd_mux_addr == 10'h118) begin
            readback_data_var[31:0] = hwif_in.y.derr.value.next;
        end
        if(rd_mux_addr == 10'h11c) begin
            readback_data_var[31:0] = hwif_in.y.u.value.next;
        end
        if(rd_mux_addr == 10'h120) begin
            readback_data_var[31:0] = hwif_in.y.vstar.value.next;
        end
        if(rd_mux_addr == 10'h124) begin
            readback_data_var[31:0] = hwif_in.y.iq_cmd.value.next;
        end
        if(rd_mux_addr == 10'h128) begin
            readback_data_var[31:0] = hwif_in.y.speed.value.next;
        end
        if(rd_mux_addr == 10'h12c) begin
            readback_data_var[15:0] = hwif_in.y.id_iq.i_d.next;
            readback_data_var[31:16] = hwif_in.y.id_iq.i_q.next;
        end
        if(rd_mux_addr == 10'h130) begin
            readback_data_var[15:0] = hwif_in.y.vd_vq.v_d.next;
            readback_data_var[31:16] = hwif_in.y.vd_vq.v_q.next;
        end
        if(rd_mux_addr == 10'h140) begin
            readback_data_var[10:0] = field_storage.y.kp.mant.value;
            readback_data_var[20:16] = field_storage.y.kp.exp.value;
        end
        if(rd_mux_addr == 10'h144) begin
            readback_data_var[10:0] = field_storage.y.ki.mant.value;
            readback_data_var[20:16] = field_storage.y.ki.exp.value;
        end
        if(rd_mux_addr == 10'h148) begin
            readback_data_var[10:0] = field_storage.y.kv.mant.value;
            readback_data_var[20:16] = field_storage.y.kv.exp.value;
        end
        if(rd_mux_addr == 10'h14c) begin
            readback_data_var[10:0] = field_storage.y.eta.mant.value;
            readback_data_var[20:16] = field_storage.y.eta.exp.value;
        end
        if(rd_mux_addr == 10'h150) begin
            readback_data_var[3:0] = field_storage.y.shift.e.value;
            readback_data_var[11:8] = field_storage.y.shift.de.value;
        end
        if(rd_mux_addr == 10'h154) begin
            readback_data_var[17:0] = field_storage.y.a0.value.value;
        end
        if(rd_mux_addr == 10'h158) begin
            readback_data_var[23:0] = field_storage.y.b2.value.value;
        end
        if(rd_mux_addr == 10'h160) begin
            readback_data_var[10:0] = field_storage.y.kp_cur.mant.value;
            readback_data_var[20:16] = field_storage.y.kp_cur.exp.value;
        end
        if(rd_mux_addr == 10'h164) begin
            readback_data_var[10:0] = field_storage.y.ki_cur.mant.value;
            readback_data_var[20:16] = field_storage.y.ki_cur.exp.value;
        end
        if(rd_mux_addr == 10'h168) begin
            readback_data_var[31:0] = field_storage.y.theta_ofs.value.value;
        end
        if(rd_mux_addr == 10'h16c) begin
            readback_data_var[9:0] = field_storage.y.deadtime.clk.value;
            readback_data_var[19:16] = field_storage.y.deadtime.qep_filter.value;
        end
        if(rd_mux_addr == 10'h170) begin
            readback_data_var[5:0] = field_storage.y.tab_addr.index.value;
        end
        if(rd_mux_addr == 10'h174) begin
            readback_data_var = hwif_in.y.tab_data.rd_data;
        end
        if(rd_mux_addr == 10'h17c) begin
            readback_data_var[31:0] = hwif_in.y.index_latch.value.next;
        end
        if(rd_mux_addr == 10'h180) begin
            readback_data_var[23:0] = field_storage.y.stroke_min.value.value;
        end
        if(rd_mux_addr == 10'h184) begin
            readback_data_var[23:0] = field_storage.y.stroke_max.value.value;
        end
        if(rd_mux_addr == 10'h188) begin
            readback_data_var[0] = field_storage.y.stroke_en.enable.value;
        end
        if(rd_mux_addr == 10'h18c) begin
            readback_data_var[11:0] = field_storage.y.iq_manual.value.value;
        end
        if(rd_mux_addr == 10'h200) begin
            readback_data_var[15:0] = 16'h1;
            readback_data_var[31:16] = 16'h4b58;
        end
        if(rd_mux_addr == 10'h208) begin
            readback_data_var[0] = field_storage.irq_en.tick.value;
            readback_data_var[1] = field_storage.irq_en.fault.value;
        end
        if(rd_mux_addr == 10'h20c) begin
            readback_data_var[0] = field_storage.irq_stat.tick.value;
            readback_data_var[1] = field_storage.irq_stat.fault.value;
        end
        if(rd_mux_addr == 10'h210) begin
            readback_data_var[31:0] = hwif_in.tick.value.next;
        end
        if(rd_mux_addr == 10'h214) begin
            readback_data_var[3:0] = hwif_in.fault.code.next;
            readback_data_var[4] = hwif_in.fault.axis.next;
            readback_data_var[31:8] = hwif_in.fault.tick.next;
        end
        if(rd_mux_addr == 10'h21c) begin
            readback_data_var[15:0] = field_storage.watchdog.limit.value;
        end
        if(rd_mux_addr == 10'h220) begin
            readback_data_var = hwif_in.lock.rd_data;
        end
        if(rd_mux_addr == 10'h224) begin
            readback_data_var[11:0] = field_storage.current_limit.value.value;
        end
        if(rd_mux_addr == 10'h228) begin
            readback_data_var[9:0] = field_storage.deadtime_min.clk.value;
        end
        if(rd_mux_addr == 10'h22c) begin
            readback_data_var[7:0] = field_storage.irq_period.ticks.value;
        end
        readback_data = readback_data_var;
        readback_done = decoded_req & ~decoded_req_is_wr & ~decoded_req_is_external;
        readback_err = '0;
    end

    assign external_rd_ack = readback_external_rd_ack;
    assign cpuif_rd_ack = readback_done | readback_external_rd_ack;
    assign cpuif_rd_data = readback_data;
    assign cpuif_rd_err = readback_err;
endmodule
// verilator lint_on UNUSEDSIGNAL
// verilator lint_on UNUSEDPARAM
