// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/kernel_proof.hpp"

#include "definition/exact.hpp"
#include "diagnostics/diagnostics.hpp"
#include "lower/kernel_parts.hpp"

namespace flatdyn {

void prove_parts(const Function& function, const std::vector<Function>& parts, std::uint64_t seed) {
  const ExactResult result = prove_equal(function, composed(function, parts), {seed, 1});
  if (result.equal) return;
  throw Failure(ExitCode::verification_failed,
                "the parts of " + function.name + " are not the function: " + result.summary(),
                "nothing was written; this is a mistake of the program: report it, with the robot file");
}

}  // namespace flatdyn
