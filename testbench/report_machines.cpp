// SPDX-License-Identifier: Apache-2.0
//
// What report pages need to know of each machine.
#include <fmt/format.h>

#include "testbench/config.hpp"
#include "testbench/keys.hpp"
#include "testbench/output.hpp"
#include "testbench/report_detail.hpp"

namespace trammel::testbench {
namespace {

bool ends(const std::string& name, const std::string& unit) {
  return name.size() >= unit.size() &&
         name.compare(name.size() - unit.size(), unit.size(), unit) == 0;
}

// Fine enough for every figure of a page: 10 nm, 1 um/s, 10 uA, 1 mN; 0.001 counts, 0.1 mrad/s,
// 0.1 mV; 10 nm and 1 um/s of McAfee's millimetres; words of a chip are whole.
double lsb_of(const std::string& name) {
  if (ends(name, "_m_s")) return 1e-6;
  if (ends(name, "_m") || name == "t_s") return 1e-8;
  if (ends(name, "_A") || ends(name, "_mm") || ends(name, "desired_speed")) return 1e-5;
  if (ends(name, "_V") || ends(name, "_rad_s")) return 1e-4;
  if (ends(name, "_N") || ends(name, "_mm_s") || ends(name, "desired_count") ||
      name == "theta_count") {
    return 1e-3;
  }
  return 1;
}

template <class Options>
Json keys_json() {
  const Options defaults;
  Json all = Json::object();
  for (const KeyOf<Options>& key : keys_of<Options>()) {
    all[key.name] = {{"default", value_json(key.get(defaults))}, {"help", key.help}};
  }
  return all;
}

std::string scenario_title(const Json& metrics) { return metrics["scenario"]; }

std::string kung_title(const Json& metrics) {
  const std::string controller = metrics["options"]["controller"];
  return fmt::format("{}, {}", metrics["scenario"].get<std::string>(),
                     controller == "fc" ? "FC" : "AFC");
}

PageOf kung_page() {
  PageOf page;
  page.texts = {"/options/controller", "/options/path.kind"};
  page.counts = {"/run/first_tick", "/run/end_tick", "/run/points"};
  page.numbers = {"/tracking/model/mean_mm", "/tracking/model/samples", "/tracking/command/mean_mm",
                  "/options/path.square_half_samples", "/options/path.square_low_m",
                  "/options/path.square_high_m"};
  for (const std::string axis : {"x", "y"}) {
    for (const char* figure : {"peak_current_A", "max_speed_m_s"}) {
      page.numbers.push_back('/' + axis + '/' + figure);
    }
    for (const char* key : {"dc_link_V", "encoder_count_m", "current_full_scale_A"}) {
      page.numbers.push_back("/options/plant." + axis + '.' + key);
    }
    for (const char* key : {"shift_e", "shift_de"}) {
      page.numbers.push_back("/options/gains." + axis + '.' + key);
    }
    page.objects.push_back('/' + axis + "/error_to_model");
  }
  page.columns = {"tick", "t_s"};
  for (const std::string axis : {"x_", "y_"}) {
    for (const char* column :
         {"command_m", "position_m", "model_m", "encoder_count", "e", "de", "u", "v_star", "v",
          "i_q_ref", "i_d", "i_q", "v_d", "v_q", "v_m_s", "i_d_A", "i_q_A", "force_N"}) {
      page.columns.push_back(axis + column);
    }
  }
  page.compared = {"tick",        "t_s",          "x_command_m", "x_position_m", "x_model_m",
                   "y_command_m", "y_position_m", "y_model_m",   "contour_m"};
  page.has_detail = [](const Json&) { return true; };
  page.check_detail = check_kung_detail;
  page.complete = complete_kung;
  page.lsb = lsb_of;
  page.keys = keys_json<kung::Options>;
  page.title = kung_title;
  return page;
}

PageOf an693_page() {
  PageOf page;
  for (const char* figure :
       {"samples", "time_s", "desired_count", "real_count", "max_error_counts", "overshoot_counts",
        "settled_s", "max_speed_rev_s", "max_voltage_V", "max_current_A"}) {
    page.numbers.push_back(std::string("/motion/") + figure);
  }
  page.numbers.push_back("/options/encoder.counts");
  page.arrays = {"/interrupts"};
  page.columns = {"t_s", "desired_count", "desired_speed", "real_count", "theta_count",
                  "e",   "p",             "i",             "d",          "output",
                  "status", "host_irq",   "omega_rad_s",   "i_A",        "u_V"};
  page.compared = {"t_s", "theta_count", "e", "output", "omega_rad_s"};
  page.flags = {"status", "host_irq"};
  page.lsb = lsb_of;
  page.keys = keys_json<lm628::Options>;
  page.title = scenario_title;
  return page;
}

PageOf mcafee_page() {
  PageOf page;
  page.texts = {"/options/program"};
  page.counts = {"/run/first_sample"};
  page.numbers = {"/motion/time_s", "/motion/max_error_counts", "/motion/max_speed_mm_s",
                  "/motion/max_desired_mm_s", "/motion/max_current_A",
                  "/options/encoder.lines", "/options/stage.pitch_m"};
  page.arrays = {"/events", "/real_count"};
  page.columns = {"t_s", "row", "v", "limits", "contour_mm"};
  page.compared = {"row", "v", "contour_mm"};
  page.flags = {"limits"};
  for (const std::string axis : {"x_", "y_"}) {
    for (const char* column : {"desired_count", "desired_speed", "real_count", "mm", "mm_s", "e",
                               "p", "i", "d", "output", "status", "host_irq", "i_A", "u_V"}) {
      page.columns.push_back(axis + column);
    }
    for (const char* column : {"desired_count", "mm", "mm_s", "e"}) {
      page.compared.push_back(axis + column);
    }
    for (const char* column : {"status", "host_irq"}) page.flags.push_back(axis + column);
  }
  page.has_detail = [](const Json& metrics) { return metrics["options"]["program"] == "track"; };
  page.check_detail = check_mcafee_detail;
  page.complete = complete_mcafee;
  page.lsb = lsb_of;
  page.keys = keys_json<mcafee::Options>;
  page.title = scenario_title;
  return page;
}

}  // namespace

const PageOf& page_of(const Json& machine, const std::filesystem::path& file) {
  static const PageOf kung = kung_page();
  static const PageOf an693 = an693_page();
  static const PageOf mcafee = mcafee_page();
  if (machine == machine_name<kung::Options>()) return kung;
  if (machine == machine_name<lm628::Options>()) return an693;
  if (machine == machine_name<mcafee::Options>()) return mcafee;
  throw ConfigError(fmt::format("{}: is of the machine {}, which has no report page",
                                file.string(), machine.dump()));
}

}  // namespace trammel::testbench
