// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/parameters/unidentifiable.hpp"

namespace flatdyn {
namespace {

// The freedom of a body to turn, given by the joints from the base to it.
struct Turning {
  int turns = 0;         // number of revolute joints
  int slides = 0;        // number of prismatic joints
  bool parallel = true;  // whether all revolute axes are parallel, and along z of the body
};

// Axes are compared at q = 0: parallel ones stay parallel when the joints between them turn about them, or slide.
Turning turning_of(const Mechanism& mechanism, int body) {
  Turning result;
  Vec3 own_z = {0, 0, 1};  // z of the body in the frames on the path to the base
  for (int k = body; k >= 0; k = mechanism.bodies[static_cast<std::size_t>(k)].parent) {
    const Body& joint = mechanism.bodies[static_cast<std::size_t>(k)];
    result.parallel = result.parallel && (joint.prismatic || (vanishes(own_z[0]) && vanishes(own_z[1])));
    ++(joint.prismatic ? result.slides : result.turns);
    own_z = expanded(constant_rotation(joint) * own_z);
  }
  return result;
}

bool is_moment_of_inertia(Parameter p) { return p >= Parameter::Ixx && p <= Parameter::Izz; }

std::string reason_of(const Mechanism& mechanism, int index) {
  const Turning turning = turning_of(mechanism, joint_of(index));
  const Parameter parameter = parameter_of(index);
  const std::string link = "link \"" + mechanism.bodies[static_cast<std::size_t>(joint_of(index))].link + "\" ";
  if (parameter == Parameter::Im) return "its rotor turns with a gear ratio of zero";
  if (turning.turns == 0) {
    return is_moment_of_inertia(parameter) ? link + "never turns"
                                           : link + "never turns: where its mass is makes no difference";
  }
  if (turning.turns == 1 && turning.slides == 0) {
    if (is_moment_of_inertia(parameter))
      return link + "only turns about one fixed axis, and this moment is about another";
    if (parameter == Parameter::m || parameter == Parameter::mlz)
      return link + "only turns about one fixed axis: mass on it stays where it is";
    return link + "only turns about one fixed axis, and gravity does not act about it";
  }
  if (turning.parallel && is_moment_of_inertia(parameter))
    return link + "only turns about one direction, and this moment is about another";
  if (turning.parallel && parameter == Parameter::mlz)
    return link + "only turns about one direction: mass moved along it makes no difference";
  const int parent = mechanism.bodies[static_cast<std::size_t>(joint_of(index))].parent;
  if (parent < 0) return "its effect is on the base only";
  return "it adds only to parameters of link \"" + mechanism.bodies[static_cast<std::size_t>(parent)].link +
         "\" that are not identifiable themselves";
}

}  // namespace

std::vector<Unidentifiable> unidentifiable(const Mechanism& mechanism, const BaseParameters& base, ParameterSet set) {
  std::vector<bool> unseen = parameters_in(mechanism, set);
  for (const ParameterForm& form : base.combination) {
    for (const auto& [index, coefficient] : form) unseen[static_cast<std::size_t>(index)] = false;
  }
  std::vector<Unidentifiable> result;
  for (int k = 0; k < static_cast<int>(unseen.size()); ++k) {
    if (unseen[static_cast<std::size_t>(k)]) result.push_back({k, reason_of(mechanism, k)});
  }
  return result;
}

}  // namespace flatdyn
