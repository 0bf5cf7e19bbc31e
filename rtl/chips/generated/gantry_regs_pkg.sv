// Generated from rtl/chips/gantry.rdl by scripts/tool gen-regs; do not edit.
// SPDX-License-Identifier: Apache-2.0
// verilator lint_off UNUSEDSIGNAL
// verilator lint_off UNUSEDPARAM

package gantry_regs_pkg;

    localparam GANTRY_REGS_DATA_WIDTH = 32;
    localparam GANTRY_REGS_MIN_ADDR_WIDTH = 7;
    localparam GANTRY_REGS_SIZE = 'h64;

    typedef struct packed {
        logic [31:0] next;
    } gantry__position__value__in_t;

    typedef struct packed {
        gantry__position__value__in_t value;
    } gantry__position__in_t;

    typedef struct packed {
        logic [31:0] next;
    } gantry__velocity__value__in_t;

    typedef struct packed {
        gantry__velocity__value__in_t value;
    } gantry__velocity__in_t;

    typedef struct packed {
        logic [13:0] next;
    } gantry__angle__phase__in_t;

    typedef struct packed {
        logic [1:0] next;
    } gantry__angle__region__in_t;

    typedef struct packed {
        logic next;
    } gantry__angle__known__in_t;

    typedef struct packed {
        gantry__angle__phase__in_t phase;
        gantry__angle__region__in_t region;
        gantry__angle__known__in_t known;
    } gantry__angle__in_t;

    typedef struct packed {
        logic [31:0] next;
    } gantry__ticks__value__in_t;

    typedef struct packed {
        gantry__ticks__value__in_t value;
    } gantry__ticks__in_t;

    typedef struct packed {
        logic [6:0] next;
    } gantry__request__pending__in_t;

    typedef struct packed {
        gantry__request__pending__in_t pending;
    } gantry__request__in_t;

    typedef struct packed {
        logic [9:0] next;
    } gantry__encoder_a__code__in_t;

    typedef struct packed {
        logic [9:0] next;
    } gantry__encoder_a__dot__in_t;

    typedef struct packed {
        gantry__encoder_a__code__in_t code;
        gantry__encoder_a__dot__in_t dot;
    } gantry__encoder_a__in_t;

    typedef struct packed {
        logic [9:0] next;
    } gantry__encoder_b__code__in_t;

    typedef struct packed {
        logic [9:0] next;
    } gantry__encoder_b__dot__in_t;

    typedef struct packed {
        gantry__encoder_b__code__in_t code;
        gantry__encoder_b__dot__in_t dot;
    } gantry__encoder_b__in_t;

    typedef struct packed {
        logic [9:0] next;
    } gantry__current__code__in_t;

    typedef struct packed {
        gantry__current__code__in_t code;
    } gantry__current__in_t;

    typedef struct packed {
        logic next;
    } gantry__overtemp__motor_1__in_t;

    typedef struct packed {
        logic next;
    } gantry__overtemp__motor_2__in_t;

    typedef struct packed {
        gantry__overtemp__motor_1__in_t motor_1;
        gantry__overtemp__motor_2__in_t motor_2;
    } gantry__overtemp__in_t;

    typedef struct packed {
        logic hwset;
    } gantry__status__pass__in_t;

    typedef struct packed {
        logic next;
    } gantry__status__frame__in_t;

    typedef struct packed {
        logic hwset;
    } gantry__status__sample__in_t;

    typedef struct packed {
        logic hwset;
    } gantry__status__overrun__in_t;

    typedef struct packed {
        logic hwset;
    } gantry__status__refused__in_t;

    typedef struct packed {
        logic hwset;
    } gantry__status__stored__in_t;

    typedef struct packed {
        gantry__status__pass__in_t pass;
        gantry__status__frame__in_t frame;
        gantry__status__sample__in_t sample;
        gantry__status__overrun__in_t overrun;
        gantry__status__refused__in_t refused;
        gantry__status__stored__in_t stored;
    } gantry__status__in_t;

    typedef struct packed {
        logic [4:0] next;
    } gantry__receive__channel__in_t;

    typedef struct packed {
        logic [2:0] next;
    } gantry__receive__kind__in_t;

    typedef struct packed {
        logic next;
    } gantry__receive__waits__in_t;

    typedef struct packed {
        gantry__receive__channel__in_t channel;
        gantry__receive__kind__in_t kind;
        gantry__receive__waits__in_t waits;
    } gantry__receive__in_t;

    typedef struct packed {
        logic [31:0] next;
    } gantry__receive_value__value__in_t;

    typedef struct packed {
        gantry__receive_value__value__in_t value;
    } gantry__receive_value__in_t;

    typedef struct packed {
        logic [15:0] next;
    } gantry__receive_errors__malformed__in_t;

    typedef struct packed {
        logic [15:0] next;
    } gantry__receive_errors__lost__in_t;

    typedef struct packed {
        gantry__receive_errors__malformed__in_t malformed;
        gantry__receive_errors__lost__in_t lost;
    } gantry__receive_errors__in_t;

    typedef struct packed {
        logic [5:0] next;
    } gantry__send_state__room__in_t;

    typedef struct packed {
        logic next;
    } gantry__send_state__idle__in_t;

    typedef struct packed {
        logic [15:0] next;
    } gantry__send_state__lost__in_t;

    typedef struct packed {
        gantry__send_state__room__in_t room;
        gantry__send_state__idle__in_t idle;
        gantry__send_state__lost__in_t lost;
    } gantry__send_state__in_t;

    typedef struct packed {
        logic next;
    } gantry__calibration__valid__in_t;

    typedef struct packed {
        logic next;
    } gantry__calibration__busy__in_t;

    typedef struct packed {
        logic [5:0] next;
    } gantry__calibration__count__in_t;

    typedef struct packed {
        gantry__calibration__valid__in_t valid;
        gantry__calibration__busy__in_t busy;
        gantry__calibration__count__in_t count;
    } gantry__calibration__in_t;

    typedef struct packed {
        gantry__position__in_t position;
        gantry__velocity__in_t velocity;
        gantry__angle__in_t angle;
        gantry__ticks__in_t ticks;
        gantry__request__in_t request;
        gantry__encoder_a__in_t encoder_a;
        gantry__encoder_b__in_t encoder_b;
        gantry__current__in_t current;
        gantry__overtemp__in_t overtemp;
        gantry__status__in_t status;
        gantry__receive__in_t receive;
        gantry__receive_value__in_t receive_value;
        gantry__receive_errors__in_t receive_errors;
        gantry__send_state__in_t send_state;
        gantry__calibration__in_t calibration;
    } gantry__in_t;

    typedef struct packed {
        logic value;
        logic swmod;
    } gantry__observer__active__out_t;

    typedef struct packed {
        logic value;
    } gantry__observer__velocity__out_t;

    typedef struct packed {
        gantry__observer__active__out_t active;
        gantry__observer__velocity__out_t velocity;
    } gantry__observer__out_t;

    typedef struct packed {
        logic [7:0] value;
    } gantry__slots__observer__out_t;

    typedef struct packed {
        logic [7:0] value;
    } gantry__slots__requester__out_t;

    typedef struct packed {
        gantry__slots__observer__out_t observer;
        gantry__slots__requester__out_t requester;
    } gantry__slots__out_t;

    typedef struct packed {
        logic value;
    } gantry__request__a__out_t;

    typedef struct packed {
        logic value;
    } gantry__request__a_dot__out_t;

    typedef struct packed {
        logic value;
    } gantry__request__b__out_t;

    typedef struct packed {
        logic value;
    } gantry__request__b_dot__out_t;

    typedef struct packed {
        logic value;
    } gantry__request__current__out_t;

    typedef struct packed {
        gantry__request__a__out_t a;
        gantry__request__a_dot__out_t a_dot;
        gantry__request__b__out_t b;
        gantry__request__b_dot__out_t b_dot;
        gantry__request__current__out_t current;
    } gantry__request__out_t;

    typedef struct packed {
        logic [10:0] value;
    } gantry__force_1__value__out_t;

    typedef struct packed {
        gantry__force_1__value__out_t value;
    } gantry__force_1__out_t;

    typedef struct packed {
        logic [10:0] value;
    } gantry__force_2__value__out_t;

    typedef struct packed {
        gantry__force_2__value__out_t value;
    } gantry__force_2__out_t;

    typedef struct packed {
        logic [23:0] value;
        logic swmod;
    } gantry__pass_period__clocks__out_t;

    typedef struct packed {
        gantry__pass_period__clocks__out_t clocks;
    } gantry__pass_period__out_t;

    typedef struct packed {
        logic value;
    } gantry__status__pass__out_t;

    typedef struct packed {
        logic value;
    } gantry__status__sample__out_t;

    typedef struct packed {
        logic value;
    } gantry__status__overrun__out_t;

    typedef struct packed {
        logic value;
    } gantry__status__refused__out_t;

    typedef struct packed {
        logic value;
    } gantry__status__stored__out_t;

    typedef struct packed {
        gantry__status__pass__out_t pass;
        gantry__status__sample__out_t sample;
        gantry__status__overrun__out_t overrun;
        gantry__status__refused__out_t refused;
        gantry__status__stored__out_t stored;
    } gantry__status__out_t;

    typedef struct packed {
        logic value;
    } gantry__irq_enable__pass__out_t;

    typedef struct packed {
        logic value;
    } gantry__irq_enable__frame__out_t;

    typedef struct packed {
        logic value;
    } gantry__irq_enable__sample__out_t;

    typedef struct packed {
        gantry__irq_enable__pass__out_t pass;
        gantry__irq_enable__frame__out_t frame;
        gantry__irq_enable__sample__out_t sample;
    } gantry__irq_enable__out_t;

    typedef struct packed {
        logic value;
    } gantry__receive__take__out_t;

    typedef struct packed {
        gantry__receive__take__out_t take;
    } gantry__receive__out_t;

    typedef struct packed {
        logic [31:0] value;
    } gantry__send_value__value__out_t;

    typedef struct packed {
        gantry__send_value__value__out_t value;
    } gantry__send_value__out_t;

    typedef struct packed {
        logic [4:0] value;
        logic swmod;
    } gantry__send__channel__out_t;

    typedef struct packed {
        logic [2:0] value;
    } gantry__send__kind__out_t;

    typedef struct packed {
        gantry__send__channel__out_t channel;
        gantry__send__kind__out_t kind;
    } gantry__send__out_t;

    typedef struct packed {
        logic [15:0] value;
        logic swmod;
    } gantry__calibrate__word__out_t;

    typedef struct packed {
        logic [2:0] value;
    } gantry__calibrate__command__out_t;

    typedef struct packed {
        gantry__calibrate__word__out_t word;
        gantry__calibrate__command__out_t command;
    } gantry__calibrate__out_t;

    typedef struct packed {
        gantry__observer__out_t observer;
        gantry__slots__out_t slots;
        gantry__request__out_t request;
        gantry__force_1__out_t force_1;
        gantry__force_2__out_t force_2;
        gantry__pass_period__out_t pass_period;
        gantry__status__out_t status;
        gantry__irq_enable__out_t irq_enable;
        gantry__receive__out_t receive;
        gantry__send_value__out_t send_value;
        gantry__send__out_t send;
        gantry__calibrate__out_t calibrate;
    } gantry__out_t;

endpackage
// verilator lint_on UNUSEDSIGNAL
// verilator lint_on UNUSEDPARAM
