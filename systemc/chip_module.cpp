// SPDX-License-Identifier: Apache-2.0
#include "systemc/chip_module.hpp"

#include <cstring>

namespace trammel::systemc {

using namespace sc_core;

namespace {

constexpr unsigned kAnswered = cosim::kIrq | cosim::kBusDone | cosim::kSample;

}  // namespace

ChipModule::ChipModule(sc_module_name name, cosim::Loop& loop, std::int64_t period_ps,
                       cosim::Clk end, std::function<bool()> finished)
    : sc_module(name),
      bus("bus"),
      loop_(loop),
      period_ps_(period_ps),
      end_(end),
      finished_(std::move(finished)) {
  bus.register_b_transport(this, &ChipModule::transport);
  SC_HAS_PROCESS(ChipModule);
  SC_THREAD(execute);
}

sc_time ChipModule::time_of(cosim::Clk edge) const {
  return sc_time::from_value(static_cast<sc_dt::uint64>(edge * period_ps_));
}

// The first edge at that time or later.
cosim::Clk ChipModule::edge_at(const sc_time& time) const {
  return (static_cast<std::int64_t>(time.value()) + period_ps_ - 1) / period_ps_;
}

// The first edge that must wait for other processes: edges before it cannot be influenced by them.
cosim::Clk ChipModule::limit() const {
  if (!sc_pending_activity_at_future_time()) return end_;
  return std::min(end_, edge_at(sc_time_stamp() + sc_time_to_pending_activity()));
}

void ChipModule::execute() {
  try {
    simulate();
  } catch (...) {
    error_ = std::current_exception();
  }
  sc_stop();
}

// Up to the edge `until`; a transfer begins on the way, which no one has to wait for.
cosim::Stop ChipModule::advance(cosim::Clk until) {
  cosim::Chip& chip = loop_.chip();
  if (asked_ && chip.now() < asked_from_) {
    const cosim::Stop stop = loop_.advance(std::min(until, asked_from_), kAnswered);
    if ((stop.why & kAnswered) != 0 || chip.now() >= until) return stop;
  }
  if (asked_) {
    chip.request(*asked_);
    asked_.reset();
  }
  return loop_.advance(until, kAnswered);
}

void ChipModule::simulate() {
  for (;;) {
    // Everyone else acts first at a time; only this process may use the settle loop.
    do {
      wait(SC_ZERO_TIME);
    } while (sc_pending_activity_at_current_time());
    if (finished_() || loop_.chip().now() >= end_) return;
    const cosim::Clk until = limit();
    if (until <= loop_.chip().now()) {
      wait(sc_time_to_pending_activity());
      continue;
    }
    const cosim::Stop stop = advance(until);
    const bool early = (stop.why & kAnswered) != 0;
    const sc_time at = time_of(early ? stop.edge : loop_.chip().now());
    if (at > sc_time_stamp()) wait(at - sc_time_stamp());
    if ((stop.why & cosim::kBusDone) != 0) done_event_.notify(SC_ZERO_TIME);
    if ((stop.why & cosim::kIrq) != 0) irq_event.notify(SC_ZERO_TIME);
  }
}

void ChipModule::transport(tlm::tlm_generic_payload& payload, sc_time& delay) {
  const bool write = payload.is_write();
  if (payload.get_data_length() != sizeof(std::uint32_t) || (payload.get_address() & 3u) != 0 ||
      payload.get_byte_enable_ptr() != nullptr) {
    return payload.set_response_status(tlm::TLM_BURST_ERROR_RESPONSE);
  }
  asked_ = cosim::BusOp{static_cast<std::uint32_t>(payload.get_address()), 0, write};
  if (write) std::memcpy(&asked_->data, payload.get_data_ptr(), sizeof asked_->data);
  asked_from_ = edge_at(sc_time_stamp() + delay);
  delay = SC_ZERO_TIME;
  wait(done_event_);
  if (!write) {
    const std::uint32_t data = loop_.chip().rdata();
    std::memcpy(payload.get_data_ptr(), &data, sizeof data);
  }
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
}

}  // namespace trammel::systemc

// The SystemC library wants this symbol, from outside too; our programs have their own main().
[[gnu::visibility("default")]] int sc_main(int, char**) { return 1; }
