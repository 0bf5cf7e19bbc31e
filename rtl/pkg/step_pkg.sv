// SPDX-License-Identifier: Apache-2.0
//
// What the blocks of a stepper interface share.

package step_pkg;

  // Bits of the rate and status word, above the rate code.
  localparam int unsigned StatusBusy = 12;
  localparam int unsigned StatusForward = 13;
  localparam int unsigned StatusReset = 14;  // as it is read: a limit switch is closed
  localparam int unsigned StatusEnable = 15;

  // A product with a constant, of shifts and sums: a proof leaves multipliers out.
  function automatic logic [31:0] times(logic [31:0] number, logic [15:0] constant);
    times = '0;
    for (int unsigned bit_ = 0; bit_ < 16; bit_++) begin
      if (constant[bit_]) times += number << bit_;
    end
  endfunction

  // The same with a constant of 32 bits.
  function automatic logic [31:0] times_wide(logic [31:0] number, logic [31:0] constant);
    return times(number, constant[15:0]) + (times(number, constant[31:16]) << 16);
  endfunction

endpackage
