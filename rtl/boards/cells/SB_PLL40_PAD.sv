// SPDX-License-Identifier: Apache-2.0
//
// The PLL of an iCE40 fed by a pin, as the sources name it: a black box whose insides are the
// FPGA's.

(* blackbox *)
module SB_PLL40_PAD #(
    parameter FEEDBACK_PATH = "SIMPLE",
    parameter DIVR = 4'd0,
    parameter DIVF = 7'd0,
    parameter DIVQ = 3'd0,
    parameter FILTER_RANGE = 3'd0
) (
    input PACKAGEPIN,
    input RESETB,
    input BYPASS,
    output PLLOUTGLOBAL,
    output LOCK
);
endmodule
