// SPDX-License-Identifier: Apache-2.0
//
// The fit of the observer's polynomials: a run over a sensor with errors, and how far the phase
// that the observer then computes is from the angle.
#include <catch2/catch.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "models/exact/sense/calibration.hpp"
#include "models/plant/stripe_track.hpp"
#include "sw_nios/apps/gantry/calibration_fit.hpp"
#include "tests/support/stripe_sensor.hpp"

using namespace trammel;

namespace {

constexpr double kUnit_um = 5000.0 / 16384;

// Conversions of a motion that comes to its speed with 40 ms, A and B in turn.
std::unique_ptr<sw::CalibrationFit> run_over(const plant::StripeTrack& track, double speed) {
  auto fit = std::make_unique<sw::CalibrationFit>();
  for (std::uint32_t tick = 0; !fit->full(); ++tick) {
    const double t = tick / 4612.0, x = speed * (t - 0.04 * (1 - std::exp(-t / 0.04)));
    const bool of_a = tick % 2 == 0;
    fit->add(tick, of_a, track.code(of_a ? 0 : 2, x, speed));
  }
  return fit;
}

// The phase of the observer, region by the true angle; each product is cut as there.
int phase_of(const sw::CalibrationWords& words, unsigned region, int code) {
  const auto word = [&](unsigned k) { return static_cast<std::int16_t>(words[k]); };
  const int x = (code - 512) * 64 - word(10 + region);
  int p = word(14 + 4 * region);
  for (unsigned n = 1; n < 4; ++n) p = (p * x >> 14) + word(14 + 4 * region + n);
  return p & 16383;
}

// Largest distance from the angle, once their mean is taken away [um].
double error_of(const sw::CalibrationWords& words, const plant::StripeTrack& track) {
  double low = 1e9, high = -1e9;
  for (int k = 0; k < 5000; ++k) {
    const double x = 1e-6 * k, angle = 16384 * k / 5000.0;
    const unsigned region = static_cast<unsigned>(angle / 4096 + 0.5) % 4;
    const int phase = phase_of(words, region, track.code(region % 2 == 0 ? 2 : 0, x, 0));
    const double off = std::remainder(phase - angle, 16384.0);
    low = std::min(low, off);
    high = std::max(high, off);
  }
  return (high - low) / 2 * kUnit_um;
}

}  // namespace

TEST_CASE("after the fit a sensor with 2 % of amplitude, offset and phase error is within 20 um") {
  for (const int signs : {0, 1, 2, 3, 4, 5, 6, 7}) {
    plant::StripeTrackConfig c;
    c.defect_units = {0, 0};
    c.amplitude_a_error = (signs & 1) != 0 ? 0.02 : -0.02;
    c.amplitude_b_error = -c.amplitude_a_error;
    c.offset_a_error = (signs & 2) != 0 ? 0.02 : -0.02;
    c.offset_b_error = -c.offset_a_error;
    c.phase_b_error = (signs & 4) != 0 ? 0.02 : -0.02;
    const plant::StripeTrack track(c);
    sw::CalibrationWords words{};
    REQUIRE(run_over(track, 0.1267)->fit(words));
    CAPTURE(signs);
    CHECK(error_of(words, track) < 20);
  }
}

TEST_CASE("the fit of an ideal sensor is within 4 um and near the cubic of the specification") {
  plant::StripeTrackConfig c;
  c.defect_units = {0, 0};
  const plant::StripeTrack track(c);
  sw::CalibrationWords words{};
  REQUIRE(run_over(track, 0.1267)->fit(words));
  CHECK(error_of(words, track) < 4);
  CHECK(std::abs(static_cast<std::int16_t>(words[14]) - 162) < 20);
  CHECK(std::abs(static_cast<std::int16_t>(words[16]) - 1652) < 10);
  CHECK(words[4] == 512);
  CHECK(words[5] == 512);
}

TEST_CASE("what is fitted to an ideal sensor is named, and else has the specification's words") {
  plant::StripeTrackConfig c;
  c.defect_units = {0, 0};
  sw::CalibrationWords words{};
  REQUIRE(run_over(plant::StripeTrack(c), 0.1267)->fit(words));
  const exact::Calibration ideal = test::ideal_calibration();
  // The cubics are the best for a run, the specification's are for the middle of each region.
  constexpr int kNear[] = {20, 25, 10, 10};  // of X^3, X^2, X and 1
  for (unsigned k = 0; k < 62; ++k) {
    const int is = static_cast<std::int16_t>(words[k]), wanted = ideal.at(k);
    const bool cubic = k >= 14 && k < 30;
    CAPTURE(k, is, wanted);
    if (k >= 4) CHECK(std::abs(is - wanted) <= (cubic ? kNear[(k - 14) % 4] : 0));
  }
  CHECK(words[0] == ('F' | 'I' << 8));
  CHECK(words[1] == 'T');
  CHECK((words[2] | words[3]) == 0);
  CHECK(words[62] == sw::checksum(words));
}

