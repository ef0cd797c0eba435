// SPDX-License-Identifier: GPL-2.0-or-later
// What is known of emitted functions before they are written: that they are what the Lagrangian says, and what they
// were before the passes, conditions included. In exact arithmetic (definition/exact.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "definition/exact.hpp"
#include "emit/stages.hpp"
#include "graph/fusion.hpp"
#include "planning/optimised_function.hpp"
#include "readback/emitted_text.hpp"

namespace flatdyn {

struct Proof {
  std::string function;  // "gravity"; of a fused one "inertia_matrix_gravity::gravity", of stages "at(q)::gravity"
  ExactResult result;
};

// Of the functions, then of the parts of a fused one, then of the members of stages. Throws
// Failure(verification_failed) for the first that is another function. `mechanism`: what they are derived from.
std::vector<Proof> prove(const Mechanism& mechanism, const std::vector<OptimisedFunction>& functions,
                         const std::optional<OptimisedFusion>& fused, const std::optional<Stages>& stages);

// The text that was read back: every function in it must be what was to be printed, the constants rounded to its
// scalar. Throws Failure(verification_failed) for the first that is not.
void prove_text(const EmittedText& text, const std::vector<OptimisedFunction>& functions,
                const std::optional<Stages>& stages);
// Of a C++ header.
void prove_text(const std::string& header, const std::vector<OptimisedFunction>& functions,
                const std::optional<Stages>& stages);

}  // namespace flatdyn
