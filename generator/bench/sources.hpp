// SPDX-License-Identifier: GPL-2.0-or-later
// The text of the benchmark's program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/peers.hpp"
#include "bench/toolchain.hpp"
#include "bench/variants.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/states.hpp"

namespace flatdyn {

struct BenchSubject {
  const Mechanism& mechanism;
  const std::vector<Function>& functions;
  const std::vector<State>& states;
  const Toolchain& toolchain;
  std::vector<BenchVariant> variants;
  std::vector<BenchPeer> peers;
  const SymbolValues& symbols;
};

struct SourceFile {
  std::filesystem::path path;
  std::string text;
};

// All that the program is made of, with the states that it reads.
std::vector<SourceFile> bench_sources(const BenchSubject& subject);

}  // namespace flatdyn
