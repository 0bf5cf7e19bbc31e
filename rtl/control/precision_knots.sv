// SPDX-License-Identifier: Apache-2.0
//
// Which ticks of the precision controller are knots (docs/precision.md, section 2): the first 2 kHz
// tick after the first COMMIT since the controller left reset, then every 32nd tick. A knot takes
// the COMMIT that came before it; one without goes on at constant speed, twice in a row, then
// stops. What the tick is shows in its clock (knot_o) and until the next (taken_o: with a COMMIT,
// coast_o, hold_o: without).

module precision_knots (
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,      // one that the law takes
    input logic tick_pos_i,  // it is one of 2 kHz
    input logic commit_i,
    input logic off_i,       // the controller is in reset

    output logic knot_o,
    output logic taken_o,
    output logic coast_o,
    output logic hold_o,
    output logic underrun_o,
    output logic quiescent_o
);

  localparam logic [4:0] LastTick = 5'd31;

  logic active_q, active_d, pending_q, pending_d;
  logic [4:0] tick_q, tick_d;
  logic [1:0] missed_q, missed_d;  // knots in a row without a COMMIT, 2 or more as 2
  logic taken_q, taken_d, coast_q, coast_d, hold_q, hold_d;

  assign knot_o = tick_i && !off_i && (active_q ? tick_q == LastTick : pending_q && tick_pos_i);

  always_comb begin
    active_d  = active_q;
    pending_d = pending_q || commit_i;
    tick_d    = tick_q;
    missed_d  = missed_q;
    {taken_d, coast_d, hold_d} = {taken_q, coast_q, hold_q};
    if (tick_i) begin
      tick_d = knot_o ? '0 : tick_q + 5'd1;
      {taken_d, coast_d, hold_d} = '0;
    end
    if (knot_o) begin
      active_d  = 1'b1;
      pending_d = commit_i;
      taken_d   = pending_q;
      coast_d   = !pending_q && !missed_q[1];
      hold_d    = !pending_q && missed_q[1];
      missed_d  = pending_q ? '0 : missed_q == '0 ? 2'd1 : 2'd2;
    end
    if (off_i) {active_d, pending_d, tick_d, missed_d, taken_d, coast_d, hold_d} = '0;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      {active_q, pending_q, tick_q, missed_q, taken_q, coast_q, hold_q} <= '0;
    end else begin
      {active_q, pending_q, tick_q, missed_q, taken_q, coast_q, hold_q} <=
          {active_d, pending_d, tick_d, missed_d, taken_d, coast_d, hold_d};
    end
  end

  assign taken_o     = taken_q;
  assign coast_o     = coast_q;
  assign hold_o      = hold_q;
  assign underrun_o  = knot_o && !pending_q;
  assign quiescent_o = {active_d, pending_d, tick_d, taken_d, coast_d, hold_d, missed_d} ==
      {active_q, pending_q, tick_q, taken_q, coast_q, hold_q, missed_q};

endmodule
