// SPDX-License-Identifier: Apache-2.0
//
// An axis with a permanent-magnet synchronous motor, composed of its parts: DC link, inverter,
// motor with the mass that it moves, mount and load, encoder, current sensors. Places are in the
// motor's unit: metres, or revolutions of a rotary motor. The gate bits hold from a commit on; from
// there the motion is a chain of segments (motor spans) that end after 25 us at most (of a fast
// motor after 6.25 us or less, spans.hpp), where a diode current dies out, or where the carriage
// meets a stop. Segments follow from the last commit alone, so every query in between is pure.
// next() is no later than the next event: one that is far away is searched for at the commit there,
// which moves nothing if it is still to come.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/plant/current_sensor.hpp"
#include "models/plant/dc_link.hpp"
#include "models/plant/encoder.hpp"
#include "models/plant/inverter.hpp"
#include "models/plant/pmlsm.hpp"

namespace trammel::plant {

using Clk = std::int64_t;

// How the carriage or shaft is held, and the load that is on it for a time.
struct MountConfig {
  double start = 0;                     // place
  double stroke_min = 0, stroke_max = 0;  // places of the hard stops
  bool hard_stops = false;
  bool brake = true;    // holds it until a gate is first on
  bool locked = false;  // holds it all the time
  double load = 0;      // force, beside the motor's external force
  double load_begin = 0, load_end = 0;  // [s] since the start; 0: it does not end
};

struct PmsmAxisConfig {
  DcLinkConfig link;
  InverterConfig inverter;  // its DC link is the link's source
  PmlsmConfig motor;
  MountConfig mount;
  EncoderConfig encoder;
  std::array<CurrentSensorConfig, 2> sensors;  // of phases a and b
  double longest_span = 25e-6;                 // [s] of one series
};

struct PmsmState {
  MotorState motor;
  double i_a = 0, i_b = 0;  // [A]
  double force = 0;         // electromagnetic
  double dc_link = 0;       // [V]
};

class PmsmAxis {
 public:
  PmsmAxis(const PmsmAxisConfig& config, double period_s);

  Clk next() const { return next_; }
  void commit(Clk n, unsigned gates);
  unsigned gates() const { return gates_; }
  // From n on, after a commit there.
  void open_phase(Clk n, int phase, bool open);  // it carries no current
  void supply(Clk n, double share);              // of the DC link

  PmsmState motion(Clk n) const;
  double position(Clk n) const;
  // The code of the converter of phase a (0) or b (1); seed and channel are those of its noise.
  int code(int phase, std::uint64_t seed, int channel, Clk n) const;
  const Encoder& encoder() const { return encoder_; }
  const Pmlsm& motor() const { return motor_; }
  // [J] from the supply until n, less what flowed back; without the current of a shoot-through.
  double supplied(Clk n) const;
  bool at_stop() const { return chain_[0].held && !braked_; }               // at the last commit
  bool shoot_through() const { return shoot_through_; }                     // ever since the start
  double leg_volt(std::size_t leg) const { return chain_[0].legs.volt[leg]; }  // at the last commit
  bool leg_floats(std::size_t leg) const { return ((chain_[0].legs.floating >> leg) & 1u) != 0; }

 private:
  struct Segment {
    double start = 0, length = 0;  // [s] since the commit, [s]
    Span span;
    Legs legs;
    std::array<double, 3> current{};  // [A] of the phases at the start
    bool held = false;  // carriage against a stop, or by the brake
    unsigned dies = 0;  // legs whose current is zero at the end
    bool meets_stop = false;
    double stop = 0;  // place
  };
  struct Point {
    MotorState motor;
    SinCos angle;
  };

  static constexpr Clk kNoEdge = -1;

  double seconds(Clk clocks) const { return static_cast<double>(clocks) * period_; }
  void begin(const Point& p, unsigned zero);
  void build(Segment& s, double start, const Point& p, unsigned zero) const;
  void end_at_dead_current(Segment& s, const std::array<double, 3>& current) const;
  void end_at_stop(Segment& s) const;
  const Segment& successor(std::size_t k) const;
  const Segment& segment_at(double t) const;
  Point point(const Segment& s, double t, unsigned zero) const;
  double length(const MotorState& m) const;
  double phase_current(const Span& f, double t, std::size_t leg) const;
  double link_charge(double t) const;
  double charge(const Segment& s, double t, const Point& p) const;

  void load(Clk n);  // the external force from edge n on
  Clk predict() const;
  void look_ahead(Clk n);
  Clk until_load(Clk n, Clk due) const;  // due, but no later than the load changes
  Clk safe_clocks() const;
  Clk first_edge(const Segment& s, Clk from, Clk to) const;
  bool outside(const Segment& s, Clk m) const {
    return encoder_.leaves(s.span.position(seconds(m) - s.start));
  }
  Clk search(const Segment& s, Clk inside, Clk outside) const;
  bool far_from_events(const Segment& s, double time) const;

  double period_;
  // Of a stiff link: [C] from the source since its voltage changed, and [J] before.
  double charge_ = 0, supplied_ = 0;
  Clk horizon_, ahead_;
  MountConfig mount_;
  double external_force_;  // without the load
  double source_;          // [V] of the DC link
  Pmlsm motor_;
  double segment_;       // [s] longest span of one series
  double bend_;          // [1/s] of a current that decays over a span: R/(12 L)
  double rest_, waves_;  // speed of friction, [rad] of the magnets' forces per unit of place
  Inverter inverter_;
  DcLink link_;
  std::array<CurrentSensor, 2> sensors_;  // of phases a and b
  Encoder encoder_;
  unsigned gates_ = 0;
  bool shoot_through_ = false;
  bool braked_;
  unsigned opened_ = 0;  // phases that are open
  Clk load_begin_ = 0, load_end_ = 0;  // edges
  Clk anchor_ = 0;
  // Segments since the last commit, as far as they were needed; slots are reused.
  mutable std::vector<Segment> chain_;
  mutable std::size_t known_ = 0;
  Clk next_ = 0;
  bool early_ = false;  // the event is at next_ or later
  Clk safe_ = 0;        // no line moves before, whatever the gates do
};

}  // namespace trammel::plant
