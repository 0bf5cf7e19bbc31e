// SPDX-License-Identifier: Apache-2.0
//
// A run with all stops of its loop, of any machine; and the event hash, computed from them and from
// the words of the samples. A hash that left out a word would let two runs pass for one.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cosim/direct.hpp"
#include "cosim/event_hash.hpp"
#include "tests/support/session_run.hpp"

namespace trammel::test {

struct Event {
  cosim::Clk edge;
  unsigned why;
  cosim::Lines drive;
  std::uint32_t read = 0;  // by the processor
};

// What the event hash is made of, but for the words.
struct EventRecord final : cosim::Observer {
  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant&) override {
    if (stop.why == cosim::kLimit) return;
    const bool read = (stop.why & cosim::kBusDone) != 0;
    events.push_back({stop.edge, stop.why, chip.drive(), read ? chip.rdata() : 0});
  }
  std::vector<Event> events;
};

template <class Result>
struct Recorded {
  Result result;
  std::vector<Event> events;
};

// By direct wiring; `options` say so.
template <class Session, class Result, class Options>
Recorded<Result> record_run(const Options& options) {
  Session session(options, {});
  EventRecord record;
  session.loop().watch(record);
  run_through(session);
  const auto result = session.result();
  return {std::move(static_cast<Result&>(*result)), std::move(record.events)};
}

using HashedWord = std::pair<std::string, std::uint64_t>;  // name, of both axes the same; value
using HashedWords = std::vector<HashedWord>;
using WordsOfSample = std::function<HashedWords(std::size_t)>;

inline HashedWords hashed_words(const std::vector<Event>& events, const WordsOfSample& of_sample) {
  HashedWords words;
  std::size_t sample = 0;
  for (const Event& e : events) {
    words.emplace_back("edge", static_cast<std::uint64_t>(e.edge));
    words.emplace_back("reason and drive", (std::uint64_t{e.why} << 32) | e.drive);
    if ((e.why & cosim::kBusDone) != 0) words.emplace_back("word read", e.read);
    if ((e.why & cosim::kSample) == 0) continue;
    for (HashedWord& word : of_sample(sample++)) words.push_back(std::move(word));
  }
  return words;
}

inline std::uint64_t hash_of(const HashedWords& words, const std::string& without = {}) {
  cosim::EventHash hash;
  for (const auto& [name, value] : words) {
    if (name != without) hash.mix(value);
  }
  return hash.value();
}

// Of a run that ended by its time: nothing comes after the last event.
template <class Result>
void check_event_hash(const Recorded<Result>& run, const WordsOfSample& of_sample) {
  REQUIRE(run.result.end == cosim::EndReason::kTimeout);
  REQUIRE(run.result.samples.size() > 50);
  const auto samples = std::count_if(run.events.begin(), run.events.end(), [](const Event& e) {
    return (e.why & cosim::kSample) != 0;
  });
  REQUIRE(samples == static_cast<std::ptrdiff_t>(run.result.samples.size()));
  const HashedWords words = hashed_words(run.events, of_sample);
  std::string lacks = "no word; one is another, or elsewhere";
  for (const auto& [name, value] : of_sample(0)) {
    if (hash_of(words, name) == run.result.event_hash) lacks = name;
  }
  INFO("the hash of the run lacks " << lacks);
  CHECK(hash_of(words) == run.result.event_hash);
}

}  // namespace trammel::test
