// SPDX-License-Identifier: Apache-2.0
//
// One run of the two-axis machine, ready to be driven by a wiring: chip, plant, firmware, loop and
// record, and the decision when the run is over.
#pragma once

#include <memory>
#include <optional>

#include "cosim/sampled_session.hpp"
#include "machines/kung/chip/chip.hpp"
#include "machines/kung/chip/record.hpp"
#include "machines/kung/chip/soc.hpp"
#include "machines/kung/run/asked_path.hpp"
#include "machines/kung/run/detail.hpp"
#include "machines/kung/run/followed.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/recorder.hpp"
#include "machines/kung/run/serial.hpp"
#include "sw_nios/apps/kung/kung.hpp"
#include "rtl/chips/generated/kung_xy_regs.hpp"

namespace trammel::kung {

// The plant of models/ behind the interface of cosim/; the processor may raise its trip pin.
class TablePlant final : public cosim::FalliblePlant {
 public:
  explicit TablePlant(const plant::XyTableConfig& config) : table_(config) {}

  cosim::Lines sense() const override { return table_.sense() | trapped_; }
  cosim::Clk next() const override { return std::min(table_.next(), trip_); }
  void trip_from(cosim::Clk edge) { trip_ = std::min(trip_, edge); }  // the pin rises; not the past
  void commit(cosim::Clk n, cosim::Lines drive) override {
    table_.commit(n, drive);
    if (n < trip_) return;
    trapped_ = cosim::Lines{1} << kTripPin;
    trip_ = cosim::kNever;
  }
  int sample(int channel, cosim::Clk n) const override { return table_.sample(channel, n); }
  void open_phase(cosim::Clk n, int axis, int phase, bool open) override {
    table_.open_phase(n, axis, phase, open);
  }
  void supply(cosim::Clk n, double share) override { table_.supply(n, share); }
  std::optional<double> supplied(cosim::Clk n) const override {
    return table_.axis(0).supplied(n) + table_.axis(1).supplied(n);
  }

  const plant::XyTable& table() const { return table_; }

 private:
  plant::XyTable table_;
  cosim::Clk trip_ = cosim::kNever;
  cosim::Lines trapped_ = 0;
};

// The application, but while the processor hangs: then its routine only reads.
class StallableApp final : public sw::Firmware {
 public:
  StallableApp(const sw::KungSetup& setup, const cosim::Chip& chip,
               const cosim::FaultSpan& hung = {})
      : app_(setup), chip_(chip), hung_(hung) {}

  void start(sw::Bus& bus) override { app_.start(bus); }
  void isr(sw::Bus& bus) override {
    if (hung_.holds(chip_.now())) {
      bus.read(kung_xy_regs::kId);
    } else {
      app_.isr(bus);
    }
  }
  const sw::KungMailbox& mailbox() const override { return app_.mailbox(); }

 private:
  sw::KungApp app_;
  const cosim::Chip& chip_;
  cosim::FaultSpan hung_;
};

class Session final : public cosim::SessionOf<cosim::Rig> {
 public:
  // Throws OptionsError or std::invalid_argument for options that cannot run.
  Session(const Options& options, const Hooks& hooks, const cosim::Waves& waves = {});

  sw::Firmware& firmware() override { return *firmware_; }
  cosim::ProcessorTiming timing() const override;
  cosim::Core* core() override { return core_.get(); }
  void trapped(const cosim::CoreTrap& trap) override;
  void core_ran(const cosim::CoreTimes& times) override;
  bool finished() const override { return recorder_->done(); }
  std::vector<cosim::Place> places() const override;
  std::unique_ptr<cosim::RunResult> result() override;

  const KungChip& chip() const { return *chip_; }

 private:
  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant& plant) override;
  bool drives_off() const override { return chip_->drive() == 0; }
  std::string noticed() const override;
  cosim::FaultTruth truth(cosim::Clk edge) const override;

  cosim::FaultSpan hung() const;  // when the processor is; else never
  bool over(const Sample& sample);
  bool swings(const Sample& sample);
  void watch_limits(const Sample& sample);
  bool fault_is_over(const Sample& sample);

  std::unique_ptr<KungChip> make_chip();
  void make_core(const sw::KungSetup& setup);
  const sw::Mailbox& mailbox() const;

  Options options_;
  std::shared_ptr<const Plan> plan_;
  sw::Corrections corrections_;
  std::unique_ptr<TablePlant> plant_;
  std::unique_ptr<KungChip> chip_;
  std::unique_ptr<StallableApp> firmware_;
  std::unique_ptr<SocCore> core_;  // in its place
  std::unique_ptr<SerialConsole> console_;
  std::unique_ptr<DetailRecorder> detail_;
  std::unique_ptr<Recorder> recorder_;
  std::optional<AskedPath> asked_;
  std::optional<Followed> followed_;
  std::uint32_t path_points_ = 0;  // of the whole path
  std::uint32_t after_fault_ = 0;
  std::array<std::uint32_t, 2> mass_limited_{};  // up to now
  std::string trap_text_;
  Result result_;
};

}  // namespace trammel::kung
