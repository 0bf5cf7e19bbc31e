// SPDX-License-Identifier: Apache-2.0
//
// Collects the causes of a trip, latches the first and keeps all gates off until it is cleared.
//
//   code  1 external trip, 2 over-current, 3 watchdog, 4 encoder, 5 stroke, 0 none
//
// Causes in the same clock: the lowest code wins, then axis X (0). Codes 1 and 3 belong to no axis
// and report 0. The trip pin passes two flip-flops; trip_o follows 1 clock after them and the gates
// 1 clock later. clear_i acts only while both axes are disabled and no cause is present.

module supervisor (
    input logic clk_i,
    input logic rst_i,

    input logic [31:0] tick_count_i,

    input logic [1:0] enabled_i,
    input logic       clear_i,

    input logic       trip_pin_i,
    input logic [1:0] over_current_i,
    input logic       watchdog_i,
    input logic [1:0] encoder_i,
    input logic [1:0] stroke_i,

    output logic        trip_o,
    output logic [3:0]  fault_code_o,
    output logic        fault_axis_o,
    output logic [31:0] fault_tick_o,
    output logic        quiescent_o
);

  typedef enum logic [3:0] {
    FaultNone        = 4'd0,
    FaultExternal    = 4'd1,
    FaultOverCurrent = 4'd2,
    FaultWatchdog    = 4'd3,
    FaultEncoder     = 4'd4,
    FaultStroke      = 4'd5
  } fault_e;

  logic meta_q, pin_q;
  fault_e cause, code_q;
  logic axis, axis_q;
  logic [31:0] tick_q;
  logic present, trip_q, move;

  always_comb begin
    cause = FaultNone;
    axis  = 1'b0;
    if (pin_q) begin
      cause = FaultExternal;
    end else if (over_current_i != '0) begin
      cause = FaultOverCurrent;
      axis  = !over_current_i[0];
    end else if (watchdog_i) begin
      cause = FaultWatchdog;
    end else if (encoder_i != '0) begin
      cause = FaultEncoder;
      axis  = !encoder_i[0];
    end else if (stroke_i != '0) begin
      cause = FaultStroke;
      axis  = !stroke_i[0];
    end
  end

  // What is latched depends on trip_q alone, so that the comparisons, which come late, lead to
  // an enable only.
  assign present = pin_q || over_current_i != '0 || watchdog_i || encoder_i != '0 || stroke_i != '0;
  assign move    = trip_q ? clear_i && enabled_i == '0 && !present : present;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      meta_q <= 1'b0;
      pin_q  <= 1'b0;
      trip_q <= 1'b0;
      code_q <= FaultNone;
      axis_q <= 1'b0;
      tick_q <= '0;
    end else begin
      meta_q <= trip_pin_i;
      pin_q  <= meta_q;
      if (move) begin
        trip_q <= !trip_q;
        code_q <= trip_q ? FaultNone : cause;
        axis_q <= !trip_q && axis;
        tick_q <= trip_q ? '0 : tick_count_i;
      end
    end
  end

  assign trip_o       = trip_q;
  assign fault_code_o = code_q;
  assign fault_axis_o = axis_q;
  assign fault_tick_o = tick_q;
  assign quiescent_o  = trip_pin_i == meta_q && meta_q == pin_q && !move;

endmodule
