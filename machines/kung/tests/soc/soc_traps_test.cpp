// SPDX-License-Identifier: Apache-2.0
//
// What the core of kung_soc traps on: single instructions, by the lamps "tripped" and "trapped".
#include <catch2/catch.hpp>
#include <cstdint>

#include "machines/kung/tests/soc/soc_chip.hpp"

using namespace trammel;

namespace {

constexpr std::uint32_t kLoop = 0x0000006F;
constexpr std::uint32_t kA0IsZero = 0x00000513, kA0IsRegisters = 0x80000537;  // addi, lui

// Of a0 and an offset: a load to a0, a store of it, a jump.
std::uint32_t load(std::uint32_t kind, std::uint32_t offset) {
  return offset << 20 | 10u << 15 | kind << 12 | 10u << 7 | 0x03;
}
std::uint32_t store(std::uint32_t kind, std::uint32_t offset) {
  return 10u << 20 | 10u << 15 | kind << 12 | offset << 7 | 0x23;
}
std::uint32_t jump(std::uint32_t offset) { return offset << 20 | 10u << 15 | 0x67; }

// Lamps 2 and 3 after an instruction behind one that sets a0, and before a loop.
int lamps(std::uint32_t base, std::uint32_t instruction) {
  test::SocChip chip({base, instruction, kLoop});
  for (int n = 0; n < 60; ++n) chip.clock();
  return chip.pins().status_o >> 2 & 3;
}

constexpr int kRuns = 0, kTraps = 3;

}  // namespace

TEST_CASE("a misaligned load, store or jump traps and trips, an aligned one and a byte do not") {
  for (const std::uint32_t offset : {0u, 1u, 2u, 3u}) {
    for (const std::uint32_t base : {kA0IsZero, kA0IsRegisters}) {
      for (const std::uint32_t kind : {0u, 1u, 2u, 4u, 5u}) {  // byte, half, word; unsigned
        const std::uint32_t size = 1u << (kind & 3);
        const int wanted = offset % size == 0 ? kRuns : kTraps;
        CAPTURE(base, offset, size, kind);
        CHECK(lamps(base, load(kind, offset)) == wanted);
        if (kind <= 2) CHECK(lamps(base, store(kind, offset)) == wanted);
      }
    }
    CAPTURE(offset);  // of the loop; a jump drops bit 0
    CHECK(lamps(kA0IsZero, jump(8 + offset)) == (offset < 2 ? kRuns : kTraps));
  }
}

TEST_CASE("what is not of rv32im traps and trips, multiplication and division do not") {
  struct Instruction {
    const char* name;
    std::uint32_t word;
    int wanted;
  };
  for (const Instruction& one : {Instruction{"0", 0x00000000, kTraps},
                                 {"ones", 0xFFFFFFFF, kTraps},
                                 {"fadd.s", 0x00A50553, kTraps},
                                 {"lr.w", 0x1005252F, kTraps},
                                 {"rdcycle", 0xC0002573, kTraps},
                                 {"ecall", 0x00000073, kTraps},
                                 {"ebreak", 0x00100073, kTraps},
                                 {"mul", 0x02A50533, kRuns},
                                 {"mulhu", 0x02A53533, kRuns},
                                 {"div by 0", 0x02A54533, kRuns},
                                 {"remu by 0", 0x02A57533, kRuns},
                                 {"sra", 0x40A55533, kRuns},
                                 {"fence", 0x0000000F, kRuns}}) {
    CAPTURE(one.name);
    CHECK(lamps(kA0IsZero, one.word) == one.wanted);
  }
}
