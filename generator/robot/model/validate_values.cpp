// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "robot/model/absent_limits.hpp"
#include "robot/model/exact_sign.hpp"
#include "robot/model/physical_inertia.hpp"

namespace flatdyn {

namespace {

bool is_exact_zero(const Number& a) { return vanishes(a); }

std::string decimal(const Number& a) { return fmt::format("{:.6g}", nearest_double(a)); }

std::string named(const Joint& joint) { return (joint.is_tendon ? "tendon \"" : "joint \"") + joint.name + "\""; }
std::string named(const Link& link) { return "link \"" + link.name + "\""; }

void check_axis(const Joint& joint, Diagnostics& diagnostics) {
  if (std::any_of(joint.axis.begin(), joint.axis.end(), has_symbols)) {
    diagnostics.unsupported(joint.place, named(joint) + ": a symbol in the axis is not supported",
                            "write numbers; a symbolic angle can be given in rpy, alpha or theta");
  }
  if (is_exact_zero(dot(joint.axis, joint.axis))) {
    diagnostics.error(joint.place, named(joint) + ": the axis is zero", "write a direction such as 0 0 1");
  }
}

void check_not_negative(const Value& value, const std::string& what, const std::string& hint,
                        Diagnostics& diagnostics) {
  if (is_negative(value.number)) {
    diagnostics.error(value.place, what + " is negative (" + decimal(value.number) + ")", hint);
  }
}

void check_inertia_without_mass(const std::string& what, const Inertial& inertial, Diagnostics& diagnostics) {
  if (!is_exact_zero(inertial.mass.number)) return;
  bool all_zero = true;
  for (const Vec3& row : inertial.tensor) {
    for (const Number& entry : row) all_zero = all_zero && is_exact_zero(entry);
  }
  if (all_zero) return;
  diagnostics.warning(inertial.place, what + ": the mass is zero but the inertia is not",
                      "give the mass, or delete the inertia", "bodies with an inertia but no mass");
}

// Whether only one diagonal entry is not zero: no body has such a tensor, but planar models are written so.
bool is_about_one_axis(const Mat3& tensor) {
  int entries = 0, moments = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (is_exact_zero(tensor[i][j])) continue;
      ++entries;
      if (i == j && !is_negative(tensor[i][j])) ++moments;
    }
  }
  return entries == 1 && moments == 1;
}

void check_inertia(const std::string& what, const Inertial& inertial, Diagnostics& diagnostics) {
  check_not_negative(inertial.mass, what + ": mass", "masses are in kg, not negative", diagnostics);
  const Mat3 tensor = central_tensor(inertial);
  if (is_about_one_axis(tensor)) {
    diagnostics.note(inertial.place, what + ": only a moment of inertia about one axis is given",
                     "that is enough if the link turns about that axis only, as in a planar arm",
                     "bodies with a moment of inertia about one axis only");
    return;
  }
  const auto fault = fault_of_inertia(tensor);
  if (fault) {
    const auto [largest, middle, smallest] = principal_moments(tensor);
    const std::string fact = *fault == InertiaFault::not_positive_semidefinite
                                 ? "a principal moment is negative"
                                 : "the largest principal moment exceeds the sum of the others";
    diagnostics.warning(
        inertial.place,
        fmt::format("{}: no body has this inertia: {} ({:.6g}, {:.6g}, {:.6g} kg m^2 about the centre of mass)", what,
                    fact, largest, middle, smallest),
        "check the units, the signs of the products of inertia, and the point that the tensor is about",
        "inertias that no body can have");
  }
}

