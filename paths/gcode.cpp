// SPDX-License-Identifier: Apache-2.0
#include "paths/gcode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "host/input_file.hpp"
#include "paths/gcode_arc.hpp"
#include "paths/gcode_block.hpp"
#include "paths/gcode_words.hpp"

namespace trammel::paths {
namespace {

using ideal::Move;
using ideal::Place;

constexpr double kWholeBelow_nm = 1e15;       // what is beyond is outside, and told as it is
constexpr double kLongestRest_s = 3600;       // of all G4 together
constexpr double kLongestDwell_s = 500;       // of one: readers that take P in milliseconds
constexpr double kMillimetre_nm = 1e6, kInch_nm = 25.4e6;
constexpr double kRadiusError_m = 0.02e-3;    // specification section 12
constexpr double kRadiusErrorShare = 1e-3;
constexpr double kRadiusRounding_m = 0.005e-3;  // R and the ends are rounded

// Positions are whole nanometres: the sum of many G91 steps is exact, and so is an inch.
struct Spot {
  std::int64_t x = 0, y = 0;

  Place place() const { return {static_cast<double>(x) / 1e9, static_cast<double>(y) / 1e9}; }
  bool operator==(const Spot& other) const { return x == other.x && y == other.y; }
};

double whole_nm(double nm) { return std::abs(nm) < kWholeBelow_nm ? std::round(nm) : nm; }
Spot spot_of(const Place& place) {
  return {std::llround(place.x * 1e9), std::llround(place.y * 1e9)};
}

class Program {
 public:
  Program(const std::string& name, const GcodeTable& table)
      : name_(name), table_(table), exact_(table.exact), at_(spot_of(table.start)) {
    result_.moves.start = rests_ = at_.place();
  }

  // Whether the program goes on.
  bool block(const GcodeBlock& block, const GcodeLine& line) {
    line_ = &line;
    if (block.skipped) note_skipped();
    if (block.percent) return percent();
    if (block.skipped) return true;
    began_ = began_ || !block.g.empty() || !block.m.empty() ||
             block.has_any("FHIJPRSTXYZ");
    const GcodeCommands commands = gcode_commands(block, line);
    for (const std::string& word : commands.ignored) ignore(word);
    if (commands.unit >= 0) set_unit(block, commands.unit == 20 ? kInch_nm : kMillimetre_nm);
    if (block.has('F')) set_feed(*block.of('F'));
    if (commands.path >= 0) exact_ = commands.path == 61;
    if (commands.distance >= 0) relative_ = commands.distance == 91;
    if (commands.motion >= 0) motion_ = commands.motion;
    if (commands.dwell) dwell(*block.of('P'));
    if (commands.home) home(block);
    if (commands.moves(block)) move(block);
    return !commands.end;
  }

  GcodeProgram finish(int last_line) {
    if (result_.moves.moves.empty()) {
      GcodeLine(name_, last_line).refuse("no motion in the program");
    }
    if (!ignored_.empty()) {
      std::string text;
      for (const auto& [word, line] : ignored_) {
        text += fmt::format("{}{} (line {})", text.empty() ? "" : ", ", word, line);
      }
      result_.warnings.push_back(fmt::format("{}: ignored: {}", name_, text));
    }
    return std::move(result_);
  }

 private:
  template <class... Parts>
  [[noreturn]] void refuse(fmt::format_string<Parts...> text, Parts&&... parts) const {
    line_->refuse(fmt::format(text, std::forward<Parts>(parts)...));
  }
  template <class... Parts>
  void warn(fmt::format_string<Parts...> text, Parts&&... parts) {
    result_.warnings.push_back(fmt::format("{}:{}: {}", name_, line_->number(),
                                           fmt::format(text, std::forward<Parts>(parts)...)));
  }

  void note_skipped() {
    if (!skipped_) warn("blocks that begin with '/' are skipped, this one and all others");
    skipped_ = true;
  }

  // The first begins the program, the second ends it.
  bool percent() {
    if (!percent_ && began_) refuse("'%' ends a program that began with '%'; this one did not");
    const bool begins = !percent_;
    percent_ = true;
    return begins;
  }

  void ignore(const std::string& word) {
    const bool known = std::any_of(ignored_.begin(), ignored_.end(),
                                   [&](const auto& one) { return one.first == word; });
    if (!known) ignored_.emplace_back(word, line_->number());
  }

  // Some controllers take an F beside it in the unit before, some in the one behind.
  void set_unit(const GcodeBlock& block, double unit_nm) {
    if (block.has('F') && unit_nm != unit_nm_) {
      refuse("F in the block that changes the unit; give it in the next one");
    }
    unit_nm_ = unit_nm;
  }

