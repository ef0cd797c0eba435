// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/exact_proof.hpp"

#include "functions/function_table.hpp"

namespace flatdyn {

ExactResult prove_exactly(const Mechanism& mechanism, const Function& function, const ExactOptions& options) {
  return prove_exactly(mechanism, function, row_of(function).definition, options);
}

}  // namespace flatdyn
