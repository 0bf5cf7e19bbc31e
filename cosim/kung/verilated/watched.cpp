// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy.h>
#include <Vkung_xy___024root.h>

#include "cosim/kung/verilated/chip_model.hpp"
#include "cosim/kung/verilated/signals.hpp"

namespace trammel::kung {

namespace {

using WatchedRoot = Vkung_xy___024root;

// Lets a watcher see every evaluated edge.
class Watch final : SignalReader {
 public:
  explicit Watch(Watcher& watcher) : watcher_(watcher) {}

  void attach(VerilatedContext&, Vkung_xy& model) { root_ = model.rootp; }
  static constexpr bool shows(cosim::Clk) { return false; }
  void fell(cosim::Clk) {}
  void raised(cosim::Clk edge) { watcher_.after(edge, *this); }

  std::int64_t read(std::size_t signal, int axis) const override {
    return signal_rows<WatchedRoot>()[signal].read(*root_, axis);
  }

 private:
  Watcher& watcher_;
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

std::unique_ptr<KungChip> make_watched_chip(Watcher& watcher, bool leap) {
  return std::make_unique<ChipModel<Vkung_xy, Watch>>(Watch{watcher},
                                                      cosim::ModelMode{leap, false});
}

}  // namespace trammel::kung
