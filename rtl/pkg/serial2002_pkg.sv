// SPDX-License-Identifier: Apache-2.0
//
// Frames of Serial2002.

package serial2002_pkg;

  localparam logic [2:0] KindClearBit = 3'd0;
  localparam logic [2:0] KindSetBit = 3'd1;
  localparam logic [2:0] KindPollBit = 3'd2;
  localparam logic [2:0] KindPollChannel = 3'd3;
  localparam logic [2:0] KindValue = 3'd4;

  typedef struct packed {
    logic [2:0]  kind;
    logic [4:0]  channel;
    logic [31:0] value;
  } frame_t;

endpackage
