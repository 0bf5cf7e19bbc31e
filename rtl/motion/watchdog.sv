// SPDX-License-Identifier: Apache-2.0
//
// Bites when more than limit_i position ticks pass between two kicks.
//
// The bite is a level that only enable_i low clears: a late kick does not hide it. Limit 0
// means off. A kick in the clock of a tick wins over the tick.

module watchdog (
    input logic clk_i,
    input logic rst_i,

    input logic tick_pos_i,

    input logic        kick_i,
    input logic        enable_i,
    input logic [15:0] limit_i,

    output logic bite_o,
    output logic quiescent_o
);

  logic [15:0] count_d, count_q;
  logic bite_d, bite_q;

  always_comb begin
    count_d = count_q;
    bite_d  = bite_q;
    if (!enable_i) begin
      count_d = '0;
      bite_d  = 1'b0;
    end else if (kick_i || limit_i == '0) begin
      count_d = '0;
    end else if (tick_pos_i && !bite_q) begin
      if (count_q >= limit_i) bite_d = 1'b1;
      else count_d = count_q + 16'd1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      count_q <= '0;
      bite_q  <= 1'b0;
    end else begin
      count_q <= count_d;
      bite_q  <= bite_d;
    end
  end

  assign bite_o      = bite_q;
  assign quiescent_o = count_d == count_q && bite_d == bite_q;

endmodule
