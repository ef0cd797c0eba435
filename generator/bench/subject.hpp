// SPDX-License-Identifier: GPL-2.0-or-later
// What the benchmark's program calls: a robot's functions, whole, abbreviated and in stages, and its peers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/peers.hpp"
#include "bench/toolchain.hpp"
#include "bench/variants.hpp"
#include "emit/stages.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/states.hpp"

namespace flatdyn {

// Of all that is generated for the program.
inline constexpr const char* kBenchNamespace = "robot";

struct AbbreviatedFunctions {
  std::string budget;  // "0.1%"
  std::vector<Function> functions;
};

struct BenchSubject {
  const Mechanism& mechanism;
  const std::vector<Function>& functions;
  const std::vector<State>& states;
  const Toolchain& toolchain;
  std::vector<BenchVariant> variants;
  std::vector<BenchPeer> peers;
  const SymbolValues& symbols;
  std::vector<AbbreviatedFunctions> abbreviated = {};
  std::optional<Stages> stages = {};
};

// A function as it is called in a variant.
struct CalledFunction {
  Function function;     // a stage's member without the inputs that the stage has
  std::string scope;     // what it is declared in: "robot", "robot::budget_1_"; of a member "robot::Motion"
  std::string receiver;  // what it is called on: "robot::", "motion."
};

// Function k of the subject; nothing where the variant has none.
std::optional<CalledFunction> called_function(const BenchSubject& subject, std::size_t k, const BenchVariant& variant);

// "robot::budget_0_1_".
std::string name_space_of_budget(const std::string& budget);

}  // namespace flatdyn
