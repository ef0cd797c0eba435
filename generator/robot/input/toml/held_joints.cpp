// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/toml/held_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/held_position.hpp"
#include "robot/input/common/robot_builder.hpp"
#include "robot/input/common/units.hpp"
#include "robot/model/coupling.hpp"
#include "robot/model/exact_sign.hpp"
#include "robot/model/unit_plausibility.hpp"

namespace flatdyn {

namespace {

// The inertia of a rotor that no longer turns, as a body fixed to the link that carries it.
Inertial as_inertial(const Motor& motor) {
  Inertial inertial;
  inertial.mass = motor.mass;
  inertial.centre_of_mass = motor.position;
  inertial.place = motor.place;
  // I_t E + (I_a - I_t) z z^T / (z^T z)
  const Number& transverse = motor.inertia_transverse.number;
  const Number along = (motor.inertia_axial.number - transverse) / dot(motor.axis, motor.axis);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      inertial.tensor[i][j] = (i == j ? transverse : Number(0)) + along * motor.axis[i] * motor.axis[j];
    }
  }
  return inertial;
}

void hold_rotor(Joint& joint, Robot& robot) {
  if (!joint.motor) return;
  const int carrier = joint.motor->carrier >= 0 ? joint.motor->carrier : joint.parent;
  const bool has_axis = !vanishes(dot(joint.motor->axis, joint.motor->axis));
  if (carrier >= 0 && has_axis) {
    robot.links[static_cast<std::size_t>(carrier)].inertials.push_back(as_inertial(*joint.motor));
  }
  joint.motor.reset();
}

std::string hint_for_degrees(const HeldJoint& position) {
  if (position.units.has_keys) return degrees_hint(position.position);
  return fmt::format("if so, write --fix {}={}deg", position.joint, position.written);
}

// position: in rad or m. True if it was asked whether degrees were meant.
bool ask_about(const Number& position, const HeldJoint& written, const Joint& joint, JointType type, const Spot& spot,
               ReadContext& context) {
  if (type == JointType::prismatic) {
    note_length(position, spot, written.units, context);
    return false;
  }
  if (!may_be_degrees(position, joint.limits, type == JointType::continuous)) return false;
  warn_of_degrees(position, spot, hint_for_degrees(written), context.diagnostics);
  return true;
}

// Exporters write lower = upper = 0 where nobody gave limits.
bool has_no_range(const Limits& limits) {
  return limits.lower && limits.upper && vanishes(limits.lower->number) && vanishes(limits.upper->number);
}

void warn_outside_limits(const JointPosition& lock, const Joint& joint, Diagnostics& diagnostics) {
  const Limits& limits = joint.limits;
  if (has_no_range(limits)) return;
  const auto warn = [&](const char* what, const Number& limit) {
    diagnostics.warning(lock.place, held_at(lock) + ", is " + what + " limit (" + to_decimal(limit, 6) + ")",
                        "the robot cannot be there; correct the position or the limits");
  };
  if (limits.lower && is_below(joint.held->position, limits.lower->number))
    warn("below its lower", limits.lower->number);
  if (limits.upper && is_below(limits.upper->number, joint.held->position))
    warn("above its upper", limits.upper->number);
}

// False, and an error, where there is no motion by which the joint could get to its position.
bool can_move(const JointPosition& lock, const Joint& joint, JointType type, Diagnostics& diagnostics) {
  if (type == JointType::fixed || type == JointType::spherical) {
    diagnostics.error(lock.place, held_at(lock) + ": it is a fixed joint, or of a type that can be held at 0 only",
                      "leave the position out");
    return false;
  }
  if (!vanishes(dot(joint.axis, joint.axis))) return true;
  diagnostics.error(joint.place, "joint \"" + joint.name + "\": its axis is zero", "give the axis a direction");
  return false;
}

// A joint that is held has a coordinate no longer: q_j = (p - b - Σ f_k q_k) / f_j, of its position p, is put in where
// other joints follow it.
void put_in_coordinate(const Joint& held, const Coupled& coupled, Robot& robot) {
  const Number own = own_factor(held.name, coupled);
  for (Joint& joint : robot.joints) {
    if (!joint.coupled) continue;
    std::vector<Coupled::Term> terms;
    for (const Coupled::Term& term : joint.coupled->terms) {
      if (term.joint.name != held.name) {
        terms.push_back(term);
        continue;
      }
      joint.coupled->offset += term.factor * (held.held->position - coupled.offset) / own;
      for (const Coupled::Term& other : coupled.terms) {
        if (other.joint.name != held.name) terms.push_back({other.joint, -term.factor * other.factor / own});
      }
    }
    joint.coupled->terms = terms;
  }
}

