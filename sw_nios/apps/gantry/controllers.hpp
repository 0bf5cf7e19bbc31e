// SPDX-License-Identifier: Apache-2.0
//
// The controllers of the gantry track in integers (Brochier 2006, chapter 3 and appendix C): an
// error of position is measured - desired in control counts of 512 position units; a force is
// -1023 to 1023, positive toward the right, where the position decreases. Shifts are arithmetic.
// Freestanding.
#pragma once

#include <cstdint>

namespace trammel::sw {

inline constexpr std::int32_t kFullForce = 0x3FF;

inline std::int32_t within(std::int32_t value, std::int32_t limit) {
  return value > limit ? limit : value < -limit ? -limit : value;
}
inline std::int32_t narrowed(std::int64_t value) {
  constexpr std::int64_t kMost = INT32_MAX;
  return static_cast<std::int32_t>(value > kMost ? kMost : value < -kMost ? -kMost : value);
}
inline std::int32_t sign_of(std::int32_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// A force that is not 0 is at least that large.
inline std::int32_t lifted(std::int32_t force, std::int32_t least) {
  return force < least && force > -least ? sign_of(force) * least : force;
}

// Proportional control and the family of PI: P = K e, I = S >> TI, S the sum of e.
struct PositionPi {
  enum class Sum : std::uint8_t {
    kNone,        // bang-bang and P
    kPlain,
    kCancel,      // S is cleared where e is 0 or has changed its sign
    kAntiWindup,  // S stands while P is beyond the limit, else P + I stops at it
  };

  struct Config {
    Sum sum = Sum::kNone;
    bool bang = false;             // force = +-most, by the sign of e
    bool per_tick = true;          // S grows at every conversion tick, not once a pass
    std::int32_t gain = 3;         // K
    std::int32_t time = 10;        // TI
    std::int32_t most = 0x3FF;     // MAX
    std::int32_t least = 0x80;     // MIN: a smaller force is lifted to it; 0: none is
    std::int32_t aw_limit = 0x3FF;  // of the anti-windup
  };

  struct State {
    std::int64_t sum = 0, last_sum = 0;
    std::int32_t error = 0;      // held from pass to pass
    std::int32_t last_sign = 0;  // of the last error that was not 0
  };

  // One pass, `ticks` after the last one.
  static std::int32_t step(const Config& c, State& s, std::int32_t error, std::uint32_t ticks) {
    if (c.bang) return within(sign_of(error) * c.most, kFullForce);
    const std::int64_t grows = c.per_tick ? std::int64_t{s.error} * ticks : error;
    s.error = error;
    const std::int32_t p = narrowed(std::int64_t{c.gain} * error);
    std::int32_t i = 0;
    if (c.sum != Sum::kNone) {
      s.sum += grows;
      if (c.sum == Sum::kCancel) {
        const std::int32_t sign = sign_of(error);
        if (sign == 0 || sign == -s.last_sign) s.sum = 0;
        if (sign != 0) s.last_sign = sign;
      }
      if (c.sum == Sum::kAntiWindup) limit(c, s, p);
      s.last_sum = s.sum;
      i = narrowed(s.sum >> c.time);
    }
    const std::int32_t u = lifted(narrowed(std::int64_t{p} + i), c.least);
    return within(within(u, c.most), kFullForce);
  }

 private:
  static void limit(const Config& c, State& s, std::int32_t p) {
    if (p > c.aw_limit || p < -c.aw_limit) {
      s.sum = s.last_sum;
      return;
    }
    const std::int64_t u = p + (s.sum >> c.time), scale = std::int64_t{1} << c.time;
    if (u > c.aw_limit) s.sum = (c.aw_limit - p) * scale;
    if (u < -c.aw_limit) s.sum = (-c.aw_limit - p) * scale;
  }
};

// Force that keeps a velocity [2^-9 position unit a tick]: 88 counts of Coulomb friction, 186
// velocity units a count.
inline std::int32_t feed_forward(std::int32_t v) {
  const std::int64_t wide = v;
  if (v > 10000) return narrowed((11 * wide >> 11) + 88);
  if (v < -10000) return narrowed((11 * wide >> 11) - 88);
  return narrowed(29 * wide >> 11);
}

// Velocity control: u = ff(vref) - (ev >> KV) - (S >> KIV), ev = velocity - vref; S once a pass, or
// at every conversion tick, as the listing's interrupt has it (appendix C.1).
struct VelocityPi {
  struct Config {
    bool sum = true;                 // false: S is 0
    bool feed_forward = true;        // false: ff is 0
    std::int32_t gain = 7;           // KV, a shift
    std::int32_t time = 14;          // KIV
    bool per_tick = false;           // S grows at every conversion tick
    std::int32_t aw_limit = 592;     // 250h
    bool aw_shift = false;           // what the anti-windup stores is shifted by KIV
    std::int32_t least = 0;          // a smaller force is lifted to it; 0: none is
  };
  struct State {
    std::int64_t sum = 0, last_sum = 0;
    std::int64_t error = 0;  // held from pass to pass
  };

  // The force toward larger positions, `ticks` after the last pass.
  static std::int32_t step(const Config& c, State& s, std::int32_t ref, std::int32_t velocity,
                           std::uint32_t ticks = 1) {
    const std::int64_t ev = std::int64_t{velocity} - ref;
    if (c.sum) s.sum += c.per_tick ? s.error * ticks : ev;
    s.error = ev;
    const std::int64_t p = ev >> c.gain, i = s.sum >> c.time;
    if (!c.sum || p > c.aw_limit || p < -c.aw_limit) {
      s.sum = s.last_sum;
    } else if (p > 0 && p + i > c.aw_limit) {
      s.sum = stored(c, c.aw_limit - p);
    } else if (p <= 0 && p + i < -c.aw_limit) {
      s.sum = stored(c, -c.aw_limit - p);
    }
    s.last_sum = s.sum;
    const std::int32_t ahead = c.feed_forward ? feed_forward(ref) : 0;
    return within(lifted(narrowed(ahead - p - (s.sum >> c.time)), c.least), kFullForce);
  }

 private:
  static std::int64_t stored(const Config& c, std::int64_t sum) {
    return c.aw_shift ? sum * (std::int64_t{1} << c.time) : sum;
  }
};

// A velocity at most 5000 units from the last filtered one, then the mean of four, toward minus
// infinity.
class MeanFilter {
 public:
  static constexpr std::int32_t kMostChange = 5000;

  std::int32_t step(std::int32_t velocity) {
    last_[at_] = mean_ + within(narrowed(std::int64_t{velocity} - mean_), kMostChange);
    at_ = (at_ + 1) % 4;
    const std::int64_t sum = std::int64_t{last_[0]} + last_[1] + last_[2] + last_[3];
    mean_ = static_cast<std::int32_t>(sum >> 2);
    return mean_;
  }
  std::int32_t mean() const { return mean_; }

 private:
  std::int32_t last_[4] = {};
  std::int32_t mean_ = 0;
  std::uint32_t at_ = 0;
};

struct MotorForces {
  std::int32_t one = 0, two = 0;  // of motor 1 and 2
};

// In place of that mean.
class VelocityFilter {
 public:
  // Once a pass, with the observer's velocity and the forces since the pass before.
  virtual std::int32_t step(std::int32_t velocity, MotorForces forces) = 0;
  virtual void restart() = 0;

 protected:
  ~VelocityFilter() = default;
};

// Two motors against the backlash between them: near the goal the one that does not lead brakes, at
// the goal both pull away from each other.
struct Compensation {
  std::int32_t brake = 0x70;
  std::int32_t near = 32;  // [count]

  MotorForces share(std::int32_t e, std::int32_t u) const {
    if (e > near || e < -near) return {u, u};
    if (e == 0) return {brake, -brake};
    const std::int32_t s = sign_of(e);
    const std::int32_t other = s * (s * e * ((s * u + brake) >> 5) - brake);
    return e > 0 ? MotorForces{u, within(other, kFullForce)}
                 : MotorForces{within(other, kFullForce), u};
  }
};

}  // namespace trammel::sw