  void set_feed(double f) {
    if (!(f > 0)) refuse("F must be above 0");
    constexpr double kRounded = 1e-9;  // of a limit in m/s given in another unit
    const double unit = unit_nm_ * 1e-9 / 60;
    const double speed = f * unit;
    const char* const per = unit_nm_ == kMillimetre_nm ? "mm/min" : "inch/min";
    if (speed < table_.feed_min * (1 - kRounded)) {
      refuse("F = {:g} is out of range {:g}..{:g} {}", f, table_.feed_min / unit,
             table_.feed_max / unit, per);
    }
    if (speed > table_.feed_max * (1 + kRounded) && !lowered_) {
      lowered_ = true;
      warn("F = {:g} is lowered to {:g} {}, {}; so is any other above it", f,
           table_.feed_max / unit, per, table_.feed_max_name);
    }
    feed_ = std::min(speed, table_.feed_max);
  }

  // RS274 takes seconds; P500 and more is hardly meant so.
  void dwell(double s) {
    if (s >= kLongestDwell_s) {
      refuse("G4 P{:g}: P is in seconds here, in milliseconds for some controllers; permitted: "
             "below {:g} s", s, kLongestDwell_s);
    }
    rest_s_ += s;
    if (rest_s_ > kLongestRest_s) {
      refuse("G4 P{:g}: all rests of a program take {:g} s; permitted: {:g} s", s, rest_s_,
             kLongestRest_s);
    }
    auto& moves = result_.moves.moves;
    if (moves.empty()) {
      result_.moves.start_dwell += s;
    } else {
      moves.back().stop = true;
      moves.back().dwell += s;
    }
  }

  // The point of X and Y.
  Spot target(const GcodeBlock& block) const {
    return {target(block, 'X', at_.x, table_.low.x, table_.high.x),
            target(block, 'Y', at_.y, table_.low.y, table_.high.y)};
  }

  std::int64_t target(const GcodeBlock& block, char axis, std::int64_t from_nm, double low,
                      double high) const {
    const auto from = static_cast<double>(from_nm);
    const std::optional<double>& word = block.of(axis);
    const double to = word ? (relative_ ? from : 0) + whole_nm(*word * unit_nm_) : from;
    if (to / 1e9 < low - 1e-9 || to / 1e9 > high + 1e-9) {
      refuse("the point leaves the stroke: {} = {:.7g} mm; permitted: {:g}..{:g} mm", axis,
             to / 1e6, 1e3 * low, 1e3 * high);
    }
    return std::llround(to);
  }

  void check_inside(const Move& arc) const {
    const Extent extent = arc_extent(arc);
    const auto check = [this](char axis, double reached, double low, double high) {
      if (reached >= low - 1e-9 && reached <= high + 1e-9) return;
      refuse("the arc leaves the stroke: it reaches {} = {:.7g} mm; permitted: {:g}..{:g} mm", axis,
             1e3 * reached, 1e3 * low, 1e3 * high);
    };
    for (const Place& corner : {extent.low, extent.high}) {
      check('X', corner.x, table_.low.x, table_.high.x);
      check('Y', corner.y, table_.low.y, table_.high.y);
    }
  }

  void add(Move move, double feed, bool stop) {
    if (result_.moves.moves.size() == kMostMoves) {
      refuse("more than {} lines and arcs", kMostMoves);
    }
    move.feed = feed;
    move.stop = stop;
    move.exact = exact_;
    move.line = line_->number();
    result_.moves.moves.push_back(move);
    rests_ = move.to;
  }

  // A line to where the table is already is none.
  void line_to(const Spot& to, double feed, bool stop) {
    at_ = to;
    Move move;
    move.from = rests_;
    move.to = to.place();
    constexpr double kRounded = 1e-6;
    if (move.length() >= table_.shortest * (1 - kRounded)) add(move, feed, stop);
  }

  void home(const GcodeBlock& block) {
    if (block.has('X')) line_to(target(block), table_.rapid, true);
    line_to(spot_of(table_.home), table_.rapid, true);
  }

  void move(const GcodeBlock& block) {
    if (motion_ < 0) refuse("no G0, G1, G2 or G3 yet");
    if (motion_ <= 1 && block.has_any("IJR")) {
      refuse("I, J and R belong to G2 and G3; the motion is G{}", motion_);
    }
    if (motion_ != 0 && feed_ == 0) refuse("no F yet");
    const Spot to = target(block);
    if (motion_ <= 1) return line_to(to, motion_ == 0 ? table_.rapid : feed_, motion_ == 0);
    const bool center = block.has_any("IJ"), radius = block.has('R');
    if (center == radius) {
      refuse(center ? "R and I or J in one block" : "an arc needs I and J, or R");
    }
    const Place end = to == at_ ? rests_ : to.place();
    for (const Move& arc : radius ? by_radius(end, *block.of('R') * unit_nm_ * 1e-9)
                                  : by_center(end, center_of(block))) {
      check_radius(arc.radius(), 0.01);  // the centre may have moved
      check_inside(arc);
      add(arc, feed_, false);
    }
    at_ = to;
  }

