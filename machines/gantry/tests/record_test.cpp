// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine gantry records, held against its track driven once more with the pins
// that the chip drove, and against the words of chip and program; how its runs go on and end.
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cosim/trigger_search.hpp"
#include "lab/record.hpp"
#include "machines/gantry/machine_members.hpp"
#include "machines/gantry/session.hpp"
#include "machines/gantry/signals.hpp"
#include "machines/gantry/tests/by_twin.hpp"
#include "tests/support/event_record.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::gantry;

namespace {

// What program and chip hold as a sample is recorded, and what a trigger reads of them.
struct Held {
  Words words;
  std::map<std::string, std::int64_t> program, signals;
};

struct HeldRecord final : cosim::Observer {
  explicit HeldRecord(Session& of) : session(of) {}
  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant& plant) override {
    events.on(stop, chip, plant);
    if ((stop.why & cosim::kSample) == 0) return;
    const auto& mail = static_cast<const sw::GantryApp&>(session.firmware()).mailbox();
    Held h;
    h.words = static_cast<const GantryChip&>(chip).words();
    h.program = {{"error", mail.error},       {"goal", mail.goal},
                 {"zero", mail.zero},         {"velocity", mail.velocity},
                 {"goal_velocity", mail.goal_velocity},
                 {"phase", static_cast<int>(mail.phase)}};
    const auto& reader = static_cast<const cosim::SignalReader&>(session);
    for (std::size_t n = 0; n < signals().size(); ++n) {
      h.signals[signals()[n].name] = reader.read(n, 0);
    }
    all.push_back(std::move(h));
  }
  Session& session;
  test::EventRecord events;
  std::vector<Held> all;
};

}  // namespace

