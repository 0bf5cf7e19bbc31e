// SPDX-License-Identifier: Apache-2.0
//
// The profile of the LM628 against the laws a trapezoid has to obey, and the numbers of the data
// sheet and AN-693.

#include "models/exact/motion/trapezoid.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "tests/support/checked.hpp"
#include "tests/support/random.hpp"

using trammel::exact::Trapezoid;
using trammel::test::Random;
using trammel::test::trials;
using Config = Trapezoid::Config;

namespace {

constexpr std::int64_t kOne = 65536;  // a count

// As likely to be small as large: 1..2^bits - 1.
std::int64_t spread(Random& random, unsigned bits) {
  return 1 + random() % ((1u << (1 + random() % bits)) - 1);
}

double ideal_samples(const Config& c, double way) {
  const double a = static_cast<double>(c.acceleration);
  const double v = static_cast<double>(c.velocity);
  return v * v / a <= way ? v / a + way / v : 2 * std::sqrt(way / a);
}

struct Fall {
  double samples = 0, way = 0;
};

// By steps of the acceleration to a lower speed.
Fall fall(double acceleration, double speed, double lowest) {
  Fall f;
  while (speed > lowest) {
    speed = std::max(speed - acceleration, lowest);
    f.way += speed;
    ++f.samples;
  }
  return f;
}

// From a speed to rest at a target so far off, as fast as steps of the acceleration let it.
double ideal_samples_on(const Config& c, double target, double speed) {
  if (target < 0) return ideal_samples_on(c, -target, -speed);
  const double a = static_cast<double>(c.acceleration), v = static_cast<double>(c.velocity);
  const Fall stop = fall(a, std::fabs(speed), 0);
  if (speed < 0) return stop.samples + ideal_samples(c, target + stop.way);
  if (stop.way > target) return stop.samples + ideal_samples(c, stop.way - target);
  if (speed > v) {  // down to V, on, and to rest
    const Fall down = fall(a, speed, v), last = fall(a, v, 0);
    return down.samples + (target - down.way - last.way) / v + last.samples;
  }
  // As from rest, without the part that is behind it.
  return ideal_samples(c, target + speed * speed / (2 * a) + speed / 2) - speed / a;
}

// The sample before the present one, and whether the step from it was within the limits.
struct Watch {
  std::int64_t speed = 0;
  int direction = 0;   // of the last motion
  int turns = 0;       // of it
  bool steep = false;  // a change of speed that only the last two samples of a move may have

  // now: the distance of this sample; after the last one it rests.
  void check(const Config& c, std::int64_t now, bool finished) {
    const std::int64_t change = std::abs(now - speed);
    if (change > 2 * c.acceleration || (steep && !finished)) FAIL("acceleration");
    if (finished && std::abs(now) > 2 * c.acceleration) FAIL("acceleration of the last sample");
    if (std::abs(now) > c.velocity && std::abs(now) >= std::abs(speed)) FAIL("velocity");
    steep = change > c.acceleration && !finished;
    if (now != 0) {
      if (direction * now < 0) ++turns;
      direction = now > 0 ? 1 : -1;
    }
    speed = finished ? 0 : now;
  }
};

std::int64_t rest_of(const Trapezoid& t) { return t.state.target * kOne - t.state.position; }

// Samples until the move is finished, every one within the limits; at most `patience`.
int run(Trapezoid& t, const Config& c, Watch& watch, int patience) {
  for (int n = 1; n <= patience; ++n) {
    const std::int64_t before = t.state.position;
    const bool finished = t.step(c);
    watch.check(c, t.state.position - before, finished);
    if (finished) return n;
  }
  return patience + 1;
}

Config position(std::int64_t acceleration, std::int64_t velocity) {
  Config c;
  c.acceleration = acceleration;
  c.velocity = velocity;
  return c;
}

int samples(const Config& c, std::int64_t target) {
  Trapezoid t;
  t.state.target = target;
  Watch watch;
  const int n = run(t, c, watch, 200000);
  CHECK(t.state.position == target * kOne);
  return n;
}

}  // namespace

TEST_CASE("trapezoid ends 10,000 random moves exactly, within limits and in time") {
  Random random(21);
  double worst = 0;
  for (int move = 0; move < trials(10000);) {
    const std::int64_t acceleration = spread(random, 30);
    const Config c = position(acceleration, spread(random, 30));
    const std::int64_t target = spread(random, 30) * (random() % 2 == 0 ? 1 : -1);
    const double ideal = ideal_samples(c, static_cast<double>(std::abs(target)) * kOne);
    if (ideal > 3000) continue;
    ++move;
    CAPTURE(c.acceleration, c.velocity, target);
    Trapezoid t;
    t.state.target = target;
    Watch watch;
    bool turned = false;
    int n = 0;
    for (bool finished = false; !finished && n < 4000; ++n) {
      const std::int64_t before = t.state.position;
      finished = t.step(c);
      watch.check(c, t.state.position - before, finished);
      turned = turned || (target > 0 ? t.state.speed < 0 : t.state.speed > 0);
    }
    REQUIRE(t.state.position == target * kOne);
    REQUIRE(t.state.speed == 0);
    REQUIRE_FALSE(turned);
    REQUIRE(n <= 1.001 * ideal + 3);
    worst = std::max(worst, n - ideal);
  }
  CHECK(worst < 3);
}

