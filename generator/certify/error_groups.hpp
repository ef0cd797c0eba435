// SPDX-License-Identifier: GPL-2.0-or-later
// Which errors of an output are bounded together.
#pragma once

#include <vector>

#include "certify/error_terms.hpp"

namespace flatdyn {

// Errors of operations by the derivative that brings them to the output, an operation itself.
struct ErrorsByDerivative {
  int derivative = 0;
  double sensitivity = 0;  // largest size of the derivative
  AlikeErrors errors;
};

// Groups that make the sum of their bounds small: each derivative joins the vector before it from which most is gained,
// or none. Derivatives come backward, as they are made; groups and their components are in the order of the text.
std::vector<ErrorGroup> grouped(const std::vector<ErrorsByDerivative>& errors, Norms& norms);

}  // namespace flatdyn
