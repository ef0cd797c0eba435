// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/model_constants.hpp"

#include <algorithm>
#include <cmath>

#include "code/emit/literals.hpp"

namespace flatdyn {
namespace {

double distance(const Rational& exact, double value) {
  return std::abs(Rational(exact - Rational(value)).truncated()) * kRoundingMargin;
}

}  // namespace

ModelConstants::ModelConstants(const Function& function) {
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    const Node& node = function.graph[id];
    add(node.value);
    for (const Term& term : node.terms) add(term.coefficient);
  }
}

void ModelConstants::add(const Rational& value) { values_[std::abs(nearest_double(value))].insert(abs(value)); }

double ModelConstants::error(double literal, const RoundingFormat& format) const {
  const double value = std::abs(literal);
  const auto known = values_.find(value);
  if (known == values_.end()) {
    return rounding_format("double").half_ulp(value) + std::abs(format.rounded(value) - value);
  }
  double largest = 0;
  for (const Rational& exact : known->second) largest = std::max(largest, distance(exact, format.rounded(value)));
  return largest;
}

bool ModelConstants::is_ambiguous(double literal) const {
  const auto known = values_.find(std::abs(literal));
  return known != values_.end() && known->second.size() > 1;
}

std::optional<Rational> ModelConstants::exact_size(double literal) const {
  const auto known = values_.find(std::abs(literal));
  if (known == values_.end()) return Rational(std::abs(literal));
  if (known->second.size() > 1) return std::nullopt;
  return *known->second.begin();
}

std::set<Rational> ModelConstants::exact_sizes(double literal) const {
  const auto known = values_.find(std::abs(literal));
  return known == values_.end() ? std::set<Rational>{} : known->second;
}

}  // namespace flatdyn
