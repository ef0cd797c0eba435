// SPDX-License-Identifier: GPL-2.0-or-later
// Where the error of an output comes from: every operation, sine, cosine and constant adds its own error times the
// output's sensitivity to it.
//
// Why this is exact: let every operation k add θ ρ_k to its result, ρ_k being its own error at some state. θ = 0 is the
// exact function, θ = 1 what is computed, and the output y(θ) is differentiable (there are sums and products only),
// with
//     y(1) - y(0) = ∫ Σ_k (∂y/∂ρ_k)(θ) ρ_k dθ,  so  |y(1) - y(0)| ≤ Σ_k max|∂y/∂ρ_k| max|ρ_k|,
// the largest over all states and all θ. The derivatives are sums and products themselves, made by going through the
// operations backward; Norms bounds them, as it bounds the results. That by a result is also no larger than what the
// operations that read it allow: |∂y/∂x_a| ≤ Σ |∂y/∂x_k| |∂x_k/∂x_a|, which is less where many of them read it, as
// they do sines.
//
// Not all of them are largest at the same state. The derivatives by the components of a vector turn as the vector does:
// each may become as large as all of them together, but |Σ a_k ρ_k| ≤ |a| |ρ|, which is √3 times less for three. So
// errors are put into groups whose derivatives are bounded by the length of their vector.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "certify/norms.hpp"

namespace flatdyn {

struct ErrorTerm {
  int operation = 0;  // of the text
  double error = 0;   // largest error that it makes itself
};

// Errors that reach the output by the same derivative, or by one of the other sign.
using AlikeErrors = std::vector<ErrorTerm>;

// The sums of alike errors are a vector, and so are the derivatives by them.
struct ErrorGroup {
  std::vector<AlikeErrors> components;
  double sensitivity = 0;  // largest length of the vector of derivatives
  double bound = 0;        // of what all of them add to the output's error: that length times the errors', rounded up
};

struct OutputError {
  int operation = 0;               // whose result is the output
  std::vector<ErrorGroup> groups;  // in the order of the text
  double bound = 0;                // of the absolute error: the groups' sum, rounded up

  int terms() const;  // of all groups
};

// A function's operations, and the derivatives that were asked for.
class ErrorAnalysis {
 public:
  ErrorAnalysis(StraightLine text, RoundingModel model, InputLimits limits, std::unique_ptr<Motions> motions = nullptr,
                int effort = kUsualEffort);

  const StraightLine& text() const { return lines_; }  // derivatives come behind it
  int executed() const { return executed_; }
  Norms& norms() { return norms_; }

  // Of the result of an operation of the text; of the torque of this joint, if it is one.
  OutputError error_of(int output, std::optional<int> joint = std::nullopt);

 private:
  // Of a result, by those that read it: how large the output's derivatives by them are, times what they make of it.
  struct Readers {
    double others = 0;
    std::map<int, std::pair<double, double>> turning;  // by joint: those that multiply it by its cosine, by its sine

    double allow() const;
  };

  std::vector<int> derivatives(int output);
  void pass_on(double sensitivity, int k, std::vector<Readers>& readers);
  int product(int a, int b);

  StraightLine lines_;
  int executed_;
  std::unique_ptr<Motions> motions_;
  Norms norms_;
};

}  // namespace flatdyn
