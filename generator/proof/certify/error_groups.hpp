// SPDX-License-Identifier: GPL-2.0-or-later
// Groups of errors of an output that are bounded together.
#pragma once

#include <vector>

#include "proof/certify/error_terms.hpp"

namespace flatdyn {

// The errors of operations that reach the output by the same derivative, which is an operation itself.
struct ErrorsByDerivative {
  int derivative = 0;
  double sensitivity = 0;  // bound of the derivative's size
  AlikeErrors errors;
};

// Forms groups so that the sum of their bounds is small: each derivative joins the earlier vector that gains most by
// it, or none. Derivatives are given backward, as they are made; the groups and their components are in the order of
// the text.
std::vector<ErrorGroup> grouped(const std::vector<ErrorsByDerivative>& errors, Norms& norms);

}  // namespace flatdyn
