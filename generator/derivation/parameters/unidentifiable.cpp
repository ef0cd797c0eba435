// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/parameters/unidentifiable.hpp"

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

// The reason for what the joint's motion does not change: it counts as a part of the parent.
std::string reason_in_parent(const Mechanism& mechanism, int body) {
  const int parent = mechanism.bodies[static_cast<std::size_t>(body)].parent;
  if (parent < 0) return "its effect is on the base only";
  return "it adds only to parameters of link \"" + mechanism.bodies[static_cast<std::size_t>(parent)].link +
         "\" that are not identifiable themselves";
}

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
  return reason_in_parent(mechanism, joint_of(index));
}

// The reason for a parameter of the file; `seen`: whether the torques depend on a parameter in π. A unit of it adds to
// several in π, of which the first is of its own kind; some may be seen, and together make no difference.
std::string reason_in_file(const Mechanism& mechanism, const FileParameter& parameter, const std::vector<bool>& seen) {
  for (const auto& [index, entry] : parameter.in_canonical) {
    if (seen[static_cast<std::size_t>(index)]) return reason_in_parent(mechanism, joint_of(index));
  }
  return reason_of(mechanism, parameter.in_canonical.begin()->first);
}

// By index: whether a form has the parameter.
std::vector<bool> occurring(const std::vector<ParameterForm>& forms, std::size_t size) {
  std::vector<bool> occurs(size, false);
  for (const ParameterForm& form : forms) {
    for (const auto& [index, coefficient] : form) occurs[static_cast<std::size_t>(index)] = true;
  }
  return occurs;
}

}  // namespace

std::vector<Unidentifiable> unidentifiable(const Mechanism& mechanism, const BaseParameters& base, ParameterSet set) {
  const std::vector<bool> present = parameters_in(mechanism, set);
  const std::vector<bool> seen = occurring(base.combination, present.size());
  std::vector<Unidentifiable> result;
  for (std::size_t k = 0; k < present.size(); ++k) {
    const int index = static_cast<int>(k);
    if (present[k] && !seen[k]) result.push_back({index, reason_of(mechanism, index)});
  }
  return result;
}

std::vector<Unidentifiable> unidentifiable_in_file(const Mechanism& mechanism, const BaseParameters& base,
                                                   const std::vector<FileParameter>& parameters) {
  std::vector<ParameterForm> forms;
  for (const ParameterForm& form : base.combination) forms.push_back(in_file_parameters(form, parameters));
  const std::vector<bool> seen = occurring(forms, parameters.size());
  const auto size_of_pi = static_cast<std::size_t>(kParametersPerJoint * mechanism.body_count());
  const std::vector<bool> seen_in_pi = occurring(base.combination, size_of_pi);
  std::vector<Unidentifiable> result;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    if (!seen[k]) result.push_back({static_cast<int>(k), reason_in_file(mechanism, parameters[k], seen_in_pi)});
  }
  return result;
}

}  // namespace flatdyn
