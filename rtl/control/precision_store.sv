// SPDX-License-Identifier: Apache-2.0
//
// The words of the precision controller: 64 of 48 bits for each axis, in block memory with one read
// and one write port. The law owns both while hold_i is high; a request of the bus waits until it
// is low, takes one clock, and is acknowledged in the next, with what it read. The bus writes 32
// bits, sign-extended, to the words that a knot or a tick takes (0 to 6, 8 to 13), to no other.
// Memory has no reset: what the law does not clear stays.

module precision_store
  import precision_pkg::*;
#(
    parameter int unsigned Words = 128  // fewer in the proof: high bits of the address are ignored
) (
    input logic clk_i,
    input logic rst_i,

    input logic hold_i,  // the law runs

    input  logic     read_i,
    input  address_t read_addr_i,
    output store_t   word_o,       // of the last read

    input logic     write_i,
    input address_t write_addr_i,
    input store_t   write_data_i,

    input  logic        request_i,     // pulse; not before the last is acknowledged
    input  logic        request_we_i,
    input  address_t    request_addr_i,
    input  logic [31:0] request_data_i,
    output logic        ack_o,         // pulse
    output logic [31:0] rdata_o,

    output logic quiescent_o
);

  localparam int unsigned Bits = $clog2(Words);

  logic pending_q, ack_q, we_q, access, valid, we;
  address_t addr_q, write_addr, read_addr;
  logic [31:0] data_q;
  store_t write_data;

  assign access = pending_q && !hold_i;
  assign valid  = !addr_q[5] && !addr_q[4] && addr_q[3:0] != 4'd7 && addr_q[3:1] != 3'd7;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      pending_q <= 1'b0;
      ack_q     <= 1'b0;
    end else begin
      pending_q <= request_i || (pending_q && hold_i);
      ack_q     <= access;
    end
  end

  always_ff @(posedge clk_i) begin
    if (request_i) begin
      we_q   <= request_we_i;
      addr_q <= request_addr_i;
      data_q <= request_data_i;
    end
  end

  assign we         = write_i || access && we_q && valid;
  assign write_addr = hold_i ? write_addr_i : addr_q;
  assign read_addr  = hold_i ? read_addr_i : addr_q;
  assign write_data = hold_i ? write_data_i : store_t'($signed(data_q));

  // The law never reads a word in the clock that writes it, and the bus does one or the other.
  (* no_rw_check *) store_t mem_q[Words];
  store_t word_q;
  initial for (int unsigned i = 0; i < Words; i++) mem_q[i] = '0;

  always_ff @(posedge clk_i) begin
    if (we) mem_q[write_addr[Bits-1:0]] <= write_data;
    if (read_i || access && !we_q) word_q <= mem_q[read_addr[Bits-1:0]];
  end

  assign word_o      = word_q;
  assign ack_o       = ack_q;
  assign rdata_o     = word_q[31:0];
  assign quiescent_o = !request_i && !pending_q && !ack_q && !write_i && !read_i;

endmodule
