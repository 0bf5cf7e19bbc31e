// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/figures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "machines/mcafee/machine.hpp"
#include "parts/lm628/columns.hpp"

namespace trammel::mcafee {
namespace {

constexpr const char* kSwitches[] = {"low switch", "high switch"};

bool same_target(const Sample& a, const Sample& b) {
  return a.axis[0].words.position == b.axis[0].words.position &&
         a.axis[1].words.position == b.axis[1].words.position;
}

// What began with sample k.
void add_events(std::vector<Event>& events, const Sample& before,
                const Sample& s, std::size_t k) {
  for (std::size_t a = 0; a < 2; ++a) {
    const lm628::Words& w = s.axis[a].words;
    const auto add = [&](const std::string& what) {
      events.push_back({k, lab::seconds_of(s.edge), static_cast<int>(a), what,
                        w.position >> 16, w.actual, w.status});
    };
    if (s.axis[a].host_irq && !before.axis[a].host_irq) add("interrupt");
    const unsigned begun = w.status & ~before.axis[a].words.status;
    if ((begun & sw::lm628_status::kMotorOff) != 0) add("motor off");
    for (std::size_t end = 0; end < 2; ++end) {
      const unsigned open = s.limits >> (2 * a + end) & 1;
      if (open == (before.limits >> (2 * a + end) & 1)) continue;
      add(std::string(kSwitches[end]) + (open != 0 ? " open" : " closed"));
    }
  }
}

}  // namespace

Metrics evaluate(const Options& options, Result& result) {
  Metrics m;
  result.first = 0;
  result.events.clear();
  result.contour_mm = {};
  const bool tracks = options.tracks();
  std::optional<Path> path;
  if (tracks) path.emplace(options.path);
  const PointMm origin = tracks ? path->at(0) : PointMm{};
  constexpr double kReachMm = 10;  // a path may cross itself
  double squares = 0;
  std::size_t last = 0;
  bool begun = false;
  Sample before;
  const double count_mm = options.count_mm();
  for (std::size_t k = 0; k < result.samples.size(); ++k) {
    const Sample s = result.samples[k];
    const bool moves = k > 0 && !same_target(s, before);
    if (k > 0) add_events(result.events, before, s, k);
    before = s;
    if (!begun && (tracks ? s.row > 0 : moves)) {
      begun = true;
      result.first = k;
    }
    if (begun && moves) last = k;
    if (tracks) {
      const PointMm at{origin.x + s.axis[0].x_mm, origin.y + s.axis[1].x_mm};
      const double way = result.table.row_mm * s.row;
      m.contour_end_mm = path->distance(at, way, kReachMm);
      result.contour_mm.push_back(m.contour_end_mm);
      if (m.contour_end_mm > m.contour_max_mm) {
        m.contour_max_mm = m.contour_end_mm;
        m.contour_max_s = begun ? static_cast<double>(k - result.first) * kSampleS : 0;
      }
      if (begun) squares += m.contour_end_mm * m.contour_end_mm;
    }
    for (const AxisSample& a : s.axis) {
      m.max_error_counts = std::max<std::int64_t>(m.max_error_counts, std::abs(a.words.error));
      const double speed =
          std::fabs(static_cast<double>(a.words.speed)) / lm628::kPerCount * count_mm;
      m.max_desired_mm_s = std::max(m.max_desired_mm_s, speed / kSampleS);
      m.max_speed_mm_s = std::max(m.max_speed_mm_s, std::fabs(a.mm_s));
      m.max_current_A = std::max(m.max_current_A, std::fabs(a.i));
    }
  }
  const auto moving = result.samples.size() - result.first;
  if (tracks && moving > 0) m.contour_rms_mm = std::sqrt(squares / static_cast<double>(moving));
  if (last > result.first) m.moving_s = static_cast<double>(last - result.first) * kSampleS;
  return m;
}

std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  auto& result = static_cast<Result&>(run);
  const Metrics m = evaluate(options, result);
  std::vector<lab::Figure> list;
  const auto add = [&list](lab::Figure f, const char* tile = "") {
    f.tile = tile;
    list.push_back(std::move(f));
  };
  using lab::count;
  using lab::figure;
  add(figure("motion.time_s", "motion", "", m.moving_s, "s"),
      options.stage == sw::McafeeStage::kRead ? "" : "Time");
  if (options.tracks()) {
    const std::size_t rows = result.samples.empty() ? 0 : result.samples.back().row;
    add(count("motion.rows", "motion", "rows", static_cast<double>(rows)));
    add(figure("motion.contour_max_mm", "contour error", "largest", m.contour_max_mm, "mm", 4),
        "Largest contour error");
    add(figure("motion.contour_max_s", "contour error", "largest at", m.contour_max_s, "s"));
    add(figure("motion.contour_rms_mm", "contour error", "rms", m.contour_rms_mm, "mm", 4),
        "Rms contour error");
    add(figure("motion.contour_end_mm", "contour error", "at the end", m.contour_end_mm, "mm", 4));
  }
  add(count("motion.max_error_counts", "largest error", "",
            static_cast<double>(m.max_error_counts), "counts"),
      options.tracks() ? "" : "Largest error");
  add(figure("motion.max_speed_mm_s", "largest speed", "", m.max_speed_mm_s, "mm/s", 2),
      "Top speed");
  add(figure("motion.max_desired_mm_s", "largest speed", "desired", m.max_desired_mm_s, "mm/s", 2));
  add(figure("motion.max_current_A", "largest current", "", m.max_current_A, "A", 2),
      "Peak current");
  add(count("real_count.0", "end position", "X", result.real[0], "counts"),
      options.tracks() ? "" : "X at the end");
  add(count("real_count.1", "end position", "Y", result.real[1], "counts"));
  add(count("motion.events", "interrupts and switches", "",
            static_cast<double>(result.events.size())));
  if (options.stage == sw::McafeeStage::kRead) {
    add(count("readings", "readings of X", "", result.readings), "Readings");
  }
  return list;
}

