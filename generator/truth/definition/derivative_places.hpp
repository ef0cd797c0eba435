// SPDX-License-Identifier: GPL-2.0-or-later
// The order of the entries of derivatives that are matrices, as docs/derivatives.md has it.
#pragma once

#include <vector>

#include "derivation/differentiation/tangents.hpp"
#include "graph/function_name.hpp"

namespace flatdyn {

// A row among all entries of the function that is differentiated, and a column among the directions.
struct DerivativePlace {
  std::size_t row = 0, column = 0;
};

struct DerivativePlaces {
  std::vector<DerivativePlace> entries;   // of all outputs, in order
  std::vector<DerivativePlace> left_out;  // of a Hessian: those of pairs of arguments without an output, which are zero
};

// Those of a Jacobian or of a contracted Hessian, whose rows are the entries of wᵀ J; none of other derivatives.
DerivativePlaces derivative_places(const Function& derivatives, Derivative derivative, const Tangents& tangents);

}  // namespace flatdyn
