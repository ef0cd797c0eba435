// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/straight_line_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatdyn {
namespace {

template <class T>
T value_of(const Operation& operation, const std::vector<T>& values, const State& state, const SinesAndCosines& given) {
  const auto a = [&] { return values[static_cast<std::size_t>(operation.a)]; };
  const auto b = [&] { return values[static_cast<std::size_t>(operation.b)]; };
  const auto index = static_cast<std::size_t>(operation.input.index);
  switch (operation.step) {
    case Step::constant:
      return static_cast<T>(operation.value);
    case Step::input:
      return static_cast<T>(state.of(operation.input.kind)[index]);
    case Step::sine:
      return static_cast<T>(operation.a < 0 ? given.sine[index] : std::sin(double(a())));
    case Step::cosine:
      return static_cast<T>(operation.a < 0 ? given.cosine[index] : std::cos(double(a())));
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
  return static_cast<T>((a() > 0 ? 1 : 0) - (a() < 0 ? 1 : 0));
}

template <class T>
std::vector<T> values_in(const StraightLine& lines, const State& state, const SinesAndCosines& given) {
  std::vector<T> values;
  values.reserve(static_cast<std::size_t>(lines.size()));
  for (int k = 0; k < lines.size(); ++k) values.push_back(value_of<T>(lines[k], values, state, given));
  return values;
}

}  // namespace

SinesAndCosines library_sines(const State& state) {
  SinesAndCosines all;
  for (const double q : state.q) {
    all.sine.push_back(std::sin(q));
    all.cosine.push_back(std::cos(q));
  }
  return all;
}

std::vector<double> values_of(const StraightLine& lines, const State& state) {
  return values_in<double>(lines, state, library_sines(state));
}

std::vector<double> outputs_of(const StraightLine& lines, const State& state) {
  return outputs_of<double>(lines, state, library_sines(state));
}

template <class T>
std::vector<double> outputs_of(const StraightLine& lines, const State& state, const SinesAndCosines& given) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::vector<T> values = values_in<T>(lines, state, given);
  const auto value = [&values](int k) { return k < 0 ? kNone : double(values[static_cast<std::size_t>(k)]); };
  const bool holds =
      std::all_of(lines.positive.begin(), lines.positive.end(), [&](int condition) { return value(condition) > 0; });
  std::vector<double> entries;
  for (const std::vector<int>& output : lines.outputs) {
    for (const int entry : output) entries.push_back(holds ? value(entry) : kNone);
  }
  return entries;
}

template std::vector<double> outputs_of<float>(const StraightLine&, const State&, const SinesAndCosines&);
template std::vector<double> outputs_of<double>(const StraightLine&, const State&, const SinesAndCosines&);

}  // namespace flatdyn
