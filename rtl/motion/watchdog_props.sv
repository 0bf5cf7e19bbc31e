// SPDX-License-Identifier: Apache-2.0
//
// Properties of watchdog for any input; the model counts ticks since the last kick independently.

module watchdog_props (
    input logic clk_i,
    input logic rst_i,

    input logic tick_pos_i,

    input logic        kick_i,
    input logic        enable_i,
    input logic [15:0] limit_i,

    input logic bite_o,
    input logic quiescent_o,

    input logic [15:0] count_q
);

  logic live_q = 1'b0;
  logic was_rst_q, was_bite_q, was_tick_q, was_enable_q, was_quiescent_q;
  logic hungry;  // nothing resets the ticks counted so far
  logic was_hungry_q;
  logic [16:0] ticks_d, ticks_q;  // since the last kick, at most one more than any limit
  logic [15:0] limit_q, was_count_q;
  logic steady_q;  // the limit is the one of the last kick

  assign hungry = enable_i && !kick_i && limit_i != '0;

  always_comb begin
    ticks_d = ticks_q;
    if (!hungry) ticks_d = '0;
    else if (tick_pos_i && ticks_q != 17'h1_0000) ticks_d = ticks_q + 17'd1;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_bite_q      <= !rst_i && bite_o;
    was_tick_q      <= !rst_i && tick_pos_i;
    was_enable_q    <= enable_i;
    was_hungry_q    <= hungry;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_count_q     <= count_q;
    ticks_q         <= rst_i ? '0 : ticks_d;
    limit_q         <= limit_i;
    steady_q        <= rst_i || !hungry || (steady_q && limit_i == limit_q) || ticks_q == '0;
    if (live_q) begin
      quiet_from_reset : assert (!was_rst_q || !bite_o);
      // The clock of tick number limit + 1 is the one before the bite.
      bites_after_limit_ticks :
      assert (!was_tick_q || !was_hungry_q || ticks_q <= 17'(limit_q) || bite_o);
      bites_not_earlier :
      assert (!bite_o || was_bite_q || (was_tick_q && ticks_q > 17'(limit_q)));
      bites_exactly :
      assert (!bite_o || was_bite_q || !steady_q || ticks_q == 17'(limit_q) + 17'd1);
      only_disabling_takes_it_back : assert (!was_bite_q || bite_o == was_enable_q);
      quiescent_is_honest :
      assert (!was_quiescent_q || (bite_o == was_bite_q && count_q == was_count_q));
      inv_count : assert (bite_o || 17'(count_q) == ticks_q);
      inv_steady : assert (bite_o || !steady_q || ticks_q <= 17'(limit_q) || was_rst_q);
      reaches_bite : cover (bite_o && !was_bite_q && ticks_q == 17'd4);
      reaches_late_kick : cover (bite_o && was_bite_q && !was_hungry_q && limit_q != '0);
    end
  end

  // breaks quiet_from_reset: bite_q <= bite_d
  // breaks bites_after_limit_ticks: bite_d = enable_i && !kick_i && count_q == limit_i ? bite_q : bite_d
  // breaks bites_not_earlier: bite_d = bite_d || (enable_i && !kick_i && limit_i != '0 && tick_pos_i && count_q + 16'd1 >= limit_i)
  // breaks bites_exactly: count_d = enable_i && kick_i && limit_i != '0 ? count_q : count_d
  // breaks only_disabling_takes_it_back: bite_d = bite_d && !kick_i
  // breaks quiescent_is_honest: quiescent_o = bite_d == bite_q

endmodule

bind watchdog watchdog_props u_watchdog_props (.*);
