// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/planar.hpp"

#include <algorithm>

#include "robot/input/common/joint_parts.hpp"
#include "robot/model/exact_sign.hpp"

namespace flatdyn {

namespace {

bool has_forces(const Joint& joint) {
  const auto is_given = [](const Value& value) { return !vanishes(value.number); };
  return is_given(joint.viscous) || is_given(joint.coulomb) || is_given(joint.armature) || is_given(joint.stiffness) ||
         joint.motor || joint.coupled;
}

bool names(const std::string& joint, const Coupled& coupled) {
  return std::any_of(coupled.terms.begin(), coupled.terms.end(),
                     [&joint](const Coupled::Term& term) { return term.joint.name == joint; });
}

// Whether a joint follows it, or a loop moves it.
bool is_coupled(const std::string& name, const Robot& robot) {
  const bool leads = std::any_of(robot.joints.begin(), robot.joints.end(),
                                 [&name](const Joint& joint) { return joint.coupled && names(name, *joint.coupled); });
  return leads || std::any_of(robot.loops.begin(), robot.loops.end(), [&name](const Loop& loop) {
           return std::any_of(loop.dependent.begin(), loop.dependent.end(),
                              [&name](const Reference& joint) { return joint.name == name; });
         });
}

void tell_of_axes(const Joint& joint, const std::string& what, Diagnostics& diagnostics) {
  const Vec3& axis = joint.axis;
  const bool is_z = vanishes(axis[0]) && vanishes(axis[1]) && is_positive(axis[2]);
  if (is_z) return;
  diagnostics.note(joint.place,
                   what +
                       ": x and y of its plane are those of its frame, turned by the smallest angle that takes z to "
                       "its axis",
                   "turn its <origin> and write <axis xyz=\"0 0 1\"/>, which all programs read alike",
                   "planar joints whose axis is not 0 0 1");
}

}  // namespace

void split_planar_joint(const std::string& name, ReadContext& context, Robot& robot) {
  const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&name](const Joint& joint) { return joint.name == name; });
  if (found == robot.joints.end()) return;
  const Joint whole = *found;
  const std::string what = "joint \"" + name + "\"";
  if (vanishes(dot(whole.axis, whole.axis))) {
    context.diagnostics.error(whole.place, what + ": its axis is zero", "give the axis a direction");
    return;
  }
  if (has_forces(whole) || is_coupled(name, robot)) {
    context.diagnostics.unsupported(
        whole.place, what + ": friction, springs, rotors and couplings of a planar joint are not supported",
        "the file does not say which of its three coordinates is meant: give them in a "
        "TOML file over the URDF, of " +
            name + ".x, " + name + ".y, " + name + ".turn");
  }
  for (Joint& joint : robot.joints) {
    if (joint.coupled && names(name, *joint.coupled)) joint.coupled.reset();  // which was reported
  }
  tell_of_axes(whole, what, context.diagnostics);
  const std::vector<Joint> parts = planar_parts(whole, what + ", axis", context);
  const auto place = robot.joints.erase(found);
  const std::vector<Joint> joined = joined_in_tree(whole, parts, robot);
  robot.joints.insert(place, joined.begin(), joined.end());
}

}  // namespace flatdyn
