// SPDX-License-Identifier: Apache-2.0
//
// Words, instruction format and program of control/precision. An instruction is executed for axis
// X, then for axis Y; what it computes,
//   acc = fit((acc or 0) +- operand),   operand = a stored word, or x times f with its shift,
// is the acc of the next instruction, the x of the second after it, and can be read as a stored
// word by the third.

package precision_pkg;

  localparam int unsigned SumWidth = 52;   // the largest term, K1 e1 << 15, has 50 bits
  localparam int unsigned WordWidth = 48;  // of memory
  localparam int unsigned XWidth = 35;     // a product of mantissa and 24 bits

  typedef logic signed [SumWidth-1:0] sum_t;
  typedef logic signed [WordWidth-1:0] store_t;
  typedef logic signed [XWidth-1:0] x_t;
  typedef logic signed [17:0] factor_t;
  typedef logic [6:0] address_t;  // {axis, word}

  typedef enum logic [5:0] {
    WC      = 6'd0,   // taken at a knot: control point,
    WIff    = 6'd1,   // feed-forward current,
    WKm     = 6'd2,   // current per acceleration,
    WKmi    = 6'd3,   // its inverse,
    WRatio  = 6'd4,   // change of the mass,
    WKb     = 6'd5,   // current per speed,
    WFc     = 6'd6,   // Coulomb friction
    WL1     = 6'd8,   // taken at a tick: gains of the observer
    WL2     = 6'd9,
    WL3     = 6'd10,
    WK1     = 6'd11,  // and of the feedback
    WK2     = 6'd12,
    WMisc   = 6'd13,
    E1      = 6'd16,  // observer
    E2      = 6'd17,
    D       = 6'd18,
    Acc     = 6'd19,  // feedback
    Vff     = 6'd20,  // speed ahead
    P15     = 6'd21,  // set point, Q8
    Y       = 6'd22,  // position
    C1      = 6'd32,  // control points in effect
    C2      = 6'd33,
    C3      = 6'd34,
    P       = 6'd35,  // spline
    V       = 6'd36,
    A       = 6'd37,
    J       = 6'd38,
    Iacc    = 6'd39,  // ramp of the current
    Istep   = 6'd40,
    Iff     = 6'd41,
    U1      = 6'd42,  // feedback that acted
    U2      = 6'd43,
    Um      = 6'd44,
    Km      = 6'd45,  // in effect
    Kmi     = 6'd46,
    Kb      = 6'd47,
    Fc      = 6'd48,
    V24     = 6'd49,
    A24     = 6'd50,
    Aff     = 6'd51,  // acceleration ahead
    T1      = 6'd52,
    T2      = 6'd53,
    E       = 6'd54,
    ErrSum  = 6'd55,
    IqSum   = 6'd56,
    Iq      = 6'd57,
    I8      = 6'd58,
    ErrLast = 6'd59,  // sums of the last knot
    IqLast  = 6'd60,
    Dist    = 6'd61,
    Knots   = 6'd62,
    Zero    = 6'd63   // never written
  } word_e;

  typedef enum logic [1:0] {XWord, XAcc, XCount, XSmall} x_e;  // small: 1, or the age for FAge

  typedef enum logic [3:0] {
    FPower,  // 2^k of the instruction's shift
    FExp,    // 2^k of the exponent in the word and the instruction's shift
    FKnee,   // 2^KNEE
    FMant,
    FLead,
    FHyst,
    FTime,   // 18 bits
    FRatio,  // 16 bits
    FAge     // 5369: ticks of 2^-12 per clock, and its 12 bits
  } factor_e;

  // {the last acc is a term, subtract, subtract if the last edge was up, if it was down}
  typedef enum logic [3:0] {
    Load     = 4'b0000,
    LoadNeg  = 4'b0100,
    Plus     = 4'b1000,
    Minus    = 4'b1100,
    MinusUp  = 4'b1010,
    MinusDn  = 4'b1001
  } add_e;

  // {above 0 becomes 0, below 0 becomes 0, saturate, at 24 bits or less, 20, 18, 12}
  typedef enum logic [6:0] {
    Free  = 7'b0000000,
    Low   = 7'b1000000,
    High  = 7'b0100000,
    Sat35 = 7'b0010000,
    Sat24 = 7'b0011000,
    Sat20 = 7'b0011100,
    Sat18 = 7'b0011110,
    Sat12 = 7'b0011111
  } fit_e;

  typedef enum logic [1:0] {Any, IfFresh, IfRest, IfSat} only_e;  // else the operand is 0

  // When the result is stored. In reset everything is 0 but what InReset stores.
  typedef enum logic [2:0] {
    Never,
    Always,
    InReset,
    AtKnot,    // and in reset, as 0
    AtCommit,  // at a knot with new words; and in reset, as 0
    WhenTaken, // at a knot with new words
    AtCoast,   // at a knot without: the first and second in a row
    AtHold     // and those after them
  } when_e;

  typedef enum logic [2:0] {NoNote, NoteA, NoteV, NoteClip, NoteSat, NoteOut} note_e;

  typedef struct packed {
    word_e      read;
    logic       wide;   // the operand is the word itself
    x_e         x;
    factor_e    f;
    logic [5:0] shift;  // 32 + left, or 32 - right, of the product; for FExp at exponent 0
    only_e      only;
  } operand_t;

  typedef struct packed {
    fit_e  fit;
    when_e store;
    word_e write;
    note_e note;
    logic  last;
  } effect_t;

  typedef struct packed {
    operand_t operand;
    add_e     add;
    effect_t  effect;
  } instr_t;

  // ---- operands ----

  function automatic operand_t full(word_e w);  // 48 bits
    return {w, 1'b1, XWord, FPower, 6'd32, Any};
  endfunction

  function automatic operand_t left(x_e x, word_e w, logic [5:0] n, only_e only = Any);
    return {w, 1'b0, x, FPower, 6'd32 + n, only};
  endfunction

  function automatic operand_t right(x_e x, word_e w, logic [5:0] n, only_e only = Any);
    return {w, 1'b0, x, FPower, 6'd32 - n, only};
  endfunction

  function automatic operand_t by(factor_e f, word_e w, x_e x = XAcc, only_e only = Any);
    return {w, 1'b0, x, f, 6'd32, only};
  endfunction

  function automatic operand_t ratio(word_e w);  // acc is doubled: by 2^-15 in all
    return {w, 1'b0, XAcc, FRatio, 6'd16, Any};
  endfunction

  // acc times the gain's power of two, shifted right by n + 3
  function automatic operand_t scaled(word_e w, logic [5:0] n, only_e only = Any);
    return {w, 1'b0, XAcc, FExp, 6'd35 - n, only};
  endfunction

  function automatic instr_t one(operand_t operand, add_e add = Load, fit_e fit = Free,
                                 word_e write = Zero, when_e store = Never, note_e note = NoNote,
                                 logic last = 1'b0);
    return {operand, add, fit, store, write, note, last};
  endfunction

  // ---- program: at a knot or in reset from 0, else from Tick ----

  localparam int unsigned Size = 136;
  localparam int unsigned Tick = 24;

  localparam instr_t Program[Size] = '{
      // item 1: the new control point,
      one(left(XWord, C1, 1)),
      one(left(XWord, C2, 0), Minus, Free, T1, AtCoast),
      one(left(XWord, WC, 0), Load, Free, T1, AtCommit),
      one(full(C1), Load, Free, T1, AtHold),
      // j = C - 3 c1 + 3 c2 - c3,
      one(left(XWord, C2, 1)),
      one(left(XWord, C2, 0), Plus),
      one(left(XWord, C1, 0), Minus),
      one(left(XWord, C1, 1), Minus),
      one(left(XWord, C3, 0), Minus),
      one(left(XWord, T1, 0), Plus, Free, J, AtKnot),
      one(full(C2), Load, Free, C3, AtKnot),
      one(full(C1), Load, Free, C2, AtKnot),
      one(full(T1), Load, Free, C1, AtKnot),
      // the ramp of the current, the sums
      one(left(XWord, Iff, 5), Load, Free, Iacc, AtKnot),
      one(full(Zero), Load, Free, Istep, AtKnot),
      one(left(XWord, WIff, 0), Load, Sat20),
      one(full(Iff), Minus, Free, Istep, AtCommit),
      one(left(XWord, WIff, 0), Load, Sat20, Iff, AtCommit),
      one(full(ErrSum), Load, Free, ErrLast, AtKnot),
      one(full(IqSum), Load, Free, IqLast, AtKnot),
      one(full(Zero), Load, Free, ErrSum, AtKnot),
      one(full(Zero), Load, Free, IqSum, AtKnot),
      one(full(Knots)),
      one(left(XSmall, Zero, 0), Plus, Free, Knots, AtKnot),
      // item 2
      one(full(A)),
      one(full(J), Plus, Free, A, Always),
      one(full(V), Plus, Free, V, Always),
      one(full(P), Plus, Free, P, Always),
      one(full(Iacc)),
      one(full(Istep), Plus, Free, Iacc, Always),
      // v24, a24, vff
      one(full(V), Load, Sat35),
      one(full(A), Load, Sat24, A24, Always, NoteA),
      one(right(XAcc, Zero, 9), Load, Sat24, V24, Always, NoteV),
      one(by(FLead, WMisc)),
      one(full(D), Load, Free, Dist, AtKnot),
      one(right(XAcc, Zero, 9)),
      one(full(V24), Plus, Sat24, Vff, Always),
      // item 3: the widest excursion, the time since the edge, the way since then, its limits
      one(left(XSmall, Zero, 7)),
      one(by(FHyst, WMisc, XSmall), Plus, Free, T2, Always),
      one(by(FAge, Zero, XSmall)),
      one(full(J), Load, Sat18),
      one(right(XAcc, Zero, 12), Load, Free, T1, Always),
      one(by(FLead, WMisc)),
      one(full(A24), Plus),
      one(full(V24)),
      one(left(XAcc, Zero, 3), Load, Sat24, Aff, Always),  // item 5
      one(by(FTime, T1), Load, Sat35),
      one(full(WKm), Load, Free, Km, AtCommit),
      one(right(XAcc, Zero, 18, IfFresh), Load, Sat12),
      one(left(XSmall, Zero, 7, IfFresh), MinusUp),
      one(by(FHyst, WMisc, XSmall, IfFresh), MinusDn),
      one(full(T2), Minus, Low),
      one(left(XWord, T2, 1), Plus, High),
      one(full(T2), Minus),
      one(left(XCount, Zero, 8), Plus, Free, Y, Always),
      // items 4 and 6: e; the disturbance after a change of the mass
      one(full(P)),
      one(left(XAcc, Zero, 15), Minus, Free, T1, Always),
      one(full(Aff)),
      one(full(D), Plus, Sat24),
      one(full(T1), Load, Sat35),
      one(left(XAcc, Zero, 1)),
      one(right(XAcc, Zero, 15), Load, Sat20, E, Always, NoteClip),
      one(ratio(WRatio)),
      one(full(D), Plus, Sat24, D, AtCommit),
      // item 7
      one(full(E)),
      one(left(XSmall, Zero, 7, IfRest), Minus, High, T1, Always),
      one(full(E)),
      one(left(XSmall, Zero, 7, IfRest), Plus, Low),
      one(full(T1), Plus),
      one(full(WFc), Load, High, Fc, AtCommit),
      one(left(XAcc, Zero, 4)),
      one(full(E1), Minus, Sat24, T2, Always),
      // item 8
      one(full(Zero), Load, Free, WRatio, WhenTaken),
      one(by(FMant, WL1)),
      one(full(E1)),
      one(scaled(WL1, 14), Plus, Sat24, E1, Always),
      one(full(T2)),
      one(full(WKb), Load, Free, Kb, AtCommit),
      one(by(FMant, WL2)),
      one(full(E2)),
      one(scaled(WL2, 6), Plus, Sat24, E2, Always),
      one(full(T2)),
      one(full(WKmi), Load, Free, Kmi, AtCommit),
      one(by(FMant, WL3)),
      one(full(D)),
      one(scaled(WL3, 0), Plus, Sat24, D, Always),
      // item 12: what acted, with the lag of the current loop
      one(full(U2)),
      one(full(Um), Minus),
      one(full(U1), Load, Free, U2, Always),
      one(right(XAcc, Zero, 2)),
      one(full(Um), Plus, Free, Um, Always),
      // item 9
      one(full(E1)),
      one(full(E2)),
      one(by(FMant, WK1)),
      one(by(FMant, WK2)),
      one(scaled(WK1, 0)),
      one(scaled(WK2, 8), Plus),
      one(full(D), Plus, Sat24, Acc, Always),
      // item 10
      one(full(Aff), Plus, Sat24),
      one(full(Vff)),
      one(by(FMant, Km)),
      one(by(FMant, Kb)),
      one(scaled(Km, 14)),
      one(scaled(Kb, 14), Plus, Free, T1, Always),
      one(full(Vff)),
      one(full(Zero)),
      one(by(FKnee, WMisc), Load, Sat24),
      one(left(XWord, Fc, 0), Minus, Low),
      one(left(XWord, Fc, 1), Plus, High),
      one(left(XWord, Fc, 0), Minus),
      one(full(T1), Plus),
      one(right(XWord, Iacc, 5), Plus, Sat24, I8, Always),
      one(left(XCount, Zero, 8), Load, Free, C3, InReset),
      one(right(XAcc, Zero, 8), Load, Sat12, Iq, Always, NoteSat),
      one(left(XAcc, Zero, 15), Load, Free, P, InReset),
      // item 11
      one(left(XAcc, Zero, 8), LoadNeg),
      one(full(I8), Plus),
      one(left(XCount, Zero, 8), Load, Free, C1, InReset),
      one(by(FMant, Kmi)),
      one(full(Acc)),
      one(scaled(Kmi, 14, IfSat), Minus, Sat24, U1, Always),
      // item 12
      one(full(D)),
      one(full(Um), Minus),
      one(left(XCount, Zero, 8), Load, Free, C2, InReset),
      one(right(XAcc, Zero, 6)),
      one(full(E2), Plus, Sat24, E2, Always),
      one(full(Zero)),
      one(right(XAcc, Zero, 8)),
      one(full(E1), Plus, Sat24, E1, Always),
      // item 13
      one(full(ErrSum)),
      one(full(E), Plus, Free, ErrSum, Always),
      one(full(IqSum)),
      one(full(Iq), Plus, Free, IqSum, Always),
      one(full(Y)),
      one(full(E), Plus, Free, P15, Always),
      one(full(Iq), Load, Free, Zero, Never, NoteOut, 1'b1)
  };

endpackage
