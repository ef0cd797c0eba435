// SPDX-License-Identifier: GPL-2.0-or-later
// Statements of a test's program that fill sine[k] and cosine[k] like callers who have them from elsewhere: those of
// the entries of q, and of the multiples of them by which coupled joints turn.
#pragma once

#include <fmt/format.h>

#include <string>

#include "emit/literals.hpp"
#include "model/field_mechanism.hpp"
#include "model/mechanism.hpp"

namespace flatdyn::testing {

inline std::string given_sines(const Mechanism& mechanism, const std::string& scalar) {
  std::string text = fmt::format("  {0} sine[{1}], cosine[{1}];\n", scalar, mechanism.angle_count());
  const auto fill = [&text](int k, const std::string& angle) {
    text += fmt::format("  sine[{0}] = std::sin({1}), cosine[{0}] = std::cos({1});\n", k, angle);
  };
  for (int k = 0; k < mechanism.position_count(); ++k) fill(k, fmt::format("q[{}]", k));
  for (std::size_t a = 0; a < mechanism.angles.size(); ++a) {
    const CoordinateMultiple& angle = mechanism.angles[a];
    fill(mechanism.position_count() + static_cast<int>(a),
         fmt::format("{}({}) * q[{}]", scalar, decimal_literal(to_rational(angle.factor)), angle.position));
  }
  return text;
}

}  // namespace flatdyn::testing
