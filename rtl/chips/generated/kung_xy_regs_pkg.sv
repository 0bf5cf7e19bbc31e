// Generated from rtl/chips/kung_xy.rdl by scripts/tool gen-regs; do not edit.
// SPDX-License-Identifier: Apache-2.0
// verilator lint_off UNUSEDSIGNAL
// verilator lint_off UNUSEDPARAM

package kung_xy_regs_pkg;

    localparam KUNG_XY_REGS_DATA_WIDTH = 32;
    localparam KUNG_XY_REGS_MIN_ADDR_WIDTH = 10;
    localparam KUNG_XY_REGS_SIZE = 'h244;

    typedef struct packed {
        logic next;
    } axis_regs__status__busy__in_t;

    typedef struct packed {
        logic hwset;
    } axis_regs__status__overrun__in_t;

    typedef struct packed {
        logic hwset;
    } axis_regs__status__qep_error__in_t;

    typedef struct packed {
        logic hwset;
    } axis_regs__status__saturated__in_t;

    typedef struct packed {
        logic hwset;
    } axis_regs__status__limited__in_t;

    typedef struct packed {
        logic hwset;
    } axis_regs__status__underrun__in_t;

    typedef struct packed {
        logic hwset;
    } axis_regs__status__clipped__in_t;

    typedef struct packed {
        logic [6:0] next;
    } axis_regs__status__step__in_t;

    typedef struct packed {
        axis_regs__status__busy__in_t busy;
        axis_regs__status__overrun__in_t overrun;
        axis_regs__status__qep_error__in_t qep_error;
        axis_regs__status__saturated__in_t saturated;
        axis_regs__status__limited__in_t limited;
        axis_regs__status__underrun__in_t underrun;
        axis_regs__status__clipped__in_t clipped;
        axis_regs__status__step__in_t step;
    } axis_regs__status__in_t;

    typedef struct packed {
        logic [31:0] next;
    } axis_regs__pos__value__in_t;

    typedef struct packed {
        axis_regs__pos__value__in_t value;
    } axis_regs__pos__in_t;

    typedef struct packed {
        logic [31:0] next;
    } axis_regs__pos_model__value__in_t;

    typedef struct packed {
        axis_regs__pos_model__value__in_t value;
    } axis_regs__pos_model__in_t;

    typedef struct packed {
        logic [31:0] next;
    } axis_regs__err__value__in_t;

    typedef struct packed {
        axis_regs__err__value__in_t value;
    } axis_regs__err__in_t;

    typedef struct packed {
        logic [31:0] next;
    } axis_regs__derr__value__in_t;

    typedef struct packed {
        axis_regs__derr__value__in_t value;
    } axis_regs__derr__in_t;

    typedef struct packed {
        logic [31:0] next;
    } axis_regs__u__value__in_t;

    typedef struct packed {
        axis_regs__u__value__in_t value;
    } axis_regs__u__in_t;

    typedef struct packed {
        logic [31:0] next;
    } axis_regs__vstar__value__in_t;

    typedef struct packed {
        axis_regs__vstar__value__in_t value;
    } axis_regs__vstar__in_t;

    typedef struct packed {
        logic [31:0] next;
    } axis_regs__iq_cmd__value__in_t;

    typedef struct packed {
        axis_regs__iq_cmd__value__in_t value;
    } axis_regs__iq_cmd__in_t;

    typedef struct packed {
        logic [31:0] next;
    } axis_regs__speed__value__in_t;

    typedef struct packed {
        axis_regs__speed__value__in_t value;
    } axis_regs__speed__in_t;

    typedef struct packed {
        logic [15:0] next;
    } axis_regs__id_iq__i_d__in_t;

    typedef struct packed {
        logic [15:0] next;
    } axis_regs__id_iq__i_q__in_t;

    typedef struct packed {
        axis_regs__id_iq__i_d__in_t i_d;
        axis_regs__id_iq__i_q__in_t i_q;
    } axis_regs__id_iq__in_t;

    typedef struct packed {
        logic [15:0] next;
    } axis_regs__vd_vq__v_d__in_t;

    typedef struct packed {
        logic [15:0] next;
    } axis_regs__vd_vq__v_q__in_t;

    typedef struct packed {
        axis_regs__vd_vq__v_d__in_t v_d;
        axis_regs__vd_vq__v_q__in_t v_q;
    } axis_regs__vd_vq__in_t;

    typedef struct packed {
        logic swwel;
    } axis_regs__deadtime__clk__in_t;

    typedef struct packed {
        axis_regs__deadtime__clk__in_t clk;
    } axis_regs__deadtime__in_t;

    typedef struct packed {
        logic [31:0] value;
    } axis_regs__tab_data__external__fields__in_t;

    typedef struct packed {
        logic rd_ack;
        axis_regs__tab_data__external__fields__in_t rd_data;
        logic wr_ack;
    } axis_regs__tab_data__external__in_t;

    typedef struct packed {
        logic wr_ack;
    } axis_regs__pos_preset__external__in_t;

    typedef struct packed {
        logic [31:0] next;
    } axis_regs__index_latch__value__in_t;

    typedef struct packed {
        axis_regs__index_latch__value__in_t value;
    } axis_regs__index_latch__in_t;

    typedef struct packed {
        logic swwel;
    } axis_regs__stroke_min__value__in_t;

    typedef struct packed {
        axis_regs__stroke_min__value__in_t value;
    } axis_regs__stroke_min__in_t;

    typedef struct packed {
        logic swwel;
    } axis_regs__stroke_max__value__in_t;

    typedef struct packed {
        axis_regs__stroke_max__value__in_t value;
    } axis_regs__stroke_max__in_t;

    typedef struct packed {
        logic swwel;
    } axis_regs__stroke_en__enable__in_t;

    typedef struct packed {
        axis_regs__stroke_en__enable__in_t enable;
    } axis_regs__stroke_en__in_t;

    typedef struct packed {
        logic [4:0] next;
        logic we;
    } axis_regs__prec_addr__word__in_t;

    typedef struct packed {
        axis_regs__prec_addr__word__in_t word;
    } axis_regs__prec_addr__in_t;

    typedef struct packed {
        logic [31:0] value;
    } axis_regs__prec_data__external__fields__in_t;

    typedef struct packed {
        logic rd_ack;
        axis_regs__prec_data__external__fields__in_t rd_data;
        logic wr_ack;
    } axis_regs__prec_data__external__in_t;

    typedef struct packed {
        logic [31:0] value;
    } axis_regs__prec_err__external__fields__in_t;

    typedef struct packed {
        logic rd_ack;
        axis_regs__prec_err__external__fields__in_t rd_data;
    } axis_regs__prec_err__external__in_t;

    typedef struct packed {
        logic [31:0] value;
    } axis_regs__err_sum__external__fields__in_t;

    typedef struct packed {
        logic rd_ack;
        axis_regs__err_sum__external__fields__in_t rd_data;
    } axis_regs__err_sum__external__in_t;

    typedef struct packed {
        logic [31:0] value;
    } axis_regs__iq_sum__external__fields__in_t;

    typedef struct packed {
        logic rd_ack;
        axis_regs__iq_sum__external__fields__in_t rd_data;
    } axis_regs__iq_sum__external__in_t;

    typedef struct packed {
        logic [31:0] value;
    } axis_regs__prec_dist__external__fields__in_t;

    typedef struct packed {
        logic rd_ack;
        axis_regs__prec_dist__external__fields__in_t rd_data;
    } axis_regs__prec_dist__external__in_t;

    typedef struct packed {
        logic swwel;
    } axis_regs__angle_step__value__in_t;

    typedef struct packed {
        axis_regs__angle_step__value__in_t value;
    } axis_regs__angle_step__in_t;

    typedef struct packed {
        logic swwel;
    } axis_regs__current_offset__a__in_t;

    typedef struct packed {
        logic swwel;
    } axis_regs__current_offset__b__in_t;

    typedef struct packed {
        axis_regs__current_offset__a__in_t a;
        axis_regs__current_offset__b__in_t b;
    } axis_regs__current_offset__in_t;

    typedef struct packed {
        logic [15:0] next;
    } axis_regs__phase_currents__i_a__in_t;

    typedef struct packed {
        logic [15:0] next;
    } axis_regs__phase_currents__i_b__in_t;

    typedef struct packed {
        axis_regs__phase_currents__i_a__in_t i_a;
        axis_regs__phase_currents__i_b__in_t i_b;
    } axis_regs__phase_currents__in_t;

    typedef struct packed {
        logic swwel;
    } axis_regs__adc_frame__zeros__in_t;

    typedef struct packed {
        axis_regs__adc_frame__zeros__in_t zeros;
    } axis_regs__adc_frame__in_t;

    typedef struct packed {
        axis_regs__status__in_t status;
        axis_regs__pos__in_t pos;
        axis_regs__pos_model__in_t pos_model;
        axis_regs__err__in_t err;
        axis_regs__derr__in_t derr;
        axis_regs__u__in_t u;
        axis_regs__vstar__in_t vstar;
        axis_regs__iq_cmd__in_t iq_cmd;
        axis_regs__speed__in_t speed;
        axis_regs__id_iq__in_t id_iq;
        axis_regs__vd_vq__in_t vd_vq;
        axis_regs__deadtime__in_t deadtime;
        axis_regs__tab_data__external__in_t tab_data;
        axis_regs__pos_preset__external__in_t pos_preset;
        axis_regs__index_latch__in_t index_latch;
        axis_regs__stroke_min__in_t stroke_min;
        axis_regs__stroke_max__in_t stroke_max;
        axis_regs__stroke_en__in_t stroke_en;
        axis_regs__prec_addr__in_t prec_addr;
        axis_regs__prec_data__external__in_t prec_data;
        axis_regs__prec_err__external__in_t prec_err;
        axis_regs__err_sum__external__in_t err_sum;
        axis_regs__iq_sum__external__in_t iq_sum;
        axis_regs__prec_dist__external__in_t prec_dist;
        axis_regs__angle_step__in_t angle_step;
        axis_regs__current_offset__in_t current_offset;
        axis_regs__phase_currents__in_t phase_currents;
        axis_regs__adc_frame__in_t adc_frame;
    } axis_regs__in_t;

    typedef struct packed {
        logic hwset;
    } kung_xy__irq_stat__tick__in_t;

    typedef struct packed {
        logic hwset;
    } kung_xy__irq_stat__fault__in_t;

    typedef struct packed {
        kung_xy__irq_stat__tick__in_t tick;
        kung_xy__irq_stat__fault__in_t fault;
    } kung_xy__irq_stat__in_t;

    typedef struct packed {
        logic [31:0] next;
    } kung_xy__tick__value__in_t;

    typedef struct packed {
        kung_xy__tick__value__in_t value;
    } kung_xy__tick__in_t;

    typedef struct packed {
        logic [3:0] next;
    } kung_xy__fault__code__in_t;

    typedef struct packed {
        logic next;
    } kung_xy__fault__axis__in_t;

    typedef struct packed {
        logic [23:0] next;
    } kung_xy__fault__tick__in_t;

    typedef struct packed {
        kung_xy__fault__code__in_t code;
        kung_xy__fault__axis__in_t axis;
        kung_xy__fault__tick__in_t tick;
    } kung_xy__fault__in_t;

    typedef struct packed {
        logic wr_ack;
    } kung_xy__fault_clear__external__in_t;

    typedef struct packed {
        logic swwel;
    } kung_xy__watchdog__limit__in_t;

    typedef struct packed {
        kung_xy__watchdog__limit__in_t limit;
    } kung_xy__watchdog__in_t;

    typedef struct packed {
        logic [31:0] key;
    } kung_xy__lock__external__fields__in_t;

    typedef struct packed {
        logic rd_ack;
        kung_xy__lock__external__fields__in_t rd_data;
        logic wr_ack;
    } kung_xy__lock__external__in_t;

    typedef struct packed {
        logic swwel;
    } kung_xy__current_limit__value__in_t;

    typedef struct packed {
        kung_xy__current_limit__value__in_t value;
    } kung_xy__current_limit__in_t;

    typedef struct packed {
        logic swwel;
    } kung_xy__deadtime_min__clk__in_t;

    typedef struct packed {
        kung_xy__deadtime_min__clk__in_t clk;
    } kung_xy__deadtime_min__in_t;

    typedef struct packed {
        logic [31:0] count;
    } kung_xy__knot__external__fields__in_t;

    typedef struct packed {
        logic rd_ack;
        kung_xy__knot__external__fields__in_t rd_data;
    } kung_xy__knot__external__in_t;

    typedef struct packed {
        logic swwel;
    } kung_xy__rates__carrier__in_t;

    typedef struct packed {
        logic swwel;
    } kung_xy__rates__position__in_t;

    typedef struct packed {
        kung_xy__rates__carrier__in_t carrier;
        kung_xy__rates__position__in_t position;
    } kung_xy__rates__in_t;

    typedef struct packed {
        axis_regs__in_t x;
        axis_regs__in_t y;
        kung_xy__irq_stat__in_t irq_stat;
        kung_xy__tick__in_t tick;
        kung_xy__fault__in_t fault;
        kung_xy__fault_clear__external__in_t fault_clear;
        kung_xy__watchdog__in_t watchdog;
        kung_xy__lock__external__in_t lock;
        kung_xy__current_limit__in_t current_limit;
        kung_xy__deadtime_min__in_t deadtime_min;
        kung_xy__knot__external__in_t knot;
        kung_xy__rates__in_t rates;
    } kung_xy__in_t;

    typedef struct packed {
        logic value;
    } axis_regs__ctrl__enable__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__ctrl__current_loop__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__ctrl__position_loop__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__ctrl__adapt__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__ctrl__reset_model__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__ctrl__reset_table__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__ctrl__interpolate__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__ctrl__feedforward__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__ctrl__precision__out_t;

    typedef struct packed {
        axis_regs__ctrl__enable__out_t enable;
        axis_regs__ctrl__current_loop__out_t current_loop;
        axis_regs__ctrl__position_loop__out_t position_loop;
        axis_regs__ctrl__adapt__out_t adapt;
        axis_regs__ctrl__reset_model__out_t reset_model;
        axis_regs__ctrl__reset_table__out_t reset_table;
        axis_regs__ctrl__interpolate__out_t interpolate;
        axis_regs__ctrl__feedforward__out_t feedforward;
        axis_regs__ctrl__precision__out_t precision;
    } axis_regs__ctrl__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__status__overrun__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__status__qep_error__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__status__saturated__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__status__limited__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__status__underrun__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__status__clipped__out_t;

    typedef struct packed {
        axis_regs__status__overrun__out_t overrun;
        axis_regs__status__qep_error__out_t qep_error;
        axis_regs__status__saturated__out_t saturated;
        axis_regs__status__limited__out_t limited;
        axis_regs__status__underrun__out_t underrun;
        axis_regs__status__clipped__out_t clipped;
    } axis_regs__status__out_t;

    typedef struct packed {
        logic [23:0] value;
    } axis_regs__pos_cmd__value__out_t;

    typedef struct packed {
        axis_regs__pos_cmd__value__out_t value;
    } axis_regs__pos_cmd__out_t;

    typedef struct packed {
        logic [10:0] value;
    } axis_regs__kp__mant__out_t;

    typedef struct packed {
        logic [4:0] value;
    } axis_regs__kp__exp__out_t;

    typedef struct packed {
        axis_regs__kp__mant__out_t mant;
        axis_regs__kp__exp__out_t exp;
    } axis_regs__kp__out_t;

    typedef struct packed {
        logic [10:0] value;
    } axis_regs__ki__mant__out_t;

    typedef struct packed {
        logic [4:0] value;
    } axis_regs__ki__exp__out_t;

    typedef struct packed {
        axis_regs__ki__mant__out_t mant;
        axis_regs__ki__exp__out_t exp;
    } axis_regs__ki__out_t;

    typedef struct packed {
        logic [10:0] value;
    } axis_regs__kv__mant__out_t;

    typedef struct packed {
        logic [4:0] value;
    } axis_regs__kv__exp__out_t;

    typedef struct packed {
        axis_regs__kv__mant__out_t mant;
        axis_regs__kv__exp__out_t exp;
    } axis_regs__kv__out_t;

    typedef struct packed {
        logic [10:0] value;
    } axis_regs__eta__mant__out_t;

    typedef struct packed {
        logic [4:0] value;
    } axis_regs__eta__exp__out_t;

    typedef struct packed {
        axis_regs__eta__mant__out_t mant;
        axis_regs__eta__exp__out_t exp;
    } axis_regs__eta__out_t;

    typedef struct packed {
        logic [4:0] value;
    } axis_regs__shift__e__out_t;

    typedef struct packed {
        logic [4:0] value;
    } axis_regs__shift__de__out_t;

    typedef struct packed {
        axis_regs__shift__e__out_t e;
        axis_regs__shift__de__out_t de;
    } axis_regs__shift__out_t;

    typedef struct packed {
        logic [17:0] value;
    } axis_regs__a0__value__out_t;

    typedef struct packed {
        logic [1:0] value;
    } axis_regs__a0__scale__out_t;

    typedef struct packed {
        axis_regs__a0__value__out_t value;
        axis_regs__a0__scale__out_t scale;
    } axis_regs__a0__out_t;

    typedef struct packed {
        logic [23:0] value;
    } axis_regs__b2__value__out_t;

    typedef struct packed {
        axis_regs__b2__value__out_t value;
    } axis_regs__b2__out_t;

    typedef struct packed {
        logic [10:0] value;
    } axis_regs__kp_cur__mant__out_t;

    typedef struct packed {
        logic [4:0] value;
    } axis_regs__kp_cur__exp__out_t;

    typedef struct packed {
        axis_regs__kp_cur__mant__out_t mant;
        axis_regs__kp_cur__exp__out_t exp;
    } axis_regs__kp_cur__out_t;

    typedef struct packed {
        logic [10:0] value;
    } axis_regs__ki_cur__mant__out_t;

    typedef struct packed {
        logic [4:0] value;
    } axis_regs__ki_cur__exp__out_t;

    typedef struct packed {
        axis_regs__ki_cur__mant__out_t mant;
        axis_regs__ki_cur__exp__out_t exp;
    } axis_regs__ki_cur__out_t;

    typedef struct packed {
        logic [31:0] value;
    } axis_regs__theta_ofs__value__out_t;

    typedef struct packed {
        axis_regs__theta_ofs__value__out_t value;
    } axis_regs__theta_ofs__out_t;

    typedef struct packed {
        logic [9:0] value;
    } axis_regs__deadtime__clk__out_t;

    typedef struct packed {
        logic [3:0] value;
    } axis_regs__deadtime__qep_filter__out_t;

    typedef struct packed {
        axis_regs__deadtime__clk__out_t clk;
        axis_regs__deadtime__qep_filter__out_t qep_filter;
    } axis_regs__deadtime__out_t;

    typedef struct packed {
        logic [5:0] value;
    } axis_regs__tab_addr__index__out_t;

    typedef struct packed {
        axis_regs__tab_addr__index__out_t index;
    } axis_regs__tab_addr__out_t;

    typedef struct packed {
        logic [31:0] value;
    } axis_regs__tab_data__external__fields__out_t;

    typedef struct packed {
        logic req;
        logic req_is_wr;
        axis_regs__tab_data__external__fields__out_t wr_data;
        axis_regs__tab_data__external__fields__out_t wr_biten;
    } axis_regs__tab_data__external__out_t;

    typedef struct packed {
        logic [7:0] _reserved_31_24;
        logic [23:0] value;
    } axis_regs__pos_preset__external__fields__out_t;

    typedef struct packed {
        logic req;
        logic req_is_wr;
        axis_regs__pos_preset__external__fields__out_t wr_data;
        axis_regs__pos_preset__external__fields__out_t wr_biten;
    } axis_regs__pos_preset__external__out_t;

    typedef struct packed {
        logic [23:0] value;
    } axis_regs__stroke_min__value__out_t;

    typedef struct packed {
        axis_regs__stroke_min__value__out_t value;
    } axis_regs__stroke_min__out_t;

    typedef struct packed {
        logic [23:0] value;
    } axis_regs__stroke_max__value__out_t;

    typedef struct packed {
        axis_regs__stroke_max__value__out_t value;
    } axis_regs__stroke_max__out_t;

    typedef struct packed {
        logic value;
    } axis_regs__stroke_en__enable__out_t;

    typedef struct packed {
        axis_regs__stroke_en__enable__out_t enable;
    } axis_regs__stroke_en__out_t;

    typedef struct packed {
        logic [11:0] value;
    } axis_regs__iq_manual__value__out_t;

    typedef struct packed {
        axis_regs__iq_manual__value__out_t value;
    } axis_regs__iq_manual__out_t;

    typedef struct packed {
        logic [4:0] value;
    } axis_regs__prec_addr__word__out_t;

    typedef struct packed {
        axis_regs__prec_addr__word__out_t word;
    } axis_regs__prec_addr__out_t;

    typedef struct packed {
        logic [31:0] value;
    } axis_regs__prec_data__external__fields__out_t;

    typedef struct packed {
        logic req;
        logic req_is_wr;
        axis_regs__prec_data__external__fields__out_t wr_data;
        axis_regs__prec_data__external__fields__out_t wr_biten;
    } axis_regs__prec_data__external__out_t;

    typedef struct packed {
        logic req;
        logic req_is_wr;
    } axis_regs__prec_err__external__out_t;

    typedef struct packed {
        logic req;
        logic req_is_wr;
    } axis_regs__err_sum__external__out_t;

    typedef struct packed {
        logic req;
        logic req_is_wr;
    } axis_regs__iq_sum__external__out_t;

    typedef struct packed {
        logic req;
        logic req_is_wr;
    } axis_regs__prec_dist__external__out_t;

    typedef struct packed {
        logic [31:0] value;
    } axis_regs__angle_step__value__out_t;

    typedef struct packed {
        axis_regs__angle_step__value__out_t value;
    } axis_regs__angle_step__out_t;

    typedef struct packed {
        logic [11:0] value;
    } axis_regs__current_offset__a__out_t;

    typedef struct packed {
        logic [11:0] value;
    } axis_regs__current_offset__b__out_t;

    typedef struct packed {
        axis_regs__current_offset__a__out_t a;
        axis_regs__current_offset__b__out_t b;
    } axis_regs__current_offset__out_t;

    typedef struct packed {
        logic [2:0] value;
    } axis_regs__adc_frame__zeros__out_t;

    typedef struct packed {
        axis_regs__adc_frame__zeros__out_t zeros;
    } axis_regs__adc_frame__out_t;

    typedef struct packed {
        axis_regs__ctrl__out_t ctrl;
        axis_regs__status__out_t status;
        axis_regs__pos_cmd__out_t pos_cmd;
        axis_regs__kp__out_t kp;
        axis_regs__ki__out_t ki;
        axis_regs__kv__out_t kv;
        axis_regs__eta__out_t eta;
        axis_regs__shift__out_t shift;
        axis_regs__a0__out_t a0;
        axis_regs__b2__out_t b2;
        axis_regs__kp_cur__out_t kp_cur;
        axis_regs__ki_cur__out_t ki_cur;
        axis_regs__theta_ofs__out_t theta_ofs;
        axis_regs__deadtime__out_t deadtime;
        axis_regs__tab_addr__out_t tab_addr;
        axis_regs__tab_data__external__out_t tab_data;
        axis_regs__pos_preset__external__out_t pos_preset;
        axis_regs__stroke_min__out_t stroke_min;
        axis_regs__stroke_max__out_t stroke_max;
        axis_regs__stroke_en__out_t stroke_en;
        axis_regs__iq_manual__out_t iq_manual;
        axis_regs__prec_addr__out_t prec_addr;
        axis_regs__prec_data__external__out_t prec_data;
        axis_regs__prec_err__external__out_t prec_err;
        axis_regs__err_sum__external__out_t err_sum;
        axis_regs__iq_sum__external__out_t iq_sum;
        axis_regs__prec_dist__external__out_t prec_dist;
        axis_regs__angle_step__out_t angle_step;
        axis_regs__current_offset__out_t current_offset;
        axis_regs__adc_frame__out_t adc_frame;
    } axis_regs__out_t;

    typedef struct packed {
        logic value;
    } kung_xy__commit__take__out_t;

    typedef struct packed {
        kung_xy__commit__take__out_t take;
    } kung_xy__commit__out_t;

    typedef struct packed {
        logic value;
    } kung_xy__irq_en__tick__out_t;

    typedef struct packed {
        logic value;
    } kung_xy__irq_en__fault__out_t;

    typedef struct packed {
        kung_xy__irq_en__tick__out_t tick;
        kung_xy__irq_en__fault__out_t fault;
    } kung_xy__irq_en__out_t;

    typedef struct packed {
        logic value;
    } kung_xy__irq_stat__tick__out_t;

    typedef struct packed {
        logic value;
    } kung_xy__irq_stat__fault__out_t;

    typedef struct packed {
        kung_xy__irq_stat__tick__out_t tick;
        kung_xy__irq_stat__fault__out_t fault;
    } kung_xy__irq_stat__out_t;

    typedef struct packed {
        logic [31:0] key;
    } kung_xy__fault_clear__external__fields__out_t;

    typedef struct packed {
        logic req;
        logic req_is_wr;
        kung_xy__fault_clear__external__fields__out_t wr_data;
        kung_xy__fault_clear__external__fields__out_t wr_biten;
    } kung_xy__fault_clear__external__out_t;

    typedef struct packed {
        logic [15:0] value;
    } kung_xy__watchdog__limit__out_t;

    typedef struct packed {
        kung_xy__watchdog__limit__out_t limit;
    } kung_xy__watchdog__out_t;

    typedef struct packed {
        logic [31:0] key;
    } kung_xy__lock__external__fields__out_t;

    typedef struct packed {
        logic req;
        logic req_is_wr;
        kung_xy__lock__external__fields__out_t wr_data;
        kung_xy__lock__external__fields__out_t wr_biten;
    } kung_xy__lock__external__out_t;

    typedef struct packed {
        logic [11:0] value;
    } kung_xy__current_limit__value__out_t;

    typedef struct packed {
        kung_xy__current_limit__value__out_t value;
    } kung_xy__current_limit__out_t;

    typedef struct packed {
        logic [9:0] value;
    } kung_xy__deadtime_min__clk__out_t;

    typedef struct packed {
        kung_xy__deadtime_min__clk__out_t clk;
    } kung_xy__deadtime_min__out_t;

    typedef struct packed {
        logic [7:0] value;
    } kung_xy__irq_period__ticks__out_t;

    typedef struct packed {
        kung_xy__irq_period__ticks__out_t ticks;
    } kung_xy__irq_period__out_t;

    typedef struct packed {
        logic req;
        logic req_is_wr;
    } kung_xy__knot__external__out_t;

    typedef struct packed {
        logic [1:0] value;
    } kung_xy__rates__carrier__out_t;

    typedef struct packed {
        logic [1:0] value;
    } kung_xy__rates__position__out_t;

    typedef struct packed {
        kung_xy__rates__carrier__out_t carrier;
        kung_xy__rates__position__out_t position;
    } kung_xy__rates__out_t;

    typedef struct packed {
        axis_regs__out_t x;
        axis_regs__out_t y;
        kung_xy__commit__out_t commit;
        kung_xy__irq_en__out_t irq_en;
        kung_xy__irq_stat__out_t irq_stat;
        kung_xy__fault_clear__external__out_t fault_clear;
        kung_xy__watchdog__out_t watchdog;
        kung_xy__lock__external__out_t lock;
        kung_xy__current_limit__out_t current_limit;
        kung_xy__deadtime_min__out_t deadtime_min;
        kung_xy__irq_period__out_t irq_period;
        kung_xy__knot__external__out_t knot;
        kung_xy__rates__out_t rates;
    } kung_xy__out_t;

    typedef enum logic [2:0] {
        fault_code__none = 'h0,
        fault_code__external_trip = 'h1,
        fault_code__over_current = 'h2,
        fault_code__watchdog = 'h3,
        fault_code__encoder = 'h4,
        fault_code__stroke = 'h5
    } fault_code_e;

    localparam logic [31:0] KeyLock = 32'h4C4F434B;
    localparam logic [31:0] KeyUnlock = 32'h554E4C4B;
    localparam logic [31:0] KeyFaultClear = 32'h434C5246;
endpackage
// verilator lint_on UNUSEDSIGNAL
// verilator lint_on UNUSEDPARAM
