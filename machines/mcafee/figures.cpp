// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine mcafee is judged by, and the columns of its trace.
#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "machines/mcafee/machine_members.hpp"
#include "machines/mcafee/signals.hpp"
#include "parts/lm628/columns.hpp"

namespace trammel::mcafee {
namespace {

// Of Stage III from the first row on, of the others from the first motion.
struct Motion {
  double time_s = 0;          // until the desired position stood for good
  double contour_max_mm = 0;  // distance of the table from the path: its largest,
  double contour_max_s = 0;   // when that was, from the first row on,
  double contour_rms_mm = 0;  // its root mean square while moving,
  double contour_end_mm = 0;  // and at the end
  double overshoot_mm = 0;    // farthest behind the end of an open path, along its direction there
};

// What began with sample k.
void add_events(Result& result, const Sample& before, const Sample& s, std::size_t k) {
  for (std::size_t a = 0; a < 2; ++a) {
    const lm628::Words& w = s.axis[a].words;
    const auto add = [&](const std::string& what) {
      result.events.push_back({k, result.seconds(s.edge), static_cast<int>(a), what,
                               w.position >> 16, w.actual, w.status});
    };
    if (s.axis[a].host_irq && !before.axis[a].host_irq) add("interrupt");
    const unsigned begun = w.status & ~before.axis[a].words.status;
    if ((begun & sw::lm628_status::kMotorOff) != 0) add("motor off");
    for (const auto& [name, bit] : {std::pair{"low switch", 2 * a}, {"high switch", 2 * a + 1}}) {
      const unsigned open = s.limits >> bit & 1;
      if (open == (before.limits >> bit & 1)) continue;
      add(std::string(name) + (open != 0 ? " open" : " closed"));
    }
  }
}

// Also puts into the result where its motion begins, and the events.
Motion motion_of(const Options& options, Result& result) {
  Motion m;
  result.first = 0;
  result.events.clear();
  if (result.contour_mm.empty()) find_contour(options, result);
  const bool path = options.tracks();
  double squares = 0;
  std::size_t last = 0;
  bool begun = false;
  const std::optional<Path> shape = path ? std::optional<Path>(options.path) : std::nullopt;
  Sample before;
  for (std::size_t k = 0; k < result.samples.size(); ++k) {
    const Sample s = result.samples[k];
    const bool moves = k > 0 && (s.axis[0].words.position != before.axis[0].words.position ||
                                 s.axis[1].words.position != before.axis[1].words.position);
    if (k > 0) add_events(result, before, s, k);
    before = s;
    if (!begun && (path ? s.row > 0 : moves)) {
      begun = true;
      result.first = k;
    }
    if (begun && moves) last = k;
    if (!path) continue;
    if (s.row == result.table.rows.size()) {
      const PointMm table(s.axis[0].x_mm, s.axis[1].x_mm);
      m.overshoot_mm = std::max(m.overshoot_mm, shape->behind_end(shape->at(0) + table));
    }
    m.contour_end_mm = result.contour_mm[k];
    if (m.contour_end_mm > m.contour_max_mm) {
      m.contour_max_mm = m.contour_end_mm;
      m.contour_max_s = begun ? static_cast<double>(k - result.first) * options.sample_s() : 0;
    }
    if (begun) squares += m.contour_end_mm * m.contour_end_mm;
  }
  const auto moving = result.samples.size() - result.first;
  if (path && moving > 0) m.contour_rms_mm = std::sqrt(squares / static_cast<double>(moving));
  if (last > result.first) m.time_s = static_cast<double>(last - result.first) * options.sample_s();
  return m;
}

}  // namespace

std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  auto& result = static_cast<Result&>(run);
  const Motion m = motion_of(options, result);
  const auto largest = [&](auto get) {  // of an axis
    double most = 0;
    for (const Sample& s : result.samples) {
      for (const AxisSample& a : s.axis) {
        most = std::max(most, std::fabs(static_cast<double>(std::invoke(get, a))));
      }
    }
    return most;
  };
  const double desired = largest([](const AxisSample& a) { return a.words.speed; }) /
                         lm628::kPerCount * options.count_mm() / options.sample_s();
  std::vector<lab::Figure> list;
  const auto add = [&list](lab::Figure f, const char* tile = "") {
    f.tile = tile;
    list.push_back(std::move(f));
  };
  using lab::count;
  using lab::figure;
  add(figure("motion.time_s", "motion", "", m.time_s, "s"),
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
    if (!Path(options.path).closed()) {
      add(figure("motion.overshoot_mm", "overshoot", "behind the end", m.overshoot_mm, "mm", 4));
    }
  }
  add(count("motion.max_error_counts", "largest error", "",
            largest([](const AxisSample& a) { return a.words.error; }), "counts"),
      options.tracks() ? "" : "Largest error");
  add(figure("motion.max_speed_mm_s", "largest speed", "", largest(&AxisSample::mm_s), "mm/s", 2),
      "Top speed");
  add(figure("motion.max_desired_mm_s", "largest speed", "desired", desired, "mm/s", 2));
  add(figure("motion.max_current_A", "largest current", "", largest(&AxisSample::i), "A", 2),
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
          [](const At& at) { return at.result.seconds(at.sample.edge); });
    const auto own = [&t](OwnSignal which, bool bits, ColumnTable::Get get) {
      const cosim::Word& word = kOwnWords[static_cast<std::size_t>(which)];
      t.add({word.name, word.unit, 1, {}, word.help, !bits, bits}, std::move(get));
    };
    own(OwnSignal::kRow, false, [](const At& at) { return static_cast<double>(at.sample.row); });
    own(OwnSignal::kSpeed, false, [](const At& at) { return static_cast<double>(at.sample.v); });
    own(OwnSignal::kLimits, true,
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
