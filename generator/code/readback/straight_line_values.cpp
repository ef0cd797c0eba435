// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/straight_line_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "code/readback/execute.hpp"

namespace flatdyn {
namespace {

// Arithmetic with T's rounding, and with given sines and cosines of the joints' positions.
template <class T>
class RoundedArithmetic {
 public:
  using Scalar = T;

  RoundedArithmetic(const State& state, const SinesAndCosines& given) : state_(state), given_(given) {}

  T constant(double value) const { return static_cast<T>(value); }
  T input(const Input& input) const { return entry(state_.of(input.kind), input); }
  T sine(const Input& position) const { return entry(given_.sine, position); }
  T cosine(const Input& position) const { return entry(given_.cosine, position); }
  T sine(const T& angle) const { return static_cast<T>(std::sin(double(angle))); }
  T cosine(const T& angle) const { return static_cast<T>(std::cos(double(angle))); }
  T divide(const T& a, const T& b) const { return a / b; }
  T sign(const T& x) const { return static_cast<T>((x > 0 ? 1 : 0) - (x < 0 ? 1 : 0)); }
  T sqrt(const T& x) const { return std::sqrt(x); }
  T fused(const T& a, const T& b, const T& c) const { return std::fma(a, b, c); }

 private:
  static T entry(const std::vector<double>& values, const Input& input) {
    return static_cast<T>(values[static_cast<std::size_t>(input.index)]);
  }

  const State& state_;
  const SinesAndCosines& given_;
};

template <class T>
std::vector<T> values_in(const StraightLine& lines, const State& state, const SinesAndCosines& given) {
  RoundedArithmetic<T> arithmetic(state, given);
  std::vector<T> values;
  execute(lines, lines.size(), arithmetic, values);
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
  const bool holds = std::all_of(lines.validity_conditions.begin(), lines.validity_conditions.end(),
                                 [&](int condition) { return value(condition) > 0; });
  std::vector<double> entries;
  for (const std::vector<int>& output : lines.outputs) {
    for (const int entry : output) entries.push_back(holds ? value(entry) : kNone);
  }
  return entries;
}

template std::vector<double> outputs_of<float>(const StraightLine&, const State&, const SinesAndCosines&);
template std::vector<double> outputs_of<double>(const StraightLine&, const State&, const SinesAndCosines&);

}  // namespace flatdyn
