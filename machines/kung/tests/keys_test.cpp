// SPDX-License-Identifier: Apache-2.0
//
// Each key of the table sets the member that it is named after, in its own axis, and no other.
#include <catch2/catch.hpp>
#include <string>

#include "machines/kung/machine.hpp"
#include "tests/support/key_members.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

using Members = test::KeyMembers<Options>;

template <class Select, class Part>
void add(Members& m, const std::string& prefix, Select select,
         std::initializer_list<std::pair<const char*, double Part::*>> members) {
  for (const auto& [name, member] : members) {
    m.add(prefix + name, [select, member = member](const Options& o) { return select(o).*member; });
  }
}

template <class Select, class Part>
void add_whole(Members& m, const std::string& prefix, Select select,
               std::initializer_list<std::pair<const char*, int Part::*>> members) {
  for (const auto& [name, member] : members) {
    m.add(prefix + name, [select, member = member](const Options& o) { return select(o).*member; });
  }
}

template <class Select, class Part>
void add_flags(Members& m, const std::string& prefix, Select select,
               std::initializer_list<std::pair<const char*, bool Part::*>> members) {
  for (const auto& [name, member] : members) {
    m.add(prefix + name, [select, member = member](const Options& o) { return select(o).*member; });
  }
}

}  // namespace

