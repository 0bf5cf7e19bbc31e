// SPDX-License-Identifier: Apache-2.0
//
// Waves of one verilated block in a window of its clocks, for scripts/tool unit-waves alone: it
// compiles a failed test again, with models that trace, and runs it twice. The first run tells
// which block was clocked last when an assertion failed, and how often; the second traces around
// that.
//
//   TRAMMEL_FAILED   file for "block clock" of the first failed assertion
//   TRAMMEL_WAVES    "block first last file": which clocks of which block go into which VCD
//
// Edge n of a block is at 20 n ns.
#pragma once

#include <verilated.h>
#include <verilated_vcd_c.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

namespace trammel::test {

struct Clocked {
  int made = 0;  // blocks so far
  int block = 0;
  std::uint64_t clock = 0;
};

inline Clocked& clocked() {
  static Clocked last;
  return last;
}

inline void note_failure() {
  const char* file = std::getenv("TRAMMEL_FAILED");
  if (file != nullptr) std::ofstream(file) << clocked().block << ' ' << clocked().clock << '\n';
}

class Waves {
 public:
  template <class Model>
  void begin(VerilatedContext& context, Model& model) {
    block_ = ++clocked().made;
    clocked().block = block_;
    clocked().clock = 0;
    const char* asked = std::getenv("TRAMMEL_WAVES");
    if (asked == nullptr) return;
    int block = 0;
    std::string file;
    std::istringstream(asked) >> block >> first_ >> last_ >> file;
    if (block != block_) return;
    context.traceEverOn(true);
    vcd_ = std::make_unique<VerilatedVcdC>();
    model.trace(vcd_.get(), 99);
    vcd_->open(file.c_str());
  }

  // Before the next edge, at it, and half a clock behind it.
  void settled() {
    ++clock_;
    clocked().block = block_;
    clocked().clock = clock_;
    dump(20 * clock_ - 1);
  }
  void rose() { dump(20 * clock_); }
  void fell() { dump(20 * clock_ + 10); }

  void end() {
    if (vcd_) vcd_->close();
  }

 private:
  void dump(std::uint64_t time) {
    if (vcd_ && first_ <= clock_ && clock_ <= last_) vcd_->dump(time);
  }

  int block_ = 0;
  std::uint64_t clock_ = 0;
  std::uint64_t first_ = 0, last_ = 0;
  std::unique_ptr<VerilatedVcdC> vcd_;
};

}  // namespace trammel::test
