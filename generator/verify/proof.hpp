// SPDX-License-Identifier: GPL-2.0-or-later
// Proofs about emitted functions before they are written: each equals its definition by the Lagrangian, and equals
// itself before the passes, conditions included. They use exact arithmetic (definition/exact.hpp). The mechanism whose
// Lagrangian that is, is the robot as read (definition/as_read.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "definition/as_read.hpp"
#include "emit/stages.hpp"
#include "functions/exact_proof.hpp"
#include "graph/fusion.hpp"
#include "planning/optimised_function.hpp"
#include "readback/emitted_text.hpp"

namespace flatdyn {

struct Proof {
  std::string function;  // "gravity"; of a fused function "inertia_matrix_gravity::gravity", of stages "at(q)::gravity"
  ExactResult result;
};

// Proves the functions, then the parts of a fused one, then the members of stages. Throws Failure(verification_failed)
// for the first that differs. `mechanism`: the one that they are derived from.
std::vector<Proof> prove(const Mechanism& mechanism, const std::vector<OptimisedFunction>& functions,
                         const std::optional<OptimisedFusion>& fused, const std::optional<Stages>& stages);

// Proves that the mechanism is the robot that it was made from. Throws Failure(verification_failed) if it is not.
AsReadResult prove_robot(const Robot& robot, const Mechanism& mechanism);

// Proves that every function in the text that was read back is the one that was to be printed, with the constants
// rounded to its scalar. Throws Failure(verification_failed) for the first that differs.
void prove_text(const EmittedText& text, const std::vector<OptimisedFunction>& functions,
                const std::optional<Stages>& stages);
// The same for a C++ header.
void prove_text(const std::string& header, const std::vector<OptimisedFunction>& functions,
                const std::optional<Stages>& stages);

}  // namespace flatdyn
