// SPDX-License-Identifier: GPL-2.0-or-later
#include "certify/error_terms.hpp"

#include <algorithm>
#include <utility>

namespace flatdyn {

ErrorAnalysis::ErrorAnalysis(StraightLine text, RoundingModel model, InputLimits limits)
    : lines_(std::move(text)),
      executed_(lines_.size()),
      norms_(lines_, executed_, std::move(model), std::move(limits)) {}

int ErrorAnalysis::product(int a, int b) {
  const auto is_one = [this](int k) { return lines_[k].step == Step::constant && lines_[k].value == 1; };
  if (is_one(a)) return b;
  if (is_one(b)) return a;
  return lines_.multiply(a, b);
}

// By operation: the derivative of the output by its result; -1: it has none.
std::vector<int> ErrorAnalysis::derivatives(int output) {
  std::vector<int> of(static_cast<std::size_t>(output) + 1, -1);
  of.back() = lines_.constant(1);
  const auto pass_on = [this, &of](int to, int derivative) {
    int& sum = of[static_cast<std::size_t>(to)];
    sum = sum < 0 ? derivative : lines_.add(sum, derivative);
  };
  for (int k = output; k >= 0; --k) {
    const int derivative = of[static_cast<std::size_t>(k)];
    if (derivative < 0) continue;
    const Operation operation = lines_[k];
    switch (operation.step) {
      case Step::negate:
        pass_on(operation.a, lines_.negate(derivative));
        break;
      case Step::add:
        pass_on(operation.a, derivative);
        pass_on(operation.b, derivative);
        break;
      case Step::subtract:
        pass_on(operation.a, derivative);
        pass_on(operation.b, lines_.negate(derivative));
        break;
      case Step::multiply:
        pass_on(operation.a, product(derivative, operation.b));
        pass_on(operation.b, product(derivative, operation.a));
        break;
      default:
        break;  // Norms refuses divisions, and signs of what has errors
    }
  }
  return of;
}

// Operations forward, derivatives backward: each then needs only what is known.
OutputError ErrorAnalysis::error_of(int output) {
  for (int k = 0; k <= output; ++k) norms_.largest(k);
  const std::vector<int> derivative = derivatives(output);
  OutputError result{output, {}, 0};
  for (int k = output; k >= 0; --k) {
    const int by_k = derivative[static_cast<std::size_t>(k)];
    const double error = by_k < 0 ? 0 : norms_.own_error(k);
    const double sensitivity = by_k < 0 ? 0 : rounded_up(norms_.largest(by_k));
    if (!(error > 0 && sensitivity > 0)) continue;
    result.terms.push_back({k, error, sensitivity});
    result.bound += error * sensitivity;
  }
  std::reverse(result.terms.begin(), result.terms.end());
  result.bound = rounded_up(result.bound);
  return result;
}

}  // namespace flatdyn
