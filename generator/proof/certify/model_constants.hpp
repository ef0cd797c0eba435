// SPDX-License-Identifier: GPL-2.0-or-later
// The exact numbers of the model that the text's literals represent.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "graph/function.hpp"
#include "graph/rational.hpp"
#include "proof/certify/rounding.hpp"

namespace flatdyn {

class ModelConstants {
 public:
  explicit ModelConstants(const Function& function);

  // The error of the literal in the scalar. For a literal that represents no number of the model: the largest rounding
  // error.
  double error(double literal, const RoundingFormat& format) const;
  // Whether the literal represents several numbers, whose errors differ.
  bool is_ambiguous(double literal) const;
  // The absolute value of the number that the literal represents: the literal itself if it represents none; nothing if
  // it represents several.
  std::optional<Rational> exact_size(double literal) const;
  // The absolute values of all numbers that the literal represents.
  std::set<Rational> exact_sizes(double literal) const;

 private:
  void add(const Rational& value);

  std::map<double, std::set<Rational>> values_;  // absolute values by that of the literal as which they are printed
};

}  // namespace flatdyn
