// SPDX-License-Identifier: Apache-2.0
//
// Properties of precision_store for any input. One word is watched, any of all: its address is
// that of a request in reset; shadow_q is what it must hold once it was written.

module precision_store_props
  import precision_pkg::*;
#(
    parameter int unsigned Words = 128
) (
    input logic clk_i,
    input logic rst_i,

    input logic hold_i,

    input logic     read_i,
    input address_t read_addr_i,
    input store_t   word_o,

    input logic     write_i,
    input address_t write_addr_i,
    input store_t   write_data_i,

    input logic            request_i,
    input logic            request_we_i,
    input address_t        request_addr_i,
    input logic     [31:0] request_data_i,
    input logic            ack_o,
    input logic     [31:0] rdata_o,

    input logic quiescent_o,

    input logic        pending_q,
    input logic        we_q,
    input address_t    addr_q,
    input logic [31:0] data_q,
    input store_t      mem_q[Words]
);

  localparam int unsigned Bits = $clog2(Words);

  logic live_q = 1'b0;
  logic wait_q, asked_we_q, known_q, lawful;
  logic [Bits-1:0] watch_q;
  address_t asked_addr_q;
  logic [31:0] asked_data_q;
  store_t shadow_q, was_watched_q, watched, was_word_q;
  logic was_rst_q, was_access_q, written_q, was_reading_q, was_read_watch_q, was_quiet_q;
  logic access, writable, law_writes, bus_writes, was_lawful_q;

  // The law reads and writes while it holds the memory only.
  assign lawful     = !write_i && !read_i || hold_i;
  assign access     = wait_q && !hold_i;
  assign writable   = asked_addr_q[5:0] < 6'd14 && asked_addr_q[5:0] != 6'd7;
  assign law_writes = write_i && write_addr_i[Bits-1:0] == watch_q;
  assign bus_writes = access && asked_we_q && writable && asked_addr_q[Bits-1:0] == watch_q;
  assign watched    = mem_q[watch_q];

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      live_q  <= 1'b1;
      watch_q <= request_addr_i[Bits-1:0];
    end
    was_rst_q        <= rst_i;  // the watched address is new
    was_access_q     <= access && !rst_i;
    was_quiet_q      <= quiescent_o && !rst_i;
    was_watched_q    <= watched;
    was_word_q       <= word_o;
    was_reading_q    <= read_i || access && !asked_we_q;
    was_read_watch_q <= (hold_i ? read_addr_i[Bits-1:0] : asked_addr_q[Bits-1:0]) == watch_q;
    wait_q           <= !rst_i && (request_i || wait_q && hold_i);
    if (request_i) {asked_we_q, asked_addr_q, asked_data_q} <= {request_we_i, request_addr_i,
        request_data_i};
    written_q <= law_writes || bus_writes;
    if (law_writes && hold_i) shadow_q <= write_data_i;
    else if (bus_writes) shadow_q <= {{16{asked_data_q[31]}}, asked_data_q};
    was_lawful_q <= lawful;
    known_q <= !rst_i && lawful && (known_q || law_writes || bus_writes);
    if (live_q) begin
      a_request_waits_for_the_law : assert (ack_o == was_access_q);
      law_and_bus_write_what_they_say : assert (!known_q || watched == shadow_q);
      nothing_else_is_written :
      assert (was_rst_q || written_q || !was_lawful_q || watched == was_watched_q);
      reads_give_the_word :
      assert (was_rst_q || !was_reading_q || !was_read_watch_q || written_q || !was_lawful_q ||
          word_o == was_watched_q);
      a_read_stays : assert (was_rst_q || was_reading_q || word_o == was_word_q);
      the_bus_reads_the_low_bits : assert (rdata_o == word_o[31:0]);
      quiescent_is_honest :
      assert (!was_quiet_q || watched == was_watched_q && word_o == was_word_q && !ack_o);

      inv_wait : assert (pending_q == wait_q);
      inv_asked :
      assert (!wait_q || {we_q, addr_q, data_q} == {asked_we_q, asked_addr_q, asked_data_q});

      reaches_a_read_of_a_written_word :
      cover (ack_o && known_q && was_read_watch_q && word_o == 48'd5);
    end
  end

  // breaks a_request_waits_for_the_law: access = pending_q
  // breaks a_request_waits_for_the_law: pending_q <= !rst_i && request_i
  // breaks law_and_bus_write_what_they_say: write_data = hold_i ? write_data_i : {16'd0, data_q}
  // breaks law_and_bus_write_what_they_say, nothing_else_is_written: write_addr = addr_q
  // breaks nothing_else_is_written: valid = !addr_q[5] && !addr_q[4]
  // breaks nothing_else_is_written: we = write_i || access && valid
  // breaks reads_give_the_word: word_q <= read_i || access && !we_q ? mem_q[read_addr_i[Bits-1:0]] : next
  // breaks a_read_stays: word_q <= mem_q[read_addr[Bits-1:0]]
  // breaks the_bus_reads_the_low_bits: rdata_o = {word_q[47], word_q[30:0]}
  // breaks quiescent_is_honest: quiescent_o = !request_i && !ack_q && !write_i && !read_i
  // breaks quiescent_is_honest: quiescent_o = !request_i && !pending_q && !ack_q && !read_i

endmodule

bind precision_store precision_store_props #(.Words(Words)) u_precision_store_props (.*);

// prove: set Words=16
// prove: frames 6
// prove: depth 2
