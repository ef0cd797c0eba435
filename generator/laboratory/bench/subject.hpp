// SPDX-License-Identifier: GPL-2.0-or-later
// The subject of the benchmark: a robot's functions, whole, abbreviated and in stages, and its peers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "code/lower/stages.hpp"
#include "graph/function.hpp"
#include "laboratory/bench/peers.hpp"
#include "laboratory/bench/toolchain.hpp"
#include "laboratory/bench/variants.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

// The namespace of all code generated for the program.
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

// A function as a variant calls it.
struct CalledFunction {
  Function function;     // a stage's member lacks the inputs that the stage has
  std::string scope;     // scope of its declaration: "robot", "robot::budget_1_"; for a member "robot::Motion"
  std::string receiver;  // prefix of the call: "robot::", "motion."
};

// The namespace of the whole functions that a variant calls, which has sources of sines of its own.
std::string name_space_of(const BenchVariant& variant);

// A whole function as a variant calls it.
CalledFunction whole_function(const Function& function, const BenchVariant& variant);

// Function k of the subject; none if the variant lacks it.
std::optional<CalledFunction> called_function(const BenchSubject& subject, std::size_t k, const BenchVariant& variant);

// The namespace of the functions with fused multiply-adds, and their header.
inline constexpr const char *kFusedNamespace = "robot::fused", *kFusedHeader = "robot_fused.hpp";
// The same of functions with limbs in the lanes of vectors.
inline constexpr const char *kLimbsNamespace = "robot::limbs", *kLimbsHeader = "robot_limbs.hpp";
// The same of functions that are compiled with the compiler's own tuning.
inline constexpr const char *kNativeNamespace = "robot::native", *kNativeHeader = "robot_native.hpp";
// The same of the CUDA form.
inline constexpr const char *kKernelsNamespace = "robot::kernels", *kKernelsHeader = "robot_kernels.cuh";
// The namespace of a budget's functions: "robot::budget_0_1_".
std::string name_space_of_budget(const std::string& budget);

}  // namespace flatdyn
