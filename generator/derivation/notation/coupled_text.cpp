// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/coupled_text.hpp"

#include <fmt/format.h>

#include "derivation/notation/number_text.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// Appends a term to a sum: "a", "a - 2 b", "a - 2 b + pi/2". `what`: the factor after the number, if any.
void append_term(std::string& sum, const Number& number, const std::string& what) {
  const bool negative = nearest_double(number) < 0;
  const Number size = negative ? -number : number;
  const std::string factor = what.empty()       ? exact_number_text(size)
                             : size.is_equal(1) ? ""
                                                : exact_number_text(size) + " ";
  sum += sum.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
  sum += factor + what;
}

bool is_own_coordinate(const Mechanism& mechanism, int body) {
  for (int k = 0; k < mechanism.position_count(); ++k) {
    const Number& factor = mechanism.coupling[static_cast<std::size_t>(body)][static_cast<std::size_t>(k)];
    if (!factor.is_equal(mechanism.body_at(k) == body ? 1 : 0)) return false;
  }
  return vanishes(mechanism.offsets[static_cast<std::size_t>(body)]);
}

// The positions of tendons, or of other joints, that are no entries of q.
std::vector<std::string> position_texts(const Mechanism& mechanism, const CoordinateName& coordinate, bool of_tendons) {
  std::vector<std::string> texts;
  for (int i = 0; i < mechanism.body_count() && mechanism.is_coupled(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (is_own_coordinate(mechanism, i) || mechanism.bodies[row].is_tendon != of_tendons) continue;
    std::string sum;
    for (int k = 0; k < mechanism.position_count(); ++k) {
      const Number& factor = mechanism.coupling[row][static_cast<std::size_t>(k)];
      if (!vanishes(factor)) append_term(sum, factor, coordinate(k));
    }
    if (!vanishes(mechanism.offsets[row])) append_term(sum, mechanism.offsets[row], "");
    texts.push_back(mechanism.bodies[row].joint + " = " + sum);
  }
  return texts;
}

}  // namespace

std::vector<std::string> coupled_joint_texts(const Mechanism& mechanism, const CoordinateName& coordinate) {
  return position_texts(mechanism, coordinate, false);
}

std::vector<std::string> tendon_texts(const Mechanism& mechanism, const CoordinateName& coordinate) {
  return position_texts(mechanism, coordinate, true);
}

std::string joints_text(const Mechanism& mechanism) {
  const int count = mechanism.position_count() - (kSphericalBodies * static_cast<int>(mechanism.spherical.size()));
  std::string text = std::to_string(count) + (count == 1 ? " joint" : " joints");
  if (mechanism.has_loops()) text += ", " + std::to_string(mechanism.joints().size()) + " of them independent";
  const std::size_t spherical = mechanism.spherical.size();
  const bool are_all = count == static_cast<int>(spherical);
  if (spherical > 0) text += are_all ? ", spherical" : fmt::format(", {} of them spherical", spherical);
  if (mechanism.floating_base) text += ", floating base";
  return text;
}

std::vector<std::string> dependent_joint_names(const Mechanism& mechanism, const LoopClosure& loop) {
  std::vector<std::string> names;
  for (const int k : loop.dependent) {
    names.push_back(mechanism.joint_at(k).joint);
  }
  return names;
}

}  // namespace flatdyn