void check_motor(const Joint& joint, Diagnostics& diagnostics) {
  if (!joint.motor) return;
  const Motor& motor = *joint.motor;
  const std::string what = named(joint) + ", motor: ";
  check_not_negative(motor.mass, what + "mass", "masses are in kg, not negative", diagnostics);
  check_not_negative(motor.inertia_axial, what + "inertia", "kg m^2, not negative", diagnostics);
  check_not_negative(motor.inertia_transverse, what + "inertia_transverse", "kg m^2, not negative", diagnostics);
  if (is_exact_zero(motor.gear_ratio.number)) {
    diagnostics.error(motor.gear_ratio.place, what + "gear_ratio is zero",
                      "k_r = motor speed / joint speed; 1 if direct");
  }
  if (std::any_of(motor.axis.begin(), motor.axis.end(), has_symbols)) {
    diagnostics.unsupported(motor.place, what + "a symbol in the axis is not supported", "write numbers");
  }
  if (is_exact_zero(dot(motor.axis, motor.axis))) {
    diagnostics.error(motor.place, what + "the axis is zero", "write a direction such as [0, 0, 1]");
  }
  const Number excess = motor.inertia_axial.number - 2 * motor.inertia_transverse.number;
  if (!is_exact_zero(motor.inertia_transverse.number) && is_positive(excess)) {
    diagnostics.warning(motor.place, what + "no body has this inertia: inertia exceeds twice inertia_transverse",
                        "check the units; a flat disc has twice, a slender rotor less",
                        "motors with an inertia that no body can have");
  }
}

// A position of the joint in the unit of its file.
std::string position_text(const Number& position, const Joint& joint, bool in_degrees, int digits = 6) {
  if (!in_degrees || joint.type == JointType::prismatic)
    return fmt::format("{:.{}g}", nearest_double(position), digits);
  return fmt::format("{:.{}g} deg", nearest_double(position * 180 / GiNaC::Pi), digits);
}

void check_range(const Joint& joint, bool in_degrees, Diagnostics& diagnostics) {
  const std::optional<Value>& lower = joint.limits.lower;
  const std::optional<Value>& upper = joint.limits.upper;
  if (!lower || !upper) return;
  const Number range = upper->number - lower->number;
  if (is_negative(range)) {
    const auto text = [&](const Number& limit, int digits) { return position_text(limit, joint, in_degrees, digits); };
    const int digits = text(lower->number, 6) == text(upper->number, 6) ? 17 : 6;
    diagnostics.error(lower->place,
                      fmt::format("{}: the lower limit ({}) is above the upper one ({})", named(joint),
                                  text(lower->number, digits), text(upper->number, digits)),
                      "exchange them");
  } else if (is_exact_zero(range)) {
    diagnostics.warning(lower->place, named(joint) + " cannot move: its lower and upper limit are the same",
                        "give the range, or make the joint a fixed one",
                        "joints that cannot move, as their limits are the same");
  }
}

void check_limits(Joint& joint, bool in_degrees, Diagnostics& diagnostics) {
  remove_absent_limits(joint, diagnostics);
  check_range(joint, in_degrees, diagnostics);
  struct Magnitude {
    const char* name;
    const std::optional<Value>& limit;
    const char* per_time;  // after degrees; nullptr of what is no motion
  };
  const Magnitude magnitudes[] = {{"velocity", joint.limits.velocity, "/s"},
                                  {"acceleration", joint.limits.acceleration, "/s^2"},
                                  {"effort", joint.limits.effort, nullptr}};
  for (const auto& [name, limit, per_time] : magnitudes) {
    if (!limit || !is_negative(limit->number)) continue;
    std::string text = position_text(limit->number, joint, in_degrees && per_time != nullptr);
    if (text.ends_with("deg")) text += per_time;
    diagnostics.error(limit->place, fmt::format("{}: {} limit is negative ({})", named(joint), name, text),
                      "it bounds the magnitude");
  }
}

// A spherical joint may have viscous friction, and limits of velocity, acceleration and effort.
void check_spherical(const Joint& joint, Diagnostics& diagnostics) {
  const auto refuse = [&](const Place& place, const std::string& what) {
    diagnostics.unsupported(place, fmt::format("{}: {} of a spherical joint is not supported", named(joint), what),
                            "leave it out; viscous friction and limits of velocity, acceleration and effort are known");
  };
  for (const auto* value : {&joint.law.speed, &joint.law.offset, &joint.law.static_friction, &joint.law.backward}) {
    if (*value) return refuse((*value)->place, "Coulomb friction");
  }
  if (joint.law.load) refuse(joint.law.load->place, "load_friction");
  if (!is_exact_zero(joint.coulomb.number)) refuse(joint.coulomb.place, "Coulomb friction");
  if (!is_exact_zero(joint.armature.number)) refuse(joint.armature.place, "the armature");
  if (!is_exact_zero(joint.stiffness.number)) refuse(joint.stiffness.place, "the stiffness");
  if (joint.motor) refuse(joint.motor->place, "the motor");
  if (joint.coupled) refuse(joint.coupled->place, "the coupling");
  const std::optional<Value>& limit = joint.limits.lower ? joint.limits.lower : joint.limits.upper;
  if (limit) refuse(limit->place, "a limit of position");
}

