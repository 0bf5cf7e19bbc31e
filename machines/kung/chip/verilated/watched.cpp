// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy_fast.h>
#include <Vkung_xy_fast___024root.h>

#include "machines/kung/chip/verilated/chip_model.hpp"
#include "machines/kung/chip/verilated/signals.hpp"

namespace trammel::kung {

namespace {

using WatchedRoot = Vkung_xy_fast___024root;

// Lets a watcher see every evaluated edge.
class Watch final : SignalReader {
 public:
  explicit Watch(cosim::Watcher& watcher) : watcher_(watcher) {}

  void attach(VerilatedContext&, Vkung_xy_fast& model) { root_ = model.rootp; }
  static constexpr bool shows(cosim::Clk) { return false; }
  void fell(cosim::Clk) {}
  void raised(cosim::Clk edge) { watcher_.after(edge, *this); }

  std::int64_t read(std::size_t signal, int axis) const override {
    const SignalRow<WatchedRoot>& row = signal_rows<WatchedRoot>()[signal];
    return bits_of(row.read(*root_, axis), row.signal.bits, row.signal.is_signed);
  }

 private:
  cosim::Watcher& watcher_;
  const WatchedRoot* root_ = nullptr;
};

}  // namespace

const std::vector<Signal>& signals() {
  static const std::vector<Signal> all = [] {
    std::vector<Signal> list;
    for (const auto& row : signal_rows<WatchedRoot>()) list.push_back(row.signal);
    return list;
  }();
  return all;
}

std::unique_ptr<KungChip> make_watched_chip(cosim::Watcher& watcher, bool leap) {
  return std::make_unique<ChipModel<Vkung_xy_fast, Watch>>(Watch{watcher},
                                                      cosim::ModelMode{leap, false});
}

}  // namespace trammel::kung
