// SPDX-License-Identifier: GPL-2.0-or-later
// Compiles and runs emitted headers as their users would.
#pragma once

#include <string>
#include <vector>

namespace flatdyn::testing {

// g++, and clang++ where it is installed.
std::vector<std::string> compilers();

struct Source {
  std::string name;
  std::string text;
};

struct Run {
  bool built = false;
  std::string output;  // of the program; of the compiler if that failed
};

// Writes the sources into a fresh folder, compiles all .cpp files with every warning an error and without exceptions
// and RTTI, links them, and runs the result.
Run build_and_run(const std::string& compiler, const std::vector<Source>& sources);

}  // namespace flatdyn::testing
