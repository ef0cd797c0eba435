// SPDX-License-Identifier: GPL-2.0-or-later
// The proof of functions that kernels compute in parts.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// Proves that parts, called in their order, compute the function: a part may read what an earlier one has written.
// Throws Failure(verification_failed) if they do not.
void prove_parts(const Function& function, const std::vector<Function>& parts, std::uint64_t seed = 1);

}  // namespace flatdyn
