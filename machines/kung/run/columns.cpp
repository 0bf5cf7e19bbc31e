// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/columns.hpp"

#include "machines/kung/chip/chip.hpp"
#include "machines/kung/chip/measures.hpp"

namespace trammel::kung {
namespace {

using Table = lab::Columns<Options, Result>;
using lab::fixed;
using lab::general;
using lab::whole;

// A column of each axis is one twice; `get` takes sample, length of a count [m].
template <class Get>
void add(Table& t, std::size_t axis, const char* name, lab::Column column, Get get) {
  column.name = (axis == 0 ? "x_" : "y_") + std::string(name);
  t.add(column, [axis, get](const Table::At& at) {
    return static_cast<double>(
        get(at.sample.axis[axis], at.options.plant.axis[axis].encoder_count_m));
  });
}

void add_axis(Table& t, std::size_t axis) {
  const auto length = [](int digits, const char* help, bool compared = true) {
    return lab::Column{"", "m", 1e-8, fixed(digits), help, compared};
  };
  add(t, axis, "command_m", length(8, "command in force"),
      [](const AxisSample& s, double count_m) { return command_m(s, count_m); });
  add(t, axis, "position_m", length(9, "true position"),
      [](const AxisSample& s, double) { return s.x_true_m; });
  add(t, axis, "model_m", length(9, "output of the reference model"),
      [](const AxisSample& s, double count_m) { return model_m(s, count_m); });
  add(t, axis, "encoder_count", {"", "count", 1, whole(), "encoder"},
      [](const AxisSample& s, double) { return s.x_p; });
  const auto word = [&](const cosim::Word& told, std::int32_t AxisSample::* member) {
    add(t, axis, told.name, {"", told.unit, 1, whole(), told.help},
        [member](const AxisSample& s, double) { return s.*member; });
  };
  word(words::kE, &AxisSample::e);
  word(words::kDe, &AxisSample::de);
  word(words::kU, &AxisSample::u);
  word(words::kVStar, &AxisSample::v_star);
  word(words::kV, &AxisSample::v);
  word(words::kIqRef, &AxisSample::i_q_ref);
  word(words::kId, &AxisSample::i_d);
  word(words::kIq, &AxisSample::i_q);
  word(words::kVd, &AxisSample::v_d);
  word(words::kVq, &AxisSample::v_q);
  const auto truth = [&](const char* name, const char* unit, double resolution,
                         double AxisSample::* member, const char* help) {
    add(t, axis, name, {"", unit, resolution, general(7), help},
        [member](const AxisSample& s, double) { return s.*member; });
  };
  truth("v_m_s", "m/s", 1e-6, &AxisSample::v_true_m_s, "true speed");
  truth("i_d_A", "A", 1e-5, &AxisSample::i_d_true_A, "true d current");
  truth("i_q_A", "A", 1e-5, &AxisSample::i_q_true_A, "true q current");
  truth("force_N", "N", 1e-3, &AxisSample::force_N, "thrust");
}

}  // namespace

const lab::ColumnTable& columns() {
  static const lab::ColumnTable all = [] {
    Table t;
    t.add({"tick", "", 1, whole(), "TICK register of the chip", true},
          [](const Table::At& at) { return static_cast<double>(at.sample.tick); });
    t.add({"t_s", "s", 1e-8, fixed(8), "time from the start of the run", true},
          [](const Table::At& at) { return at.result.seconds(at.sample.edge); });
    for (std::size_t axis = 0; axis < 2; ++axis) add_axis(t, axis);
    return std::move(t).table();
  }();
  return all;
}

}  // namespace trammel::kung