// Its coupling ends with its motion. That of a follower without a coordinate is said, because its leaders move on.
void end_coupling(const JointPosition& lock, const Joint& joint, const Coupled& coupled, ReadContext& context,
                  Robot& robot) {
  if (!vanishes(own_factor(joint.name, coupled))) {
    put_in_coordinate(joint, coupled, robot);
    return;
  }
  context.diagnostics.note(lock.place, held_at(lock) + ", follows no other joint any more",
                           "to hold them together, hold \"" + coupled.terms.front().joint.name + "\" instead",
                           "held joints that follow no other joint any more");
}

void hold(const HeldJoint& lock, Joint& joint, ReadContext& context, Robot& robot) {
  const JointType type = joint.held ? joint.held->type : joint.type;
  const std::optional<Coupled> coupled = joint.coupled;
  joint.type = JointType::fixed;
  joint.coupled.reset();
  joint.held.reset();
  hold_rotor(joint, robot);
  if ((type == JointType::fixed || type == JointType::spherical) && vanishes(lock.position)) return;
  if (!vanishes(lock.position) && !can_move(lock, joint, type, context.diagnostics)) return;
  joint.held = Held{type, held_position(lock, type, context)};
  if (coupled) end_coupling(lock, joint, *coupled, context, robot);
  if (ask_about(joint.held->position, lock, joint, type, {lock.place, held_at(lock)}, context)) return;
  warn_outside_limits(lock, joint, context.diagnostics);
}

// A joint whose leaders are all held stands still with them.
void hold_followers(Robot& robot) {
  const std::vector<LinearPosition> positions = joint_positions(robot);
  for (std::size_t j = 0; j < positions.size(); ++j) {
    Joint& joint = robot.joints[j];
    if (!joint.coupled || !positions[j].is_constant()) continue;
    joint.held = Held{joint.type, positions[j].offset};
    joint.type = JointType::fixed;
    joint.coupled.reset();
    hold_rotor(joint, robot);
  }
}

}  // namespace

std::vector<JointPosition> read_locked(TomlTable table) {
  std::vector<JointPosition> all;
  for (const std::string& joint : table.keys()) {
    if (std::optional<JointPosition> lock = table.locked_joint(joint)) all.push_back(*lock);
  }
  return all;
}

Number assembled(const HeldJoint& written, const Joint& joint, const Spot& spot, ReadContext& context) {
  const bool slides = joint.type == JointType::prismatic;
  check_degrees(written, slides, spot, context.diagnostics);
  const Number position = slides ? in_metres(written.position, written.units, spot, context.diagnostics)
                                 : in_radians(written.position, units_of(written), spot, context.diagnostics);
  ask_about(position, written, joint, joint.type, spot, context);
  return position;
}

void hold_joints(ReadContext& context, Robot& robot) {
  const bool couplings_are_valid = validate_couplings(robot, context.diagnostics);
  std::vector<std::string> known;
  for (const Joint& joint : robot.joints) {
    if (!joint.is_tendon) known.push_back(joint.name);
  }
  std::set<std::string> done;
  for (const HeldJoint& lock : context.held_joints) {
    if (!done.insert(lock.joint).second) continue;
    Joint* found = joint_in(robot, lock.joint);
    if (found != nullptr && found->is_tendon) {
      context.diagnostics.error(lock.place, "\"" + lock.joint + "\" is a tendon, which cannot be fixed",
                                "fix the joints that it runs over, or leave out its forces");
    } else if (found != nullptr) {
      hold(lock, *found, context, robot);
    } else if (!robot.joints.empty()) {
      context.diagnostics.error(lock.place, "there is no joint \"" + lock.joint + "\" to be fixed",
                                hint_for_unknown(lock.joint, known, "joints"));
    }
  }
  if (!couplings_are_valid) return;
  hold_followers(robot);
  refuse_factors(robot, context.diagnostics);
}

}  // namespace flatdyn
