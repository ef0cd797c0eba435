// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/deviation/rounding_error_meter.hpp"

#include <cmath>
#include <limits>

namespace flatdyn {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The factor on the smallest normal number below which errors count as underflow. Numbers below that one lose digits in
// every code, and lengths, masses and other rates (up to 1e6 here) multiply the loss: errors of smaller terms are
// measured against this size.
constexpr double kUnderflow = 1e12;

double as_double(long double x) { return static_cast<double>(x); }
double as_double(const Real50& x) { return x.convert_to<double>(); }

}  // namespace

RoundingErrorMeter::RoundingErrorMeter(const Function& function, Expected expected, const std::string& scalar)
    : is_float_(scalar == "float"),
      epsilon_(is_float_ ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon()),
      underflow_(kUnderflow * (is_float_ ? std::numeric_limits<float>::min() : std::numeric_limits<double>::min())),
      expected_(std::move(expected)),
      graph_(function) {}

std::optional<EntryTruth<long double>> RoundingErrorMeter::truth(const State& given) {
  if (!expected_.is_regular(given)) return std::nullopt;
  const StateOf<long double> wide = with_unit_quaternions(expected_.quaternions, widened<long double>(given));
  TapeInputsOf<long double> inputs;
  for (const InputKind kind : kArgumentKinds) inputs[kind] = wide.of(kind);
  std::vector<long double> values(graph_.results());
  if (!graph_.run(inputs, values)) return std::nullopt;
  return EntryTruth<long double>{std::move(values), expected_.scale(given)};
}

EntryTruth<Real50> RoundingErrorMeter::exact_truth(const State& given) const {
  return {expected_.exact(given), expected_.scale(given)};
}

std::vector<double> RoundingErrorMeter::reference(const State& given) const {
  return is_float_ ? expected_.in_float(given) : expected_.rounded(given);
}

template <class Wide>
RoundingError RoundingErrorMeter::error(const std::vector<double>& values, const EntryTruth<Wide>& truth) const {
  using std::abs;
  RoundingError worst;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double size = as_double(Wide(abs(truth.values[k])));
    const double found = std::isfinite(values[k]) ? as_double(Wide(abs(Wide(values[k]) - truth.values[k]))) : kInfinity;
    if (found == 0) continue;
    // An entry without terms must be exactly zero.
    const double scale = truth.scale[k] > 0 ? std::max(truth.scale[k], underflow_) : 0;
    const double scaled = scale > 0 ? found / (epsilon_ * scale) : kInfinity;
    if (scaled <= worst.scaled) continue;
    worst = {scaled, size > 0 ? scale / size : kInfinity, size > 0 ? found / (epsilon_ * size) : kInfinity};
  }
  return worst;
}

template RoundingError RoundingErrorMeter::error(const std::vector<double>&, const EntryTruth<long double>&) const;
template RoundingError RoundingErrorMeter::error(const std::vector<double>&, const EntryTruth<Real50>&) const;

}  // namespace flatdyn
