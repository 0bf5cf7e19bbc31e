// SPDX-License-Identifier: Apache-2.0

#include <Vlm628_axil.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/bus/lm628_wrapped.hpp"
#include "tests/chips/lm628_transfers.hpp"

using trammel::test::Opcode;
using trammel::test::Random;
using trammel::test::same;

namespace {

class Bench : public trammel::test::Wrapped<Vlm628_axil>,
              public trammel::test::Lm628Commands<Bench> {
 public:
  explicit Bench(std::uint32_t seed) : Wrapped(seed) {
    rtl->s_axil_awvalid_i = rtl->s_axil_wvalid_i = rtl->s_axil_arvalid_i = 0;
    rtl->s_axil_bready_i = rtl->s_axil_rready_i = 0;
    start();
  }

  // A transfer up to its response.
  void write(bool ps, std::uint8_t byte) { run(ask_write(ps, byte, true), reads_done_); }
  std::uint8_t read(bool ps) {
    run(writes_done_, ask_read(ps));
    return last_;
  }
  void clocks(std::int64_t n) { pass(n); }

  // Offers one; returns its number.
  int ask_write(bool ps, std::uint8_t byte, bool lane) {
    aw_ps_ = ps;
    w_byte_ = byte;
    w_lane_ = lane;
    aw_left_ = w_left_ = true;
    if (lane) expect(true, ps, byte);
    return ++writes_;
  }
  int ask_read(bool ps) {
    ar_ps_ = ps;
    ar_left_ = true;
    expect(false, ps, 0);
    return ++reads_;
  }
  bool write_offered() const { return aw_left_ || w_left_; }
  bool read_offered() const { return ar_left_; }
  int writes_waiting() const { return writes_ - writes_done_; }
  int reads_waiting() const { return reads_ - reads_done_; }

  // Until so many of each have had their responses.
  void run(int writes, int reads) {
    for (int clocks = 0; writes_done_ < writes || reads_done_ < reads; ++clocks) {
      REQUIRE(clocks < 2000);
      step();
    }
  }

  // A clock, in which each channel moves or waits.
  void step() {
    auto& m = *rtl.operator->();
    if (aw_left_ && random() % 3 == 0) m.s_axil_awvalid_i = 1;
    if (w_left_ && random() % 3 == 0) m.s_axil_wvalid_i = 1;
    if (ar_left_ && random() % 3 == 0) m.s_axil_arvalid_i = 1;
    const auto byte = [](unsigned bits) { return static_cast<std::uint8_t>(bits); };
    m.s_axil_awaddr_i = byte(m.s_axil_awvalid_i ? 4 * aw_ps_ : random() & 7);
    m.s_axil_araddr_i = byte(m.s_axil_arvalid_i ? 4 * ar_ps_ : random() & 7);
    m.s_axil_wdata_i = m.s_axil_wvalid_i ? w_byte_ * 0x01010101u ^ 0xAA55AA00u : random();
    m.s_axil_wstrb_i = byte(m.s_axil_wvalid_i ? w_lane_ | (w_byte_ & 0xE) : random() & 0xF);
    m.s_axil_awprot_i = m.s_axil_arprot_i = random() & 7;
    m.s_axil_bready_i = random() % 3 != 0;
    m.s_axil_rready_i = random() % 3 != 0;
    rtl.eval();
    const bool aw = m.s_axil_awvalid_i && m.s_axil_awready_o;
    const bool w = m.s_axil_wvalid_i && m.s_axil_wready_o;
    const bool ar = m.s_axil_arvalid_i && m.s_axil_arready_o;
    const bool b = m.s_axil_bvalid_o && m.s_axil_bready_i;
    const bool r = m.s_axil_rvalid_o && m.s_axil_rready_i;
    same("bresp", m.s_axil_bresp_o, 0, now());
    same("rresp", m.s_axil_rresp_o, 0, now());
    if (m.s_axil_rvalid_o) same("rdata", m.s_axil_rdata_o, given(), now());
    if (r) last_ = given();
    edge();
    if (aw) aw_left_ = (m.s_axil_awvalid_i = 0);
    if (w) w_left_ = (m.s_axil_wvalid_i = 0);
    if (ar) ar_left_ = (m.s_axil_arvalid_i = 0);
    aws_ += aw;
    ws_ += w;
    ars_ += ar;
    writes_done_ += b;
    reads_done_ += r;
    REQUIRE(writes_done_ <= std::min(aws_, ws_));
    REQUIRE(reads_done_ <= ars_);
  }

 private:
  bool bus_idle() override {
    return !offers() && aws_ == writes_done_ && ws_ == writes_done_ && ars_ == reads_done_;
  }
  bool offers() {
    return (rtl->s_axil_awvalid_i | rtl->s_axil_wvalid_i | rtl->s_axil_arvalid_i) != 0;
  }

  bool aw_left_ = false, w_left_ = false, ar_left_ = false;  // offered, and not yet taken
  bool aw_ps_ = false, ar_ps_ = false, w_lane_ = false;
  std::uint8_t w_byte_ = 0, last_ = 0;
  int writes_ = 0, reads_ = 0, writes_done_ = 0, reads_done_ = 0;
  int aws_ = 0, ws_ = 0, ars_ = 0;  // taken
};

}  // namespace

TEST_CASE("lm628_axil does with its part what the bare port does, over 400 random transfers") {
  Bench bench(105);
  Random random(106);
  for (int n = 0; n < 400; ++n) {
    CAPTURE(n);
    if (random() % 8 == 0) {
      trammel::test::wild(bench, random);
    } else {
      bench.ready();
      trammel::test::ordered(bench, random);
    }
    if (random() % 4 == 0) bench.clocks(random() % 20'000);
  }
  CHECK(bench.accesses() > 2000);
  bench.clocks(40);
  CHECK(bench.all_done());
}

TEST_CASE("lm628_axil answers reads and writes that overlap, each once and in its order") {
  Bench bench(107);
  Random random(108);
  for (int n = 0; n < 60'000; ++n) {
    if (!bench.write_offered() && bench.writes_waiting() < 2 && random() % 12 == 0) {
      bench.ask_write(random() % 2 == 0, static_cast<std::uint8_t>(random() | 1),
                      random() % 5 != 0);
    }
    if (!bench.read_offered() && bench.reads_waiting() < 2 && random() % 12 == 0) {
      bench.ask_read(random() % 2 == 0);
    }
    bench.step();
  }
  bench.run(bench.writes_waiting(), bench.reads_waiting());
  for (int i = 0; i < 400; ++i) bench.step();
  CHECK(bench.writes_waiting() == 0);
  CHECK(bench.reads_waiting() == 0);
  CHECK(bench.all_done());
  CHECK(bench.accesses() > 2000);
}

TEST_CASE("lm628_axil interrupts while HI is high, two clocks later") {
  Bench bench(109);
  bench.clear_status();
  bench.command(Opcode::kMski, {0x0004});
  bench.command(Opcode::kStt);
  int high = 0;
  for (int i = 0; i < 30'000; ++i) {
    bench.edge();
    REQUIRE((bench.rtl->irq_o != 0) == bench.hi());
    high += bench.rtl->irq_o;
  }
  CHECK(high > 100);
  bench.clear_status();
  bench.clocks(3);
  CHECK(bench.rtl->irq_o == 0);
}
