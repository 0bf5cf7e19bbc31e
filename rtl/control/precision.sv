// SPDX-License-Identifier: Apache-2.0
//
// Precision controller of both axes (docs/precision.md, sections 2 to 6):
// spline, position between the counts, observer, feed-forward and feedback, at every 16 kHz tick.
// One 35 x 18 multiplier, one adder, all words in block memory; precision_pkg has the program. The
// axes take turns: each instruction is executed for X, then for Y, and so passes five stages, of
// which none waits for the one before:
//   read    stored word
//   factor  x and f           multiply  x f
//   sum     (acc or 0) +- the product or the word, with the rounding carry of its shift
//   fit     saturation; acc, memory
// 229 clocks from the tick, 277 at a knot or in reset; then both i_q* change at once.

module precision
  import trammel_pkg::*;
  import precision_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,      // 16 kHz
    input logic tick_pos_i,  // and 2 kHz

    input logic [1:0] enable_i,  // of each axis; with none the law does not run
    input logic [1:0] reset_i,
    input logic       commit_i,

    input count_t [1:0]       count_i,  // what the tick sees, until the next
    input logic   [1:0][ 3:0] ticks_i,  // of edge_time
    input logic   [1:0][15:0] age_i,
    input logic   [1:0]       up_i,

    input  logic            request_i,  // of the bus, see precision_store
    input  logic            request_we_i,
    input  address_t        request_addr_i,
    input  logic     [31:0] request_data_i,
    output logic            ack_o,
    output logic     [31:0] rdata_o,

    output logic        busy_o,
    output logic        done_o,
    output logic        overrun_o,    // a tick came while the law ran
    output logic        underrun_o,   // a knot came without a COMMIT
    output logic  [1:0] saturated_o,  // with done_o
    output logic  [1:0] clipped_o,
    output word_t [1:0] i_q_ref_o,
    output logic        quiescent_o
);

  // ---- knots ----

  logic [1:0] off, asked_q, asked_d, resetting_q, resetting_d;
  logic start, knot, taken, coast, hold, knots_quiescent;

  assign off   = reset_i | ~enable_i;
  assign start = tick_i && enable_i != '0 && !busy_o;

  precision_knots u_knots (
      .clk_i,
      .rst_i,
      .tick_i     (start),
      .tick_pos_i,
      .commit_i,
      .off_i      (off == '1),
      .knot_o     (knot),
      .taken_o    (taken),
      .coast_o    (coast),
      .hold_o     (hold),
      .underrun_o,
      .quiescent_o(knots_quiescent)
  );

  // An axis starts a run in reset if it was off since the last one.
  assign asked_d     = start ? '0 : asked_q | off;
  assign resetting_d = start ? asked_q | off : resetting_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      asked_q     <= '1;
      resetting_q <= '0;
    end else begin
      asked_q     <= asked_d;
      resetting_q <= resetting_d;
    end
  end

  // ---- sequence ----

  localparam int unsigned CodeBits = 8;

  logic running_q, axis_q;  // axis_q: that of the factor and sum stages
  logic reads_q, factors_q, multiplies_q, sums_q, fits_q, done_q;
  logic [CodeBits-1:0] pc_q;
  instr_t code_q[2**CodeBits];
  instr_t instr_q, factor_q;
  add_e add_multiply_q;
  logic [2:0] minus_q;  // always, if the last edge was up, if it was down
  effect_t effect_multiply_q, effect_sum_q, effect_q;
  initial begin
    for (int unsigned i = 0; i < 2**CodeBits; i++) code_q[i] = Program[i < Size ? i : Size-1];
  end

  logic fetch;
  assign fetch  = running_q && !axis_q;
  assign busy_o = running_q || reads_q || factors_q || multiplies_q || sums_q || fits_q;

  always_ff @(posedge clk_i) if (fetch) instr_q <= code_q[pc_q];

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      {running_q, reads_q, factors_q, multiplies_q, sums_q, fits_q, done_q} <= '0;
      axis_q <= 1'b0;
      pc_q   <= '0;
    end else begin
      axis_q <= busy_o && !axis_q;
      if (start) begin
        running_q <= 1'b1;
        axis_q    <= 1'b0;
        pc_q      <= knot || resetting_d != '0 ? '0 : CodeBits'(Tick);
      end else if (running_q && axis_q) begin
        running_q <= !instr_q.effect.last;
        pc_q      <= pc_q + 1'b1;
      end
      reads_q      <= running_q;
      factors_q    <= reads_q;
      multiplies_q <= factors_q;
      sums_q       <= multiplies_q;
      fits_q       <= sums_q;
      done_q       <= fits_q && axis_q == 1'b0 && effect_q.last;
    end
  end

  always_ff @(posedge clk_i) begin
    if (reads_q) factor_q <= instr_q;
    if (factors_q) {add_multiply_q, effect_multiply_q} <= {factor_q.add, factor_q.effect};
    if (multiplies_q) {minus_q, effect_sum_q} <= {add_multiply_q[2:0], effect_multiply_q};
    if (sums_q) effect_q <= effect_sum_q;
  end

  // ---- words ----

  store_t word;
  logic write, store_quiescent;
  sum_t result;

  precision_store u_store (
      .clk_i,
      .rst_i,
      .hold_i        (busy_o),
      .read_i        (reads_q),
      .read_addr_i   ({!axis_q, instr_q.operand.read}),
      .word_o        (word),
      .write_i       (write),
      .write_addr_i  ({!axis_q, effect_q.write}),
      .write_data_i  (result[WordWidth-1:0]),
      .request_i,
      .request_we_i,
      .request_addr_i,
      .request_data_i,
      .ack_o,
      .rdata_o,
      .quiescent_o   (store_quiescent)
  );

  // ---- factor stage ----

  x_t acc_q, x, x_q;
  factor_t f, f_q;
  logic [5:0] shift;
  logic [1:0] place, place_q, place_sum_q;  // of the product: >> 32, >> 16, >> 0; 3: the word
  store_t wide_q, wide_sum_q;
  logic [1:0] fresh_q, rests_q, rest_q, saturated_q;  // conditions of an axis
  logic only;

  always_comb begin
    unique case (factor_q.operand.x)
      XWord:   x = word[XWidth-1:0];
      XAcc:    x = acc_q;
      XCount:  x = x_t'(count_i[axis_q]);
      default: x = factor_q.operand.f == FAge ? x_t'({1'b0, age_i[axis_q]}) : x_t'(1);
    endcase
  end

  always_comb begin
    shift = factor_q.operand.shift;
    if (factor_q.operand.f == FExp) shift = shift + 6'($signed(word[20:16]));
    if (factor_q.operand.f == FKnee) shift = {2'b10, word[7:4]};
    place = {shift[5], shift[4] && !shift[5]};
    if (factor_q.operand.wide) place = 2'd3;
    unique case (factor_q.operand.f)
      FMant:   f = {7'd0, word[10:0]};
      FLead:   f = {14'd0, word[3:0]};
      FHyst:   f = {10'd0, word[19:12]};
      FTime:   f = word[17:0];
      FRatio:  f = {{2{word[15]}}, word[15:0]};
      FAge:    f = 18'sd5369;
      default: f = factor_t'(18'd1 << shift[3:0]);
    endcase
    unique case (factor_q.operand.only)
      IfFresh: only = fresh_q[axis_q];
      IfRest:  only = rest_q[axis_q];
      IfSat:   only = saturated_q[axis_q];
      default: only = 1'b1;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (factors_q) begin
      x_q     <= x;
      f_q     <= only ? f : '0;
      place_q <= place;
      wide_q  <= word;
    end
  end

  // ---- multiply stage ----

  logic signed [XWidth+17:0] product_q;

  always_ff @(posedge clk_i) begin
    if (multiplies_q) begin
      product_q   <= x_q * f_q;
      place_sum_q <= place_q;
      wide_sum_q  <= wide_q;
    end
  end

  // ---- sum stage ----

  sum_t first_q, operand, total_q;
  logic half, minus, carry, unused_sum;

  always_comb begin
    unique case (place_sum_q)
      2'd0:    {operand, half} = (SumWidth+1)'($signed(product_q[XWidth+17:31]));
      2'd1:    {operand, half} = (SumWidth+1)'($signed(product_q[XWidth+17:15]));
      2'd2:    {operand, half} = {product_q[SumWidth-1:0], 1'b0};
      default: {operand, half} = {sum_t'(wide_sum_q), 1'b0};
    endcase
    minus = minus_q[2] || (minus_q[1] && up_i[axis_q]) || (minus_q[0] && !up_i[axis_q]);
    carry = half ^ minus;
  end

  sum_t total;
  assign {total, unused_sum} = {first_q, 1'b1} + {operand ^ {SumWidth{minus}}, carry};

  always_ff @(posedge clk_i) if (sums_q) total_q <= total;

  // ---- fit stage ----

  logic below, above, saturates, forced;
  logic [3:0] narrow;  // at 24 bits or less, 20, 18, 12
  logic [3:0] out;     // bits there that differ from the sign: 35..., 24..34, 20..23, ...

  assign below  = total_q[SumWidth-1];
  assign narrow = effect_q.fit[3:0];

  assign out[3] = total_q[33:23] != {11{below}};
  assign out[2] = total_q[22:19] != {4{below}};
  assign out[1] = total_q[18:17] != {2{below}};
  assign out[0] = total_q[16:11] != {6{below}};
  assign above  = total_q[SumWidth-2:34] != {SumWidth - 35{below}};
  assign saturates = effect_q.fit[4] && (above || (out & narrow) != '0);

  assign forced = (resetting_q[!axis_q] && effect_q.store != InReset) ||
      (effect_q.fit[6] && !below) || (effect_q.fit[5] && below);

  always_comb begin
    result = total_q;
    if (saturates) begin
      result = {SumWidth{below}};
      result[10:0] = {11{!below}};
      result[16:11] = {6{below == narrow[0]}};
      result[18:17] = {2{below == narrow[1]}};
      result[22:19] = {4{below == narrow[2]}};
      result[33:23] = {11{below == narrow[3]}};
    end
    if (forced) result = '0;
  end

  always_comb begin
    unique case (effect_q.store)
      Always:    write = 1'b1;
      InReset:   write = resetting_q[!axis_q];
      AtKnot:    write = taken || coast || hold || resetting_q[!axis_q];
      AtCommit:  write = taken || resetting_q[!axis_q];
      WhenTaken: write = taken;
      AtCoast:   write = coast;
      AtHold:    write = hold;
      default:   write = 1'b0;
    endcase
    write = write && fits_q;
  end

  // acc_q is the x of the second instruction after, first_q the first term of the next one.
  always_ff @(posedge clk_i) begin
    if (fits_q) acc_q <= result[XWidth-1:0];
    if (multiplies_q) first_q <= add_multiply_q[3] ? result : '0;
  end

  // ---- conditions ----

  logic zero, moving;
  logic [1:0] clipped_q;
  logic [1:0][3:0] sub_ticks_q;
  logic [1:0] may_rest_q;
  logic axis;  // in the fit stage
  word_t i_q_x_q;
  word_t [1:0] i_q_ref_q;

  assign zero = result[23:0] == '0;
  assign axis = !axis_q;
  assign moving = result[23] != up_i[axis] && !zero;  // v24 goes the way of the edge

  always_ff @(posedge clk_i) begin
    if (factors_q && factor_q.operand.f == FLead) begin
      sub_ticks_q[axis_q] <= word[11:8];
      may_rest_q[axis_q]  <= word[20];
    end
    if (fits_q) begin
      unique case (effect_q.note)
        NoteA:    rests_q[axis] <= zero;
        NoteV: begin
          fresh_q[axis] <= moving && ticks_i[axis] < sub_ticks_q[axis];
          rest_q[axis]  <= zero && rests_q[axis] && may_rest_q[axis];
        end
        NoteClip: clipped_q[axis] <= saturates && !forced;
        NoteSat:  saturated_q[axis] <= saturates && !forced;
        NoteOut:  i_q_x_q <= result[11:0];
        default:  ;
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) i_q_ref_q <= '0;
    else if (fits_q && effect_q.last && axis) i_q_ref_q <= {result[11:0], i_q_x_q};
  end

  assign done_o      = done_q;
  assign overrun_o   = tick_i && enable_i != '0 && busy_o;
  assign saturated_o = saturated_q & {2{done_q}};
  assign clipped_o   = clipped_q & {2{done_q}};
  assign i_q_ref_o   = i_q_ref_q;
  assign quiescent_o = !busy_o && !start && !done_q && store_quiescent && knots_quiescent &&
      asked_d == asked_q;

endmodule
