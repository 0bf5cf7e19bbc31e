// SPDX-License-Identifier: Apache-2.0
//
// Properties of timer for any load, value and leap.

module timer_props
  import trammel_pkg::*;
#(
    parameter int unsigned Width = 12
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic             load_i,
    input logic [Width-1:0] value_i,

    input logic [Width-1:0] count_o,
    input gap_t             next_o
);

  logic live_q = 1'b0;
  logic was_rst_q, was_load_q;
  logic [31:0] now, was_q, value_q, passed_q;  // clocks passed by the previous edge: 1 + leap
  gap_t was_next_q;
  logic quiet;  // the previous edge did nothing but count

  assign now   = 32'(count_o);
  assign quiet = !was_rst_q && !was_load_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q  <= rst_i;
    was_load_q <= load_i;
    was_q      <= now;
    value_q    <= 32'(value_i);
    passed_q   <= 32'(leap_i) + 32'd1;
    was_next_q <= next_o;
    if (live_q) begin
      zero_from_reset : assert (!was_rst_q || now == '0);
      loads_the_value : assert (was_rst_q || !was_load_q || now == value_q);
      counts_the_clocks : assert (!quiet || now == (was_q > passed_q ? was_q - passed_q : '0));
      // next_o edges do nothing but count: none of them makes the count 0 ...
      no_event_within_next :
      assert (!quiet || passed_q > 32'(was_next_q) || (now == '0) == (was_q == '0));
      // ... the one after them does, and next_o stays consistent from clock to clock.
      event_at_next_zero : assert (!quiet || was_next_q != '0 || (was_q == 32'd1 && now == '0));
      next_falls_by_the_clocks :
      assert (!quiet || load_i || passed_q > 32'(was_next_q) || was_next_q == GapMax ||
              32'(next_o) == 32'(was_next_q) - passed_q ||
              (was_next_q == GapMax - 12'd1 && 32'(next_o) > 32'(was_next_q) - passed_q));
      never_means_never : assert ((next_o == GapMax) == (now == '0 && !load_i));
      load_is_an_event : assert (!load_i || next_o == '0);
      reaches_zero : cover (!rst_i && quiet && was_q == 32'd3 && now == '0 && passed_q > 32'd2);
      reaches_far : cover (next_o == GapMax - 12'd1);
    end
  end

  // breaks zero_from_reset: count_q <= rst_i ? value_i : next
  // breaks loads_the_value: count_q <= !rst_i && load_i ? value_i + leap_i : next
  // breaks counts_the_clocks: step = Wide'(1)
  // breaks counts_the_clocks: count_q <= rst_i || load_i || count >= step + Wide'(1) + step ? next : '0
  // breaks no_event_within_next: next_o = !load_i && count_q != '0 && count <= Wide'(GapMax) ? gap_t'(count) : next_o
  // breaks event_at_next_zero: next_o = !load_i && count_q != '0 && count <= Wide'(GapMax) ? gap_t'(count >> 2) : next_o
  // breaks next_falls_by_the_clocks: next_o = !load_i && count > Wide'(GapMax) ? GapMax - gap_t'(2) : next_o
  // breaks never_means_never: next_o = !load_i && count_q == '0 ? '0 : next_o
  // breaks load_is_an_event: next_o = load_i ? GapMax : next_o

  // prove: set Width=14
  // prove: set Width=12
  // prove: set Width=10

endmodule

bind timer timer_props #(.Width(Width)) u_timer_props (.*);
