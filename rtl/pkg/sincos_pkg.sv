// SPDX-License-Identifier: Apache-2.0
//
// Words of the calibration data of a sine-cosine sensor (Brochier 2006, C.15).

package sincos_pkg;

  typedef logic signed [15:0] calib_t;
  typedef logic [5:0] calib_addr_t;

  localparam calib_addr_t CalibOrigin = 6'd4;  // of A, B
  localparam calib_addr_t CalibRegion = 6'd6;  // limits r0 to r3
  localparam calib_addr_t CalibYmid = 6'd10;  // by region, as the next one
  localparam calib_addr_t CalibPoly = 6'd14;  // 4 words each
  localparam calib_addr_t CalibFlags = 6'd30;  // bit 0: invert
  localparam calib_addr_t CalibDotOffset = 6'd31;  // of dA/dt, dB/dt, as the next two
  localparam calib_addr_t CalibDotMin = 6'd33;
  localparam calib_addr_t CalibDotMax = 6'd35;
  localparam calib_addr_t CalibPhasemid = 6'd37;  // by region, as the next one
  localparam calib_addr_t CalibDotPoly = 6'd41;  // 5 words each
  localparam calib_addr_t CalibExponent = 6'd61;
  localparam calib_addr_t CalibCheck = 6'd62;

endpackage
