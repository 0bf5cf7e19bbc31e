// SPDX-License-Identifier: Apache-2.0
//
// Registers, commands and the sample of the LM628 (data sheet SNVS781C, AN-693): a machine of one
// accumulator, one adder and 64 registers of 64 bits in block memory. Its program is
// lm628_engine.asm; products and quotients are formed bit by bit.
//
//   sample_i  encoder and index taken; the result is there at most 400 clocks later
//   start_i   the command opcode_i is executed in at most 127 clocks
//
// After a reset the registers are cleared, 133 clocks. A caller requests nothing while busy_o.

module lm628_engine
  import lm628_pkg::*;
  import lm628_code_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic sample_i,
    input logic start_i,
    input logic commit_i,  // the sample's events are taken
    input logic end_i,     // the command's events are taken

    input logic       wrap_i,      // products and sum wrap; else they saturate
    input logic [7:0] opcode_i,
    input events_t    status_i,    // what RDSIGS shows of the host port
    input logic       host_irq_i,
    input logic       arm_i,       // capture the next index

    input  logic        [15:0] word_i,        // word of the command at word_addr_o
    output logic        [ 2:0] word_addr_o,
    input  logic        [23:0] count_i,
    input  logic               index_seen_i,
    input  logic        [23:0] index_count_i,
    output logic        [31:0] reply_o,
    output events_t            sample_events_o,
    output logic               sample_off_o,
    output events_t            command_events_o,
    output logic               command_off_o,
    output logic signed [15:0] u_o,
    output logic               eight_bits_o,
    output logic               busy_o,
    output logic               quiescent_o
);

  localparam int unsigned CodeBits = $clog2(CodeSize);
  typedef logic [CodeBits-1:0] address_t;

  // ---- program ----

  typedef logic [5:0] register_t;

  typedef struct packed {
    logic write;  // to the accumulator
    logic zero;   // first operand: 0 instead of the accumulator,
    logic shift;  // twice the accumulator
    logic div;    // plus the dividend's bit; the difference only where it is not negative
    logic mul;    // second operand: the word where the multiplier's bit is 1,
    logic alone;  // none
    logic sub;    // it is subtracted
    logic shr8;   // instead of the sum: the accumulator / 256,
    logic ext;    // extended,
    logic in;     // an input word
  } controls_t;

  function automatic controls_t controls(logic branch, op_e op);
    controls_t c;
    c.write = !branch && (op[4] || op[3]);
    c.zero  = op inside {OpLd, OpToq, OpToq15};
    c.shift = op inside {OpMul, OpDiv, OpShl};
    c.div   = op == OpDiv;
    c.mul   = op == OpMul;
    c.alone = op inside {OpShl, OpToq, OpToq15};
    c.sub   = op inside {OpSub, OpDiv};
    c.shr8  = op == OpShr8;
    c.ext   = op == OpExt;
    c.in    = op == OpIn;
    return c;
  endfunction

  // Stored with an instruction: the register of the next one, which is read while that is fetched,
  // and the adder's controls; in a branch or call the register of its target in their place. The
  // memory has all 2^CodeBits words, so that memory blocks of 4 bits hold it without a multiplexer.
  localparam int unsigned Bits = $bits(register_t) + $bits(controls_t) + 18;
  logic [Bits-1:0] code_q[2**CodeBits];
  initial begin
    for (int unsigned i = 0; i < CodeSize; i++) begin
      code_q[i] = {
        register_t'(Code[(i+1)%CodeSize]),
        Code[i][17] || op_e'(Code[i][16:12]) == OpCall ?
            controls_t'(register_t'(Code[address_t'(Code[i])])) :
            controls(Code[i][17], op_e'(Code[i][16:12])),
        Code[i]
      };
    end
  end

  logic [17:0] instr_q;
  controls_t c_q;
  register_t after_q, return_after_q, read;
  logic boot_q, busy_q, fetch;
  address_t pc_q, pc_d, return_q;
  logic [5:0] loop_q;
  op_e op;
  logic runs, jump, branches, taken, loops, looping;

  assign branches = instr_q[17];
  assign op       = op_e'(instr_q[16:12]);
  assign runs     = busy_q && !branches;
  assign jump     = branches && taken == instr_q[16];
  assign loops    = op[4];
  assign looping  = runs && loops && loop_q != instr_q[11:6];

  logic halts;
  assign halts = runs && op == OpHalt;

  always_comb begin
    pc_d = pc_q + 1'b1;
    read = after_q;
    if (!busy_q) begin
      if (boot_q) pc_d = '0;
      else if (sample_i) pc_d = address_t'(CodeSample);
      else pc_d = address_t'(opcode_i);
    end else if (jump || (!branches && op == OpCall)) begin
      pc_d = instr_q[CodeBits-1:0];
      read = register_t'(c_q);
    end else if (!branches && op == OpRet) begin
      pc_d = return_q;
      read = return_after_q;
    end
  end

  assign fetch = busy_q ? !looping && !halts : boot_q || sample_i || start_i;

  always_ff @(posedge clk_i) begin
    if (fetch) {after_q, c_q, instr_q} <= code_q[pc_d];
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      boot_q         <= 1'b1;
      busy_q         <= 1'b0;
      pc_q           <= '0;
      return_q       <= '0;
      return_after_q <= '0;
      loop_q         <= '0;
    end else begin
      boot_q <= 1'b0;
      busy_q <= fetch || looping;
      if (fetch) pc_q <= pc_d;
      if (runs && op == OpCall) {return_q, return_after_q} <= {pc_q + 1'b1, after_q};
      if (busy_q) loop_q <= looping ? loop_q + 6'd1 : '0;
    end
  end

  // ---- registers: none is used that was read as it was written, gen_lm628.py checks that ----

  (* no_rw_check *)
  lm628_t m_q[64];
  lm628_t operand_q, acc_q, acc_d, a, b, shifted, sum, extended;
  logic unused_carry;
  logic [29:0] q_q, q_d;
  logic writes, acc_en, q_en, to_q;

  assign writes = runs && op == OpSt;
  assign to_q   = op == OpToq || op == OpToq15;

  always_ff @(posedge clk_i) begin
    if (writes) m_q[instr_q[5:0]] <= acc_q;
    if (fetch) operand_q <= m_q[read];
  end

  // ---- input words ----

  logic [23:0] outside, count_q, index_q;
  logic [15:0] signals;
  logic [Flags-1:0] flag_q, flag_d;

  assign signals = {host_irq_i, flag_q[14:7], status_i, flag_q[FlagIndexArmed]};

  always_comb begin
    unique case (source_e'(instr_q[11:9]))
      FromWord:    outside = {8'd0, word_i};
      FromCount:   outside = count_q;
      FromIndex:   outside = index_q;
      FromSignals: outside = {8'd0, signals};
      default:     outside = {15'd0, instr_q[8:0]};
    endcase
  end

  // ---- accumulator ----

  always_comb begin
    shifted = {acc_q[62:0], c_q.div && q_q[29]};
    a = acc_q;
    if (c_q.zero) a = '0;
    if (c_q.shift) a = shifted;
    b = operand_q;
    if (c_q.alone || (c_q.mul && !q_q[29])) b = '0;
    if (c_q.sub) b = ~b;
    {sum, unused_carry} = {a, 1'b1} + {b, c_q.sub};
  end

  always_comb begin
    extended = '0;
    unique case (ext_e'(instr_q[2:0]))
      ExtZ15:  extended = {49'd0, acc_q[14:0]};
      ExtS16:  extended = {{48{acc_q[15]}}, acc_q[15:0]};
      ExtS24:  extended = {{40{acc_q[23]}}, acc_q[23:0]};
      ExtZ30:  extended = {34'd0, acc_q[29:0]};
      ExtS31:  extended = {{33{acc_q[30]}}, acc_q[30:0]};
      ExtS32:  extended = {{32{acc_q[31]}}, acc_q[31:0]};
      default: extended = {{16{acc_q[47]}}, acc_q[47:0]};
    endcase
  end

  always_comb begin
    acc_d = sum;
    if (c_q.div && sum[32]) acc_d = shifted;  // remainder and divisor have 31 bits: negative
    if (c_q.shr8) acc_d = {{8{acc_q[63]}}, acc_q[63:8]};
    if (c_q.ext) acc_d = extended;
    if (c_q.in) acc_d = {40'd0, outside};
    acc_en = busy_q && c_q.write;
    q_d = {q_q[28:0], c_q.mul ? q_q[29] : !sum[32]};
    if (op == OpToq) q_d = acc_q[29:0];
    if (op == OpToq15) q_d = {acc_q[14:0], 15'd0};
    q_en = runs && (to_q || op == OpMul || op == OpDiv);
  end

  always_ff @(posedge clk_i) begin
    if (acc_en) acc_q <= acc_d;
    if (q_en) q_q <= q_d;
  end

  // ---- conditions and flags ----

  logic captured_q, capturing_q, take_q;
  logic [5:0] cond;
  logic [31:0] flags;
  logic [15:0] low_bits;

  assign cond  = instr_q[15:10];
  assign flags = 32'(flag_q);
  assign low_bits = acc_q[15:0];

  always_comb begin
    taken = 1'b1;
    if (cond[5]) taken = flags[cond[4:0]];
    else if (cond[4]) taken = low_bits[cond[3:0]];
    else if (cond == CondN) taken = acc_q[63];
    else if (cond == CondZ) taken = acc_q == '0;
    else if (cond == CondWrap) taken = wrap_i;
    else if (cond == CondTake) taken = take_q;
  end

  always_comb begin
    flag_d = flag_q;
    for (int unsigned i = 0; i < Flags; i++) begin
      if (runs && op == OpFlag && instr_q[4:0] == 5'(i)) flag_d[i] = instr_q[5];
    end
    if (end_i || (runs && op == OpOut)) flag_d[FlagBreakpoint:FlagError] = '0;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      flag_q <= Flags'(1 << FlagOff | 1 << FlagEightBits);
    end else begin
      flag_q <= flag_d;
    end
  end

  // ---- results ----

  events_t sample_events_q;
  logic sample_off_q, eight_bits_q;
  logic signed [15:0] u_q;
  logic [31:0] reply_q;
  logic [2:0] word_addr_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      sample_events_q <= '0;
      sample_off_q    <= 1'b1;
      eight_bits_q    <= 1'b1;
      u_q             <= '0;
    end else if (runs && op == OpOut) begin
      sample_events_q <= flag_q[FlagBreakpoint:FlagError];
      sample_off_q    <= flag_q[FlagOff];
      eight_bits_q    <= flag_q[FlagEightBits];
      u_q             <= acc_q[15:0];
    end else if (commit_i) begin
      sample_events_q <= '0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      word_addr_q <= '0;
      reply_q     <= '0;
    end else begin
      if (start_i) word_addr_q <= '0;
      else if (runs && op == OpIn && instr_q[11:9] == FromWord) word_addr_q <= word_addr_q + 3'd1;
      if (runs && op == OpReply) reply_q <= acc_q[31:0];
    end
  end

  assign word_addr_o      = word_addr_q;
  assign reply_o          = reply_q;
  assign sample_events_o  = sample_events_q;
  assign sample_off_o     = sample_off_q;
  assign command_events_o = flag_q[FlagBreakpoint:FlagError];
  assign command_off_o    = flag_q[FlagOff];
  assign u_o              = u_q;
  assign eight_bits_o     = eight_bits_q;

  // ---- index: the first one after arming, for the next sample ----

  logic captures;
  assign captures = capturing_q && index_seen_i;

  always_ff @(posedge clk_i) begin
    if (sample_i) count_q <= count_i;
    if (captures) index_q <= index_count_i;
    if (rst_i) begin
      captured_q  <= 1'b0;
      capturing_q <= 1'b0;
      take_q      <= 1'b0;
    end else begin
      if (sample_i) take_q <= captured_q;
      if (arm_i) begin
        captured_q  <= 1'b0;
        capturing_q <= 1'b1;
      end else if (captures) begin
        captured_q  <= 1'b1;
        capturing_q <= 1'b0;
      end else if (sample_i) begin
        captured_q <= 1'b0;
      end
    end
  end

  assign busy_o      = busy_q || boot_q;
  assign quiescent_o = !busy_o && !sample_i && !start_i && !arm_i && !captures &&
      !(end_i && command_events_o != '0) && !(commit_i && sample_events_q != '0);

endmodule
