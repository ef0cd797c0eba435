// SPDX-License-Identifier: GPL-2.0-or-later
// The exact numbers of the model that literals of the text stand for.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "certify/rounding.hpp"
#include "graph/function.hpp"
#include "graph/rational.hpp"

namespace flatdyn {

class ModelConstants {
 public:
  explicit ModelConstants(const Function& function);

  // How far the scalar is from them. Of a literal that stands for none: what a literal can be off.
  double error(double literal, const RoundingFormat& format) const;
  // It stands for several, whose errors differ.
  bool is_ambiguous(double literal) const;
  // The size of the number that it stands for, itself if for none; nothing if for several.
  std::optional<Rational> exact_size(double literal) const;

 private:
  void add(const Rational& value);

  std::map<double, std::set<Rational>> values_;  // sizes, by the size of the literal that they are printed as
};

}  // namespace flatdyn