// The entries of q and v of a spherical joint have names of their own, which no other joint may have.
void check_names_of_entries(const Robot& robot, const Joint& spherical, Diagnostics& diagnostics) {
  for (const char* ending : {".qw", ".qx", ".qy", ".qz", ".wx", ".wy", ".wz"}) {
    for (const Joint& other : robot.joints) {
      if (other.name != spherical.name + ending) continue;
      diagnostics.error(
          other.place,
          fmt::format("{}: its name is that of an entry of the spherical {}", named(other), named(spherical)),
          "give one of them another name");
    }
  }
}

// Coupled joints and closed loops have one coordinate for each joint.
void check_spherical_joints(const Robot& robot, Diagnostics& diagnostics) {
  const auto of_type = [](const Joint& joint) { return joint.type == JointType::spherical; };
  const auto spherical = std::find_if(robot.joints.begin(), robot.joints.end(), of_type);
  if (spherical == robot.joints.end()) return;
  for (const Joint& joint : robot.joints) {
    if (of_type(joint)) check_names_of_entries(robot, joint, diagnostics);
  }
  for (const Joint& joint : robot.joints) {
    if (!joint.coupled || joint.type == JointType::fixed || of_type(joint)) continue;
    diagnostics.unsupported(joint.coupled->place,
                            fmt::format("{} {}, and {} is spherical: both in one robot are not supported yet",
                                        named(joint), joint.is_tendon ? "has forces" : "is coupled", named(*spherical)),
                            joint.is_tendon ? "hold the spherical joint still, --fix, or leave out the tendon's forces"
                                            : "hold one of them still: --fix");
    return;
  }
  for (const Loop& loop : robot.loops) {
    diagnostics.unsupported(loop.place,
                            fmt::format("{}, and {} is spherical: both in one robot are not supported yet",
                                        name_of(loop), named(*spherical)),
                            "leave the loop open, or hold the joint still: --fix");
    return;
  }
}

void check_base_joint(BaseJoint& joint, Diagnostics& diagnostics) {
  const char* const against = "friction acts against the motion: write it positive";
  check_not_negative(joint.viscous, "the base: viscous friction (damping)", against, diagnostics);
  check_not_negative(joint.coulomb, "the base: Coulomb friction", against, diagnostics);
  check_not_negative(joint.armature, "the base: armature", "reflected inertia is not negative", diagnostics);
}

void check_speed(const Joint& joint, const std::optional<Value>& speed, const char* key, Diagnostics& diagnostics) {
  if (!speed || has_symbols(speed->number) || (!is_negative(speed->number) && !is_exact_zero(speed->number))) return;
  diagnostics.error(speed->place, fmt::format("{}: {} is not positive", named(joint), key),
                    "it is the speed, rad/s or m/s, around which friction changes; leave it out for none");
}

// Which keys of friction need others.
void check_keys_of_dry_friction(const Joint& joint, Diagnostics& diagnostics) {
  const DryFrictionLaw& law = joint.law;
  const auto refuse = [&](const Value& at, const std::string& what, const char* hint) {
    diagnostics.error(at.place, named(joint) + ": " + what, hint);
  };
  if (law.offset && !law.speed) {
    refuse(*law.offset, "coulomb_offset has no effect without coulomb_speed", "write coulomb_speed = ... as well");
  }
  if (law.static_friction && !law.stribeck_speed) {
    refuse(*law.static_friction, "static friction is given without stribeck_speed",
           "write stribeck_speed = ..., at which it has fallen half of the way to coulomb");
  }
  if (law.stribeck_speed && !law.static_friction) {
    refuse(*law.stribeck_speed, "stribeck_speed has no effect without static", "write static = ..., or leave it out");
  }
  const bool is_uneven = law.offset || law.backward;
  if (law.static_friction && is_uneven) {
    refuse(
        *law.static_friction,
        std::string("static is not supported together with ") + (law.offset ? "coulomb_offset" : "forward, backward"),
        "leave out one of them");
  } else if (law.offset && law.backward) {
    refuse(*law.offset, "coulomb_offset is not supported together with forward, backward", "leave out one of them");
  }
}

