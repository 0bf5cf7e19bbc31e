// SPDX-License-Identifier: Apache-2.0
//
// The bit-exact twin of the chip behind the interface that the verilated one has.
#include "machines/kung/chip/chip.hpp"
#include "models/exact/chips/kung_xy.hpp"

namespace trammel::kung {

namespace {

using exact::KungXy;

class TwinChip final : public KungChip {
 public:
  cosim::Clk now() const override { return chip_.now(); }
  void sense(cosim::Lines lines) override { chip_.pins(lines); }
  void request(const cosim::BusOp& op) override { chip_.request({op.addr, op.data, op.write}); }

  cosim::Stop run(cosim::Clk end, const cosim::Plant& plant) override {
    const KungXy::Stop stop = chip_.run(end, Converters(plant));
    return {stop.edge, why(stop.events)};
  }

  cosim::Lines drive() const override { return chip_.gates(); }
  bool irq() const override { return chip_.irq(); }
  std::uint32_t rdata() const override { return chip_.read_data(); }

  void read_words(int axis, AxisSample& s) const override {
    const exact::Afc& afc = chip_.afc(axis);
    const exact::Afc::Out& p = afc.out();
    const exact::CurrentLoop::Out& c = chip_.current(axis).out();
    s.r = afc.r();
    s.x_p = afc.x_p();
    s.x_m = p.x_m;
    s.x_r = p.x_r;
    s.dx = p.dx;
    s.e = p.e;
    s.de = p.de;
    s.u = p.u;
    s.v_star = p.v_star;
    s.v = p.v;
    s.i_q_ref = p.i_q_ref;
    s.i_d = c.i_d;
    s.i_q = c.i_q;
    s.v_d = c.v_d;
    s.v_q = c.v_q;
    if (!chip_.is_precise(axis)) return;
    s.x_p = chip_.position(axis);
    s.i_q_ref = chip_.precision().out(axis).i_q_ref;
    show_precision(chip_.precision().set_point(axis),
                   chip_.precision().word(axis, exact::PrecisionStore::Word::kV24), s);
  }

  AxisLaw law(int axis) const override {
    if (!chip_.is_precise(axis)) return {};
    const exact::Precision::State& s = chip_.precision().law(axis);
    const auto word = [](std::int64_t of) { return static_cast<std::int32_t>(of); };
    return {word(s.d),    word(s.acc), word(s.aff), word(s.vff),
            word(s.iacc), s.km,        s.kb,        word(s.fc)};
  }

  CurrentWords current(int axis) const override {
    const exact::KungCurrent& loop = chip_.current(axis);
    const exact::CurrentLoop::Out& out = loop.out();
    CurrentWords words;
    words.code_a = loop.codes()[0];
    words.code_b = loop.codes()[1];
    words.count = loop.count();
    words.i_q_ref = loop.i_q_ref();
    words.cmp_a = out.cmp_a;
    words.cmp_b = out.cmp_b;
    words.cmp_c = out.cmp_c;
    words.i_d = out.i_d;
    words.i_q = out.i_q;
    words.v_d = out.v_d;
    words.v_q = out.v_q;
    words.busy = loop.busy(chip_.now() - 1);
    words.clear = loop.cleared();
    return words;
  }

  std::int32_t rule(int axis, int index) const override { return chip_.afc(axis).rule(index); }
  std::int32_t integral(int axis) const override { return chip_.afc(axis).integral(); }
  Fault fault() const override {
    const exact::Supervisor::Out& fault = chip_.fault();
    return {static_cast<FaultCode>(fault.code), fault.axis ? 1 : 0, fault.tick};
  }
  cosim::Clk evaluated() const override { return chip_.events(); }

 private:
  class Converters final : public KungXy::Converters {
   public:
    explicit Converters(const cosim::Plant& plant) : plant_(plant) {}
    std::array<std::int32_t, 2> hold(int axis, exact::Clk edge) const override {
      return {plant_.sample(adc_channel(axis, 0), edge), plant_.sample(adc_channel(axis, 1), edge)};
    }

   private:
    const cosim::Plant& plant_;
  };

  static unsigned why(unsigned events) {
    if (events == 0) return cosim::kLimit;
    static_assert(KungXy::kGates << 1 == cosim::kDrive && KungXy::kIrq << 1 == cosim::kIrq &&
                      KungXy::kBusDone << 1 == cosim::kBusDone &&
                      KungXy::kTick << 1 == cosim::kTick && KungXy::kSample << 1 == cosim::kSample,
                  "the same reasons in the same order");
    return events << 1;
  }

  KungXy chip_;
};

}  // namespace

std::unique_ptr<KungChip> make_twin_chip() { return std::make_unique<TwinChip>(); }

}  // namespace trammel::kung
