// SPDX-License-Identifier: GPL-2.0-or-later
// Other programs' ways to the same numbers, on the same mechanism.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "bench/toolchain.hpp"
#include "model/mechanism.hpp"
#include "reference/reference_model.hpp"

namespace flatdyn {

struct BenchPeer {
  std::string name;                 // in reports
  std::string stem;                 // of its source file; add_STEM() adds its cases
  std::string flags;                // of the compiler
  std::string libraries;            // of the linker
  const char* source;               // template of the source file, with a section per function
  std::set<std::string> functions;  // that it has
};

struct BenchPeers {
  std::vector<BenchPeer> found;
  std::vector<std::string> left_out;  // a line each
};

// Of all that there may be.
inline constexpr const char* kBenchPeers[] = {"reference", "KDL", "MuJoCo", "DART"};

// Those that are installed and know all that the mechanism has.
BenchPeers find_peers(const Toolchain& toolchain, const Mechanism& mechanism);

// A C++ header with the mechanism's numbers, the free symbols replaced by `symbols`.
std::string mechanism_numbers(const Mechanism& mechanism, const SymbolValues& symbols);

}  // namespace flatdyn
