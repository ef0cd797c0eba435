// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/firmware/proven_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/diagnostics/diagnostics.hpp"
#include "proof/certify/certificate.hpp"
#include "proof/certify/input_limits.hpp"

namespace flatdyn {
namespace {

constexpr double kNothing = -1;

// Options for flatdyn's own bounds with little effort: Gappa only checks bounds, and larger ones serve a self test as
// well.
CertifyOptions without_gappa(const std::string& scalar) {
  CertifyOptions options;
  options.scalar = scalar;
  options.effort = kLittleEffort;
  options.time_limit = 0;
  options.observed.states = 1;
  return options;
}

std::map<std::string, double> bounds_by_name(const CertifiedFunction& certified) {
  std::map<std::string, double> bounds;
  for (const CertifiedOutput& output : certified.outputs) {
    bounds[output.name] = output.bound;
    for (const std::string& name : output.also) bounds[name] = output.bound;
  }
  return bounds;
}

// The bounds by entry. An entry that is always zero has no error and is not in the certificate.
std::vector<double> by_entry(const Function& function, const CertifiedFunction& certified) {
  const std::map<std::string, double> known = bounds_by_name(certified);
  std::vector<double> bounds;
  for (const Output& output : function.outputs) {
    for (std::size_t e = 0; e < output.entries.size(); ++e) {
      const auto found = known.find(certified_name(output, e));
      bounds.push_back(output.leaves_out(e) ? kNothing : found == known.end() ? 0 : found->second);
    }
  }
  return bounds;
}

}  // namespace

ProvenBounds::ProvenBounds(const Mechanism& mechanism, const std::vector<Function>& functions, const EmittedText& text,
                           std::size_t k, const std::string& scalar, Progress& progress)
    : mechanism_(mechanism), lines_(text.operations(k, functions[k])) {
  try {
    bounds_ = by_entry(functions[k], certify(mechanism, functions[k], lines_, without_gappa(scalar), progress));
  } catch (const Failure& failure) {
    if (failure.kind() != FailureKind::unsupported) throw;
    for (const Output& output : functions[k].outputs) bounds_.resize(bounds_.size() + output.entries.size(), kNothing);
  }
}

std::vector<double> ProvenBounds::at(const State& state) const {
  const bool is_certified = std::any_of(bounds_.begin(), bounds_.end(), [](double bound) { return bound >= 0; });
  if (is_certified && keeps_limits(state)) return bounds_;
  return std::vector<double>(bounds_.size(), kNothing);
}

// Whether the inputs keep the limits. Angles may have any value: only their sines and cosines are read.
bool ProvenBounds::keeps_limits(const State& state) const {
  const InputLimits limit = input_limits(mechanism_);
  for (int k = 0; k < lines_.size(); ++k) {
    if (lines_[k].step != Step::input) continue;
    const Input& input = lines_[k].input;
    if (!(std::abs(state.of(input.kind)[static_cast<std::size_t>(input.index)]) <= limit(input))) return false;
  }
  return true;
}

}  // namespace flatdyn
