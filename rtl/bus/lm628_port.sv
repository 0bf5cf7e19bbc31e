// SPDX-License-Identifier: Apache-2.0
//
// Host port of the LM628 (data sheet SNVS781C): commands and data in bytes, status, interrupt.
//
//   clocks  stage
//   3       pins: two synchroniser flip-flops, one to detect edges
//   160 t   busy after a command, a data word, and a word read (t: ticks of 25 / Inc clocks)
//   128     the last of these clocks: a command with all its words is executed
//
// A write acts when its strobe ends, with ps and data as they were before; a read when it begins.
// A command that would end in ticks 0..399 of a sample waits for open_i.

module lm628_port
  import trammel_pkg::*;
  import lm628_pkg::*;
#(
    parameter int unsigned Inc = 4
) (
    input logic clk_i,       // of the timers; gated for the other registers
    input logic clock_en_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic commit_i,
    input logic open_i,
    input logic ready_i,  // not in the reset routine

    input  logic       cs_n_i,
    input  logic       rd_n_i,
    input  logic       wr_n_i,
    input  logic       ps_i,
    input  logic [7:0] d_i,
    output logic [7:0] d_o,
    output logic       d_oe_o,
    output logic       hi_o,

    output logic restart_o,  // the command RESET
    output logic start_o,
    output logic end_o,
    output logic arm_o,      // SIP

    output logic    [ 7:0] opcode_o,
    input  logic    [ 2:0] word_addr_i,
    output logic    [15:0] word_o,
    input  logic    [31:0] reply_i,
    input  events_t        sample_events_i,
    input  logic           sample_off_i,
    input  events_t        command_events_i,
    input  logic           command_off_i,
    output events_t        status_o,          // bits 1 to 6 as they will be published
    output logic           host_irq_o,
    output gap_t           next_o,
    output logic           quiescent_o
);

  logic clk_gated;
  assign clk_gated = clk_i & clock_en_i;

  localparam logic [10:0] Busy = 11'(lm628_clocks(Inc, 160) - Lm628Run - 1);
  localparam logic [10:0] Run  = 11'(Lm628Run - 1);

  // ---- pins ----

  typedef struct packed {
    logic cs_n;
    logic rd_n;
    logic wr_n;
    logic ps;
    logic [7:0] d;
  } pins_t;

  pins_t pins, meta_q, sync_q, prev_q;
  logic reading, was_reading, written, read;

  assign pins = {cs_n_i, rd_n_i, wr_n_i, ps_i, d_i};

  always_ff @(posedge clk_gated) begin
    meta_q <= pins;
    sync_q <= meta_q;
    prev_q <= sync_q;
  end

  assign reading     = !sync_q.cs_n && !sync_q.rd_n;
  assign was_reading = !prev_q.cs_n && !prev_q.rd_n;
  assign written     = !prev_q.cs_n && !prev_q.wr_n && (sync_q.cs_n || sync_q.wr_n);
  assign read        = reading && !was_reading && !written;

  // ---- transfers ----

  typedef enum logic [1:0] {
    StIdle,
    StBusy,
    StWait,  // for open_i
    StRun
  } state_e;

  state_e state_q, state_d;
  logic idle, command, data, give, wrong, word_done, word_given;
  logic known, replies, half_written_q, half_read_q, executes_q, executes_d;
  logic [2:0] due_q, due_d, due, more, next_q;
  logic [1:0] left_q;
  logic [7:0] code, opcode_q, high_q, last_q, d_q, byte_out;

  assign idle       = state_q == StIdle && ready_i;
  assign command    = written && !prev_q.ps && idle;
  assign data       = written && prev_q.ps && idle;
  assign give       = read && sync_q.ps && idle && left_q != '0;
  assign word_done  = data && due_q != '0 && half_written_q;
  assign word_given = give && half_read_q;
  assign restart_o  = command && code == CmdReset;

  // Words that follow the opcode; the first of LFIL and LTRJ says how many more.
  assign code  = prev_q.d;
  assign known = code <= 8'h0D || (code >= 8'h1A && code <= 8'h21);

  always_comb begin
    due = '0;
    if (code >= 8'h1A && code <= 8'h1F) due = 3'd1;
    if (code == 8'h20 || code == 8'h21) due = 3'd2;
  end

  always_comb begin
    more = '0;
    if (next_q == '0 && opcode_q == CmdLfil) begin
      more = 3'(code[3]) + 3'(code[2]) + 3'(code[1]) + 3'(code[0]);
    end
    if (next_q == '0 && opcode_q == CmdLtrj) begin
      more = {2'(code[5]) + 2'(code[3]) + 2'(code[1]), 1'b0};
    end
  end

  always_comb begin
    due_d      = due_q;
    executes_d = executes_q;
    wrong      = (data && due_q == '0) || (read && sync_q.ps && idle && left_q == '0);
    if (command) begin
      due_d      = due;
      executes_d = known && due == '0;
      wrong      = due_q != '0 || left_q != '0 || !known;
    end
    if (word_done) begin
      due_d      = due_q + more - 3'd1;
      executes_d = due_d == '0;
    end
    if (word_given) executes_d = 1'b0;
  end

  // ---- busy ----

  logic [10:0] count, value;
  logic load, last, runs;

  timer #(
      .Width(11)
  ) u_busy (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (load),
      .value_i(value),
      .count_o(count),
      .next_o (next_o)
  );

  assign last = count == '0;
  assign runs = (state_q == StBusy && last && (open_i || !executes_q)) ||
      (state_q == StWait && open_i);

  always_comb begin
    state_d = state_q;
    load    = 1'b0;
    value   = Run;
    unique case (state_q)
      StIdle: begin
        value = Busy;
        load  = command || word_done || word_given;
        if (load) state_d = StBusy;
      end
      StRun:   if (last) state_d = StIdle;
      default: begin
        load = runs;
        if (runs) state_d = StRun;
        else if (last) state_d = StWait;
      end
    endcase
  end

  assign start_o = runs && executes_q;
  assign end_o   = state_q == StRun && last && executes_q;
  assign arm_o   = end_o && opcode_q == CmdSip;
  assign replies = opcode_q >= 8'h07 && opcode_q <= 8'h0D;

  always_ff @(posedge clk_gated) begin
    if (rst_i) begin
      state_q    <= StIdle;
      due_q      <= '0;
      executes_q <= 1'b0;
    end else begin
      state_q    <= state_d;
      due_q      <= due_d;
      executes_q <= executes_d;
    end
  end

  // ---- words ----

  logic [15:0] words_q[8];

  always_ff @(posedge clk_gated) begin
    if (word_done) words_q[next_q] <= {high_q, code};
  end

  assign word_o = words_q[word_addr_i];

  always_ff @(posedge clk_gated) begin
    if (rst_i) begin
      opcode_q       <= '0;
      next_q         <= '0;
      left_q         <= '0;
      half_written_q <= 1'b0;
      half_read_q    <= 1'b0;
    end else begin
      if (command) opcode_q <= code;
      if (command) next_q <= '0;
      else if (word_done) next_q <= next_q + 3'd1;
      if (command) left_q <= '0;
      else if (end_o) left_q <= replies ? {opcode_q <= 8'h0A, opcode_q > 8'h0A} : 2'd0;
      else if (word_given) left_q <= left_q - 2'd1;
      if (command) begin  // drops a half word; a status read does not
        half_written_q <= 1'b0;
        half_read_q    <= 1'b0;
      end else begin
        if (data && due_q != '0) half_written_q <= !half_written_q;
        if (give) half_read_q <= !half_read_q;
      end
    end
  end

  always_ff @(posedge clk_gated) begin
    if (data && due_q != '0 && !half_written_q) high_q <= code;
  end

  always_comb begin
    unique case ({left_q[1], half_read_q})
      2'b10:   byte_out = reply_i[31:24];
      2'b11:   byte_out = reply_i[23:16];
      2'b00:   byte_out = reply_i[15:8];
      default: byte_out = reply_i[7:0];
    endcase
  end

  // ---- status ----

  events_t status_q, mask_q, operand_q, raised, kept;
  logic off_q, hi_q, resets, by_command_q;
  logic [7:0] status;

  assign resets = end_o && opcode_q == CmdRsti;
  assign kept   = resets ? operand_q : '1;

  always_ff @(posedge clk_gated) begin
    if (word_done) operand_q <= code[6:1];
  end

  always_comb begin
    raised = '0;
    if (commit_i) raised |= sample_events_i;
    if (end_o) raised |= command_events_i;
  end

  always_ff @(posedge clk_gated) begin
    if (rst_i) begin
      status_q <= 6'b000010;
      mask_q   <= 6'b011111;
      off_q    <= 1'b1;
      hi_q     <= 1'b0;
    end else begin
      status_q <= ((status_q | raised) & kept) | events_t'(wrong);
      if (end_o && opcode_q == CmdMski) mask_q <= operand_q;
      if (end_o) off_q <= command_off_i;
      else if (commit_i) off_q <= sample_off_i;
      hi_q <= !resets && (hi_q || ((raised | events_t'(wrong)) & mask_q) != '0);
    end
  end

  // A reset by command shows busy until it is over.
  always_ff @(posedge clk_gated) begin
    if (rst_i) by_command_q <= restart_o;
  end

  assign status = ready_i ? {off_q, status_q, state_q != StIdle} : {7'd0, by_command_q};

  always_ff @(posedge clk_gated) begin
    if (rst_i) begin
      d_q    <= '0;
      last_q <= '0;
    end else if (read) begin
      if (give) last_q <= byte_out;
      if (!sync_q.ps) d_q <= status;
      else d_q <= give ? byte_out : last_q;
    end
  end

  assign d_o        = d_q;
  assign d_oe_o     = was_reading;
  assign hi_o       = hi_q;
  assign opcode_o   = opcode_q;
  assign status_o   = status_q | sample_events_i;
  assign host_irq_o = hi_q || (sample_events_i & mask_q) != '0;

  assign quiescent_o = pins == meta_q && meta_q == sync_q && sync_q == prev_q && !commit_i &&
      (state_q == StIdle || (state_q == StWait ? !open_i : !last));

endmodule
