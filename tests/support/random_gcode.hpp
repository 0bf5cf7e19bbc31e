// SPDX-License-Identifier: Apache-2.0
//
// Programs of G-code from a seed, inside 200 x 200 mm around the middle of a table of 600 mm, with
// what they ask for: the same with every compiler. Lengths in whole micrometres.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace trammel::test {

struct AskedMove {
  bool arc = false;
  std::int64_t x = 0, y = 0;  // end [um]
  double center_x = 0, center_y = 0;  // [um]
  double sweep = 0;           // [rad], above 0 counter-clockwise
  double feed = 0;            // [m/s]
  bool stop = false, exact = false;
  double dwell = 0;           // [s]
};

class RandomGcode {
 public:
  static constexpr std::int64_t kLow = 150000, kHigh = 350000, kMiddle = 250000;  // [um]
  static constexpr double kRapid = 0.5;                                           // [m/s]

  RandomGcode(unsigned seed, std::size_t moves) : random_(seed) {
    if (chance(2)) text += "%\n";
    block("G21 G90 G17 G94 G64");
    feed();
    while (asked.size() < moves) element();
    block(chance(2) ? "M2" : "M30");
    if (chance(2)) text += "%\nwhat follows is not read\n";
  }

  std::string text;
  std::vector<AskedMove> asked;

