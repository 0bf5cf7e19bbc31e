// SPDX-License-Identifier: Apache-2.0
//
// Calibration data of the observer: 62 words of 16 bits and their checksum, in two banks. Commands
// fill the one that is not in use; where the checksum is right it is taken into use and written to
// a non-volatile memory, else the previous data stays. After reset the memory is read the same way.
//
//   1 start   2 next word   7 check: count 63 and CRC-16/CCITT-FALSE of the 124 bytes, low byte of
//   a word first
//
// A word of the memory passes at an edge where nv_valid_o and nv_ready_i are high. The banks change
// places only while the reader rests; a word is fetched for the memory only then, too.

module calibration
  import sincos_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic        write_i,    // a command
    input logic [ 2:0] command_i,
    input logic [15:0] word_i,

    input  logic        reads_i,  // the reader is at work
    input  calib_addr_t addr_i,
    output calib_t      data_o,

    output logic        nv_valid_o,
    output logic        nv_write_o,
    output calib_addr_t nv_addr_o,
    output logic [15:0] nv_data_o,
    input  logic        nv_ready_i,
    input  logic [15:0] nv_data_i,

    output logic       valid_o,
    output logic       busy_o,
    output logic [5:0] count_o,
    output logic       stored_o,    // pulse
    output logic       refused_o,   // pulse
    output logic       quiescent_o
);

  typedef enum logic [2:0] {
    StLoad,   // words of the memory come
    StCheck,  // what came
    StTake,   // the banks change places
    StFetch,  // a word for the memory
    StStore,  // it goes there
    StReady
  } state_e;

  localparam logic [2:0] CmdStart = 3'd1;
  localparam logic [2:0] CmdWord = 3'd2;
  localparam logic [2:0] CmdCheck = 3'd7;
  localparam logic [5:0] All = 6'd63;

  state_e state_d, state_q;
  logic bank_d, bank_q, valid_d, valid_q, right_d, right_q, loading_d, loading_q;
  logic [5:0] count_d, count_q, saved_d, saved_q;
  logic [15:0] check_d, check_q, word, fetched_q;
  logic takes;  // a word into the bank that is not in use

  logic [15:0] bank[128];
  logic [5:0] addr;

  assign addr   = state_q == StFetch && !reads_i ? saved_q : addr_i;
  assign data_o = bank[{bank_q, addr}];

  // A word into the checksum.
  function automatic logic [15:0] checked(logic [15:0] check, logic [15:0] data);
    checked = check;
    for (int k = 0; k < 16; k++) begin  // bit 7 of the low byte first
      checked = {checked[14:0], 1'b0} ^ (checked[15] ^ data[k^7] ? 16'h1021 : 16'h0000);
    end
  endfunction

  always_comb begin
    state_d   = state_q;
    bank_d    = bank_q;
    valid_d   = valid_q;
    right_d   = right_q;
    loading_d = loading_q;
    count_d   = count_q;
    saved_d   = saved_q;
    check_d   = check_q;
    word      = word_i;
    takes     = 1'b0;
    stored_o  = 1'b0;
    refused_o = 1'b0;
    unique case (state_q)
      StLoad: begin
        word  = nv_data_i;
        takes = nv_ready_i;
        if (takes && count_q == CalibCheck) state_d = StCheck;
      end
      StCheck: begin
        state_d = StTake;
        if (count_q != All || !right_q) begin
          refused_o = 1'b1;
          state_d   = StReady;
          loading_d = 1'b0;
        end
      end
      StTake: begin
        saved_d = '0;
        if (!reads_i) begin
          bank_d    = !bank_q;
          valid_d   = 1'b1;
          count_d   = '0;
          check_d   = '1;
          right_d   = 1'b0;
          loading_d = 1'b0;
          state_d   = loading_q ? StReady : StFetch;
        end
      end
      StFetch: if (!reads_i) state_d = StStore;
      StStore: begin
        if (nv_ready_i) begin
          saved_d = saved_q + 6'd1;
          state_d = StFetch;
          if (saved_q == CalibCheck) begin
            stored_o = 1'b1;
            state_d  = StReady;
          end
        end
      end
      default: begin
        if (write_i && command_i == CmdStart) begin
          count_d = '0;
          check_d = '1;
          right_d = 1'b0;
        end
        takes = write_i && command_i == CmdWord && count_q != All;
        if (write_i && command_i == CmdCheck) state_d = StCheck;
      end
    endcase
    if (takes) begin
      count_d = count_q + 6'd1;
      right_d = word == check_q;  // of the last word this is said
      check_d = checked(check_q, word);
    end
  end

  always_ff @(posedge clk_i) begin
    if (takes) bank[{!bank_q, count_q}] <= word;
    if (state_q == StFetch && !reads_i) fetched_q <= data_o;
    if (rst_i) begin
      state_q   <= StLoad;
      bank_q    <= 1'b0;
      valid_q   <= 1'b0;
      right_q   <= 1'b0;
      loading_q <= 1'b1;
      count_q   <= '0;
      saved_q   <= '0;
      check_q   <= '1;
    end else begin
      state_q   <= state_d;
      bank_q    <= bank_d;
      valid_q   <= valid_d;
      right_q   <= right_d;
      loading_q <= loading_d;
      count_q   <= count_d;
      saved_q   <= saved_d;
      check_q   <= check_d;
    end
  end

  assign nv_valid_o = state_q == StLoad || state_q == StStore;
  assign nv_write_o = state_q == StStore;
  assign nv_addr_o = state_q == StStore ? saved_q : count_q;
  assign nv_data_o = state_q == StStore ? fetched_q : '0;
  assign valid_o = valid_q;
  assign busy_o = state_q != StReady;
  assign count_o = count_q;
  assign quiescent_o = !busy_o && !write_i;

endmodule
