// SPDX-License-Identifier: Apache-2.0
//
// Keys of the machine larson; positions in steps of 0.001 inch.
#include "lab/key_table.hpp"
#include "machines/larson/machine_members.hpp"

namespace trammel::larson {
namespace {

using Table = lab::KeyTable<Options>;

void add_table(Table& t) {
  t.one("table.soft_end_step", 10, 60000, "largest coordinate; the least is 0",
        TRAMMEL_LENS(table.soft_end));
  t.one("table.margin_step", 1, 1000, "from where a switch opens to the coordinate 0",
        TRAMMEL_LENS(table.margin));
  t.one("table.seek_rate", 59, 4000, "pulses per second toward the switches, CALTBL",
        TRAMMEL_LENS(table.seek_rate));
  t.one("table.back_rate", 59, 4000, "and away from them", TRAMMEL_LENS(table.back_rate));
  t.one("table.most_rate", 59, 4000, "pulses per second, of any move",
        TRAMMEL_LENS(table.most_rate));
  t.one("table.poll_ms", 0.1, 100, "from one look at an open switch to the next",
        TRAMMEL_LENS(poll_ms));
  t.one("table.settle_ms", 0, 100, "from the end of a move to the return of WTTBL or CALTBL",
        TRAMMEL_LENS(wttbl_ms));
  t.one("plot.move_rate", 59, 4000, "pulses per second with the pen up, of a list of moves",
        TRAMMEL_LENS(plot.move));
  t.one("plot.draw_rate", 59, 4000, "with the pen down, of the longer axis",
        TRAMMEL_LENS(plot.draw));
}

void add_axis(Table& t) {
  t.one("axis.start_x_step", -12, 6000, "where X stands", TRAMMEL_LENS(start_x));
  t.one("axis.start_y_step", -12, 6000, "where Y stands", TRAMMEL_LENS(start_y));
  t.one("axis.switch_low_step", -1000, 0, "at which the lower switch opens",
        TRAMMEL_LENS(axis.switch_low));
  t.one("axis.switch_high_step", 10, 100000, "at which the upper switch opens",
        TRAMMEL_LENS(axis.switch_high));
  t.one("axis.switch_hysteresis_step", 0.1, 100, "how far beyond it is closed",
        TRAMMEL_LENS(axis.switch_hysteresis));
  t.one("axis.overtravel_step", 1, 1000, "from there to the stop", TRAMMEL_LENS(axis.overtravel));
  t.one("axis.accuracy_step", 0, 10, "most distance of the platform from its screw's ideal place",
        TRAMMEL_LENS(axis.platform.accuracy));
  t.one("axis.repeatability_step", 0, 10, "of a place of the platform, approached from either side",
        TRAMMEL_LENS(axis.platform.repeatability));
  t.one("axis.perpendicularity_arcsec", -3600, 3600,
        "by which the Y axis leans from square toward positive X",
        TRAMMEL_LENS(perpendicularity_arcsec));
  t.one("translator.width_us", 0, 100, "least width of a step pulse, or it makes no step",
        TRAMMEL_LENS(width_us));
  t.one("translator.setup_us", 0, 100, "direction before a step pulse, or that makes no step",
        TRAMMEL_LENS(setup_us));
  t.one("translator.hold_us", 0, 100, "direction behind the beginning of a step pulse",
        TRAMMEL_LENS(hold_us));
  t.one("buffer.fitted", 0, 0, "false: the pulses go to the motor as they are",
        TRAMMEL_LENS(axis.buffer.fitted));
  t.one("buffer.dead_s", 0, 0.1, "from the first pulse to its ramp",
        TRAMMEL_LENS(axis.buffer.dead_s));
  t.one("buffer.start_rate", 10, 8000, "pulses per second at which the ramp begins",
        TRAMMEL_LENS(axis.buffer.start));
  t.one("buffer.rise", 10, 1e6, "pulses per second, in a second", TRAMMEL_LENS(axis.buffer.rise));
  t.one("buffer.brake_rate", 10, 8000, "pulses per second from which the motor may stop",
        TRAMMEL_LENS(axis.buffer.brake));
  t.one("buffer.busy_above", 0, 1000, "pulses that may still wait when the buffer is not busy",
        TRAMMEL_LENS(axis.buffer.busy_above));
  t.one("buffer.idle_s", 1e-3, 1, "without a pulse, until the next ramp is a new one",
        TRAMMEL_LENS(axis.buffer.idle_s));
}

void add_motor(Table& t) {
  t.one("motor.inertia_kg_m2", 5e-6, 1e-2, "of rotor, screw and table",
        TRAMMEL_LENS(axis.motor.inertia));
  t.one("motor.stiffness_2_N_m_rad", 0.1, 50, "with two phases on",
        TRAMMEL_LENS(axis.motor.stiffness_2));
  t.one("motor.stiffness_3_N_m_rad", 0.1, 50, "with three phases on",
        TRAMMEL_LENS(axis.motor.stiffness_3));
  t.one("motor.damping_2", 0, 2, "ratio, with two phases on", TRAMMEL_LENS(axis.motor.damping_2));
  t.one("motor.damping_3", 0, 2, "ratio, with three phases on",
        TRAMMEL_LENS(axis.motor.damping_3));
  t.one("motor.friction_N_m", 0, 2, "against motion", TRAMMEL_LENS(axis.motor.friction));
  t.one("motor.friction_speed_step_s", 1, 1000, "at which it is 76 % of that",
        TRAMMEL_LENS(axis.motor.friction_speed));
  t.one("motor.torque_share", 0, 10, "of the torque that its currents make, damping included",
        TRAMMEL_LENS(axis.motor.torque_share));
}

}  // namespace

const std::vector<lab::Key>& keys() {
  static const auto all = [] {
    Table t(machine().name);
    t.names();
    t.text("script", "calls of .TABLE: a built-in script's name or a file; .csv: x,y,pen",
           TRAMMEL_LENS(script));
    t.platform_and_clocks();
    t.window();
    t.longest_run();
    t.one("run.reached_steps", 1, 10000,
          "most distance of the table from where its program has it, at the end",
          TRAMMEL_LENS(reached_steps));
    t.waves("the first drive", "see docs/waves.md");
    t.faults(fault_pins({}));
    t.one("record.every_ms", 0.1, 1000, "from one sample to the next", TRAMMEL_LENS(record_ms));
    t.one("record.settle_s", 0, 60, "recorded behind the last call", TRAMMEL_LENS(settle_s));
    add_table(t);
    t.processor();
    add_axis(t);
    add_motor(t);
    return t.keys;
  }();
  return all;
}

}  // namespace trammel::larson
