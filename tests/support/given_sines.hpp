// SPDX-License-Identifier: GPL-2.0-or-later
// Statements of a test's program that fill sine[k] and cosine[k] like callers who have them from elsewhere: those of
// the entries of q, and of the multiples of them by which coupled joints turn.
#pragma once

#include <fmt/format.h>

#include <string>

#include "code/emit/literals.hpp"
#include "robot/model/field_mechanism.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn::testing {

// `name_space`: that of the C++ form, whose own sines they are, so that results can have the same bits.
inline std::string given_sines(const Mechanism& mechanism, const std::string& scalar, const std::string& name_space) {
  std::string text = fmt::format("  {0} angle[{1}], sine[{1}], cosine[{1}];\n", scalar, mechanism.angle_count()), all;
  const auto fill = [&](int k, const std::string& angle) {
    text += fmt::format("  angle[{0}] = {1}, sine[{0}] = cosine[{0}] = {2}(0);\n", k, angle, scalar);
    all += (k == 0 ? "" : ", ") + std::to_string(k);
  };
  for (int k = 0; k < mechanism.position_count(); ++k) fill(k, fmt::format("q[{}]", k));
  for (std::size_t a = 0; a < mechanism.angles.size(); ++a) {
    const CoordinateMultiple& angle = mechanism.angles[a];
    fill(mechanism.position_count() + static_cast<int>(a),
         fmt::format("{}({}) * q[{}]", scalar, decimal_literal(to_rational(angle.factor)), angle.position));
  }
  bool turns = false;
  for (int k = 0; k < mechanism.position_count(); ++k) turns = turns || !mechanism.joint_at(k).prismatic;
  if (!turns) return text;
  return text + fmt::format("  {0}::PolynomialSinCos()(angle, {0}::Joints<{1}>(), sine, cosine);\n", name_space, all);
}

}  // namespace flatdyn::testing
