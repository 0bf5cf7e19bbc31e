// Generated from rtl/chips/gantry_tau.rdl by scripts/tool gen-regs; do not edit.
// SPDX-License-Identifier: Apache-2.0
// verilator lint_off UNUSEDSIGNAL
// verilator lint_off UNUSEDPARAM

package gantry_tau_regs_pkg;

    localparam GANTRY_TAU_REGS_DATA_WIDTH = 32;
    localparam GANTRY_TAU_REGS_MIN_ADDR_WIDTH = 7;
    localparam GANTRY_TAU_REGS_SIZE = 'h68;

    typedef struct packed {
        logic [31:0] next;
    } gantry_tau__position__value__in_t;

    typedef struct packed {
        gantry_tau__position__value__in_t value;
    } gantry_tau__position__in_t;

    typedef struct packed {
        logic [31:0] next;
    } gantry_tau__velocity__value__in_t;

    typedef struct packed {
        gantry_tau__velocity__value__in_t value;
    } gantry_tau__velocity__in_t;

    typedef struct packed {
        logic [13:0] next;
    } gantry_tau__angle__phase__in_t;

    typedef struct packed {
        logic [1:0] next;
    } gantry_tau__angle__region__in_t;

    typedef struct packed {
        logic next;
    } gantry_tau__angle__known__in_t;

    typedef struct packed {
        gantry_tau__angle__phase__in_t phase;
        gantry_tau__angle__region__in_t region;
        gantry_tau__angle__known__in_t known;
    } gantry_tau__angle__in_t;

    typedef struct packed {
        logic [31:0] next;
    } gantry_tau__ticks__value__in_t;

    typedef struct packed {
        gantry_tau__ticks__value__in_t value;
    } gantry_tau__ticks__in_t;

    typedef struct packed {
        logic [6:0] next;
    } gantry_tau__request__pending__in_t;

    typedef struct packed {
        gantry_tau__request__pending__in_t pending;
    } gantry_tau__request__in_t;

    typedef struct packed {
        logic [9:0] next;
    } gantry_tau__encoder_a__code__in_t;

    typedef struct packed {
        logic [9:0] next;
    } gantry_tau__encoder_a__dot__in_t;

    typedef struct packed {
        gantry_tau__encoder_a__code__in_t code;
        gantry_tau__encoder_a__dot__in_t dot;
    } gantry_tau__encoder_a__in_t;

    typedef struct packed {
        logic [9:0] next;
    } gantry_tau__encoder_b__code__in_t;

    typedef struct packed {
        logic [9:0] next;
    } gantry_tau__encoder_b__dot__in_t;

    typedef struct packed {
        gantry_tau__encoder_b__code__in_t code;
        gantry_tau__encoder_b__dot__in_t dot;
    } gantry_tau__encoder_b__in_t;

    typedef struct packed {
        logic [9:0] next;
    } gantry_tau__current__code__in_t;

    typedef struct packed {
        gantry_tau__current__code__in_t code;
    } gantry_tau__current__in_t;

    typedef struct packed {
        logic next;
    } gantry_tau__overtemp__motor_1__in_t;

    typedef struct packed {
        logic next;
    } gantry_tau__overtemp__motor_2__in_t;

    typedef struct packed {
        gantry_tau__overtemp__motor_1__in_t motor_1;
        gantry_tau__overtemp__motor_2__in_t motor_2;
    } gantry_tau__overtemp__in_t;

    typedef struct packed {
        logic hwset;
    } gantry_tau__status__pass__in_t;

    typedef struct packed {
        logic next;
    } gantry_tau__status__frame__in_t;

    typedef struct packed {
        logic hwset;
    } gantry_tau__status__sample__in_t;

    typedef struct packed {
        logic hwset;
    } gantry_tau__status__overrun__in_t;

    typedef struct packed {
        logic hwset;
    } gantry_tau__status__refused__in_t;

    typedef struct packed {
        logic hwset;
    } gantry_tau__status__stored__in_t;

    typedef struct packed {
        gantry_tau__status__pass__in_t pass;
        gantry_tau__status__frame__in_t frame;
        gantry_tau__status__sample__in_t sample;
        gantry_tau__status__overrun__in_t overrun;
        gantry_tau__status__refused__in_t refused;
        gantry_tau__status__stored__in_t stored;
    } gantry_tau__status__in_t;

    typedef struct packed {
        logic [4:0] next;
    } gantry_tau__receive__channel__in_t;

    typedef struct packed {
        logic [2:0] next;
    } gantry_tau__receive__kind__in_t;

    typedef struct packed {
        logic next;
    } gantry_tau__receive__waits__in_t;

    typedef struct packed {
        gantry_tau__receive__channel__in_t channel;
        gantry_tau__receive__kind__in_t kind;
        gantry_tau__receive__waits__in_t waits;
    } gantry_tau__receive__in_t;

    typedef struct packed {
        logic [31:0] next;
    } gantry_tau__receive_value__value__in_t;

    typedef struct packed {
        gantry_tau__receive_value__value__in_t value;
    } gantry_tau__receive_value__in_t;

    typedef struct packed {
        logic [15:0] next;
    } gantry_tau__receive_errors__malformed__in_t;

    typedef struct packed {
        logic [15:0] next;
    } gantry_tau__receive_errors__lost__in_t;

    typedef struct packed {
        gantry_tau__receive_errors__malformed__in_t malformed;
        gantry_tau__receive_errors__lost__in_t lost;
    } gantry_tau__receive_errors__in_t;

    typedef struct packed {
        logic [5:0] next;
    } gantry_tau__send_state__room__in_t;

    typedef struct packed {
        logic next;
    } gantry_tau__send_state__idle__in_t;

    typedef struct packed {
        logic [15:0] next;
    } gantry_tau__send_state__lost__in_t;

    typedef struct packed {
        gantry_tau__send_state__room__in_t room;
        gantry_tau__send_state__idle__in_t idle;
        gantry_tau__send_state__lost__in_t lost;
    } gantry_tau__send_state__in_t;

    typedef struct packed {
        logic next;
    } gantry_tau__calibration__valid__in_t;

    typedef struct packed {
        logic next;
    } gantry_tau__calibration__busy__in_t;

    typedef struct packed {
        logic [5:0] next;
    } gantry_tau__calibration__count__in_t;

    typedef struct packed {
        gantry_tau__calibration__valid__in_t valid;
        gantry_tau__calibration__busy__in_t busy;
        gantry_tau__calibration__count__in_t count;
    } gantry_tau__calibration__in_t;

    typedef struct packed {
        gantry_tau__position__in_t position;
        gantry_tau__velocity__in_t velocity;
        gantry_tau__angle__in_t angle;
        gantry_tau__ticks__in_t ticks;
        gantry_tau__request__in_t request;
        gantry_tau__encoder_a__in_t encoder_a;
        gantry_tau__encoder_b__in_t encoder_b;
        gantry_tau__current__in_t current;
        gantry_tau__overtemp__in_t overtemp;
        gantry_tau__status__in_t status;
        gantry_tau__receive__in_t receive;
        gantry_tau__receive_value__in_t receive_value;
        gantry_tau__receive_errors__in_t receive_errors;
        gantry_tau__send_state__in_t send_state;
        gantry_tau__calibration__in_t calibration;
    } gantry_tau__in_t;

    typedef struct packed {
        logic value;
        logic swmod;
    } gantry_tau__observer__active__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__observer__velocity__out_t;

    typedef struct packed {
        gantry_tau__observer__active__out_t active;
        gantry_tau__observer__velocity__out_t velocity;
    } gantry_tau__observer__out_t;

    typedef struct packed {
        logic [7:0] value;
    } gantry_tau__slots__observer__out_t;

    typedef struct packed {
        logic [7:0] value;
    } gantry_tau__slots__requester__out_t;

    typedef struct packed {
        gantry_tau__slots__observer__out_t observer;
        gantry_tau__slots__requester__out_t requester;
    } gantry_tau__slots__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__request__a__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__request__a_dot__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__request__b__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__request__b_dot__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__request__current__out_t;

    typedef struct packed {
        gantry_tau__request__a__out_t a;
        gantry_tau__request__a_dot__out_t a_dot;
        gantry_tau__request__b__out_t b;
        gantry_tau__request__b_dot__out_t b_dot;
        gantry_tau__request__current__out_t current;
    } gantry_tau__request__out_t;

    typedef struct packed {
        logic [10:0] value;
    } gantry_tau__force_1__value__out_t;

    typedef struct packed {
        gantry_tau__force_1__value__out_t value;
    } gantry_tau__force_1__out_t;

    typedef struct packed {
        logic [10:0] value;
    } gantry_tau__force_2__value__out_t;

    typedef struct packed {
        gantry_tau__force_2__value__out_t value;
    } gantry_tau__force_2__out_t;

    typedef struct packed {
        logic [23:0] value;
        logic swmod;
    } gantry_tau__pass_period__clocks__out_t;

    typedef struct packed {
        gantry_tau__pass_period__clocks__out_t clocks;
    } gantry_tau__pass_period__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__status__pass__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__status__sample__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__status__overrun__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__status__refused__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__status__stored__out_t;

    typedef struct packed {
        gantry_tau__status__pass__out_t pass;
        gantry_tau__status__sample__out_t sample;
        gantry_tau__status__overrun__out_t overrun;
        gantry_tau__status__refused__out_t refused;
        gantry_tau__status__stored__out_t stored;
    } gantry_tau__status__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__irq_enable__pass__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__irq_enable__frame__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__irq_enable__sample__out_t;

    typedef struct packed {
        gantry_tau__irq_enable__pass__out_t pass;
        gantry_tau__irq_enable__frame__out_t frame;
        gantry_tau__irq_enable__sample__out_t sample;
    } gantry_tau__irq_enable__out_t;

    typedef struct packed {
        logic value;
    } gantry_tau__receive__take__out_t;

    typedef struct packed {
        gantry_tau__receive__take__out_t take;
    } gantry_tau__receive__out_t;

    typedef struct packed {
        logic [31:0] value;
    } gantry_tau__send_value__value__out_t;

    typedef struct packed {
        gantry_tau__send_value__value__out_t value;
    } gantry_tau__send_value__out_t;

    typedef struct packed {
        logic [4:0] value;
        logic swmod;
    } gantry_tau__send__channel__out_t;

    typedef struct packed {
        logic [2:0] value;
    } gantry_tau__send__kind__out_t;

    typedef struct packed {
        gantry_tau__send__channel__out_t channel;
        gantry_tau__send__kind__out_t kind;
    } gantry_tau__send__out_t;

    typedef struct packed {
        logic [15:0] value;
        logic swmod;
    } gantry_tau__calibrate__word__out_t;

    typedef struct packed {
        logic [2:0] value;
    } gantry_tau__calibrate__command__out_t;

    typedef struct packed {
        gantry_tau__calibrate__word__out_t word;
        gantry_tau__calibrate__command__out_t command;
    } gantry_tau__calibrate__out_t;

    typedef struct packed {
        logic [23:0] value;
    } gantry_tau__receive_gap__clocks__out_t;

    typedef struct packed {
        gantry_tau__receive_gap__clocks__out_t clocks;
    } gantry_tau__receive_gap__out_t;

    typedef struct packed {
        gantry_tau__observer__out_t observer;
        gantry_tau__slots__out_t slots;
        gantry_tau__request__out_t request;
        gantry_tau__force_1__out_t force_1;
        gantry_tau__force_2__out_t force_2;
        gantry_tau__pass_period__out_t pass_period;
        gantry_tau__status__out_t status;
        gantry_tau__irq_enable__out_t irq_enable;
        gantry_tau__receive__out_t receive;
        gantry_tau__send_value__out_t send_value;
        gantry_tau__send__out_t send;
        gantry_tau__calibrate__out_t calibrate;
        gantry_tau__receive_gap__out_t receive_gap;
    } gantry_tau__out_t;

endpackage
// verilator lint_on UNUSEDSIGNAL
// verilator lint_on UNUSEDPARAM
