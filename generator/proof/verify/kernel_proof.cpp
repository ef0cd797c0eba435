// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/kernel_proof.hpp"

#include "base/diagnostics/diagnostics.hpp"
#include "code/lower/kernel_parts.hpp"
#include "truth/definition/exact.hpp"

namespace flatdyn {

void prove_parts(const Function& function, const std::vector<Function>& parts, std::uint64_t seed) {
  const ExactResult result = prove_equal(function, composed(function, parts), {seed, 1});
  if (result.equal) return;
  throw Failure(FailureKind::verification_failed,
                "the parts of " + function.name + " are not the function: " + result.summary(),
                "nothing was written; this is a mistake of the program: report it, with the robot file");
}

}  // namespace flatdyn