  Place center_of(const GcodeBlock& block) const {
    const auto along = [&](char letter, std::int64_t from_nm) {
      return (static_cast<double>(from_nm) +
              whole_nm(block.of(letter).value_or(0) * unit_nm_)) / 1e9;
    };
    return {along('I', at_.x), along('J', at_.y)};
  }

  double nearest_ends() const { return std::max(kNearestArcEnds, table_.shortest); }

  void check_radius(double radius_m, double rounded) const {
    if (radius_m >= table_.radius_min * (1 - rounded) &&
        radius_m <= table_.radius_max * (1 + rounded)) {
      return;
    }
    refuse("the arc's radius of {:g} mm is out of range {:g}..{:g} mm", 1e3 * radius_m,
           1e3 * table_.radius_min, 1e3 * table_.radius_max);
  }

  std::vector<Move> by_radius(const Place& end, double radius) const {
    const double chord = std::hypot(end.x - rests_.x, end.y - rests_.y);
    if (chord < nearest_ends()) refuse("an arc with R needs another end point");
    if (std::abs(radius) < chord / 2 - kRadiusRounding_m) {
      refuse("R is too small for the end point: {:g} mm; permitted: {:g} mm and more, or as much "
             "below 0", 1e3 * radius, 1e3 * chord / 2);
    }
    check_radius(std::abs(radius), 1e-9);
    return {arc_of_radius(rests_, end, radius, motion_ == 3)};
  }

  std::vector<Move> by_center(const Place& end, const Place& center) const {
    const double chord = std::hypot(end.x - rests_.x, end.y - rests_.y);
    if (chord > 0 && chord < nearest_ends()) {
      refuse("the end is the start but for {:g} mm: a full circle ends where it begins",
             1e3 * chord);
    }
    const double radius = std::hypot(rests_.x - center.x, rests_.y - center.y);
    check_radius(radius, 1e-9);
    const double error = radius_error(rests_, end, center);
    if (error > kRadiusError_m && error > kRadiusErrorShare * radius) {
      refuse("start and end differ in radius by {:.3g} mm; permitted: {:g} mm or {:g} %",
             1e3 * error, 1e3 * kRadiusError_m, 100 * kRadiusErrorShare);
    }
    return arc_around(rests_, end, center, motion_ == 3);
  }

  const std::string& name_;
  const GcodeTable& table_;
  GcodeProgram result_;
  const GcodeLine* line_ = nullptr;
  std::vector<std::pair<std::string, int>> ignored_;  // with the line where each came first
  bool skipped_ = false, lowered_ = false, began_ = false, percent_ = false;

  double unit_nm_ = kMillimetre_nm;
  bool relative_ = false, exact_;
  int motion_ = -1;
  double feed_ = 0;  // [m/s]; 0: none yet
  double rest_s_ = 0;
  Spot at_;       // the program's point
  Place rests_;   // where the moves so far end: nearer to it than the shortest line
};

// Programs that write text mark its encoding in the first bytes.
std::string_view unmarked(std::string_view text, const std::string& name) {
  const std::string_view mark = text.substr(0, 2);
  if (mark == "\xFF\xFE" || mark == "\xFE\xFF") {
    GcodeLine(name, 1).refuse("UTF-16 text; save it as UTF-8 or ASCII");
  }
  return host::past_mark(text);
}

}  // namespace

GcodeProgram read_gcode(std::string_view text, const std::string& name, const GcodeTable& table) {
  Program program(name, table);
  text = unmarked(text, name);
  int number = 0;
  for (bool more = true; more && !text.empty();) {
    const auto end = text.find('\n');
    std::string_view one = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    if (!one.empty() && one.back() == '\r') one.remove_suffix(1);
    const GcodeLine line(name, ++number);
    more = program.block(read_gcode_block(one, line), line);
  }
  return program.finish(std::max(1, number));
}

GcodeProgram read_gcode_file(const std::string& file, const GcodeTable& table) {
  constexpr std::uintmax_t kMost = 16 * host::kMiB;
  return read_gcode(host::read_file(file, kMost), file, table);
}

}  // namespace trammel::paths
