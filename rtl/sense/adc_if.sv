// SPDX-License-Identifier: Apache-2.0
//
// Frame of two serial converters of the AD7476 type that share chip select and clock.
//
//   clock after start_i  0    2     6         62       64
//                        |    |     |         |        |
//   cs_n                 fall                          rise, valid_o
//   sclk (idles high)         fall1 fall2 ... fall16
//
// The converter samples at the fall of cs_n and shows the first bit of its frame then; each fall of
// sclk brings the next. The 12 bits behind the leading zeros are the code: a converter
// of fewer bits shows zeros behind its own, the further bits of a longer one are left. A bit is
// taken at the edge that lowers sclk, when it has been stable for a whole period of 4 clocks. A
// start during a frame is ignored.

module adc_if (
    input logic clk_i,
    input logic rst_i,

    input logic       start_i,
    input logic [2:0] zeros_i,  // leading zeros of a frame, at most 4; taken with the start

    input logic sdata_a_i,
    input logic sdata_b_i,

    output logic        cs_n_o,
    output logic        sclk_o,
    output logic        busy_o,
    output logic        valid_o,
    output logic [11:0] code_a_o,
    output logic [11:0] code_b_o,
    output logic        quiescent_o
);

  localparam logic [5:0] Last = 6'd63;  // 16 periods of 4 clocks

  logic busy_d, busy_q, sclk_q, valid_q;
  logic [5:0] clock_q;  // clocks since the fall of cs_n
  logic [2:0] zeros_q;
  logic sample, finish;
  logic [11:0] shift_a_q, shift_b_q;  // the leading zeros drop out at the top
  logic [11:0] code_a_q, code_b_q;

  assign sample = busy_q && clock_q[1:0] == 2'd1 && 5'(clock_q[5:2]) < 5'd12 + 5'(zeros_q);
  assign finish = busy_q && clock_q == Last;
  assign busy_d = busy_q ? !finish : start_i;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      busy_q    <= 1'b0;
      sclk_q    <= 1'b1;
      valid_q   <= 1'b0;
      clock_q   <= '0;
      zeros_q   <= '0;
      shift_a_q <= '0;
      shift_b_q <= '0;
      code_a_q  <= '0;
      code_b_q  <= '0;
    end else begin
      busy_q  <= busy_d;
      valid_q <= finish;
      if (start_i && !busy_q) zeros_q <= zeros_i;
      if (busy_q) begin
        clock_q <= clock_q + 6'd1;  // 63 wraps to 0 as the frame ends
        sclk_q  <= clock_q[1:0] == 2'd0 || clock_q[1:0] == 2'd3;
      end
      if (sample) begin
        shift_a_q <= {shift_a_q[10:0], sdata_a_i};
        shift_b_q <= {shift_b_q[10:0], sdata_b_i};
      end
      if (finish) begin
        code_a_q <= shift_a_q;
        code_b_q <= shift_b_q;
      end
    end
  end

  assign cs_n_o      = !busy_q;
  assign sclk_o      = sclk_q;
  assign busy_o      = busy_q;
  assign valid_o     = valid_q;
  assign code_a_o    = code_a_q;
  assign code_b_o    = code_b_q;
  assign quiescent_o = !busy_q && !start_i && !valid_q;

endmodule