TEST_CASE("gantry: each sample is of the track, as the pins move it, and of the program's words") {
  Options options = by_twin(0.9);
  options.axis.start = 0.01;
  options.axis.gap = 1e-4;
  options.firmware.cascade = options.firmware.compensate = true;
  options.firmware.home = true;  // to zero, below where it starts
  options.firmware.home_ticks = 100;
  options.sends = "0.4:21=25 0.7:22=171000";
  options.record_ms = 0.5;
  Session session(options, {});
  HeldRecord held(session);
  session.loop().watch(held);
  test::run_through(session);
  const auto run = session.result();
  const auto& result = static_cast<const Result&>(*run);
  REQUIRE(result.end == cosim::EndReason::kDone);
  REQUIRE(result.samples.size() == 1801);
  REQUIRE(held.all.size() == 1801);
  TrackPlant plant(options.axis, options.stripes, read_sends(options.sends), false);
  cosim::Lines drive = cosim::Lines{1} << kTx;
  std::size_t sample = 0;
  std::map<std::string, int> seen;  // of what is not zero, so that it can be wrong
  for (const test::Event& event : held.events.events) {
    while (plant.next() <= event.edge) plant.commit(plant.next(), drive);  // as the loop does
    drive = event.drive;
    if ((event.why & (cosim::kDrive | cosim::kSample)) != 0) plant.commit(event.edge, drive);
    if ((event.why & cosim::kSample) == 0) continue;
    const Sample s = result.samples[sample];
    const Held& h = held.all[sample++];
    INFO("sample " << sample - 1 << ", clock " << event.edge);
    REQUIRE(s.edge == event.edge);
    REQUIRE(s.edge == 25'000 * static_cast<cosim::Clk>(sample) - 1);
    const plant::BeltState& is = plant.axis().state();
    REQUIRE(s.x == Approx(is.x[plant::BeltState::kCart]).margin(1e-9));
    REQUIRE(s.v == Approx(is.v[plant::BeltState::kCart]).margin(1e-9));
    for (const std::size_t m : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t mass = m == 0 ? plant::BeltState::kMotor1 : plant::BeltState::kMotor2;
      INFO("motor " << m + 1 << ": apart " << s.motor[m] << ", force " << s.force[m] << ", flank "
                    << s.flank[m]);
      REQUIRE(s.motor[m] == Approx(is.x[mass] - is.x[plant::BeltState::kCart]).margin(1e-9));
      const double mean = plant.axis().mean_force(m, TrackPlant::kCarrier);
      REQUIRE(s.force[m] == Approx(mean).margin(1e-6));
      REQUIRE(s.flank[m] == plant.axis().flank(mass));
      REQUIRE(s.words.force[m] == h.words.force[m]);
      const std::string name = "motor " + std::to_string(m + 1);
      seen[name + (s.flank[m] > 0 ? " pushes up" : s.flank[m] < 0 ? " pushes down" : " loose")]++;
    }
    REQUIRE(s.stripes[0] == plant.sample(kA, event.edge));
    REQUIRE(s.stripes[1] == plant.sample(kB, event.edge));
    REQUIRE(s.words.position == h.words.position);
    REQUIRE(s.words.velocity == h.words.velocity);
    REQUIRE(s.words.phase == h.words.phase);
    REQUIRE(s.words.region == h.words.region);
    REQUIRE(s.words.codes == h.words.codes);
    const std::map<std::string, std::int64_t> of_program{
        {"error", s.error},       {"goal", s.goal},   {"zero", s.zero},
        {"velocity", s.velocity}, {"goal_velocity", s.goal_velocity}, {"phase", s.phase}};
    for (const auto& [name, value] : h.program) {
      INFO(name << " of the program");
      REQUIRE(of_program.at(name) == value);
      seen[name] += value != 0 ? 1 : 0;
    }
    const std::map<std::string, std::int64_t> triggers{
        {"position", s.words.position}, {"velocity", s.words.velocity},
        {"force", s.words.force[0]},    {"error", s.error},
        {"region", s.words.region}};
    for (const auto& [name, value] : h.signals) {
      INFO(name << " as a trigger reads it");
      REQUIRE(triggers.at(name) == value);
    }
    seen["forces apart"] += s.words.force[0] != s.words.force[1] ? 1 : 0;
  }
  CHECK(sample == result.samples.size());
  for (const char* what :
       {"error", "goal", "zero", "velocity", "goal_velocity", "phase", "forces apart",
        "motor 1 pushes up", "motor 1 pushes down", "motor 2 pushes up", "motor 2 pushes down",
        "motor 1 loose", "motor 2 loose"}) {
    INFO(what << " was seen");
    CHECK(seen[what] > 0);
  }
  CHECK(result.homed);
  CHECK_FALSE(result.fitted);
  CHECK(result.heard == plant.heard());
}

TEST_CASE("gantry: the event hash is of every stop, and of position and velocity of every sample") {
  Options options = by_twin(10);
  options.run.max_s = 0.15;
  options.sends = "0.02:21=305 0.05:31?";
  const auto run = test::record_run<Session, Result>(options);
  test::check_event_hash(run, [&run](std::size_t sample) {
    const Sample s = run.result.samples[sample];
    return test::HashedWords{{"position", static_cast<std::uint32_t>(s.words.position)},
                             {"velocity", static_cast<std::uint32_t>(s.words.velocity)}};
  });
  CHECK(run.result.events == static_cast<cosim::Clk>(run.events.size()));
}

TEST_CASE("gantry: a run tells of what it heard and counted, by the times of its own keys") {
  Options options = by_twin(0.25);
  options.pass_ms = 5;
  options.record_ms = 2;
  options.sends = "0.05:15? 0.06:17=3 0.08:xFFFFFFFFFFFFFF00 0.1:x8A";
  const Result result = lab::simulate(options);
  CHECK(result.end == cosim::EndReason::kDone);
  CHECK(result.passes == Approx(50).margin(1));
  CHECK(result.samples.size() == 126);
  CHECK(result.unknown == 2);
  CHECK(result.malformed == 2);  // too long, and without its end
  CHECK(result.lost == 0);
  CHECK_FALSE(result.homed);
  CHECK_FALSE(result.fitted);
  CHECK(result.store == ideal_store());
  CHECK(result.heard == std::vector<unsigned char>{0x8A, 0x49});
}

TEST_CASE("gantry: a session tells its clock, its processor, its end and its place") {
  Options options = by_twin(1);
  test::set_timing(options);
  options.axis.start = 0.123;
  Session session(options, {});
  test::check_timing(session, 20'000);
  const auto places = session.places();
  REQUIRE(places.size() == 1);
  CHECK(places[0].axis.empty());
  CHECK(places[0].unit == "mm");
  CHECK(places[0].value == Approx(123));
}

TEST_CASE("gantry: a run goes on to its time, tells its share of it, and can be stopped") {
  std::vector<double> told;
  cosim::Hooks hooks;
  hooks.progress = [&told](double share) { told.push_back(share); };
  const Options options = by_twin(0.2);
  const Result whole = lab::simulate(options, hooks);
  CHECK(whole.end == cosim::EndReason::kDone);
  REQUIRE(whole.samples.size() == 201);  // at the last clock of each millisecond
  REQUIRE(told.size() == 3);
  for (std::size_t k = 0; k < told.size(); ++k) {
    CHECK(told[k] == Approx(64 * static_cast<double>(k + 1) / 200));
  }
  std::atomic<bool> stop{false};
  hooks.stop = &stop;
  hooks.progress = [&stop](double share) { stop = share > 0.5; };
  Session session(options, hooks);
  test::run_through(session);
  CHECK(session.stopped());
  const auto stopped = session.result();
  CHECK(stopped->end == cosim::EndReason::kStopped);
  CHECK(stopped->sample_count() == 128);
  Options late = options;
  late.run.max_s = 0.1;
  CHECK(lab::simulate(late).end == cosim::EndReason::kTimeout);
}

TEST_CASE("gantry: a cart that is not at its reference has missed it, on either side") {
  for (const double start_mm : {0.0, 20.0}) {
    for (const double reached_mm : {9.9, 10.1, -1.0}) {
      Options options = by_twin(0.01);
      options.sends = "";
      options.axis.start = 1e-3 * start_mm;
      options.reference_mm = 10;
      options.reached_mm = reached_mm;
      const Result result = lab::simulate(options);
      CAPTURE(start_mm, reached_mm, result.fault);
      const bool missed = reached_mm == 9.9;
      CHECK(machine().verdict(options, result) == (missed ? "missed: " + result.fault : "done"));
      CHECK(result.end == (missed ? cosim::EndReason::kMissed : cosim::EndReason::kDone));
      CHECK(result.fault ==
            (!missed         ? ""
             : start_mm == 0 ? "the cart is -10.00 mm from its reference (run.reached_mm)"
                             : "the cart is 10.00 mm from its reference (run.reached_mm)"));
      options.run.max_s = 5e-3;  // one that did not end is not asked
      CHECK(lab::simulate(options).end == cosim::EndReason::kTimeout);
    }
  }
}

TEST_CASE("gantry: a run that ends before its last send has no step, and misses its reference") {
  Options options = by_twin(0.01);
  options.sends = "0.005:21=0 0.02:21=305";
  Result result = lab::simulate(options);
  CHECK(result.end == cosim::EndReason::kDone);
  for (const lab::Figure& f : gantry::figures(options, result)) {
    CAPTURE(f.id);
    CHECK(f.id.rfind("step.", 0) != 0);
  }
  options.reached_mm = 400;
  result = lab::simulate(options);
  CHECK(result.end == cosim::EndReason::kMissed);
  CHECK(result.fault == "the run ended before the last of host.sends (run.reached_mm)");
  REQUIRE(machine().texts.warnings(options).size() == 1);
  CHECK(machine().texts.warnings(options)[0] ==
        "host.sends: its last entry is at 0.02 s, and the run ends at 0.01 s (run.time_s): it is "
        "not sent");
  options.time_s = 0.03;
  CHECK(machine().texts.warnings(options).empty());
}

TEST_CASE("gantry: a program that fails ends the run at once where the cart stands, and says why") {
  struct Case {
    const char* why;
    void (*make)(Options&);
    double least_s, most_s;
  };
  const Case cases[] = {
      {"a force and no motion",
       [](Options& o) {
         o.axis.coulomb = o.axis.stiction = 5000;
         o.firmware.stall_ticks = 460;  // a tenth of a second
       },
       0.15, 0.16},
      {"A and B are not on their circle",
       [](Options& o) {
         o.stripes.amplitude = 200;
         o.firmware.watch_sensor = true;
       },
       0, 0.01}};
  for (const Case& one : cases) {
    Options options = by_twin(60);
    options.sends = "0.05:21=305";
    options.run.max_s = 60;
    one.make(options);
    const Result result = lab::simulate(options);
    const double end_s = result.seconds(result.samples.back().edge);
    CAPTURE(one.why, end_s);
    CHECK(result.end == cosim::EndReason::kFault);
    CHECK(result.fault == one.why);
    CHECK(machine().verdict(options, result) == std::string("failed: ") + one.why);
    CHECK(end_s >= one.least_s);
    CHECK(end_s <= one.most_s);
  }
}

TEST_CASE("gantry: a calibration run in which A sticks ends as one without a steady motion") {
  Options options = by_twin(8);
  options.run.max_s = 10;
  options.record_ms = 10;
  options.sends = "";
  options.firmware.home = options.firmware.calibrate = true;
  options.firmware.home_ticks = 100;
  double begun_s = 0;
  for (const Sample& s : lab::simulate(options).samples) {
    const bool fits = s.phase == static_cast<int>(sw::GantryPhase::kFitting);
    if (begun_s == 0 && fits) begun_s = options.run.seconds(s.edge);
  }
  REQUIRE(begun_s > 0);
  options.fault.kind = cosim::FaultKind::kConverterStuck;
  options.fault.begin_s = begun_s + 0.2;
  const Result result = lab::simulate(options);
  CAPTURE(begun_s);
  CHECK(result.end == cosim::EndReason::kFault);
  CHECK(result.fault == "the calibration run was no steady motion");
  CHECK(result.fault_report.by == result.fault);
  CHECK_FALSE(result.fitted);
}

TEST_CASE("gantry: a cart that fails in motion is recorded until it stands, or for a second") {
  for (const bool friction : {true, false}) {
    Options options = by_twin(5);
    options.sends = "0.01:21=305";
    options.firmware.watch_sensor = true;
    if (!friction) options.axis.coulomb = options.axis.stiction = options.axis.viscous = 0;
    options.fault.kind = cosim::FaultKind::kConverterSaturated;
    options.fault.begin_s = 0.1;
    options.fault.value = -1;
    const Result result = lab::simulate(options);
    const Sample last = result.samples.back();
    CAPTURE(friction, last.v, result.seconds(last.edge));
    CHECK(result.end == cosim::EndReason::kFault);
    CHECK((std::fabs(last.v) < 1e-4) == friction);
    if (!friction) CHECK(result.seconds(last.edge) == Approx(1.1).margin(0.01));
    CHECK(result.fault_report.by == "A and B are not on their circle");
    CHECK(result.fault_report.begin == 5'000'000);
    CHECK(result.fault_report.detected > 5'000'000);
    CHECK(result.fault_report.unit == "mm");
  }
}

TEST_CASE("gantry: a run that looks for its trigger ends where it has found it") {
  const Options options = by_twin(0.3);
  cosim::TriggerSearch search(cosim::parse_trigger("force < -100", triggers(), 20'000));
  const Result run = test::run_to<Session, Result>(options, &search);
  REQUIRE(search.found());
  CHECK(run.end == cosim::EndReason::kDone);
  const auto& samples = run.samples;
  CHECK(samples.back().edge == *search.found());
  CHECK(samples.back().words.force[0] < -100);
  CHECK(samples[samples.size() - 2].words.force[0] >= -100);
}
