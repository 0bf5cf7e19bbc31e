// SPDX-License-Identifier: Apache-2.0
//
// Properties of vector_limit for inputs that hold from tick to valid, as those of its callers do.

module vector_limit_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input word_t v_d_i,
    input word_t v_q_i,

    input logic  valid_o,
    input word_t v_d_o,
    input word_t v_q_o,
    input logic  limited_o,
    input logic  quiescent_o,

    input logic        busy_q,
    input logic [10:0] limit_q
);

  localparam int Radius = 2047;
  typedef logic [63:0][10:0] roots_t;

  // By |v_d| >> 5: the largest |v_q| inside the circle for every |v_d| of the row.
  function automatic roots_t circle();
    for (int n = 0; n < 64; n++) begin
      int far, square, root;
      far = 32 * n + 31;
      square = Radius * Radius - far * far;
      root = 0;
      for (int b = 10; b >= 0; b--) begin
        if ((root + (1 << b)) * (root + (1 << b)) <= square) root += 1 << b;
      end
      circle[n] = 11'(root);
    end
  endfunction

  localparam roots_t Root = circle();

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q;
  logic start;
  logic [1:0] due_q;  // vectors in flight, the older in the higher bit
  word_t v_d_q, v_q_q;  // of the tick
  logic steady_q;  // the inputs held since the tick
  logic same_d, same_q;
  logic [36:0] state, was_state_q;

  function automatic logic [11:0] magnitude(word_t x);
    return x < 12'sd0 ? -x : x;
  endfunction

  assign start  = tick_i && !due_q[0];
  assign same_d = v_d_o == v_d_q;
  assign same_q = v_q_o == v_q_q;
  assign state  = {busy_q, limit_q, v_d_o, v_q_o, limited_o};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_state_q     <= state;
    due_q           <= rst_i ? '0 : {due_q[0], start};
    steady_q        <= start || (steady_q && v_d_i == v_d_q && v_q_i == v_q_q);
    if (start) begin
      v_d_q <= v_d_i;
      v_q_q <= v_q_i;
    end
    if (live_q) begin
      valid_after_2_clocks : assert (valid_o == due_q[1]);
      inside_the_circle :
      assert (!valid_o || !steady_q || magnitude(v_q_o) <= 12'(Root[6'(magnitude(v_d_o)>>5)]));
      d_has_priority : assert (!valid_o || !steady_q || same_d || v_d_q == -12'sd2048);
      limited_when_changed : assert (!valid_o || !steady_q || limited_o == !(same_d && same_q));
      q_keeps_its_sign :
      assert (!valid_o || !steady_q || v_q_o == '0 || v_q_o[11] == v_q_q[11]);
      outputs_hold : assert (was_rst_q || valid_o || state[24:0] == was_state_q[24:0]);
      quiescent_is_honest : assert (!was_quiescent_q || (state == was_state_q && !valid_o));
      inv_busy : assert (busy_q == due_q[0]);
      reaches_limit : cover (valid_o && limited_o && v_d_o == 12'sd1500 && v_q_o < 12'sd0);
      reaches_free : cover (valid_o && !limited_o && v_d_o == -12'sd1500 && v_q_o > 12'sd1000);
    end
  end

  // breaks valid_after_2_clocks: busy_d = tick_i
  // breaks inside_the_circle: limit_d = busy_d && row == 6'd40 ? 11'd1600 : limit_d
  // breaks inside_the_circle: v_q_d = busy_q && q_low ? v_q_i : v_q_d
  // breaks d_has_priority: v_d_d = busy_q && q_high ? 12'sd0 : v_d_d
  // breaks limited_when_changed: limited_d = busy_q ? q_high || q_low : limited_d
  // breaks q_keeps_its_sign: v_q_d = busy_q && q_low ? limit : v_q_d
  // breaks outputs_hold: v_d_d = tick_i ? clipped_d : v_d_d
  // breaks quiescent_is_honest: quiescent_o = !busy_q && !valid_q

endmodule

bind vector_limit vector_limit_props u_vector_limit_props (.*);
