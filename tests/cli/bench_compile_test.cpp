// SPDX-License-Identifier: GPL-2.0-or-later
// The controllers whose compilation scripts/bench-compile measures are ones that compile.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

// The names in the script's lines "functions=…" and "functions+=,…".
std::string functions_of_script() {
  std::ifstream script(FLATDYN_SOURCE_DIR "/scripts/bench-compile");
  std::string names;
  for (std::string line; std::getline(script, line);) {
    if (line.starts_with("functions")) names += line.substr(line.find('=') + 1);
  }
  return names;
}

TEST(BenchCompile, MeasuresControllersThatCallAllFunctions) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn(
      fmt::format("generate robots/panda.urdf -q --functions {} -o '{}'", functions_of_script(), scratch.path()));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* file : {"arrays.cpp", "eigen.cpp"}) {
    const std::string compile = fmt::format(
        "cd '{}' && g++ -std=c++17 -fsyntax-only -Wall -Wextra -Werror -I '{}' -I runtime/include -isystem "
        "/usr/include/eigen3 docs/examples/compile_time/{}",
        FLATDYN_SOURCE_DIR, scratch.path(), file);
    EXPECT_EQ(std::system(compile.c_str()), 0) << compile;
  }
}

}  // namespace
}  // namespace flatdyn::testing
