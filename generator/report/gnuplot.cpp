// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/gnuplot.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "diagnostics/diagnostics.hpp"
#include "diagnostics/temporary_folder.hpp"

namespace flatdyn {

namespace fs = std::filesystem;

namespace {

std::string content_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace

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

std::string gnuplot_svg(const std::function<std::string(const fs::path&)>& script) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) {
    throw Failure(ExitCode::io, "no plot: gnuplot cannot be run", "install gnuplot-nox");
  }
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "plot.gp", output = folder.path() / "plot.svg", log = folder.path() / "log";
  std::ofstream(file, std::ios::binary) << script(output);
  const std::string command = fmt::format("gnuplot '{}' > /dev/null 2> '{}'", file.string(), log.string());
  if (std::system(command.c_str()) != 0) throw Failure(ExitCode::io, "gnuplot failed: " + content_of(log));
  return content_of(output);
}

}  // namespace flatdyn