TEST_CASE("trapezoid ends 10,000 moves exactly whose speed and target change in motion") {
  Random random(22);
  double worst = 0;
  for (int move = 0; move < trials(10000); ++move) {
    const std::int64_t acceleration = spread(random, 24);
    Config c = position(acceleration, spread(random, 28));
    Trapezoid t;
    Watch watch;
    CAPTURE(move, c.acceleration);
    for (int change = 0; change < 4; ++change) {
      watch.steep = false;  // a new target may come between the last two samples
      const std::int64_t least = std::max<std::int64_t>(c.acceleration / 64, 1);
      c.velocity = std::min(least * spread(random, 12), (std::int64_t{1} << 30) - 1);
      const std::int64_t reach = std::min<std::int64_t>(c.velocity * 100 / kOne + 10, 1 << 30);
      t.state.target = static_cast<std::int64_t>(random()) % (2 * reach) - reach;
      run(t, c, watch, static_cast<int>(random() % 200));
    }
    const double ideal = ideal_samples_on(c, static_cast<double>(rest_of(t)),
                                          static_cast<double>(t.state.speed));
    watch.turns = 0;
    const int n = run(t, c, watch, static_cast<int>(2 * ideal) + 100);
    REQUIRE(watch.turns <= 1);
    worst = std::max(worst, n - 1.001 * ideal);
    REQUIRE(t.state.position == t.state.target * kOne);
    REQUIRE(t.state.speed == 0);
  }
  CHECK(worst < 3);
}

TEST_CASE("trapezoid's stopping distance is the sum of the falling speeds") {
  Random random(23);
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t a = spread(random, 12);
    const std::int64_t w = spread(random, 16);
    std::int64_t sum = 0;
    for (std::int64_t v = w - a; v > 0; v -= a) sum += v;
    REQUIRE(Trapezoid::stopping(w, a) == sum);
    const std::int64_t n = w / a;
    REQUIRE(2 * (w + sum) == (n + 1) * (w + w % a));
  }
  REQUIRE(Trapezoid::stopping(1000, 0) == 0);
  const std::int64_t top = (std::int64_t{1} << 30) - 1;
  REQUIRE(Trapezoid::stopping(top, 1) == top * (top - 1) / 2);
}

// Data sheet: 2000 counts per revolution, 1 rev/s^2 to 600 rpm, 100 revolutions in 19.54 s, 8 MHz.
TEST_CASE("L-05 trapezoid: the data sheet's move takes 19.54 s and ends at 200 000") {
  const int n = samples(position(9, 0x51EB8), 200000);
  REQUIRE(std::abs(n - 76345) <= 80);
}

TEST_CASE("E6 and E7 trapezoid: AN-693's moves take 11.718 s and 11.542 s") {
  REQUIRE(samples(position(2, 0x346E), 0x1F40) == 45772);
  REQUIRE(samples(position(0x11, 0x41893), 0x1D4C0) == 45087);
}

// A rule that never passes the stopping distance crawls here: 65,539 samples.
TEST_CASE("trapezoid does not crawl where the last step exceeds the stopping distance") {
  REQUIRE(samples(position(65536, 3 * 65536 + 1), 100) == 36);
}

TEST_CASE("trapezoid slows down by its acceleration beyond a target that came too near") {
  constexpr std::int64_t kA = 2 * kOne;
  const Config c = position(kA, 20 * kA);
  for (const std::int64_t speed : {2 * kA, 2 * kA + 1}) {
    Trapezoid t;
    t.state.target = 1;  // half of the acceleration away
    t.state.speed = speed;
    CAPTURE(speed);
    const bool ends = speed == 2 * kA;  // the last two samples may change it by twice as much
    REQUIRE(t.step(c) == ends);
    REQUIRE(t.state.position == (ends ? kOne : speed - kA));
    Watch watch;
    watch.speed = t.state.speed;
    run(t, c, watch, 100);
    REQUIRE(t.state.position == kOne);
  }
}

TEST_CASE("trapezoid without acceleration or speed holds where it stands") {
  for (const Config& c : {position(0, 100), position(100, 0)}) {
    Trapezoid t;
    t.state = {7 * kOne + 5, 0, 1000};
    REQUIRE(t.step(c));
    REQUIRE(t.state.target == 7);
    REQUIRE(t.state.position == 7 * kOne + 5);
  }
}

// AN-693 reference system: 17 counts a sample squared, 2 rev/s; then 4 rev/s; then to rest.
TEST_CASE("L-06 trapezoid: three velocity moves pass 80 000 and 160 000 and rest at 192 338") {
  Trapezoid t;
  Config c = position(0x11, 0x20C4A);
  c.mode = Trapezoid::Mode::kVelocity;
  int n = 0;
  const auto until = [&](std::int64_t count) {
    while (t.count() < count) {
      t.step(c);
      ++n;
    }
  };
  until(80000);
  CHECK(std::abs(n - 43010) <= 30);
  CHECK(t.count() <= 80003);
  c.velocity += 0x20C4A;
  until(160000);
  CHECK(std::abs(n - 64515) <= 30);
  CHECK(t.count() <= 160005);
  c.mode = Trapezoid::Mode::kSmoothStop;
  do {
    ++n;
  } while (!t.step(c));
  CHECK(std::abs(n - 80306) <= 30);
  CHECK(std::abs(t.count() - 192338) <= 60);
  CHECK(t.state.target == t.count());
}
