// SPDX-License-Identifier: GPL-2.0-or-later
// Modules written by `flatdyn generate --python`, compiled and imported as users do.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/program.hpp"

namespace flatdyn::testing {

inline constexpr const char* kPython = "/usr/bin/python3";  // Debian's, which has Debian's numpy

class Python : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system(fmt::format("{} -c 'import numpy' 2> /dev/null", kPython).c_str()) != 0) {
      GTEST_SKIP() << "numpy is not installed: scripts/setup";
    }
  }

  void generate(const std::string& arguments) const {
    const Outcome outcome = run_flatdyn(fmt::format("generate {} -q --python -o '{}'", arguments, folder_.path()));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }

  // Compiles the library with the command that the module's own text names.
  void build(const std::string& name) const {
    const std::string text = folder_.read(name + ".py");
    const std::size_t begin = text.find("cc -std=c99");
    const std::string command = text.substr(begin, text.find('\n', begin) - begin);
    ASSERT_EQ(std::system(fmt::format("cd '{}' && {} -Wall -Wextra -Werror", folder_.path(), command).c_str()), 0);
  }

  int run(const std::string& script) const {
    folder_.write("script.py", script);
    return std::system(
        fmt::format("cd '{}' && {} script.py > '{}' 2>&1", folder_.path(), kPython, folder_.path("log")).c_str());
  }

  Scratch folder_;
};

}  // namespace flatdyn::testing