 private:
  std::int64_t below(std::int64_t n) {
    return static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(n));
  }
  std::int64_t between(std::int64_t low, std::int64_t high) { return low + below(high - low + 1); }
  bool chance(std::int64_t one_in) { return below(one_in) == 0; }
  double angle(double low, double high) {
    return low + (high - low) * static_cast<double>(below(100001)) / 1e5;
  }

  // As people and programs write it.
  void block(std::string words) {
    for (char& c : words) {
      if (c >= 'A' && c <= 'Z' && chance(8)) c = static_cast<char>(c - 'A' + 'a');
    }
    std::string line;
    if (chance(6)) line += "N" + std::to_string(10 * ++number_) + " ";
    for (const char c : words) {
      if (c != ' ' || !chance(4)) line += c;
      if (chance(60)) line += ' ';
    }
    if (chance(10)) line += " (a comment)";
    if (chance(12)) line += " ; another";
    text += line + (chance(5) ? "\r\n" : "\n");
    if (chance(12)) text += chance(2) ? "\n" : "(G1 X1000)\n";
  }

  // `value` counts 1 / 10^digits.
  std::string decimal(std::int64_t value, int digits) {
    std::string all = std::to_string(std::abs(value));
    while (static_cast<int>(all.size()) <= digits) all.insert(all.begin(), '0');
    std::string whole = all.substr(0, all.size() - static_cast<std::size_t>(digits));
    std::string part = all.substr(whole.size());
    if (chance(2)) {
      while (!part.empty() && part.back() == '0') part.pop_back();
    }
    if (whole == "0" && !part.empty() && chance(2)) whole.clear();
    const std::string sign = value < 0 ? "-" : chance(10) ? "+" : "";
    return sign + whole + (part.empty() && !chance(8) ? "" : "." + part);
  }
  std::string mm(std::int64_t um) { return decimal(um, 3); }

  static bool inside(double x, double y) {
    return x >= kLow && x <= kHigh && y >= kLow && y <= kHigh;
  }

  std::string end_words(std::int64_t x, std::int64_t y) {
    std::string words;
    if (x != x_ || chance(3)) words += " X" + mm(relative_ ? x - x_ : x);
    if (y != y_ || chance(3)) words += " Y" + mm(relative_ ? y - y_ : y);
    return words;
  }

  void ask(AskedMove move, double feed, bool stop) {
    move.feed = feed;
    move.stop = stop;
    move.exact = exact_;
    asked.push_back(move);
    x_ = move.x;
    y_ = move.y;
  }

  void line(std::int64_t x, std::int64_t y, int code) {
    if (x == x_ && y == y_) return;
    block((code == motion_ && chance(2) ? "" : "G" + std::to_string(code)) + end_words(x, y));
    motion_ = code;
    AskedMove move;
    move.x = x;
    move.y = y;
    ask(move, code == 0 ? kRapid : feed_, code == 0);
  }

  void line(int code) { line(between(kLow, kHigh), between(kLow, kHigh), code); }

  void arc() {
    const double radius = static_cast<double>(between(1000, 50000)), begin = angle(0, 6.28);
    const std::int64_t i = std::llround(-radius * std::cos(begin));
    const std::int64_t j = std::llround(-radius * std::sin(begin));
    AskedMove move;
    move.arc = true;
    move.center_x = static_cast<double>(x_ + i);
    move.center_y = static_cast<double>(y_ + j);
    const bool left = chance(2), full = chance(5);
    const double turn = full ? 2 * kTurn : angle(0.1, 6.2);
    move.sweep = left ? turn : -turn;
    move.x = full ? x_ : std::llround(move.center_x + radius * std::cos(begin + move.sweep));
    move.y = full ? y_ : std::llround(move.center_y + radius * std::sin(begin + move.sweep));
    for (double at = 0; at <= turn + 0.05; at += 0.05) {
      const double on = begin + (left ? at : -at);
      if (!inside(move.center_x + 1.01 * radius * std::cos(on),
                  move.center_y + 1.01 * radius * std::sin(on))) {
        return;
      }
    }
    if (!inside(static_cast<double>(move.x), static_cast<double>(move.y))) return;
    const int code = left ? 3 : 2;
    std::string words = code == motion_ && chance(2) ? "" : "G" + std::to_string(code);
    words += end_words(move.x, move.y);
    // Near half a turn the centre hangs on the last digit of R.
    if (!full && chance(2) && std::abs(turn - kTurn) > 0.4 && turn < 5.8) {
      words += " R" + mm(std::llround(turn < kTurn ? radius : -radius));
    } else {
      if (i != 0 || j == 0) words += " I" + mm(i);
      if (j != 0) words += " J" + mm(j);
    }
    block(words);
    motion_ = code;
    ask(move, feed_, false);
  }

  // A bent line in chords of 0.5 mm.
  void spline() {
    double heading = angle(0, 6.28), bend = 0;
    for (std::int64_t k = between(8, 40); k > 0; --k) {
      bend = std::fmin(0.05, std::fmax(-0.05, bend + angle(-0.01, 0.01)));
      heading += bend;
      const std::int64_t x = x_ + std::llround(500 * std::cos(heading));
      const std::int64_t y = y_ + std::llround(500 * std::sin(heading));
      if (!inside(static_cast<double>(x), static_cast<double>(y))) return;
      line(x, y, 1);
    }
  }

  void feed() {
    const std::int64_t f = between(6000, 36000);  // [mm/min]
    feed_ = static_cast<double>(f) * 1e-3 / 60;
    block("F" + decimal(f, 0));
  }

  void dwell() {
    const std::int64_t ms = below(60);
    block("G4 P" + decimal(ms, 3));
    if (asked.empty()) return;
    asked.back().stop = true;
    asked.back().dwell += static_cast<double>(ms) * 1e-3;
  }

  // Hundredths of an inch are whole micrometres.
  void inches() {
    const std::int64_t dx = between(-200, 200), dy = between(-200, 200);
    const std::int64_t x = x_ + 254 * dx, y = y_ + 254 * dy;
    if ((dx == 0 && dy == 0) || !inside(static_cast<double>(x), static_cast<double>(y))) return;
    block("G20 G91 G1 X" + decimal(dx, 2) + " Y" + decimal(dy, 2));
    block(relative_ ? "G21" : "G21 G90");
    motion_ = 1;
    AskedMove move;
    move.x = x;
    move.y = y;
    ask(move, feed_, false);
  }

  void home() {
    if (x_ == kMiddle && y_ == kMiddle) return;
    block("G28");
    AskedMove move;
    move.x = move.y = kMiddle;
    ask(move, kRapid, true);
  }

  void nothing() {
    static const char* const kNothing[] = {"/G1 X9999 (skipped", "M3 S8000", "T1 M6", "G64 P.02",
                                           "Z5.", "G17", "G94", ";"};
    const std::string one = kNothing[below(8)];
    if (one == "G64 P.02") exact_ = false;
    one[0] == '/' ? void(text += one + "\n") : block(one);
  }

  void element() {
    switch (below(16)) {
      case 0: return line(0);
      case 1: case 2: return line(1);
      case 3: return spline();
      case 4: return feed();
      case 5: return dwell();
      case 6: return inches();
      case 7: return nothing();
      case 8: {
        exact_ = chance(3);
        return block(exact_ ? "G61" : "G64");
      }
      case 9: {
        relative_ = chance(2);
        return block(relative_ ? "G91" : "G90");
      }
      case 10: return chance(4) ? home() : arc();
      default: return arc();
    }
  }

  static constexpr double kTurn = 3.14159265358979323846;

  std::mt19937 random_;
  std::int64_t x_ = kMiddle, y_ = kMiddle;
  int motion_ = -1, number_ = 0;
  bool relative_ = false, exact_ = false;
  double feed_ = 0;
};

}  // namespace trammel::test
