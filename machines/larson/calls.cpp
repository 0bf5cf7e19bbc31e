// SPDX-License-Identifier: Apache-2.0
#include "machines/larson/calls.hpp"

#include <cmath>

#include "machines/larson/machine_members.hpp"
#include "sw_nios/apps/larson/larson_map.hpp"

namespace trammel::larson {
namespace {

sw::StepTableSetup table_of(const Options& options) {
  const auto clocks = [&options](double ms) {
    return static_cast<std::uint32_t>(options.run.clocks(1e-3 * ms));
  };
  sw::StepTableSetup table = options.table;
  table.poll_clk = clocks(options.poll_ms);
  table.settle_clk = clocks(options.wttbl_ms);
  return table;
}

std::vector<sw::LarsonCall> program_of(const std::vector<Call>& calls) {
  std::vector<sw::LarsonCall> program;
  program.reserve(calls.size());
  for (const Call& one : calls) program.push_back(one.call);
  return program;
}

}  // namespace

Calls::Calls(const Options& options, const LarsonChip& chip, const TablePlant& plant)
    : chip_(chip),
      plant_(plant),
      lean_(options.perpendicularity_arcsec),
      table_(table_of(options)),
      calls_(calls_of(options)),
      program_(program_of(calls_)),
      answers_(calls_.size()),
      heard_(heard_at(0)) {}

bool Calls::moving(std::size_t axis) const {
  const bool busy =
      (chip_.words(static_cast<int>(axis)) >> 16 & sw::larson_map::kBusy) != 0;
  return busy || plant_.axis(axis).waiting() > 0;
}

bool Calls::late(cosim::Clk begin) const {
  for (std::size_t k = 0; k < done_.size(); ++k) {
    if (calls_[k].call.op == sw::LarsonOp::kWttbl && answers_[k].value == 0 &&
        done_[k].edge >= begin) {
      return true;
    }
  }
  return false;
}

// [step] The Y axis leans by its perpendicularity.
std::array<double, 2> Calls::platform(cosim::Clk edge) const {
  const double lean = std::tan(lean_ / 3600 * 0.017453292519943295);
  const double y = plant_.axis(1).platform(edge);
  return {plant_.axis(0).platform(edge) + lean * y, y};
}

CallDone Calls::heard_at(cosim::Clk edge) const {
  return {edge, {plant_.at(0, edge), plant_.at(1, edge)}, platform(edge), {moving(0), moving(1)}};
}

// Calls that have ended since the last stop: when the processor last heard of the chip, which is
// the same in every wiring; a stop is where the look-ahead happens to end.
void Calls::note(const sw::Mailbox& mailbox) {
  while (done_.size() < mailbox.point) {
    if (calls_[done_.size()].call.op == sw::LarsonOp::kCaltbl) {
      for (std::size_t k = 0; k < 2; ++k) {
        const plant::StepperAxis& axis = plant_.axis(k);  // the last pulses are forward
        origin_[k] =
            static_cast<double>(axis.translated() + axis.waiting() - axis.steps_lost());
      }
    }
    CallDone done = heard_;
    for (std::size_t k = 0; k < 2; ++k) {
      done.at[k] -= origin_[k];
      done.platform[k] -= origin_[k];
    }
    done_.push_back(done);
  }
  if (mailbox.done != 0 && ended_ == cosim::kNever) ended_ = heard_.edge;
}

void Calls::give(Result& result) const {
  result.calls = calls_;
  result.answers = answers_;
  result.done = done_;
  result.origin = origin_;
}

}  // namespace trammel::larson
