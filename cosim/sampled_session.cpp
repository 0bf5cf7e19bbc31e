// SPDX-License-Identifier: Apache-2.0
#include "cosim/sampled_session.hpp"

#include <algorithm>

namespace trammel::cosim {

void SampledSession::on(const Stop& stop, const Chip& chip, const Plant&) {
  if (over_) return;
  passed();
  if (stop.why == kLimit) return;
  const bool sample = (stop.why & kSample) != 0;
  const bool recorded = sample && (stop.edge + 1) % record_clk_ == 0;
  const Stop events{stop.edge, recorded ? stop.why : stop.why & ~kSample};
  if (events.why != 0) {
    if (waves_.search != nullptr) waves_.search->on(events, wired(), *this);
    watch_fault(events);
    hash_.mix(events, chip);
    noted(events);
  }
  if (!sample) return;
  sampled(stop.edge, recorded);
  if (!recorded) return;
  ++recorded_;
  if (const auto reason = ended(stop.edge)) {
    end_ = *reason;
    over_ = true;
  }
}

std::optional<EndReason> SampledSession::ended(Clk edge) {
  if (wired().failed_assertion()) return EndReason::kAssertion;
  if (waves_.found()) return EndReason::kDone;
  if (hooks_.progress && recorded_ % 64 == 0) hooks_.progress(std::min(1.0, progress()));
  if (hooks_.stopped()) return EndReason::kStopped;
  return ending(edge);
}

std::optional<EndReason> SampledSession::ending(Clk) {
  const sw::Mailbox& mailbox = firmware().mailbox();
  if (mailbox.done == 0) return {};
  return mailbox.failure == 0 ? EndReason::kDone : EndReason::kFault;
}

void SampledSession::complete(RunResult& result) const {
  result.event_hash = hash_.value();
  result.events = hash_.events();
  Rig::complete(result);
}

}  // namespace trammel::cosim
