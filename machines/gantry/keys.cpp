// SPDX-License-Identifier: Apache-2.0
//
// Keys of the machine gantry.
#include <fmt/format.h>

#include "lab/key_table.hpp"
#include "machines/gantry/machine_members.hpp"

namespace trammel::lab {

template <>
inline std::vector<std::string> enum_names<sw::PositionPi::Sum>() {
  return {"none", "plain", "cancel", "anti_windup"};
}
template <>
inline std::vector<std::string> enum_names<sw::OpenForce>() {
  return {"none", "constant", "steps", "random"};
}
template <>
inline std::vector<std::string> enum_names<gantry::Filter>() {
  return {"mean", "low_pass_1", "low_pass_2", "kalman"};
}
template <>
inline std::vector<std::string> enum_names<sw::Motors>() {
  return {"both", "motor_1", "motor_2"};
}

}  // namespace trammel::lab

namespace trammel::gantry {
namespace {

using Table = lab::KeyTable<Options>;

void add_firmware(Table& t) {
  t.one("boot.home", 0, 0, "to the right stop first: that is zero", TRAMMEL_LENS(firmware.home));
  t.one("boot.calibrate", 0, 0, "behind that a run at constant force, and the fit",
        TRAMMEL_LENS(firmware.calibrate));
  t.one("boot.home_force", 100, 1023, "of both motors", TRAMMEL_LENS(firmware.home_force));
  t.one("boot.home_ticks", 100, 1e6, "the position unchanged for so long is zero",
        TRAMMEL_LENS(firmware.home_ticks));
  t.one("boot.fit_force", 100, 1023, "of the calibration run", TRAMMEL_LENS(firmware.fit_force));
  t.one("monitor.stall_ticks", 0, 1e6, "a force and no motion for so long turns all off; 0: never",
        TRAMMEL_LENS(firmware.stall_ticks));
  t.one("monitor.sensor", 0, 0, "A and B lie on a circle of 250 to 520 codes, else off",
        TRAMMEL_LENS(firmware.watch_sensor));
  t.one("control.pass_ms", 0.5, 50, "from one control pass to the next", TRAMMEL_LENS(pass_ms));
  t.one("control.open", 0, 0,
        "a force without a controller: constant, with a changed sign after each step, or random; "
        "goals then have no effect; none: a controller",
        TRAMMEL_LENS(firmware.open));
  t.one("control.open_force", -1023, 1023, "without a controller, positive to the right",
        TRAMMEL_LENS(firmware.open_force));
  t.one("control.open_hold_ms", 0.5, 60'000,
        "time of each step, and of each bit of random, rounded to whole control passes",
        TRAMMEL_LENS(open_hold_ms));
  t.one("control.motors", 0, 0, "motors that the firmware drives; the other one has no force",
        TRAMMEL_LENS(firmware.motors));
  t.one("control.cascade", 0, 0, "the position asks for a velocity that a PI keeps",
        TRAMMEL_LENS(firmware.cascade));
  t.one("control.cascade_gain", 0, 16, "K of the cascade, a shift",
        TRAMMEL_LENS(firmware.cascade_gain));
  t.one("control.compensate", 0, 0, "of the cascade: the motors pull against the backlash",
        TRAMMEL_LENS(firmware.compensate));
  t.one("control.brake_force", 0, 512, "B of the compensation",
        TRAMMEL_LENS(firmware.compensation.brake));
  t.one("control.near_count", 1, 1000, "largest error at which it acts; 32 are 5 mm",
        TRAMMEL_LENS(firmware.compensation.near));
}

void add_position(Table& t) {
  t.one("position.bang_bang", 0, 0, "the whole force by the sign of the error",
        TRAMMEL_LENS(firmware.position.bang));
  t.one("position.sum", 0, 0, "which PI: none is P", TRAMMEL_LENS(firmware.position.sum));
  t.one("position.sum_per_tick", 0, 0, "the sum grows at each conversion; false: once a pass",
        TRAMMEL_LENS(firmware.position.per_tick));
  t.one("position.gain", 0, 1000, "K", TRAMMEL_LENS(firmware.position.gain));
  t.one("position.time_shift", 0, 30, "TI: the sum is divided by 2 to this",
        TRAMMEL_LENS(firmware.position.time));
  t.one("position.max_force", 1, 1023, "MAX", TRAMMEL_LENS(firmware.position.most));
  t.one("position.min_force", 0, 1023, "MIN: a smaller force is lifted to it; 0: none is",
        TRAMMEL_LENS(firmware.position.least));
  t.one("position.aw_limit", 1, 1023, "force at which the anti-windup holds",
        TRAMMEL_LENS(firmware.position.aw_limit));
  t.one("velocity.filter", 0, 0,
        "of the velocity: the mean of four as in the source, or at 100 Hz a low-pass filter of "
        "order 1 or 2 or a Kalman filter",
        TRAMMEL_LENS(estimator.filter));
  t.one("velocity.corner_Hz", 0.1, 45, "of the low-pass filters", TRAMMEL_LENS(estimator.corner));
  t.text("velocity.model",
         "of the Kalman filter, a1 ... an b1 ... bn in mm/s and force counts: y[k] = a1 y[k-1] + "
         "... + b1 u[k-dead] + ...; empty: the stored model of order 3",
         TRAMMEL_LENS(estimator.model));
  t.one("velocity.dead_samples", 1, 20,
        "of a model, also of an identified one: samples of 10 ms from a force to its first effect",
        TRAMMEL_LENS(estimator.dead_samples));
  t.one("velocity.noise_mm_s", 0.01, 1000, "noise that the Kalman filter assumes, rms",
        TRAMMEL_LENS(estimator.noise));
  t.one("velocity.doubt_count", 0.01, 1000,
        "force that the Kalman filter assumes its model to leave out, rms",
        TRAMMEL_LENS(estimator.doubt));
  t.one("velocity.gain_shift", 0, 30, "KV", TRAMMEL_LENS(firmware.velocity.gain));
  t.one("velocity.time_shift", 0, 30, "KIV", TRAMMEL_LENS(firmware.velocity.time));
  t.one("velocity.sum_per_tick", 0, 0, "the sum grows at each conversion; false: once per pass",
        TRAMMEL_LENS(firmware.velocity.per_tick));
  t.one("velocity.aw_limit", 1, 1023, "force at which the anti-windup holds",
        TRAMMEL_LENS(firmware.velocity.aw_limit));
  t.one("velocity.aw_shift", 0, 0, "what it stores is shifted by KIV, unlike the listing's",
        TRAMMEL_LENS(firmware.velocity.aw_shift));
  t.one("velocity.sum", 0, 0, "the velocity's controller is PI; false: P",
        TRAMMEL_LENS(firmware.velocity.sum));
  t.one("velocity.feed_forward", 0, 0, "the force that the velocity takes is added",
        TRAMMEL_LENS(firmware.velocity.feed_forward));
  t.one("velocity.min_force", 0, 1023, "a smaller force is lifted to it; 0: none is",
        TRAMMEL_LENS(firmware.velocity.least));
}

void add_axis(Table& t) {
  t.one("axis.start_m", -0.001, 0.471, "where the cart stands", TRAMMEL_LENS(axis.start));
  t.one("axis.coulomb_count", 0, 500, "friction, in force counts", TRAMMEL_LENS(axis.coulomb));
  t.one("axis.stiction_count", 0, 500,
        "force at which the whole track breaks away; each mass has its share",
        TRAMMEL_LENS(axis.stiction));
  t.one("axis.viscous_N_s_m", 0, 200, "of each motor", TRAMMEL_LENS(axis.viscous));
  for (std::size_t m = 0; m < kMotors; ++m) {
    const std::string motor = fmt::format("axis.motor_{}_", m + 1);
    t.one(motor + "left", 0.2, 2, "share of its force that this motor has to the left",
          [m](auto& o) -> auto& { return o.axis.left[m]; });
    t.one(motor + "right", 0.2, 2, "share of its force that this motor has to the right",
          [m](auto& o) -> auto& { return o.axis.right[m]; });
  }
  t.one("axis.motor_mass_kg", 0.05, 10, "of each motor at the belt", TRAMMEL_LENS(axis.motor_mass));
  t.one("axis.cart_mass_kg", 0.05, 10, "of the cart", TRAMMEL_LENS(axis.cart_mass));
  t.one("axis.belt_N_m", 1e3, 1e6, "stiffness of the belt to each motor",
        TRAMMEL_LENS(axis.belt_stiffness));
  t.one("axis.belt_damping", 0, 2, "ratio", TRAMMEL_LENS(axis.belt_damping));
  t.one("axis.gap_m", 0, 0.005, "half of the backlash of each gear wheel", TRAMMEL_LENS(axis.gap));
  t.one("axis.zone_more", 0, 2, "share of friction that 90 to 110 and 220 to 290 mm add",
        TRAMMEL_LENS(axis.zone_more));
  t.one("axis.winding_s", 0, 0.02, "electrical time constant of the motors",
        TRAMMEL_LENS(axis.winding));
  t.one("sensor.delay_s", 0, 0.05, "age of what the sensor tells", TRAMMEL_LENS(axis.delay));
  t.one("sensor.amplitude_code", 340, 460, "of A and B; the data at power-on are for 400",
        TRAMMEL_LENS(stripes.amplitude));
  t.one("sensor.amplitude_a_error", -0.15, 0.15, "share", TRAMMEL_LENS(stripes.amplitude_a_error));
  t.one("sensor.amplitude_b_error", -0.15, 0.15, "share", TRAMMEL_LENS(stripes.amplitude_b_error));
  t.one("sensor.offset_a_error", -0.15, 0.15, "share of the amplitude",
        TRAMMEL_LENS(stripes.offset_a_error));
  t.one("sensor.offset_b_error", -0.15, 0.15, "share of the amplitude",
        TRAMMEL_LENS(stripes.offset_b_error));
  t.one("sensor.phase_b_error_rad", -0.15, 0.15, "of B", TRAMMEL_LENS(stripes.phase_b_error));
  t.one("sensor.noise_code", 0, 50, "noise of A and B, rms", TRAMMEL_LENS(stripes.noise));
  t.one("sensor.dot_noise_code", 0, 100, "noise of their derivatives, rms; 1 code: 1 mm/s",
        TRAMMEL_LENS(stripes.dot_noise));
  t.one("sensor.seed", 0, 9007199254740992.0, "of the noise", TRAMMEL_LENS(stripes.seed));
  t.one("sensor.defect_1_unit", -4000, 4000, "jump at 190 mm, 2^-14 of a period; 0: none",
        TRAMMEL_LENS(stripes.defect_units[0]));
  t.one("sensor.defect_2_unit", -4000, 4000, "jump at 300 mm",
        TRAMMEL_LENS(stripes.defect_units[1]));
}

}  // namespace

const std::vector<lab::Key>& keys() {
  static const auto all = [] {
    Table t(machine().name);
    t.names();
    t.platform_and_clocks();
    t.window();
    t.longest_run();
    t.one("run.time_s", 1e-3, 3600, "of the experiment", TRAMMEL_LENS(time_s));
    t.one("run.reached_mm", -1, 500,
          "most distance of the cart from the reference at the end; below 0: any",
          TRAMMEL_LENS(reached_mm));
    t.waves("the first drive", "see docs/waves.md");
    t.faults(fault_pins({}));
    t.one("record.every_ms", 0.1, 1000, "from one sample to the next", TRAMMEL_LENS(record_ms));
    t.text("host.sends", "what the host sends and when: 0.1:21=305, 0.2:31?, 0.3:x8A49",
           TRAMMEL_LENS(sends));
    t.one("host.serial", 0, 0,
          "a pseudo-terminal is the host, in real time; host.sends is then not sent",
          TRAMMEL_LENS(serial));
    t.one("host.stream", 0, 0, "position, time and velocity are sent every pass",
          TRAMMEL_LENS(firmware.stream));
    t.one("host.gap_ms", 0, 300,
          "silence that ends a partial frame, which is counted as malformed; 0: never",
          TRAMMEL_LENS(gap_ms));
    t.one("host.clip_goals", 0, 0,
          "a position above 470 mm is 470 mm, as in the listing; false: it is refused, as is a "
          "velocity above 467 mm/s", TRAMMEL_LENS(firmware.clip_goals));
    t.one("host.checked", 0, 0,
          "chip and host send the checksum of each frame behind it on channel 27; the chip drops a "
          "frame without it", TRAMMEL_LENS(firmware.checked));
    t.one("host.baud_error", -0.2, 0.2, "share by which the host's baud rate is above 115200",
          TRAMMEL_LENS(line.baud_error));
    t.one("host.framing_errors", 0, 1,
          "share of the host's bytes that have a low stop bit, evenly spread",
          TRAMMEL_LENS(line.framing_errors));
    t.one("step.reference_mm", 0, 470, "that figures of the step are measured from",
          TRAMMEL_LENS(reference_mm));
    t.one("step.from_mm", 0, 470, "where the step begins", TRAMMEL_LENS(from_mm));
    t.one("step.zero_mm", -2, 472, "where on the track these two are 0",
          TRAMMEL_LENS(zero_mm));
    t.one("step.band_mm", 0.01, 50, "arrived is within it", TRAMMEL_LENS(band_mm));
    add_firmware(t);
    add_position(t);
    t.processor();
    add_axis(t);
    return t.keys;
  }();
  return all;
}

}  // namespace trammel::gantry