// A drive that loses all of its torque would not move.
void check_load_friction(const Joint& joint, Diagnostics& diagnostics) {
  const DryFrictionLaw& law = joint.law;
  if (!law.load) return;
  if (law.offset) {
    diagnostics.error(law.load->place, named(joint) + ": load_friction is not supported together with coulomb_offset",
                      "leave out one of them");
  }
  if (has_symbols(law.load->number)) return;
  const double share = nearest_double(law.load->number);
  if (0 <= share && share < 1) return;
  diagnostics.error(law.load->place, fmt::format("{}: load_friction is {}", named(joint), decimal(law.load->number)),
                    "it is the share of its torque that the drive loses: from 0 to less than 1");
}

// Keys without effect, and a law that nobody means.
void warn_of_dry_friction(const Joint& joint, Diagnostics& diagnostics) {
  const DryFrictionLaw& law = joint.law;
  const Number& coulomb = joint.coulomb.number;
  const bool has_friction = !is_exact_zero(coulomb) || law.backward || law.static_friction || law.load;
  if (law.speed && !has_friction) {
    diagnostics.warning(law.speed->place, named(joint) + ": coulomb_speed has no effect without coulomb",
                        "write coulomb = ... as well, or leave it out");
  }
  if (!law.static_friction || has_symbols(law.static_friction->number) || has_symbols(coulomb)) return;
  const Number& at_rest = law.static_friction->number;
  if (is_negative(at_rest) || !is_negative(at_rest - coulomb)) return;
  diagnostics.warning(law.static_friction->place, named(joint) + ": static friction is less than coulomb",
                      "friction usually falls from static to coulomb as the joint begins to move");
}

void check_dry_friction(Joint& joint, Diagnostics& diagnostics) {
  const char* const against = "friction acts against the motion: write it positive";
  DryFrictionLaw& law = joint.law;
  if (law.static_friction)
    check_not_negative(*law.static_friction, named(joint) + ": static friction", against, diagnostics);
  if (law.backward)
    check_not_negative(*law.backward, named(joint) + ": Coulomb friction backward", against, diagnostics);
  check_speed(joint, law.speed, "coulomb_speed", diagnostics);
  check_speed(joint, law.stribeck_speed, "stribeck_speed", diagnostics);
  check_keys_of_dry_friction(joint, diagnostics);
  check_load_friction(joint, diagnostics);
  warn_of_dry_friction(joint, diagnostics);
}

void check_joint(Joint& joint, bool in_degrees, Diagnostics& diagnostics) {
  if (joint.type == JointType::fixed) return;
  if (joint.type == JointType::spherical) {
    check_spherical(joint, diagnostics);
  } else {
    check_axis(joint, diagnostics);
  }
  check_not_negative(joint.viscous, named(joint) + ": viscous friction (damping)",
                     "friction acts against the motion: write it positive", diagnostics);
  check_not_negative(joint.coulomb, named(joint) + ": Coulomb friction",
                     "friction acts against the motion: write it positive", diagnostics);
  check_dry_friction(joint, diagnostics);
  check_not_negative(joint.armature, named(joint) + ": armature", "reflected inertia is not negative", diagnostics);
  check_not_negative(joint.stiffness, named(joint) + ": stiffness", "a spring pulls back to where it is relaxed",
                     diagnostics);
  check_motor(joint, diagnostics);
  check_limits(joint, in_degrees, diagnostics);
}

