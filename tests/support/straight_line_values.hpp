// SPDX-License-Identifier: GPL-2.0-or-later
// What a straight line of operations computes at a state, in double.
#pragma once

#include <cmath>
#include <vector>

#include "model/states.hpp"
#include "verify/straight_line.hpp"

namespace flatdyn::testing {

inline double value_of(const Operation& operation, const std::vector<double>& values, const State& state) {
  const auto a = [&] { return values[static_cast<std::size_t>(operation.a)]; };
  const auto b = [&] { return values[static_cast<std::size_t>(operation.b)]; };
  const auto input = [&] { return state.of(operation.input.kind)[static_cast<std::size_t>(operation.input.index)]; };
  switch (operation.step) {
    case Step::constant:
      return operation.value;
    case Step::input:
      return input();
    case Step::sine:
      return std::sin(input());
    case Step::cosine:
      return std::cos(input());
    case Step::negate:
      return -a();
    case Step::add:
      return a() + b();
    case Step::subtract:
      return a() - b();
    case Step::multiply:
      return a() * b();
    case Step::divide:
      return a() / b();
    case Step::sign:
      break;
  }
  return (a() > 0 ? 1 : 0) - (a() < 0 ? 1 : 0);
}

// By operation.
inline std::vector<double> values_of(const StraightLine& lines, const State& state) {
  std::vector<double> values;
  for (int k = 0; k < lines.size(); ++k) values.push_back(value_of(lines[k], values, state));
  return values;
}

}  // namespace flatdyn::testing
