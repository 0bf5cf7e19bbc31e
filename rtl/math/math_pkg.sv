// SPDX-License-Identifier: Apache-2.0
//
// Combinational helpers: saturation and rounding shifts at named places.
// Twin: models/fixed/fixed.hpp, function by function.

package math_pkg;

  typedef logic signed [55:0] acc_t;  // wide enough for every product of this IC and its shift

  // The bits above the word are tested: a comparison would be a carry chain of 56 bits.
  function automatic logic signed [11:0] sat12(acc_t x);
    return x[55:11] == '0 || x[55:11] == '1 ? x[11:0] : {x[55], {11{~x[55]}}};
  endfunction

  function automatic logic signed [23:0] sat24(acc_t x);
    return x[55:23] == '0 || x[55:23] == '1 ? x[23:0] : {x[55], {23{~x[55]}}};
  endfunction

  // Shift right by s rounded half up; shift left by -s for s <= 0 (specification section 3).
  function automatic acc_t rs(acc_t x, logic signed [5:0] s);
    acc_t half;
    half = s > 6'sd0 ? acc_t'(1) << (s - 6'sd1) : '0;
    return s > 6'sd0 ? (x + half) >>> s : x << (-s);
  endfunction

endpackage
