// SPDX-License-Identifier: Apache-2.0
//
// The bit-exact twin of the chip behind the interface that the verilated one has.
#include "machines/kung/chip/chip.hpp"
#include "machines/kung/chip/twin_words.hpp"

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

  void read_words(int axis, AxisSample& s) const override { twin_words(chip_, axis, s); }
  AxisLaw law(int axis) const override { return twin_law(chip_, axis); }
  CurrentWords current(int axis) const override { return twin_current(chip_, axis); }
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
