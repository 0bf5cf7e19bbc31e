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
#include "machines/kung/run/commanded_path.hpp"
#include "machines/kung/run/snapshot.hpp"
#include "machines/kung/run/outcome.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/plant.hpp"
#include "machines/kung/run/recorder.hpp"
#include "machines/kung/run/serial.hpp"
#include "machines/kung/run/stallable_app.hpp"
#include "machines/kung/precision/limits.hpp"

namespace trammel::kung {

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
  std::string detected_by() const override;
  cosim::FaultTruth truth(cosim::Clk edge) const override;

  cosim::FaultSpan hung() const;  // when the processor is; else never
  bool over(const Sample& sample);
  bool fault_is_over(const Sample& sample);

  std::unique_ptr<KungChip> make_chip();
  const sw::Mailbox& mailbox() const;

  Options options_;
  std::shared_ptr<const Plan> plan_;
  sw::Corrections corrections_;
  std::unique_ptr<TablePlant> plant_;
  std::unique_ptr<KungChip> chip_;
  std::unique_ptr<StallableApp> firmware_;
  std::unique_ptr<SocCore> core_;  // in its place
  std::unique_ptr<SerialConsole> console_;
  std::unique_ptr<SnapshotRecorder> snapshot_;
  std::unique_ptr<Recorder> recorder_;
  std::optional<CommandedPath> commanded_;
  std::optional<Outcome> outcome_;
  std::uint32_t path_points_ = 0;  // of the whole path
  std::uint32_t after_fault_ = 0;
  LimitWatch limits_;
  std::string trap_text_;
  Result result_;
};

}  // namespace trammel::kung
