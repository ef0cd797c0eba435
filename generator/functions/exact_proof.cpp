// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/exact_proof.hpp"

#include <algorithm>

#include "functions/formulation.hpp"
#include "functions/function_table.hpp"

namespace flatdyn {

ExactResult prove_exactly(const Mechanism& mechanism, const Function& function, const ExactOptions& options) {
  const FunctionRow& row = row_of(function);
  if (row.differentiated == nullptr) return prove_exactly(mechanism, function, row.definition, options);
  const Function of = derive_function(mechanism, name_of_differentiated(function.name));
  const ExactResult before = prove_exactly(mechanism, of, options);
  if (!before.equal) return before;
  ExactResult result = prove_derivatives(mechanism, function, without_condition(of), row.derivative, options);
  constexpr double kEither = 1;  // of the two may be wrong
  result.failure_log2 = std::min(0.0, std::max(before.failure_log2, result.failure_log2) + kEither);
  return result;
}

}  // namespace flatdyn
