// SPDX-License-Identifier: Apache-2.0
//
// One table axis: inverter, motor, carriage with stops, encoder, current sensors. The gate bits
// hold from a commit on; from there the motion is a chain of segments (motor spans) that end
// after 25 us at most (of a fast motor after 6.25 us or less, spans.hpp), where a diode current
// dies out, or where the carriage meets a stop. Segments follow from the last commit alone, so
// every query in between is pure. next() is no later than the next event: one that is far away is
// searched for at the commit there, which moves nothing if it is still to come.
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

struct AxisConfig {  // defaults: X axis of the table
  double resistance_ohm = 27;
  double inductance_d_h = 23.3e-3;
  double inductance_q_h = 23.3e-3;
  double force_constant_n_a = 79.9;
  double pole_pitch_m = 30.5e-3;
  double mass_kg = 2.5;
  double payload_kg = 0;
  double coulomb_n = 3.0;
  double viscous_n_s_m = 20;
  double cogging_n = 0;
  double friction_speed_m_s = 0.5e-3;
  double external_force_n = 0;
  double stribeck_n = 0, stribeck_speed_m_s = 5e-3;  // friction at rest above coulomb_n
  double cogging_harmonic_n = 0;
  int cogging_harmonic = 2;
  double cable_n_m = 0, cable_rest_m = 0.3;  // a cable that pulls toward its place of rest
  double mode_hz = 0;  // resonance of an elastic mode; 0: none
  double mode_damping = 0.02, mode_mass_ratio = 0.2;  // of critical; share of the mass
  double load_n = 0;                       // more of it, from load_begin_s to load_end_s
  double load_begin_s = 0, load_end_s = 0;  // since the start; 0: it does not end
  double stroke_min_m = 0;
  double stroke_max_m = 0.6;
  bool hard_stops = true;
  bool brake = true;  // holds the carriage until a gate is first on
  bool locked = false;  // holds it all the time
  double dc_link_v = 311;
  double supply_ohm = 0;         // of what charges the DC link; 0: a stiff one
  double dc_link_f = 1e-3;       // capacitor of one that is not
  double chopper_v = 0;          // at which its brake chopper burns; 0: none
  double switch_drop_v = 0;
  double diode_drop_v = 0;
  double encoder_count_m = 5e-6;
  double encoder_hysteresis_counts = 0.2;
  double encoder_error_m = 0, encoder_period_m = 20e-6;  // sub-divisional; period of the scale
  double encoder_jitter_m = 0;                           // rms, within the hysteresis
  double index_m = 0.25;
  double current_full_scale_a = 9.6;
  double current_noise_a = 0;  // rms
  double current_offset_a_a = 0, current_offset_b_a = 0;  // of the sensors of phases a and b [A]
  double current_gain_a = 1, current_gain_b = 1;          // what they show of the current
  double continuous_current_a = 1.6, peak_current_a = 4.8;  // rating: rms, largest of a phase
  double start_m = 0;
  int adc_bits = 12;
  double longest_span_s = 25e-6;  // of one series
};

struct AxisState {
  double x_m = 0, v_m_s = 0;
  double i_d_a = 0, i_q_a = 0, i_a_a = 0, i_b_a = 0;
  double force_n = 0;  // electromagnetic
  double dc_link_v = 0;
  double mode_m = 0;  // by which the mass on the spring is ahead
};

PmlsmConfig motor_config(const AxisConfig& c);

// The same; throws std::invalid_argument that names the first value that no axis can have.
const AxisConfig& checked(const AxisConfig& c);

class Axis {
 public:
  // The seed is that of the encoder's jitter.
  Axis(const AxisConfig& config, double period_s, std::uint64_t seed = 0);

  Clk next() const { return next_; }
  void commit(Clk n, unsigned gates);
  unsigned gates() const { return gates_; }
  // From n on, after a commit there.
  void open_phase(Clk n, int phase, bool open);  // it carries no current
  void supply(Clk n, double share);              // of the DC link

  AxisState state(Clk n) const;
  double position(Clk n) const;
  // The 16 bits of a converter's frame.
  int frame(int phase, std::uint64_t seed, int channel, Clk n) const;
  const Encoder& encoder() const { return encoder_; }
  const Pmlsm& motor() const { return motor_; }
  bool at_stop() const { return chain_[0].held && !braked_; }               // at the last commit
  bool shoot_through() const { return shoot_through_; }                     // ever since the start
  double leg_volt(std::size_t leg) const { return chain_[0].legs.volt[leg]; }  // at the last commit
  bool leg_floats(std::size_t leg) const { return ((chain_[0].legs.floating >> leg) & 1u) != 0; }

 private:
  struct Segment {
    double start = 0, length = 0;  // [s] since the commit, [s]
    Span span;
    Legs legs;
    bool held = false;  // carriage against a stop, or by the brake
    unsigned dies = 0;  // legs whose current is zero at the end
    bool meets_stop = false;
    double stop = 0;  // [m]
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

  AxisConfig config_;
  double period_;
  Clk horizon_, ahead_;
  Pmlsm motor_;
  double segment_;       // [s] longest span of one series
  double rest_, waves_;  // [m/s] of friction, [rad/m] of the magnets' forces
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
