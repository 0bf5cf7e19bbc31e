// SPDX-License-Identifier: Apache-2.0
//
// Cells of an ECP5 in simulation, which Yosys has as black boxes: a block RAM of any width without
// output registers, and the PLL, which is a wire here.

module DP16KD #(
    parameter integer DATA_WIDTH_A = 18,
    parameter integer DATA_WIDTH_B = 18,
    parameter WRITEMODE_A = "NORMAL",
    parameter WRITEMODE_B = "NORMAL",
    parameter REGMODE_A = "NOREG", REGMODE_B = "NOREG", RESETMODE = "SYNC",
    parameter ASYNC_RESET_RELEASE = "SYNC", CSDECODE_A = "0b000", CSDECODE_B = "0b000",
    parameter CLKAMUX = "CLKA", CLKBMUX = "CLKB", GSR = "AUTO", INIT_DATA = "STATIC", WID = "",
    parameter [319:0] INITVAL_00 = 320'd0,
    parameter [319:0] INITVAL_01 = 320'd0,
    parameter [319:0] INITVAL_02 = 320'd0,
    parameter [319:0] INITVAL_03 = 320'd0,
    parameter [319:0] INITVAL_04 = 320'd0,
    parameter [319:0] INITVAL_05 = 320'd0,
    parameter [319:0] INITVAL_06 = 320'd0,
    parameter [319:0] INITVAL_07 = 320'd0,
    parameter [319:0] INITVAL_08 = 320'd0,
    parameter [319:0] INITVAL_09 = 320'd0,
    parameter [319:0] INITVAL_0A = 320'd0,
    parameter [319:0] INITVAL_0B = 320'd0,
    parameter [319:0] INITVAL_0C = 320'd0,
    parameter [319:0] INITVAL_0D = 320'd0,
    parameter [319:0] INITVAL_0E = 320'd0,
    parameter [319:0] INITVAL_0F = 320'd0,
    parameter [319:0] INITVAL_10 = 320'd0,
    parameter [319:0] INITVAL_11 = 320'd0,
    parameter [319:0] INITVAL_12 = 320'd0,
    parameter [319:0] INITVAL_13 = 320'd0,
    parameter [319:0] INITVAL_14 = 320'd0,
    parameter [319:0] INITVAL_15 = 320'd0,
    parameter [319:0] INITVAL_16 = 320'd0,
    parameter [319:0] INITVAL_17 = 320'd0,
    parameter [319:0] INITVAL_18 = 320'd0,
    parameter [319:0] INITVAL_19 = 320'd0,
    parameter [319:0] INITVAL_1A = 320'd0,
    parameter [319:0] INITVAL_1B = 320'd0,
    parameter [319:0] INITVAL_1C = 320'd0,
    parameter [319:0] INITVAL_1D = 320'd0,
    parameter [319:0] INITVAL_1E = 320'd0,
    parameter [319:0] INITVAL_1F = 320'd0,
    parameter [319:0] INITVAL_20 = 320'd0,
    parameter [319:0] INITVAL_21 = 320'd0,
    parameter [319:0] INITVAL_22 = 320'd0,
    parameter [319:0] INITVAL_23 = 320'd0,
    parameter [319:0] INITVAL_24 = 320'd0,
    parameter [319:0] INITVAL_25 = 320'd0,
    parameter [319:0] INITVAL_26 = 320'd0,
    parameter [319:0] INITVAL_27 = 320'd0,
    parameter [319:0] INITVAL_28 = 320'd0,
    parameter [319:0] INITVAL_29 = 320'd0,
    parameter [319:0] INITVAL_2A = 320'd0,
    parameter [319:0] INITVAL_2B = 320'd0,
    parameter [319:0] INITVAL_2C = 320'd0,
    parameter [319:0] INITVAL_2D = 320'd0,
    parameter [319:0] INITVAL_2E = 320'd0,
    parameter [319:0] INITVAL_2F = 320'd0,
    parameter [319:0] INITVAL_30 = 320'd0,
    parameter [319:0] INITVAL_31 = 320'd0,
    parameter [319:0] INITVAL_32 = 320'd0,
    parameter [319:0] INITVAL_33 = 320'd0,
    parameter [319:0] INITVAL_34 = 320'd0,
    parameter [319:0] INITVAL_35 = 320'd0,
    parameter [319:0] INITVAL_36 = 320'd0,
    parameter [319:0] INITVAL_37 = 320'd0,
    parameter [319:0] INITVAL_38 = 320'd0,
    parameter [319:0] INITVAL_39 = 320'd0,
    parameter [319:0] INITVAL_3A = 320'd0,
    parameter [319:0] INITVAL_3B = 320'd0,
    parameter [319:0] INITVAL_3C = 320'd0,
    parameter [319:0] INITVAL_3D = 320'd0,
    parameter [319:0] INITVAL_3E = 320'd0,
    parameter [319:0] INITVAL_3F = 320'd0
) (
    input DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5,
        DIA4, DIA3, DIA2, DIA1, DIA0,
    input ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1, ADA0,
    input CEA, OCEA, CLKA, WEA, RSTA, CSA2, CSA1, CSA0,
    output DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5,
        DOA4, DOA3, DOA2, DOA1, DOA0,
    input DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5,
        DIB4, DIB3, DIB2, DIB1, DIB0,
    input ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1, ADB0,
    input CEB, OCEB, CLKB, WEB, RSTB, CSB2, CSB1, CSB0,
    output DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5,
        DOB4, DOB3, DOB2, DOB1, DOB0
);
  // 1024 words of 18 bits, two bytes of 9; narrow widths leave the ninth bits out.
  reg [17:0] words[0:1023];
  reg [17:0] qa = 0, qb = 0;
  integer n;

  initial begin
    for (n = 0; n < 16; n = n + 1) begin
      words[0 + n] = INITVAL_00[20*n+:18];
      words[16 + n] = INITVAL_01[20*n+:18];
      words[32 + n] = INITVAL_02[20*n+:18];
      words[48 + n] = INITVAL_03[20*n+:18];
      words[64 + n] = INITVAL_04[20*n+:18];
      words[80 + n] = INITVAL_05[20*n+:18];
      words[96 + n] = INITVAL_06[20*n+:18];
      words[112 + n] = INITVAL_07[20*n+:18];
      words[128 + n] = INITVAL_08[20*n+:18];
      words[144 + n] = INITVAL_09[20*n+:18];
      words[160 + n] = INITVAL_0A[20*n+:18];
      words[176 + n] = INITVAL_0B[20*n+:18];
      words[192 + n] = INITVAL_0C[20*n+:18];
      words[208 + n] = INITVAL_0D[20*n+:18];
      words[224 + n] = INITVAL_0E[20*n+:18];
      words[240 + n] = INITVAL_0F[20*n+:18];
      words[256 + n] = INITVAL_10[20*n+:18];
      words[272 + n] = INITVAL_11[20*n+:18];
      words[288 + n] = INITVAL_12[20*n+:18];
      words[304 + n] = INITVAL_13[20*n+:18];
      words[320 + n] = INITVAL_14[20*n+:18];
      words[336 + n] = INITVAL_15[20*n+:18];
      words[352 + n] = INITVAL_16[20*n+:18];
      words[368 + n] = INITVAL_17[20*n+:18];
      words[384 + n] = INITVAL_18[20*n+:18];
      words[400 + n] = INITVAL_19[20*n+:18];
      words[416 + n] = INITVAL_1A[20*n+:18];
      words[432 + n] = INITVAL_1B[20*n+:18];
      words[448 + n] = INITVAL_1C[20*n+:18];
      words[464 + n] = INITVAL_1D[20*n+:18];
      words[480 + n] = INITVAL_1E[20*n+:18];
      words[496 + n] = INITVAL_1F[20*n+:18];
      words[512 + n] = INITVAL_20[20*n+:18];
      words[528 + n] = INITVAL_21[20*n+:18];
      words[544 + n] = INITVAL_22[20*n+:18];
      words[560 + n] = INITVAL_23[20*n+:18];
      words[576 + n] = INITVAL_24[20*n+:18];
      words[592 + n] = INITVAL_25[20*n+:18];
      words[608 + n] = INITVAL_26[20*n+:18];
      words[624 + n] = INITVAL_27[20*n+:18];
      words[640 + n] = INITVAL_28[20*n+:18];
      words[656 + n] = INITVAL_29[20*n+:18];
      words[672 + n] = INITVAL_2A[20*n+:18];
      words[688 + n] = INITVAL_2B[20*n+:18];
      words[704 + n] = INITVAL_2C[20*n+:18];
      words[720 + n] = INITVAL_2D[20*n+:18];
      words[736 + n] = INITVAL_2E[20*n+:18];
      words[752 + n] = INITVAL_2F[20*n+:18];
      words[768 + n] = INITVAL_30[20*n+:18];
      words[784 + n] = INITVAL_31[20*n+:18];
      words[800 + n] = INITVAL_32[20*n+:18];
      words[816 + n] = INITVAL_33[20*n+:18];
      words[832 + n] = INITVAL_34[20*n+:18];
      words[848 + n] = INITVAL_35[20*n+:18];
      words[864 + n] = INITVAL_36[20*n+:18];
      words[880 + n] = INITVAL_37[20*n+:18];
      words[896 + n] = INITVAL_38[20*n+:18];
      words[912 + n] = INITVAL_39[20*n+:18];
      words[928 + n] = INITVAL_3A[20*n+:18];
      words[944 + n] = INITVAL_3B[20*n+:18];
      words[960 + n] = INITVAL_3C[20*n+:18];
      words[976 + n] = INITVAL_3D[20*n+:18];
      words[992 + n] = INITVAL_3E[20*n+:18];
      words[1008 + n] = INITVAL_3F[20*n+:18];
    end
  end

  wire [13:0] ada = {ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2,
      ADA1, ADA0};
  wire [17:0] dia = {DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6,
      DIA5, DIA4, DIA3, DIA2, DIA1, DIA0};
  wire [13:0] adb = {ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2,
      ADB1, ADB0};
  wire [17:0] dib = {DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6,
      DIB5, DIB4, DIB3, DIB2, DIB1, DIB0};

  // Place of a narrow datum in a word, and its bits.
  function [4:0] place(input integer width, input [13:0] ad);
    case (width)
      1: place = {1'b0, ad[2:0]} + (ad[3] ? 5'd9 : 5'd0);
      2: place = {2'b0, ad[2:1], 1'b0} + (ad[3] ? 5'd9 : 5'd0);
      4: place = {2'b0, ad[2], 2'b0} + (ad[3] ? 5'd9 : 5'd0);
      9: place = ad[3] ? 5'd9 : 5'd0;
      default: place = 5'd0;
    endcase
  endfunction

  function [17:0] mask(input integer width, input [13:0] ad);
    case (width)
      18, 36: mask = {{9{ad[1]}}, {9{ad[0]}}};
      default: mask = ((18'd1 << width) - 18'd1) << place(width, ad);
    endcase
  endfunction

  function [17:0] taken(input integer width, input [13:0] ad, input [17:0] word);
    taken = width >= 18 ? word : (word >> place(width, ad)) & ((18'd1 << width) - 18'd1);
  endfunction

  generate
    if (DATA_WIDTH_A == 36) begin : gen_wide  // port A writes both halves, port B reads them
      wire [13:0] upper = {ada[13:2], ada[3:2]};
      always @(posedge CLKA)
        if (CEA && WEA) begin
          words[{ada[13:5], 1'b0}] <= words[{ada[13:5], 1'b0}] & ~mask(36, ada) | dia & mask(36,
              ada);
          words[{ada[13:5], 1'b1}] <= words[{ada[13:5], 1'b1}] & ~mask(36, upper) |
              dib & mask(36, upper);
        end
      always @(posedge CLKB)
        if (CEB) begin
          qa <= words[{adb[13:5], 1'b0}];
          qb <= words[{adb[13:5], 1'b1}];
        end
    end else begin : gen_ports
      always @(posedge CLKA)
        if (CEA) begin
          if (WEA) words[ada[13:4]] <= words[ada[13:4]] & ~mask(DATA_WIDTH_A, ada) |
              (dia << place(DATA_WIDTH_A, ada)) & mask(DATA_WIDTH_A, ada);
          if (!WEA || WRITEMODE_A == "READBEFOREWRITE")
            qa <= taken(DATA_WIDTH_A, ada, words[ada[13:4]]);
        end
      always @(posedge CLKB)
        if (CEB) begin
          if (WEB) words[adb[13:4]] <= words[adb[13:4]] & ~mask(DATA_WIDTH_B, adb) |
              (dib << place(DATA_WIDTH_B, adb)) & mask(DATA_WIDTH_B, adb);
          if (!WEB || WRITEMODE_B == "READBEFOREWRITE")
            qb <= taken(DATA_WIDTH_B, adb, words[adb[13:4]]);
        end
    end
  endgenerate

  assign {DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5,
      DOA4, DOA3, DOA2, DOA1, DOA0} = qa;
  assign {DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5,
      DOB4, DOB3, DOB2, DOB1, DOB0} = qb;
endmodule

// In simulation the pin's clock is that of the chip, whatever the dividers are.
module EHXPLLL #(
    parameter PLLRST_ENA = "", INTFB_WAKE = "", STDBY_ENABLE = "", DPHASE_SOURCE = "",
    parameter OUTDIVIDER_MUXA = "", OUTDIVIDER_MUXB = "", OUTDIVIDER_MUXC = "",
    parameter OUTDIVIDER_MUXD = "", FEEDBK_PATH = "", CLKOP_ENABLE = "", CLKOS_ENABLE = "",
    parameter CLKI_DIV = 1, CLKFB_DIV = 1, CLKOP_DIV = 1, CLKOP_CPHASE = 0, CLKOP_FPHASE = 0,
    parameter CLKOS_DIV = 1, CLKOS_CPHASE = 0, CLKOS_FPHASE = 0
) (
    input CLKI, CLKFB, RST, STDBY, PHASESEL0, PHASESEL1, PHASEDIR, PHASESTEP, PHASELOADREG,
    input PLLWAKESYNC, ENCLKOP,
    output CLKOP, CLKOS, CLKINTFB, LOCK
);
  assign {CLKOP, CLKOS, CLKINTFB, LOCK} = {CLKI, CLKI, 1'b0, 1'b1};
endmodule
