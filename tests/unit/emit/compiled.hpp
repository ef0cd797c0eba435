// SPDX-License-Identifier: GPL-2.0-or-later
// Compiles and runs emitted headers as users do.
#pragma once

#include <string>
#include <vector>

namespace flatdyn::testing {

// g++, and clang++ if it is installed.
std::vector<std::string> compilers();

struct Source {
  std::string name;
  std::string text;
};

struct Run {
  bool built = false;
  std::string output;  // the program's output, or the compiler's if that failed
};

// Writes the sources to a new folder, compiles all .cpp files with every warning an error and without exceptions and
// RTTI, links them, and runs the result.
Run build_and_run(const std::string& compiler, const std::vector<Source>& sources);

}  // namespace flatdyn::testing
