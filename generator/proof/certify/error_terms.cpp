// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/error_terms.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "proof/certify/error_groups.hpp"

namespace flatdyn {

ErrorAnalysis::ErrorAnalysis(StraightLine text, RoundingModel model, InputLimits limits,
                             std::unique_ptr<MotionRecogniser> motions, int effort)
    : lines_(std::move(text)),
      executed_(lines_.size()),
      motions_(std::move(motions)),
      norms_(lines_, executed_, std::move(model), std::move(limits), motions_.get(), effort) {
  if (motions_) motions_->recognise(lines_, std::nullopt);
}

int ErrorAnalysis::product(int a, int b) {
  const auto is_one = [this](int k) { return lines_[k].step == Step::constant && lines_[k].value == 1; };
  if (is_one(a)) return b;
  if (is_one(b)) return a;
  return lines_.multiply(a, b);
}

// The bound of the derivative that the readers imply. Those that multiply by cosine and sine of one joint count
// together, as |c A + s B| is no larger than |(A, B)|.
double ErrorAnalysis::Readers::allow() const {
  double sum = others;
  for (const auto& [joint, by] : turning) sum += std::hypot(by.first, by.second);
  return std::max(sum * kRoundingMargin, Norms::kLeastSize);
}

// By operation: the derivative of the output by its result; -1 if there is no derivative.
std::vector<int> ErrorAnalysis::derivatives(int output) {
  std::vector<int> of(static_cast<std::size_t>(output) + 1, -1);
  of.back() = lines_.constant(1);
  const auto propagate = [this, &of](int to, int derivative) {
    int& sum = of[static_cast<std::size_t>(to)];
    sum = sum < 0 ? derivative : lines_.add(sum, derivative);
  };
  for (int k = output; k >= 0; --k) {
    const int derivative = of[static_cast<std::size_t>(k)];
    if (derivative < 0) continue;
    const Operation operation = lines_[k];
    switch (operation.step) {
      case Step::negate:
        propagate(operation.a, lines_.negate(derivative));
        break;
      case Step::add:
        propagate(operation.a, derivative);
        propagate(operation.b, derivative);
        break;
      case Step::subtract:
        propagate(operation.a, derivative);
        propagate(operation.b, lines_.negate(derivative));
        break;
      case Step::multiply:
        propagate(operation.a, product(derivative, operation.b));
        propagate(operation.b, product(derivative, operation.a));
        break;
      default:
        break;  // Norms throws for divisions, and for signs of values with errors
    }
  }
  return of;
}

// Adds the derivative of operation k to the readers of its operands.
void ErrorAnalysis::propagate(double sensitivity, int k, std::vector<Readers>& readers) {
  const auto add = [&readers, sensitivity](int to, double factor) {
    readers[static_cast<std::size_t>(to)].others += sensitivity * factor * kRoundingMargin;
  };
  const auto add_product = [this, &readers, &add, sensitivity](int to, int factor) {
    const Operation& by = lines_[factor];
    if (!by.is_sine_or_cosine()) return add(to, norms_.largest(factor));
    auto& [cosine, sine] = readers[static_cast<std::size_t>(to)].turning[by.input.index];
    (by.step == Step::cosine ? cosine : sine) += sensitivity * (1 + 2 * norms_.own_error(factor)) * kRoundingMargin;
  };
  const Operation operation = lines_[k];
  switch (operation.step) {
    case Step::negate:
      add(operation.a, 1);
      break;
    case Step::add:
    case Step::subtract:
      add(operation.a, 1);
      add(operation.b, 1);
      break;
    case Step::multiply:
      add_product(operation.a, operation.b);
      add_product(operation.b, operation.a);
      break;
    default:
      break;
  }
}

// Goes through the operations forward and the derivatives backward, so that each needs only known bounds.
OutputError ErrorAnalysis::error_of(int output, std::optional<int> joint) {
  for (int k = 0; k <= output; ++k) norms_.largest(k);
  const std::vector<int> derivative = derivatives(output);
  if (motions_) motions_->recognise(lines_, joint);
  std::vector<Readers> readers(derivative.size());
  readers.back().others = 1;
  std::vector<ErrorsByDerivative> errors;
  std::map<int, std::size_t> place;
  for (int k = output; k >= 0; --k) {
    int by_k = derivative[static_cast<std::size_t>(k)];
    if (by_k < 0) continue;
    const double sensitivity = norms_.largest(by_k, readers[static_cast<std::size_t>(k)].allow());
    propagate(sensitivity, k, readers);
    const double error = norms_.own_error(k);
    if (!(error > 0 && sensitivity > 0)) continue;
    while (lines_[by_k].step == Step::negate) by_k = lines_[by_k].a;
    const auto [known, is_new] = place.emplace(by_k, errors.size());
    if (is_new) errors.push_back({by_k, sensitivity, {}});
    ErrorsByDerivative& alike = errors[known->second];
    alike.sensitivity = std::min(alike.sensitivity, sensitivity);
    alike.errors.push_back({k, error});
  }
  for (ErrorsByDerivative& alike : errors) std::reverse(alike.errors.begin(), alike.errors.end());
  OutputError result{output, grouped(errors, norms_), 0};
  for (const ErrorGroup& group : result.groups) result.bound += group.bound;
  result.bound = rounded_up(result.bound, kBoundDigits);
  return result;
}

int OutputError::terms() const {
  std::size_t count = 0;
  for (const ErrorGroup& group : groups) {
    for (const AlikeErrors& alike : group.components) count += alike.size();
  }
  return static_cast<int>(count);
}

}  // namespace flatdyn
