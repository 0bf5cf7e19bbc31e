// SPDX-License-Identifier: Apache-2.0
//
// The placed netlist of a board beside its RTL in closed loop with the table: scripts/tool netlist.
//
//   netlist_run SECONDS PATH     all outputs at all clocks
//   netlist_run SECONDS PATH N   with lookup table N flipped, one bit after the other, until an
//                                output differs
//
// Prints one line; exit code 0: no output differed, 1: one did.
#include <Vnetlist.h>
#include <Vrtl.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "machines/kung/tests/netlist/pair.hpp"
#include "models/plant/xy_table.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace {

using namespace trammel;

constexpr double kClock = 50e6;              // [Hz]
constexpr cosim::Clk kTyped = 500'000;       // edge at which the console types: the program waits
constexpr cosim::Clk kFlipFrom = 1'320'000;  // the gates switch
constexpr cosim::Clk kFlipEach = 10'000;     // [clk] a bit stays flipped

class Table final : public cosim::Plant {
 public:
  explicit Table(const plant::XyTableConfig& config) : table_(config) {}
  cosim::Lines sense() const override { return table_.sense(); }
  cosim::Clk next() const override { return table_.next(); }
  void commit(cosim::Clk n, cosim::Lines drive) override { table_.commit(n, drive); }
  int sample(int channel, cosim::Clk n) const override { return table_.sample(channel, n); }
  double x(cosim::Clk n) const { return table_.state(0, n).x_m; }
  double y(cosim::Clk n) const { return table_.state(1, n).x_m; }

 private:
  plant::XyTable table_;
};

struct None final : cosim::Observer {
  void on(const cosim::Stop&, const cosim::Chip&, const cosim::Plant&) override {}
};

double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

plant::XyTableConfig at_the_start_of(sw::Path path) {
  sw::KungSetup setup;
  setup.path = path;
  const sw::Point start = sw::Trajectory(setup).start();
  plant::XyTableConfig config = plant::default_xy_table();
  config.axis[0].start_m = start.x * config.axis[0].encoder_count_m;
  config.axis[1].start_m = start.y * config.axis[1].encoder_count_m;
  return config;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const auto end = static_cast<cosim::Clk>(std::atof(argv[1]) * kClock);
  const std::string name = argv[2];
  const unsigned flip = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 0;
  Table table(at_the_start_of(name == "circle" ? sw::Path::kCircle : sw::Path::kLine));
  kung::Pair<Vrtl, Vnetlist> pair("path " + name + "\nstart\n", kTyped);
  None none;
  cosim::Loop loop(pair, table, none);
  const double from = cpu();
  int flipped = -1;
  if (flip == 0) {
    loop.advance(end, 0);
  } else {
    loop.advance(kFlipFrom, 0);
    for (int bit = 0; bit < 16 && pair.different() == 0; ++bit) {
      pair.flip(flip << 5 | 1u << 4 | static_cast<unsigned>(bit));
      loop.advance(pair.now() + kFlipEach, 0);
      flipped = bit;
    }
  }
  const double took = cpu() - from;
  std::string said;
  for (const char c : pair.said()) said += c >= ' ' && c != '"' && c != '\\' ? c : ' ';
  std::printf("{\"clocks\": %lld, \"cpu_s\": %.3f, \"clocks_per_s\": %.0f, \"different\": %lld, "
              "\"gate_changes\": %lld, \"first_gate\": %lld, \"said\": \"%s\", "
              "\"x_mm\": %.4f, \"y_mm\": %.4f, \"flipped_bit\": %d, "
              "\"first\": [",
              static_cast<long long>(pair.now()), took, static_cast<double>(pair.now()) / took,
              static_cast<long long>(pair.different()),
              static_cast<long long>(pair.gate_changes()),
              static_cast<long long>(pair.first_gate()), said.c_str(), table.x(pair.now()) * 1e3,
              table.y(pair.now()) * 1e3, flipped);
  bool more = false;
  for (const kung::Difference& d : pair.differences()) {
    std::printf("%s\"clock %lld: %s is %x in the RTL, %x in the netlist\"", more ? ", " : "",
                static_cast<long long>(d.clock), d.port.c_str(), d.rtl, d.netlist);
    more = true;
  }
  std::printf("]}\n");
  return pair.different() != 0;
}