// Whether a closed loop goes through the link: joints before it move what the loop takes along.
bool is_in_loop(const Robot& robot, const Link& link) {
  return std::any_of(robot.loops.begin(), robot.loops.end(), [&link](const Loop& loop) {
    return loop.links[0].name == link.name || loop.links[1].name == link.name;
  });
}

// Whether the base link, or one that fixed joints join to it, has a mass.
bool base_has_body(const Robot& robot) {
  std::vector<bool> is_of_base(robot.links.size(), false);
  is_of_base[static_cast<std::size_t>(robot.root)] = true;
  for (const int j : depth_first_joints(robot)) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    const bool is_fixed = joint.type == JointType::fixed && is_of_base[static_cast<std::size_t>(joint.parent)];
    is_of_base[static_cast<std::size_t>(joint.child)] = is_fixed;
  }
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    for (const Inertial& body : robot.links[l].inertials) {
      if (is_of_base[l] && !is_exact_zero(body.mass.number)) return true;
    }
  }
  return false;
}

// Reports joints that move neither mass nor inertia: they make B(q) singular, so there is no forward dynamics.
void check_moved_inertia(const Robot& robot, Diagnostics& diagnostics) {
  std::vector<bool> has_inertia(robot.links.size(), false);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    has_inertia[i] = is_in_loop(robot, robot.links[i]);
    for (const Inertial& inertial : robot.links[i].inertials) {
      if (!is_exact_zero(inertial.mass.number)) has_inertia[i] = true;
      for (const Vec3& row : inertial.tensor) {
        for (const Number& entry : row) has_inertia[i] = has_inertia[i] || !is_exact_zero(entry);
      }
    }
  }
  for (const Joint& joint : robot.joints) {
    if (joint.motor && joint.motor->carrier >= 0) has_inertia[static_cast<std::size_t>(joint.motor->carrier)] = true;
    if (joint.motor && joint.motor->carrier < 0) has_inertia[static_cast<std::size_t>(joint.parent)] = true;
  }
  std::vector<int> order = depth_first_joints(robot);
  for (auto index = order.rbegin(); index != order.rend(); ++index) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(*index)];
    if (has_inertia[static_cast<std::size_t>(joint.child)]) {
      has_inertia[static_cast<std::size_t>(joint.parent)] = true;
    } else if (joint.type != JointType::fixed && !joint.is_tendon && is_exact_zero(joint.armature.number) &&
               !joint.motor) {
      diagnostics.warning(joint.place, named(joint) + " moves no mass: the inertia matrix is singular",
                          "give the links after it their mass and inertia, or make it a fixed joint",
                          "joints that move no mass: the inertia matrix is singular");
    }
  }
  if (!robot.floating_base || base_has_body(robot)) return;
  diagnostics.warning(
      robot.links[static_cast<std::size_t>(robot.root)].place,
      "the floating base has no mass of its own: the inertia matrix is singular unless several limbs have",
      "give the base link its mass and inertia");
}

}  // namespace

void validate_values(Robot& robot, const std::vector<Place>& payloads, Diagnostics& diagnostics) {
  const bool complete = !diagnostics.has_errors();
  for (const Link& link : robot.links) {
    for (const Inertial& inertial : link.inertials) {
      const bool is_payload = std::find(payloads.begin(), payloads.end(), inertial.place) != payloads.end();
      const std::string what = is_payload ? "payload" : named(link);
      check_inertia(what, inertial, diagnostics);
      if (complete) check_inertia_without_mass(what, inertial, diagnostics);
    }
  }
  for (Joint& joint : robot.joints) check_joint(joint, robot.in_degrees, diagnostics);
  if (robot.floating_base) check_base_joint(robot.base_joint, diagnostics);
  check_spherical_joints(robot, diagnostics);
  if (!complete) return;
  if (moving_joints(robot).empty() && !robot.floating_base) {
    diagnostics.error({robot.file, 0}, "no joint of this robot moves",
                      robot.scene.locked.empty() ? "make a joint revolute, continuous, prismatic or spherical; for a "
                                                   "body that moves freely, such as a drone, give --base floating"
                                                 : "leave a joint free that [locked] or --fix holds");
  }
  check_moved_inertia(robot, diagnostics);
}

}  // namespace flatdyn
