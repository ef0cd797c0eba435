// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "truth/definition/exact.hpp"

namespace flatdyn {

// Compares every output entry with the definition of the function's row (truth/definition/exact.hpp). Throws
// Failure(bug) for a function without a row.
ExactResult prove_exactly(const Mechanism& mechanism, const Function& function, const ExactOptions& options = {});

}  // namespace flatdyn
