// SPDX-License-Identifier: Apache-2.0
//
// path.svg and error.svg. The data travel in the script, so gnuplot reads no other file.
#include <fmt/format.h>

#include <cctype>
#include <csignal>
#include <cstdio>
#include <iterator>

#include "testbench/output.hpp"

namespace trammel::testbench {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMaxPoints = 6000;  // more make a heavy picture, not a better one

constexpr char kCommandLine[] = "lc rgb '#bbbbbb' lw 3";
constexpr char kModelLine[] = "lc rgb '#1f77b4' lw 1.5";
constexpr char kTableLine[] = "lc rgb '#d62728' lw 1.5";

// A block $d: t, x and y of command, model and table; milliseconds and millimetres.
std::string data_block(const kung::Options& options, const kung::Result& result) {
  const Range range = counted(result);
  const std::size_t stride = (range.last - range.first) / kMaxPoints + 1;
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "$d << EOD\n");
  for (std::size_t k = range.first; k < range.last; k += stride) {
    const kung::Sample& s = result.samples[k];
    const double t_ms = static_cast<double>(s.edge - result.samples[range.first].edge) *
                        static_cast<double>(options.plant.clock_ps) * 1e-9;
    const double count_x = options.plant.axis[0].encoder_count_m;
    const double count_y = options.plant.axis[1].encoder_count_m;
    const auto& x = s.axis[0];
    const auto& y = s.axis[1];
    fmt::format_to(out, "{:.3f} {:.4f} {:.4f} {:.4f} {:.4f} {:.4f} {:.4f}\n", t_ms,
                   command_m(x, count_x) * kMm, command_m(y, count_y) * kMm,
                   model_m(x, count_x) * kMm, model_m(y, count_y) * kMm, x.x_true_m * kMm,
                   y.x_true_m * kMm);
  }
  fmt::format_to(out, "EOD\n");
  return fmt::to_string(text);
}

std::string time_panel(const char* axis, int command, const char* extra) {
  return fmt::format(
      "set ylabel '{0} (mm)'\n{1}"
      "plot $d using 1:{2} with steps title '{0} command' {5}, "
      "$d using 1:{3} with lines title 'model' {6}, "
      "$d using 1:{4} with lines title 'table' {7}\n",
      axis, extra, command, command + 2, command + 4, kCommandLine, kModelLine, kTableLine);
}

std::string path_script(bool over_time, const std::string& title) {
  std::string text = fmt::format(kPictureStyle, 800, over_time ? 640 : 760);
  text += "set output 'path.svg'\n";
  if (over_time) {
    text += fmt::format("set multiplot layout 2,1 title '{}'\n", title);
    text += "set offsets 0, 0, graph 0.05, graph 0.05\n";
    text += time_panel("X", 2, "");
    text += time_panel("Y", 3, "set xlabel 't (ms)'\n");
    return text + "unset multiplot\n";
  }
  text += fmt::format("set title '{}'\n", title);
  text += "set size ratio -1\nset offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n";
  text += "set xlabel 'x (mm)'\nset ylabel 'y (mm)'\n";
  return text + fmt::format("plot $d using 2:3 with lines title 'command' {}, "
                            "$d using 4:5 with lines title 'reference model' {}, "
                            "$d using 6:7 with lines title 'table' {}\n",
                            kCommandLine, kModelLine, kTableLine);
}

std::string error_script(bool over_time, const std::string& title) {
  std::string text = fmt::format("reset\n{}set output 'error.svg'\nset title '{}'\n",
                                 fmt::format(kPictureStyle, 800, 420), title);
  text += "set xlabel 't (ms)'\nset ylabel 'error to the model (mm)'\n";
  text += "set offsets 0, 0, graph 0.05, graph 0.05\n";
  text += fmt::format(
      "plot $d using 1:($4-$6) with lines title 'x' {}, "
      "$d using 1:($5-$7) with lines title 'y' lc rgb '#2ca02c' lw 1.5",
      kModelLine);
  if (!over_time) {
    text += fmt::format(", $d using 1:(sqrt(($4-$6)**2+($5-$7)**2)) with lines title 'T(k)' {}",
                        kTableLine);
  }
  return text + "\n";
}

}  // namespace

bool draw(const fs::path& folder, const std::string& script, const std::string& first) {
  const fs::path gnuplot = find_program("gnuplot");
  if (gnuplot.empty()) return false;
  std::signal(SIGPIPE, SIG_IGN);  // a gnuplot that dies is a return value, not the end of us
  const std::string command =
      fmt::format("cd {} && exec {} - 2>/dev/null", shell_word(folder), shell_word(gnuplot));
  std::FILE* const pipe = popen(command.c_str(), "w");
  if (pipe == nullptr) return false;
  const bool sent = std::fwrite(script.data(), 1, script.size(), pipe) == script.size();
  const bool ended = pclose(pipe) == 0;
  std::error_code ignored;
  return sent && ended && fs::file_size(folder / first, ignored) > 0;
}

std::string plain_text(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == ' ') text += c;
  }
  return text;
}

bool write_pictures(const fs::path& folder, const kung::Options& options,
                    const kung::Result& result) {
  const Range range = counted(result);
  if (range.last < range.first + 2) return false;
  const bool over_time = options.path.kind == kung::PathKind::kSquare;
  const std::string title =
      fmt::format("{}, {}", plain_text(options.scenario),
                  options.controller == kung::Controller::kFc ? "FC" : "AFC");
  return draw(folder, data_block(options, result) + path_script(over_time, title) +
                          error_script(over_time, title) + "unset output\n", "path.svg");
}

}  // namespace trammel::testbench
