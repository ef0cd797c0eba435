// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/errors.hpp"

#include <algorithm>

#include "functions/deviation/rounding_error_meter.hpp"
#include "laboratory/bench/calls.hpp"

namespace flatdyn {
namespace {

// The exact values in 50 digits, state by state.
std::vector<EntryTruth<Real50>> truths_of(const BenchSubject& subject, const Expected& expected,
                                          const std::string& scalar, std::size_t count) {
  std::vector<EntryTruth<Real50>> truths;
  for (std::size_t k = 0; k < count; ++k) {
    // A function in float gets rounded inputs, so its error is that of its own arithmetic.
    const State state = scalar == "float" ? in_float(subject.states[k]) : subject.states[k];
    truths.push_back({expected.exact(state), expected.scale(state)});
  }
  return truths;
}

BenchErrors errors_against(const std::vector<EntryTruth<Real50>>& truths, const std::vector<double>& values,
                           std::size_t entries) {
  std::vector<double> scaled, absolute;
  for (std::size_t k = 0; k < truths.size(); ++k) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(k * entries);
    const std::vector<double> x(first, first + static_cast<std::ptrdiff_t>(entries));
    scaled.push_back(scaled_error(x, truths[k].values, truths[k].scale));
    double worst = 0;
    for (std::size_t i = 0; i < entries; ++i) worst = std::max(worst, absolute_error(x[i], truths[k].values[i]));
    absolute.push_back(worst);
  }
  return {summary(scaled), summary(absolute), truths.size()};
}

}  // namespace

std::vector<BenchErrors> bench_errors(const BenchSubject& subject, const ExpectedValues& expected,
                                      const std::vector<BenchCase>& cases,
                                      const std::vector<std::vector<double>>& values, std::size_t wanted) {
  std::vector<BenchErrors> errors(cases.size());
  const auto joints = static_cast<std::size_t>(subject.mechanism.size());
  for (std::size_t f = 0; f < subject.functions.size(); ++f) {
    const Function& function = subject.functions[f];
    const Expected values_expected = expected.of(function);
    const std::size_t count = affordable_states(function, joints, wanted);
    for (const std::string scalar : {"double", "float"}) {
      const std::vector<EntryTruth<Real50>> truths = truths_of(subject, values_expected, scalar, count);
      for (std::size_t k = 0; k < cases.size(); ++k) {
        if (cases[k].function != f || cases[k].scalar != scalar) continue;
        errors[k] = errors_against(truths, values[k], entry_count(function));
      }
    }
  }
  return errors;
}

}  // namespace flatdyn
