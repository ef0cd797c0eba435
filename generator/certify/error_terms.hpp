// SPDX-License-Identifier: GPL-2.0-or-later
// Where the error of an output comes from: every operation, sine, cosine and constant adds its own error times the
// output's sensitivity to it.
//
// Why this is exact: let every operation k add θ ρ_k to its result, ρ_k being its own error at some state. θ = 0 is the
// exact function, θ = 1 what is computed, and the output y(θ) is differentiable (there are sums and products only),
// with
//     y(1) - y(0) = ∫ Σ_k (∂y/∂ρ_k)(θ) ρ_k dθ,  so  |y(1) - y(0)| ≤ Σ_k max|∂y/∂ρ_k| max|ρ_k|,
// the largest over all states and all θ. The derivatives are sums and products themselves, made by going through the
// operations backward; Norms bounds them, as it bounds the results.
#pragma once

#include <vector>

#include "certify/norms.hpp"

namespace flatdyn {

struct ErrorTerm {
  int operation = 0;       // of the text
  double error = 0;        // largest error that it makes itself
  double sensitivity = 0;  // largest derivative of the output by it
};

struct OutputError {
  int operation = 0;             // whose result is the output
  std::vector<ErrorTerm> terms;  // in the order of the text
  double bound = 0;              // of the absolute error: Σ error · sensitivity, rounded up
};

// A function's operations, and the derivatives that were asked for.
class ErrorAnalysis {
 public:
  ErrorAnalysis(StraightLine text, RoundingModel model, InputLimits limits);

  const StraightLine& text() const { return lines_; }  // derivatives come behind it
  int executed() const { return executed_; }
  Norms& norms() { return norms_; }

  // Of the result of an operation of the text.
  OutputError error_of(int output);

 private:
  std::vector<int> derivatives(int output);
  int product(int a, int b);

  StraightLine lines_;
  int executed_;
  Norms norms_;
};

}  // namespace flatdyn
