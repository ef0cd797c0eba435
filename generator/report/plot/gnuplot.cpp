// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot/gnuplot.hpp"

#include <fmt/format.h>

#include "base/diagnostics/diagnostics.hpp"
#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"

namespace flatdyn {

namespace fs = std::filesystem;

std::string gnuplot_string(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += c;
    result += c == '\n' ? ' ' : c;
  }
  return result + "'";
}

std::string gnuplot_label(const std::string& what, const std::string& text, const std::string& options) {
  return fmt::format("set {} {} {} noenhanced textcolor rgb '{}'\n", what, gnuplot_string(text), options, kPlotInk);
}

std::string gnuplot_picture(const std::function<std::string(const fs::path&)>& script) {
  const TemporaryFolder folder;
  if (run_command("gnuplot --version > /dev/null 2>&1", folder.path()) != 0) {
    throw Failure(FailureKind::io, "no plot: gnuplot cannot be run", "install gnuplot-nox");
  }
  const fs::path output = folder.path() / "plot";
  write_file(folder.path() / "plot.gp", script(output));
  if (run_command("gnuplot plot.gp > /dev/null 2> log", folder.path()) != 0) {
    const std::string messages = content_of_file(folder.path() / "log");
    check_room(folder.path(), messages);
    throw Failure(FailureKind::io, "gnuplot failed: " + messages);
  }
  return content_of_file(output);
}

}  // namespace flatdyn