TEST_CASE("each key sets its own member, in its own axis") {
  Members m;
  m.add("controller", &Options::controller).add("gains.by_rule", &Options::gains_by_rule);
  m.add("run.cpu", &Options::cpu).add("run.settle_s", &Options::settle_s);
  m.add("run.settled_m", &Options::settled_m).add("run.diverged_m", &Options::diverged_m);
  m.add("run.reached_m", &Options::reached_m);
  using I = FaultInjection;
  add<>(m, "inject.", [](const Options& o) -> const I& { return o.inject; },
        {std::pair{"trip_s", &I::trip_s}, {"encoder_s", &I::encoder_s},
         {"processor_s", &I::processor_s}});
  using P = PathOptions;
  const auto path = [](const Options& o) -> const P& { return o.path; };
  m.add("path.kind", [](const Options& o) { return o.path.kind; });
  m.add("path.profile", [](const Options& o) { return o.path.profile; });
  m.add("path.points_mode", [](const Options& o) { return o.path.points_mode; });
  m.add("path.corner", [](const Options& o) { return o.path.corner; });
  for (const std::size_t a : {std::size_t{0}, std::size_t{1}}) {
    add<>(m, a == 0 ? "path.x." : "path.y.",
          [a](const Options& o) -> const AxisPath& { return o.path.axis[a]; },
          {std::pair{"accel_m_s2", &AxisPath::accel_m_s2}});
  }
  m.add("path.sweep_of", [](const Options& o) { return o.path.sweep_of; });
  add_whole<>(m, "path.", path,
              {std::pair{"repeats", &P::repeats}, {"mean_points", &P::mean_points},
               {"circle_ticks", &P::circle_ticks},
               {"window_arc_ticks", &P::window_arc_ticks},
               {"star_stroke_ticks", &P::star_stroke_ticks},
               {"square_half_samples", &P::square_half_samples},
               {"square_periods", &P::square_periods}, {"line_ticks", &P::line_ticks},
               {"sweep_first_ticks", &P::sweep_first_ticks},
               {"sweep_last_ticks", &P::sweep_last_ticks}, {"sweep_tones", &P::sweep_tones},
               {"sweep_dwell_ticks", &P::sweep_dwell_ticks}});
  add<>(m, "path.", path,
        {std::pair{"circle_radius_m", &P::circle_radius_m},
         {"circle_center_x_m", &P::circle_center_x_m}, {"circle_center_y_m", &P::circle_center_y_m},
         {"window_side_m", &P::window_side_m}, {"window_radius_m", &P::window_radius_m},
         {"window_center_x_m", &P::window_center_x_m}, {"window_center_y_m", &P::window_center_y_m},
         {"window_step_m", &P::window_step_m}, {"star_edge_m", &P::star_edge_m},
         {"star_start_x_m", &P::star_start_x_m}, {"star_start_y_m", &P::star_start_y_m},
         {"square_low_m", &P::square_low_m}, {"square_high_m", &P::square_high_m},
         {"line_start_x_m", &P::line_start_x_m}, {"line_start_y_m", &P::line_start_y_m},
         {"line_end_x_m", &P::line_end_x_m}, {"line_end_y_m", &P::line_end_y_m},
         {"feed_m_s", &P::feed_m_s}, {"rapid_m_s", &P::rapid_m_s},
         {"feed_max_m_s", &P::feed_max_m_s}, {"start_x_m", &P::start_x_m},
         {"start_y_m", &P::start_y_m}, {"home_x_m", &P::home_x_m}, {"home_y_m", &P::home_y_m},
         {"sweep_center_m", &P::sweep_center_m},
         {"sweep_amplitude_m", &P::sweep_amplitude_m},
         {"sweep_amplitude_A", &P::sweep_amplitude_A}});
  using Q = PrecisionOptions;
  const auto precision = [](const Options& o) -> const Q& { return o.precision; };
  add_flags<>(m, "precision.", precision,
              {std::pair{"identify", &Q::identify}, {"adapt", &Q::adapt},
               {"subcount", &Q::subcount}, {"learn", &Q::learn}});
  add<>(m, "precision.", precision, {std::pair{"learn_gain", &Q::learn_gain}});
  using C = ChipOptions;
  const auto chip = [](const Options& o) -> const C& { return o.chip; };
  add_whole<>(m, "chip.", chip,
              {std::pair{"carrier_Hz", &C::carrier_Hz}, {"position_Hz", &C::position_Hz},
               {"dead_time_min_ns", &C::dead_time_min_ns}, {"offset_samples", &C::offset_samples},
               {"irq_period_ticks", &C::irq_period_ticks},
               {"watchdog_ticks", &C::watchdog_ticks}});
  add<>(m, "chip.", chip,
        {std::pair{"current_limit_A", &C::current_limit_A},
         {"following_error_m", &C::following_error_m}, {"d_current_A", &C::d_current_A}});
  for (const std::size_t a : {std::size_t{0}, std::size_t{1}}) {
    const std::string axis = a == 0 ? "x." : "y.";
    using G = AxisGains;
    const auto gains = [a](const Options& o) -> const G& { return o.gains[a]; };
    add_whole<>(m, "gains." + axis, gains,
                {std::pair{"shift_e", &G::shift_e}, {"shift_de", &G::shift_de}});
    add<>(m, "gains." + axis, gains,
          {std::pair{"kp", &G::kp}, {"ki", &G::ki}, {"kv", &G::kv},
           {"learning_rate", &G::learning_rate}, {"omega_n_rad_s", &G::omega_n_rad_s},
           {"zeta", &G::zeta}, {"current_kp_V_A", &G::current_kp_V_A},
           {"current_ki_V_A", &G::current_ki_V_A}, {"theta_offset_rad", &G::theta_offset_rad}});
    add_flags<>(m, "gains." + axis, gains,
                {std::pair{"feedforward", &G::feedforward}, {"interpolate", &G::interpolate}});
    using Own = AxisPrecision;
    const auto law = [a](const Options& o) -> const Own& { return o.precision.axis[a]; };
    add_whole<>(m, "precision." + axis, law, {std::pair{"lead_ticks", &Own::lead_ticks}});
    add<>(m, "precision." + axis, law,
          {std::pair{"w1_rad_s", &Own::w1_rad_s}, {"zeta", &Own::zeta},
           {"w2_rad_s", &Own::w2_rad_s}, {"w3_rad_s", &Own::w3_rad_s},
           {"mass_kg", &Own::mass_kg}, {"viscous_N_s_m", &Own::viscous_n_s_m},
           {"coulomb_N", &Own::coulomb_n}, {"hysteresis_counts", &Own::hysteresis_counts}});
    using A = AxisChip;
    const auto own = [a](const Options& o) -> const A& { return o.chip.axis[a]; };
    add_whole<>(m, "chip." + axis, own,
                {std::pair{"dead_time_ns", &A::dead_time_ns},
                 {"qep_filter_clk", &A::qep_filter_clk}});
    add_flags<>(m, "chip." + axis, own, {std::pair{"stroke_check", &A::stroke_check}});
    add<>(m, "chip." + axis, own,
          {std::pair{"stroke_min_m", &A::stroke_min_m}, {"stroke_max_m", &A::stroke_max_m}});
    using B = BelievedMotor;
    add<>(m, "believed." + axis, [a](const Options& o) -> const B& { return o.believed[a]; },
          {std::pair{"force_constant_N_A", &B::force_constant_n_a},
           {"resistance_ohm", &B::resistance_ohm}, {"inductance_q_H", &B::inductance_q_h},
           {"pole_pitch_m", &B::pole_pitch_m}, {"mass_kg", &B::mass_kg}});
    using X = plant::AxisConfig;
    const auto plant = [a](const Options& o) -> const X& { return o.plant.axis[a]; };
    add<>(m, "plant." + axis, plant,
          {std::pair{"resistance_ohm", &X::resistance_ohm}, {"inductance_d_H", &X::inductance_d_h},
           {"inductance_q_H", &X::inductance_q_h}, {"force_constant_N_A", &X::force_constant_n_a},
           {"pole_pitch_m", &X::pole_pitch_m}, {"mass_kg", &X::mass_kg},
           {"payload_kg", &X::payload_kg}, {"coulomb_N", &X::coulomb_n},
           {"viscous_N_s_m", &X::viscous_n_s_m}, {"cogging_N", &X::cogging_n},
           {"stribeck_N", &X::stribeck_n}, {"stribeck_speed_m_s", &X::stribeck_speed_m_s},
           {"cogging_harmonic_N", &X::cogging_harmonic_n}, {"cable_N_m", &X::cable_n_m},
           {"cable_rest_m", &X::cable_rest_m}, {"mode_Hz", &X::mode_hz},
           {"mode_damping", &X::mode_damping}, {"mode_mass_ratio", &X::mode_mass_ratio},
           {"friction_speed_m_s", &X::friction_speed_m_s},
           {"external_force_N", &X::external_force_n}, {"load_N", &X::load_n},
           {"load_begin_s", &X::load_begin_s}, {"load_end_s", &X::load_end_s},
           {"stroke_min_m", &X::stroke_min_m}, {"stroke_max_m", &X::stroke_max_m},
           {"dc_link_V", &X::dc_link_v}, {"supply_ohm", &X::supply_ohm},
           {"dc_link_F", &X::dc_link_f}, {"chopper_V", &X::chopper_v},
           {"switch_drop_V", &X::switch_drop_v}, {"diode_drop_V", &X::diode_drop_v},
           {"continuous_current_A", &X::continuous_current_a},
           {"peak_current_A", &X::peak_current_a}, {"encoder_count_m", &X::encoder_count_m},
           {"encoder_error_m", &X::encoder_error_m}, {"encoder_period_m", &X::encoder_period_m},
           {"encoder_jitter_m", &X::encoder_jitter_m},
           {"encoder_hysteresis_counts", &X::encoder_hysteresis_counts}, {"index_m", &X::index_m},
           {"current_full_scale_A", &X::current_full_scale_a},
           {"current_noise_A", &X::current_noise_a}, {"current_offset_a_A", &X::current_offset_a_a},
           {"current_offset_b_A", &X::current_offset_b_a}, {"current_gain_a", &X::current_gain_a},
           {"current_gain_b", &X::current_gain_b}});
    add_flags<>(m, "plant." + axis, plant,
                {std::pair{"hard_stops", &X::hard_stops}, {"brake", &X::brake},
                 {"locked", &X::locked}});
    add_whole<>(m, "plant." + axis, plant,
                {std::pair{"cogging_harmonic", &X::cogging_harmonic}, {"adc_bits", &X::adc_bits}});
  }
  CHECK(m.wrong() == "");
}
