// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/straight_line_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatdyn {
namespace {

double value_of(const Operation& operation, const std::vector<double>& values, const State& state) {
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
    case Step::sqrt:
      return std::sqrt(a());
    case Step::sign:
      break;
  }
  return (a() > 0 ? 1 : 0) - (a() < 0 ? 1 : 0);
}

}  // namespace

std::vector<double> values_of(const StraightLine& lines, const State& state) {
  std::vector<double> values;
  for (int k = 0; k < lines.size(); ++k) values.push_back(value_of(lines[k], values, state));
  return values;
}

std::vector<double> outputs_of(const StraightLine& lines, const State& state) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> values = values_of(lines, state);
  const auto value = [&values](int k) { return k < 0 ? kNone : values[static_cast<std::size_t>(k)]; };
  const bool holds =
      std::all_of(lines.positive.begin(), lines.positive.end(), [&](int condition) { return value(condition) > 0; });
  std::vector<double> entries;
  for (const std::vector<int>& output : lines.outputs) {
    for (const int entry : output) entries.push_back(holds ? value(entry) : kNone);
  }
  return entries;
}

}  // namespace flatdyn
