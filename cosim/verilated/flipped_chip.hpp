// SPDX-License-Identifier: Apache-2.0
//
// A verilated chip of which a bit can be flipped, by the name that waves give its register:
// u_supervisor.trip_q[0], or u_rules.mem_q[3][5] of a memory's word 3. The combinational logic is
// settled anew, as after an upset in hardware.
#pragma once

#include <verilated.h>

#include <charconv>
#include <string>
#include <string_view>
#include <vector>

namespace trammel::cosim {

template <class Chip, class Registers>
class FlippedChip : public Chip {
 public:
  using Chip::Chip;

  bool flip(const std::string& bit, bool really) override {
    bool found = false;
    Registers::each(this->registers(), [&](std::string_view name, int bits, auto& reg) {
      const std::string_view inside = name.substr(name.find('.') + 1);  // without the chip's
      for (const std::string_view one : {name, inside}) {
        if (found || bit.compare(0, one.size(), one) != 0) continue;
        found = change(reg, bits, indices(bit.substr(one.size())), really);
      }
    });
    if (found && really) {
      settle_anew(this->registers());
      this->upset();
    }
    return found;
  }

 private:
  using Indices = std::vector<int>;

  // Of "[3][5]"; -1 where it is none.
  static Indices indices(std::string_view text) {
    Indices all;
    while (!text.empty()) {
      int number = -1;
      const auto end = std::from_chars(text.data() + 1, text.data() + text.size(), number);
      const auto used = static_cast<std::size_t>(end.ptr - text.data());
      const bool good = text[0] == '[' && used < text.size() && text[used] == ']';
      all.push_back(good ? number : -1);
      if (!good) break;
      text.remove_prefix(used + 1);
    }
    return all;
  }

  template <class T>
  static bool change(T& reg, int bits, const Indices& at, bool really) {
    if (at.size() != 1 || at[0] < 0 || at[0] >= bits) return false;
    unsigned char* const byte = reinterpret_cast<unsigned char*>(&reg) + at[0] / 8;
    if (really) *byte = static_cast<unsigned char>(*byte ^ (1u << at[0] % 8));
    return true;
  }
  template <class T, std::size_t words>
  static bool change(VlUnpacked<T, words>& memory, int bits, const Indices& at, bool really) {
    if (at.size() != 2 || at[0] < 0 || at[0] >= static_cast<int>(words)) return false;
    return change(memory[static_cast<std::size_t>(at[0])], bits, {at[1]}, really);
  }
};

}  // namespace trammel::cosim
