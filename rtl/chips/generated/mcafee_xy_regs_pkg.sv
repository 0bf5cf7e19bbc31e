// Generated from rtl/chips/mcafee_xy.rdl by scripts/tool gen-register-map; do not edit.
// SPDX-License-Identifier: Apache-2.0
// verilator lint_off UNUSEDSIGNAL
// verilator lint_off UNUSEDPARAM

package mcafee_xy_regs_pkg;

    localparam MCAFEE_XY_REGS_DATA_WIDTH = 32;
    localparam MCAFEE_XY_REGS_MIN_ADDR_WIDTH = 6;
    localparam MCAFEE_XY_REGS_SIZE = 'h24;

    typedef struct packed { logic [7:0] next; } mcafee_xy__port_c__from_part__in_t;
    typedef struct packed { mcafee_xy__port_c__from_part__in_t from_part; } mcafee_xy__port_c__in_t;
    typedef struct packed { logic next; } mcafee_xy__status__busy__in_t;
    typedef struct packed { logic hwset; } mcafee_xy__status__refused__in_t;
    typedef struct packed { logic hwset; } mcafee_xy__status__sample__in_t;
    typedef struct packed { mcafee_xy__status__busy__in_t busy;
        mcafee_xy__status__refused__in_t refused; mcafee_xy__status__sample__in_t sample;
        } mcafee_xy__status__in_t;
    typedef struct packed { logic [7:0] next; } mcafee_xy__feed_out__v__in_t;
    typedef struct packed { logic next; } mcafee_xy__feed_out__ready__in_t;
    typedef struct packed { mcafee_xy__feed_out__v__in_t v; mcafee_xy__feed_out__ready__in_t ready;
        } mcafee_xy__feed_out__in_t;
    typedef struct packed { logic next; } mcafee_xy__irq__x__in_t;
    typedef struct packed { logic next; } mcafee_xy__irq__y__in_t;
    typedef struct packed { mcafee_xy__irq__x__in_t x; mcafee_xy__irq__y__in_t y;
        } mcafee_xy__irq__in_t;
    typedef struct packed { logic next; } mcafee_xy__limits__x_low__in_t;
    typedef struct packed { logic next; } mcafee_xy__limits__x_high__in_t;
    typedef struct packed { logic next; } mcafee_xy__limits__y_low__in_t;
    typedef struct packed { logic next; } mcafee_xy__limits__y_high__in_t;
    typedef struct packed { mcafee_xy__limits__x_low__in_t x_low;
        mcafee_xy__limits__x_high__in_t x_high; mcafee_xy__limits__y_low__in_t y_low;
        mcafee_xy__limits__y_high__in_t y_high; } mcafee_xy__limits__in_t;
    typedef struct packed { mcafee_xy__port_c__in_t port_c; mcafee_xy__status__in_t status;
        mcafee_xy__feed_out__in_t feed_out; mcafee_xy__irq__in_t irq;
        mcafee_xy__limits__in_t limits; } mcafee_xy__in_t;
    typedef struct packed { logic value; } mcafee_xy__port_b__write_strobe__out_t;
    typedef struct packed { logic value; } mcafee_xy__port_b__read_strobe__out_t;
    typedef struct packed { logic value; } mcafee_xy__port_b__ps__out_t;
    typedef struct packed { logic value; } mcafee_xy__port_b__read__out_t;
    typedef struct packed { logic value; } mcafee_xy__port_b__y__out_t;
    typedef struct packed { mcafee_xy__port_b__write_strobe__out_t write_strobe;
        mcafee_xy__port_b__read_strobe__out_t read_strobe; mcafee_xy__port_b__ps__out_t ps;
        mcafee_xy__port_b__read__out_t read; mcafee_xy__port_b__y__out_t y;
        } mcafee_xy__port_b__out_t;
    typedef struct packed { logic [7:0] value; } mcafee_xy__port_c__to_part__out_t;
    typedef struct packed { mcafee_xy__port_c__to_part__out_t to_part; } mcafee_xy__port_c__out_t;
    typedef struct packed { logic value; } mcafee_xy__status__refused__out_t;
    typedef struct packed { logic value; } mcafee_xy__status__sample__out_t;
    typedef struct packed { mcafee_xy__status__refused__out_t refused;
        mcafee_xy__status__sample__out_t sample; } mcafee_xy__status__out_t;
    typedef struct packed { logic [7:0] value; logic swmod; } mcafee_xy__feed_in__c__out_t;
    typedef struct packed { logic [7:0] value; } mcafee_xy__feed_in__cc__out_t;
    typedef struct packed { mcafee_xy__feed_in__c__out_t c; mcafee_xy__feed_in__cc__out_t cc;
        } mcafee_xy__feed_in__out_t;
    typedef struct packed { logic value; } mcafee_xy__reset__strobe__out_t;
    typedef struct packed { mcafee_xy__reset__strobe__out_t strobe; } mcafee_xy__reset__out_t;
    typedef struct packed { mcafee_xy__port_b__out_t port_b; mcafee_xy__port_c__out_t port_c;
        mcafee_xy__status__out_t status; mcafee_xy__feed_in__out_t feed_in;
        mcafee_xy__reset__out_t reset; } mcafee_xy__out_t;
endpackage
// verilator lint_on UNUSEDSIGNAL
// verilator lint_on UNUSEDPARAM
