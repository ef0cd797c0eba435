// SPDX-License-Identifier: GPL-2.0-or-later
// Proofs about emitted functions before they are written: each equals its definition by the Lagrangian, and equals
// itself before the passes, conditions included. They use exact arithmetic (truth/definition/exact.hpp). The mechanism
// whose Lagrangian that is, is the robot as read (truth/definition/as_read.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "code/lower/stages.hpp"
#include "code/readback/emitted_text.hpp"
#include "functions/exact_proof.hpp"
#include "functions/planning/optimised_function.hpp"
#include "graph/fusion.hpp"
#include "proof/verify/written_code.hpp"
#include "truth/definition/as_read.hpp"

namespace flatdyn {

struct Proof {
  std::string function;  // "gravity"; of a fused function "inertia_matrix_gravity::gravity", of stages "at(q)::gravity"
  ExactResult result;
};

// The seed of a proof's random points: the first digits of a hash of what is proven, so that nothing can be made to fit
// the points, and the same input has the same ones. Tests may take any seed.
std::uint64_t proof_seed(const std::vector<std::string>& contents);

// Proves the functions, then the parts of fused ones, then the members of stages. Throws Failure(verification_failed)
// for the first that differs. `mechanism`: the one that they are derived from.
std::vector<Proof> prove(const Mechanism& mechanism, const std::vector<OptimisedFunction>& functions,
                         const std::vector<OptimisedFusion>& fused, const std::optional<Stages>& stages,
                         std::uint64_t seed = 1);

// Proves that the mechanism is the robot that it was made from. Throws Failure(verification_failed) if it is not.
AsReadResult prove_robot(const Robot& robot, const Mechanism& mechanism);

// Proves that the text that was read back is the code that was to be printed: every function, with the constants
// rounded to its scalar, and everything around the functions. Throws Failure(verification_failed) for the first
// function that differs, Failure(bug) with a line for anything else.
void prove_text(const EmittedText& text, const WrittenCode& code, std::uint64_t seed = 1);
// The same of the functions over arrays of states, which the C form's header is for.
void prove_batch(const std::string& header, const std::string& batch, WrittenCode code, std::uint64_t seed = 1);

}  // namespace flatdyn
