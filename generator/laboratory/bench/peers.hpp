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
  std::string name;                 // in reports
  std::string stem;                 // stem of its source file; add_STEM() adds its cases
  std::string flags;                // compiler flags
  std::string libraries;            // linker flags
  const char* source;               // template of the source file, with a section per function
  std::set<std::string> functions;  // the functions that it has
};

struct BenchPeers {
  std::vector<BenchPeer> found;
  std::vector<std::string> left_out;  // a line each
};

// The names of all possible peers.
inline constexpr const char* kBenchPeers[] = {"reference", "KDL", "MuJoCo", "DART"};

// The peers that are installed and can express the whole mechanism.
BenchPeers find_peers(const Toolchain& toolchain, const Mechanism& mechanism);

// A C++ header with the mechanism's numbers, free symbols replaced by `symbols`.
std::string mechanism_numbers(const Mechanism& mechanism, const SymbolValues& symbols);

}  // namespace flatdyn
