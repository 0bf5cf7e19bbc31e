// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "paths/gcode.hpp"
#include "tests/support/moves_check.hpp"
#include "tests/support/random_gcode.hpp"

namespace {

using namespace trammel;
using test::AskedMove;
using test::moves_problem;
using test::RandomGcode;
using ideal::Move;

paths::GcodeTable table() {
  paths::GcodeTable t;
  t.start = t.home = {0.25, 0.25};
  return t;
}

std::string number(double metres) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6f", 1e3 * metres);
  return text;
}

// The same moves as plainly as can be.
std::string text_of(const ideal::Moves& all) {
  std::string text = "G4 P" + std::to_string(all.start_dwell) + "\n";
  for (const Move& m : all.moves) {
    const bool rapid = m.kind == Move::Kind::kLine && m.stop && m.feed == 0.5;
    char feed[40];
    std::snprintf(feed, sizeof feed, "%.9f", m.feed * 60e3);
    text += std::string(m.exact ? "G61" : "G64") + " F" + feed;
    text += m.kind == Move::Kind::kLine ? (rapid ? " G0" : " G1") : m.sweep > 0 ? " G3" : " G2";
    text += " X" + number(m.to.x) + " Y" + number(m.to.y);
    if (m.kind == Move::Kind::kArc) {
      text += " I" + number(m.center.x - m.from.x) + " J" + number(m.center.y - m.from.y);
    }
    text += "\n";
    if (m.stop && !(rapid && m.dwell == 0)) text += "G4 P" + std::to_string(m.dwell) + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("random programs ask for what they were made of") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const RandomGcode program(seed, 60);
    CAPTURE(seed, program.text);
    const ideal::Moves all = paths::read_gcode(program.text, "p.ngc", table()).moves;
    REQUIRE(moves_problem(all, {0.149, 0.149}, {0.351, 0.351}).empty());
    std::size_t at = 0;
    for (const AskedMove& asked : program.asked) {
      REQUIRE(at < all.moves.size());
      const Move* m = &all.moves[at++];
      CHECK((m->kind == Move::Kind::kArc) == asked.arc);
      double sweep = m->sweep;
      if (asked.arc) {
        const double off = std::hypot(m->center.x - 1e-6 * asked.center_x,
                                      m->center.y - 1e-6 * asked.center_y);
        CHECK(off < 20e-6);  // ends, I, J and R have three digits
        const bool two = std::abs(sweep) < std::abs(asked.sweep) - 0.5;
        if (two) sweep += (m = &all.moves[at++])->sweep;
        CHECK(sweep == Approx(asked.sweep).margin(0.01));
      }
      CHECK(m->to.x == static_cast<double>(asked.x) / 1e6);
      CHECK(m->to.y == static_cast<double>(asked.y) / 1e6);
      CHECK(m->feed == Approx(asked.feed));
      CHECK(m->stop == asked.stop);
      CHECK(m->exact == asked.exact);
      CHECK(m->dwell == Approx(asked.dwell).margin(1e-12));
    }
    CHECK(at == all.moves.size());
  }
}

TEST_CASE("moves written as G-code are read as the same moves") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const RandomGcode program(seed, 60);
    const ideal::Moves all = paths::read_gcode(program.text, "p.ngc", table()).moves;
    const std::string text = text_of(all);
    CAPTURE(seed, text);
    const ideal::Moves again = paths::read_gcode(text, "again.ngc", table()).moves;
    CHECK(again.start_dwell == Approx(all.start_dwell).margin(1e-6));
    REQUIRE(again.moves.size() == all.moves.size());
    for (std::size_t k = 0; k < all.moves.size(); ++k) {
      CAPTURE(k);
      const Move &a = all.moves[k], &b = again.moves[k];
      CHECK(a.kind == b.kind);
      CHECK(std::hypot(a.to.x - b.to.x, a.to.y - b.to.y) < 1e-9);
      CHECK(std::hypot(a.center.x - b.center.x, a.center.y - b.center.y) < 20e-9);
      CHECK(b.sweep == Approx(a.sweep).margin(1e-6));
      CHECK(b.feed == Approx(a.feed));
      CHECK(b.stop == a.stop);
      CHECK(b.exact == a.exact);
      CHECK(b.dwell == Approx(a.dwell).margin(1e-6));
    }
  }
}

TEST_CASE("damaged programs are refused in a line, or give moves that hold together") {
  std::mt19937 random(1);
  std::vector<std::string> seeds;
  for (unsigned seed = 1; seed <= 20; ++seed) seeds.push_back(RandomGcode(seed, 20).text);
  const std::string letters = "GXYIJRFPMN0123456789.+-()%;/ \n\r\t\xFF";
  int taken = 0, refused = 0;
  for (int k = 0; k < 4000; ++k) {
    std::string text = seeds[random() % seeds.size()];
    for (unsigned change = random() % 4 + 1; change > 0; --change) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0: text.erase(at, random() % 20 + 1); break;
        case 1: text.insert(at, 1, letters[random() % letters.size()]); break;
        case 2: text[at] = letters[random() % letters.size()]; break;
        default: text.insert(at, text.substr(random() % text.size(), random() % 30));
      }
      if (text.empty()) text = "G0";
    }
    CAPTURE(k, text);
    try {
      const ideal::Moves all = paths::read_gcode(text, "p.ngc", table()).moves;
      const std::string problem = moves_problem(all, {0, 0}, {0.6, 0.6});
      CAPTURE(problem);
      CHECK(problem.empty());
      ++taken;
    } catch (const std::invalid_argument& error) {
      const std::string message = error.what();
      CHECK_THAT(message, Catch::StartsWith("p.ngc:"));
      CHECK_THAT(message, !Catch::Contains("\n"));
      CHECK(message.size() < 300);
      ++refused;
    }
  }
  CHECK(taken > 300);
  CHECK(refused > 1000);
}
