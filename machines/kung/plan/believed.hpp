// SPDX-License-Identifier: Apache-2.0
//
// The motor of an axis as chip and firmware take it: the plant's, where no key believed.* says
// otherwise. All words that depend on a motor are computed from it, so that a run can have a motor
// other than its data sheet.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "machines/kung/options.hpp"

namespace trammel::kung {

// Of what the words need: force constant, resistance, inductance_q, pole pitch and mass with
// payload; the rest is the plant's.
plant::AxisConfig believed_motor(const Options& options, std::size_t axis);

// The key of such a value, in [believed] or [plant]; `name` is that of both.
std::string motor_key(const Options& options, std::size_t axis, const std::string& name);

// Throws std::invalid_argument where a value is below the plant's least.
void check_believed(const Options& options, std::size_t axis);

// The gains of an axis: those of its keys, or by gains.by_rule.
AxisGains gains_of(const Options& options, std::size_t axis);

// How an axis has a gain that is computed from these values: where gains.by_rule computes it, "by
// gains.by_rule of <key> = <value> ..., ".
std::string gain_by(const Options& options, std::size_t axis,
                    std::initializer_list<const char*> names);

// A line for each key of [believed] that nothing is computed from.
std::vector<std::string> unused_beliefs(const Options& options);

}  // namespace trammel::kung
