// SPDX-License-Identifier: GPL-2.0-or-later
// The error of an output as a sum over operations: every operation, sine, cosine and constant contributes its own error
// times the output's sensitivity to it.
//
// This bound is rigorous. Let every operation k add θ ρ_k to its result, ρ_k being its own error at some state. θ = 0
// is the exact function, θ = 1 the computed one, and the output y(θ) is differentiable (there are sums and products
// only), with
//     y(1) - y(0) = ∫ Σ_k (∂y/∂ρ_k)(θ) ρ_k dθ,  so  |y(1) - y(0)| ≤ Σ_k max|∂y/∂ρ_k| max|ρ_k|,
// the maxima taken over all states and all θ. The derivatives are sums and products themselves, made by going through
// the operations backward; Norms bounds them as it bounds the results. The derivative by a result is also no larger
// than the operations that read it allow: |∂y/∂x_a| ≤ Σ |∂y/∂x_k| |∂x_k/∂x_a|; this bound is smaller where many
// operations read the result, as with sines.
//
// The derivatives are not all largest at the same state. Those by the components of a vector turn as the vector does:
// each may become as large as all of them together, but |Σ a_k ρ_k| ≤ |a| |ρ|, which is √3 times smaller for three
// components. So errors are put into groups whose derivatives are bounded by the length of their vector.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "proof/certify/norms.hpp"

namespace flatdyn {

struct ErrorTerm {
  int operation = 0;  // an operation of the text
  double error = 0;   // bound of its own error
};

// Errors that reach the output by the same derivative up to its sign.
using AlikeErrors = std::vector<ErrorTerm>;

// Several sums of alike errors as a vector, with the vector of derivatives by them.
struct ErrorGroup {
  std::vector<AlikeErrors> components;
  double sensitivity = 0;  // bound of the length of the vector of derivatives
  // Bound of the group's contribution to the output's error: that length times the errors', rounded up.
  double bound = 0;
};

struct OutputError {
  int operation = 0;               // the operation whose result is the output
  std::vector<ErrorGroup> groups;  // the groups, in the order of the text
  double bound = 0;                // bound of the absolute error: the groups' sum, rounded up

  int terms() const;  // number of terms of all groups
};

// A function's operations, and the derivatives that have been asked for.
class ErrorAnalysis {
 public:
  ErrorAnalysis(StraightLine text, RoundingModel model, InputLimits limits,
                std::unique_ptr<MotionRecogniser> motions = nullptr, int effort = kUsualEffort);

  const StraightLine& text() const { return lines_; }  // the operations, with derivatives appended
  int executed() const { return executed_; }
  Norms& norms() { return norms_; }

  // Bounds the error of the result of an operation of the text. `joint`: the joint whose torque it is, if it is one.
  OutputError error_of(int output, std::optional<int> joint = std::nullopt);

 private:
  // The operations that read a result: the sizes of the output's derivatives by them, times their own derivatives by
  // the result.
  struct Readers {
    double others = 0;
    // By joint: readers that multiply it by the joint's cosine, by its sine.
    std::map<int, std::pair<double, double>> turning;

    double allow() const;
  };

  std::vector<int> derivatives(int output);
  void propagate(double sensitivity, int k, std::vector<Readers>& readers);
  int product(int a, int b);

  StraightLine lines_;
  int executed_;
  std::unique_ptr<MotionRecogniser> motions_;
  Norms norms_;
};

}  // namespace flatdyn
