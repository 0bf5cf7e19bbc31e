// SPDX-License-Identifier: Apache-2.0
//
// Sine and cosine of an angle, 1024 steps per revolution, from one quarter-wave table read twice.
// valid_o is high at the 4th clock edge after the one that sees tick_i.
//
//   edge 0     latch the angle
//   edge 1     read |sin|
//   edge 2     sin = +-|sin|, clipped; read |cos| = |sin(angle + 256)|
//   edge 3     cos = +-|cos|, clipped; valid

module sine
  import trammel_pkg::*;
  import sine_pkg::*;
(
  input  logic   clk_i,
  input  logic   rst_i,

  input  logic   tick_i,

  input  angle_t angle_i,

  output logic   valid_o,
  output word_t  sin_o,
  output word_t  cos_o,
  output logic   quiescent_o
);

  typedef enum logic [1:0] {StIdle, StReadSin, StReadCos, StLast} state_e;

  logic [11:0] table_q[SineQuarter];
  initial begin
    for (int i = 0; i < int'(SineQuarter); i++) table_q[i] = SineTable[i];
  end

  state_e state_d, state_q;
  angle_t angle_d, angle_q;
  logic   valid_d, valid_q;
  word_t  sin_d, sin_q;
  word_t  cos_d, cos_q;

  // The angle of the read (next) and of the value just read (current).
  logic [8:0]  read_angle;  // without bit 9, the sign, which the magnitude does not need
  angle_t      value_angle;
  logic        read;
  logic [7:0]  address;
  logic [11:0] magnitude_q;
  logic [11:0] magnitude;
  word_t       value;

  // A falling quarter is read backwards; its first entry, 256, is the crest, not in the table.
  assign address = read_angle[8] ? -read_angle[7:0] : read_angle[7:0];
  assign magnitude = value_angle[8:0] == 9'd256 ? 12'd2048 : magnitude_q;

  // +1.0 does not fit a word and is clipped to 2047; -1.0 fits.
  always_comb begin
    if (value_angle[9]) value = -$signed(magnitude);
    else value = magnitude[11] ? 12'sd2047 : $signed(magnitude);
  end

  always_comb begin
    state_d = state_q;
    angle_d = angle_q;
    valid_d = 1'b0;
    sin_d = sin_q;
    cos_d = cos_q;
    read = 1'b0;
    read_angle = angle_q[8:0];
    value_angle = angle_q;
    unique case (state_q)
      StIdle: begin
        if (tick_i) begin
          angle_d = angle_i;
          state_d = StReadSin;
        end
      end
      StReadSin: begin
        read = 1'b1;
        state_d = StReadCos;
      end
      StReadCos: begin
        sin_d = value;
        read = 1'b1;
        read_angle = angle_q[8:0] + 9'd256;
        state_d = StLast;
      end
      default: begin  // StLast
        value_angle = angle_q + 10'd256;
        cos_d = value;
        valid_d = 1'b1;
        state_d = StIdle;
      end
    endcase
  end

  // The output register of a block memory: no reset, one read enable.
  always_ff @(posedge clk_i) begin
    if (read) magnitude_q <= table_q[address];
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      state_q <= StIdle;
      angle_q <= '0;
      valid_q <= 1'b0;
      sin_q <= '0;
      cos_q <= '0;
    end else begin
      state_q <= state_d;
      angle_q <= angle_d;
      valid_q <= valid_d;
      sin_q <= sin_d;
      cos_q <= cos_d;
    end
  end

  assign valid_o = valid_q;
  assign sin_o = sin_q;
  assign cos_o = cos_q;
  assign quiescent_o = state_q == StIdle && !tick_i && !valid_q;

endmodule