TEST_CASE("a fit is of integers: its words are the same on every computer") {
  plant::StripeTrackConfig c;
  c.defect_units = {0, 0};
  c.amplitude_a_error = 0.03;
  c.offset_a_error = 0.02;
  c.offset_b_error = -0.01;
  c.phase_b_error = 0.02;
  sw::CalibrationWords words{};
  REQUIRE(run_over(plant::StripeTrack(c), 0.1267)->fit(words));
  constexpr int kOrigins[] = {520, 508};
  constexpr int kCubics[] = {161,  8,  1653,  -26,  -144, 13,  -1608, 4147,
                             -163, -6, -1652, 8114, 147,  -14, 1605,  12238};
  for (unsigned k = 0; k < 2; ++k) {
    CAPTURE(k);
    CHECK(words[4 + k] == kOrigins[k]);
  }
  for (unsigned k = 0; k < 16; ++k) {
    CAPTURE(k);
    CHECK(static_cast<std::int16_t>(words[14 + k]) == kCubics[k]);
  }
}

TEST_CASE("without motion there is no fit") {
  const auto fit = std::make_unique<sw::CalibrationFit>();
  for (std::uint32_t tick = 0; !fit->full(); ++tick) fit->add(tick, tick % 2 == 0, 600);
  sw::CalibrationWords words{};
  CHECK_FALSE(fit->fit(words));
}

TEST_CASE("the fit finds the middle of each encoder to a code, whatever its fraction") {
  for (const double more : {1.0, 1.3, 1.5, 1.7, 1.9, -1.3, -1.5, -1.7, -1.9}) {  // codes
    plant::StripeTrackConfig c;
    c.defect_units = {0, 0};
    c.amplitude = 400.4;
    c.offset_a_error = more / c.amplitude;
    c.offset_b_error = -more / c.amplitude;
    const plant::StripeTrack track(c);
    sw::CalibrationWords words{};
    REQUIRE(run_over(track, 0.1267)->fit(words));
    CAPTURE(more);
    CHECK(std::fabs(words[4] - 512 - more) < 0.85);  // extremes are whole codes
    CHECK(std::fabs(words[5] - 512 + more) < 0.85);
  }
}

TEST_CASE("a region with few codes has no fit") {
  plant::StripeTrackConfig c;
  c.defect_units = {0, 0};
  const plant::StripeTrack track(c);
  auto fit = std::make_unique<sw::CalibrationFit>();
  for (std::uint32_t tick = 0; !fit->full(); ++tick) {
    const double x = 0.1267 * tick / 4612.0;
    const bool of_a = tick % 64 != 0;  // some 15 of B in each of its regions
    fit->add(tick, of_a, track.code(of_a ? 0 : 2, x, 0.1267));
  }
  sw::CalibrationWords words{};
  CHECK_FALSE(fit->fit(words));
}

TEST_CASE("the firmware's checksum is that of the chip") {
  exact::Calibration data;
  sw::CalibrationWords words{};
  for (unsigned k = 0; k < 62; ++k) {
    words[k] = static_cast<std::uint16_t>(k * 2654 + 17);
    data.words[k] = words[k];
  }
  CHECK(sw::checksum(words) == exact::sealed(data).words[62]);
}

TEST_CASE("the checksum is CRC-16/CCITT-FALSE, of which a bit more or less changes it") {
  sw::CalibrationWords words{};
  for (unsigned k = 0; k < 62; ++k) words[k] = static_cast<std::uint16_t>(k * 257);
  const std::uint16_t good = sw::checksum(words);
  for (unsigned bit = 0; bit < 62 * 16; ++bit) {
    words[bit / 16] = static_cast<std::uint16_t>(words[bit / 16] ^ 1u << bit % 16);
    CHECK(sw::checksum(words) != good);
    words[bit / 16] = static_cast<std::uint16_t>(words[bit / 16] ^ 1u << bit % 16);
  }
}