void add_metrics(const lab::Record& record, nlohmann::ordered_json& json) {
  const Result& result = result_of(record);
  auto& all = json["events"] = nlohmann::ordered_json::array();
  for (const Event& one : result.events) {
    all.push_back({{"sample", one.sample}, {"time_s", one.time_s},
                   {"axis", one.axis == 0 ? "x" : "y"}, {"what", one.what},
                   {"desired_count", one.desired}, {"real_count", one.real},
                   {"status", one.status}});
  }
  json["run"]["first_sample"] = options_of(record).tracks() ? result.first : 0;
}

const lab::ColumnTable& columns() {
  static const lab::ColumnTable all = [] {
    using ColumnTable = lab::Columns<Options, Result>;
    using At = ColumnTable::At;
    using lab::fixed;
    using lab::general;
    ColumnTable t;
    t.add({"t_s", "s", 1e-8, fixed(8), "time from the start of the run"},
          [](const At& at) { return lab::seconds_of(at.sample.edge); });
    t.add({"row", "", 1, {}, "rows begun, Stage III", true},
          [](const At& at) { return static_cast<double>(at.sample.row); });
    t.add({"v", "", 1, {}, "speed of the last of them, 0..255", true},
          [](const At& at) { return static_cast<double>(at.sample.v); });
    t.add({"limits", "", 1, {}, "open switches: bits X low, X high, Y low, Y high", false, true},
          [](const At& at) { return static_cast<double>(at.sample.limits); });
    t.add({"contour_mm", "mm", 1e-5, fixed(5), "distance from the path, Stage III", true},
          [](const At& at) {
            return at.result.contour_mm.empty() ? 0 : at.result.contour_mm[at.index];
          });
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string axis = k == 0 ? "x_" : "y_";
      const auto words = [k](const At& at) -> const lm628::Words& {
        return at.sample.axis[k].words;
      };
      const auto add = [&](const char* name, lab::Column column, double AxisSample::* member) {
        column.name = axis + name;
        t.add(column, [k, member](const At& at) { return at.sample.axis[k].*member; });
      };
      lm628::add_trajectory(t, axis, words, true);
      add("mm", {"", "mm", 1e-5, fixed(5), "true position from the start", true},
          &AxisSample::x_mm);
      add("mm_s", {"", "mm/s", 1e-3, fixed(4), "true speed", true}, &AxisSample::mm_s);
      lm628::add_filter_words(t, axis, words,
                              [k](const At& at) { return at.sample.axis[k].host_irq; }, false);
      add("i_A", {"", "A", 1e-5, general(5), "true current of the motor"}, &AxisSample::i);
      add("u_V", {"", "V", 1e-4, general(5), "voltage that the amplifier is told to give"},
          &AxisSample::volt);
    }
    return std::move(t).table();
  }();
  return all;
}

}  // namespace trammel::mcafee
