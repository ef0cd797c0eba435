// SPDX-License-Identifier: GPL-2.0-or-later
// Peers: other programs that compute the same functions of the same mechanism.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "laboratory/bench/toolchain.hpp"
#include "robot/model/mechanism.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {

struct BenchPeer {
  std::string name;                   // in reports
  std::string stem;                   // stem of its source file; add_STEM() adds its cases
  std::string flags;                  // compiler flags
  std::string libraries;              // linker flags
  const char* source;                 // template of the source file, with a section per function
  std::set<std::string> functions;    // the functions that it has
  std::set<std::string> halved = {};  // of these: whose last output is symmetric, and of which it writes the upper half
  std::string include = {};           // the header that the source file includes, where its template is shared
  std::string call = {};              // the statement there that computes a function, {} its name, from x to y
  std::string recorder = {};          // writes the file `include`, run with the names of functions
};

struct BenchPeers {
  std::vector<BenchPeer> found;
  std::vector<std::string> left_out;  // a line each
};

// The names of all possible peers.
inline constexpr const char* kBenchPeers[] = {"reference", "KDL",          "MuJoCo", "DART",
                                              "Pinocchio", "CppADCodeGen", "CasADi"};

// The peers that are installed and can express the whole mechanism.
BenchPeers find_peers(const Toolchain& toolchain, const Mechanism& mechanism);

// A C++ header with the mechanism's numbers, free symbols replaced by `symbols`.
std::string mechanism_numbers(const Mechanism& mechanism, const SymbolValues& symbols);

// The same numbers as the file that Pinocchio's peers read: tests/benchmark/pinocchio/mechanism.hpp.
std::string mechanism_file(const Mechanism& mechanism, const SymbolValues& symbols);

}  // namespace flatdyn
