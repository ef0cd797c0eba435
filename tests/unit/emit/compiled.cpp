// SPDX-License-Identifier: GPL-2.0-or-later
#include "unit/emit/compiled.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

namespace flatdyn::testing {

namespace {

constexpr const char* kFlags =
    "-std=c++17 -O1 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Wfloat-equal -Wold-style-cast "
    "-Werror -fno-exceptions -fno-rtti";

bool succeeds(const std::string& command) { return std::system((command + " > /dev/null 2>&1").c_str()) == 0; }

std::filesystem::path fresh_folder() {
  static int count = 0;
  const auto folder =
      std::filesystem::path(::testing::TempDir()) / fmt::format("flatdyn-emit-{}-{}", getpid(), count++);
  std::filesystem::create_directories(folder);
  return folder;
}

std::string content_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

std::vector<std::string> compilers() {
  std::vector<std::string> found = {"g++"};
  if (succeeds("clang++ --version")) found.push_back("clang++");
  return found;
}

Run build_and_run(const std::string& compiler, const std::vector<Source>& sources) {
  const std::filesystem::path folder = fresh_folder();
  std::string files;
  for (const Source& source : sources) {
    std::ofstream(folder / source.name) << source.text;
    if (source.name.size() > 4 && source.name.ends_with(".cpp")) files += " " + source.name;
  }
  const std::string enter = fmt::format("cd '{}' && ", folder.string());
  const std::string build = fmt::format("{} {}{} -o program > output 2>&1", compiler, kFlags, files);
  Run run;
  run.built = std::system((enter + build).c_str()) == 0;
  if (run.built && std::system((enter + "./program > output 2>&1").c_str()) != 0) run.output = "the program failed: ";
  run.output += content_of(folder / "output");
  std::filesystem::remove_all(folder);
  return run;
}

}  // namespace flatdyn::testing
