// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/toml/parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/nearest.hpp"

namespace flatdyn {

namespace {

Mat3 read_tensor(TomlTable& table) {
  const auto entry = [&](const char* key) { return table.number_or_zero(key, Quantity::inertia).number; };
  const Number xx = entry("xx"), yy = entry("yy"), zz = entry("zz");
  const Number xy = entry("xy"), xz = entry("xz"), yz = entry("yz");
  table.reject_unknown_keys();
  return {Vec3{xx, xy, xz}, Vec3{xy, yy, yz}, Vec3{xz, yz, zz}};
}

void read_about(TomlTable& table, bool has_inertia, Inertial& inertial, Diagnostics& diagnostics) {
  const std::optional<std::string> about = table.text("inertia_about");
  if (about == "origin") {
    inertial.about = Inertial::About::frame_origin;
  } else if (about && about != "com") {
    diagnostics.error(table.place_of("inertia_about"),
                      table.what() + ", inertia_about: unknown point \"" + *about + "\"",
                      "write \"com\" or \"origin\"");
  } else if (!about && has_inertia && !table.has("inertia_about")) {
    diagnostics.error(table.place_of("inertia"), table.what() + ": inertia is given without inertia_about",
                      "write inertia_about = \"com\" (centre of mass) or \"origin\" (of the link's frame)");
  }
}

// Reads a motor. Keys that are not given stay as they are in `motor`.
Motor read_motor(TomlTable& table, Motor motor, std::optional<Reference>& carrier) {
  motor.place = table.place();
  motor.mass = table.number("mass", Quantity::mass).value_or(motor.mass);
  motor.inertia_axial = table.number("inertia", Quantity::inertia).value_or(motor.inertia_axial);
  motor.inertia_transverse = table.number("inertia_transverse", Quantity::inertia).value_or(motor.inertia_transverse);
  motor.gear_ratio = table.number("gear_ratio", Quantity::gear_ratio).value_or(motor.gear_ratio);
  motor.axis = table.vector("axis", Quantity::other, motor.axis);
  motor.position = table.vector("position", Quantity::length, motor.position);
  carrier = table.reference("carrier");
  table.reject_unknown_keys();
  return motor;
}

Motor motor_with_defaults(const Place& place) {
  Motor motor;
  for (Value* value : {&motor.mass, &motor.inertia_axial, &motor.inertia_transverse}) *value = {0, place};
  motor.gear_ratio = {1, place};
  return motor;
}

// Refuses keys that have no effect on a joint that does not move. A joint that is only held still may keep it all: so
// one file serves with and without --fix.
void check_fixed(const TomlTable& table, const ReadContext& context, Joint& joint) {
  if (joint.type != JointType::fixed || is_held(joint.name, context)) return;
  if (context.diagnostics.only_unsupported()) return;  // it is fixed only because its type is not supported
  for (const char* key : {"viscous", "coulomb", "coulomb_speed", "coulomb_offset", "static", "stribeck_speed",
                          "armature", "stiffness", "spring_reference", "position", "current_to_torque"}) {
    if (!table.has(key)) continue;
    context.diagnostics.error(table.place_of(key), table.what() + ": " + key + " has no effect on a fixed joint",
                              "leave it out, or give the joint the type it has");
  }
  if (!joint.motor) return;
  context.diagnostics.error(joint.motor->place, table.what() + ": a fixed joint has no motor",
                            "add the motor's mass to the link that carries it");
  joint.motor.reset();
}

// A rotor's inertia and an armature are the same thing: with both, it would count twice.
void settle_armature(const TomlTable& table, ReadContext& context, Joint& joint) {
  if (table.has("armature")) context.rotor_joints.erase(joint.name);
  if (!joint.motor || vanishes(joint.armature.number) || !(table.has("motor") || table.has("armature"))) return;
  const Place& motor = joint.motor->place;
  const std::string armature = relative_place_text(motor, joint.armature.place);
  if (context.rotor_joints.erase(joint.name) > 0) {
    context.diagnostics.note(motor,
                             table.what() + ": its motor replaces the rotor inertia of the URDF (" + armature + ")",
                             "give the motor all that is known of the rotor: nothing of the URDF's is kept",
                             "motors that replace the rotor inertia of the URDF");
    joint.armature = {0, motor};
  } else if (!vanishes(joint.motor->inertia_axial.number)) {
    context.diagnostics.error(motor,
                              table.what() + " has both a motor with an inertia and an armature (" + armature +
                                  "): they are the same thing twice",
                              "delete one of them, or write armature = 0");
  }
}

void read_spring(TomlTable& table, const ReadContext& context, Joint& joint) {
  if (auto stiffness = table.number("stiffness", Quantity::stiffness)) joint.stiffness = *stiffness;
  const Quantity position = joint.type == JointType::prismatic ? Quantity::length : Quantity::angle;
  const auto reference = table.number("spring_reference", position);
  if (!reference) return;
  joint.spring_reference = *reference;
  if (!vanishes(joint.stiffness.number) || table.has("stiffness")) return;
  context.diagnostics.error(reference->place, table.what() + ": spring_reference is given, but no stiffness",
                            "give the spring its stiffness (N m/rad or N/m), or leave the reference out");
}

template <class T>
void replace_if_given(T& old, const T& given) {
  if (given) old = given;
}

}  // namespace

std::string read_choice(TomlTable& table, const std::string& key, const std::vector<std::string>& known,
                        Diagnostics& diagnostics) {
  const std::optional<std::string> text = table.text(key);
  if (!text || std::find(known.begin(), known.end(), *text) != known.end()) return text.value_or("");
  // Where all are as short as units are, the nearest one need not be meant.
  constexpr std::size_t kShort = 3;
  const bool are_short =
      std::all_of(known.begin(), known.end(), [](const std::string& each) { return each.size() <= kShort; });
  diagnostics.error(
      table.place_of(key), key + ": " + quoted(*text) + " is none of " + fmt::format("{}", fmt::join(known, ", ")),
      are_short ? fmt::format("write \"{}\"", fmt::join(known, "\" or \"")) : hint_for_unknown(*text, known, "values"));
  return "";
}

void MotorCarriers::add(const std::string& joint, const Reference& link, const std::string& what) {
  carriers_[joint] = {link, what};
}

void MotorCarriers::find_in(Robot& robot, Diagnostics& diagnostics) const {
  for (Joint& joint : robot.joints) {
    const auto found = carriers_.find(joint.name);
    if (found == carriers_.end() || !joint.motor) continue;
    joint.motor->carrier = find_link(robot, found->second.link, found->second.what, diagnostics).value_or(-1);
  }
}

std::optional<Inertial> read_inertial(TomlTable& table, Diagnostics& diagnostics) {
  Inertial inertial;
  inertial.place = table.place();
  inertial.mass = table.number_or_zero("mass", Quantity::mass);
  inertial.centre_of_mass = table.vector("com", Quantity::length, zero_vector());
  std::optional<TomlTable> tensor = table.table(
      "inertia", "write inertia = { xx = 0.1, yy = 0.2, zz = 0.3 } (kg m^2), and xy, xz, yz if there are any");
  if (tensor) {
    inertial.tensor = read_tensor(*tensor);
    inertial.place = tensor->place();
  }
  read_about(table, tensor.has_value(), inertial, diagnostics);
  const bool given = table.has("mass") || table.has("com") || tensor;
  return given ? std::optional<Inertial>(inertial) : std::nullopt;
}

Limits read_limits(TomlTable& table, JointType type) {
  const Quantity position = type == JointType::prismatic ? Quantity::length : Quantity::angle;
  Limits limits;
  limits.lower = table.limit("lower", position, Bound::lower);
  limits.upper = table.limit("upper", position, Bound::upper);
  limits.velocity = table.limit("velocity", position, Bound::magnitude);
  limits.acceleration = table.limit("acceleration", position, Bound::magnitude);
  limits.effort = table.limit("effort", Quantity::other, Bound::magnitude);
  table.reject_unknown_keys();
  return limits;
}

std::optional<Value> read_gain(TomlTable& table, std::string_view key, Diagnostics& diagnostics) {
  const std::optional<Value> gain = table.number(key, Quantity::other);
  if (!gain || (!has_symbols(gain->number) && !vanishes(gain->number))) return gain;
  diagnostics.error(
      gain->place,
      fmt::format("{}{}: a drive's gain is a number but 0", table.what().empty() ? "" : table.what() + ", ", key),
      "write N m/A (N/A where the joint slides); it is negative where the current counts backwards");
  return std::nullopt;
}

void read_coulomb(TomlTable& table, ReadContext& context, Joint& joint) {
  DryFrictionLaw& law = joint.law;
  if (table.is_table("coulomb")) {
    TomlTable both = *table.table("coulomb");
    for (const char* const key : {"forward", "backward"}) {
      if (both.has(key)) continue;
      context.diagnostics.error(both.place(), both.what() + ": " + key + " is missing",
                                "write coulomb = { forward = 0.5, backward = 0.4 }, or one number for both");
    }
    joint.coulomb = both.number_or_zero("forward", Quantity::coulomb_friction);
    law.backward = both.number_or_zero("backward", Quantity::coulomb_friction);
    both.reject_unknown_keys();
  } else if (auto coulomb = table.number("coulomb", Quantity::coulomb_friction)) {
    joint.coulomb = *coulomb;
    law.backward.reset();
  }
}

void read_friction_law(TomlTable& table, Joint& joint) {
  DryFrictionLaw& law = joint.law;
  replace_if_given(law.speed, table.number("coulomb_speed", Quantity::speed));
  replace_if_given(law.offset, table.number("coulomb_offset", Quantity::speed));
  replace_if_given(law.static_friction, table.number("static", Quantity::coulomb_friction));
  replace_if_given(law.stribeck_speed, table.number("stribeck_speed", Quantity::speed));
  replace_if_given(law.load, table.number("load_friction", Quantity::other));
}

void read_joint_properties(TomlTable& table, ReadContext& context, Joint& joint, MotorCarriers& carriers) {
  std::optional<Reference> carrier;
  if (auto coupled = table.linear_position("position", joint.type)) joint.coupled = *coupled;
  if (auto viscous = table.number("viscous", Quantity::viscous_friction)) joint.viscous = *viscous;
  read_coulomb(table, context, joint);
  const Quantity reflected = joint.type == JointType::prismatic ? Quantity::mass : Quantity::inertia;
  if (auto armature = table.number("armature", reflected)) joint.armature = *armature;
  read_spring(table, context, joint);
  replace_if_given(joint.current_to_torque, read_gain(table, "current_to_torque", context.diagnostics));
  if (std::optional<TomlTable> motor = table.table("motor")) {
    joint.motor = read_motor(*motor, joint.motor.value_or(motor_with_defaults(motor->place())), carrier);
  }
  if (std::optional<TomlTable> table_of_limits = table.table("limits")) {
    const Limits limits = read_limits(*table_of_limits, joint.type);
    replace_if_given(joint.limits.lower, limits.lower);
    replace_if_given(joint.limits.upper, limits.upper);
    replace_if_given(joint.limits.velocity, limits.velocity);
    replace_if_given(joint.limits.acceleration, limits.acceleration);
    replace_if_given(joint.limits.effort, limits.effort);
  }
  read_friction_law(table, joint);
  check_fixed(table, context, joint);
  settle_armature(table, context, joint);
  if (joint.motor && carrier) carriers.add(joint.name, *carrier, table.what() + ", motor, carrier");
}

bool read_motion_of_base(const std::string& text, Robot& robot) {
  if (text != "fixed" && text != "floating") return false;
  robot.floating_base = text == "floating";
  return true;
}

Units read_units(TomlTable& table, Diagnostics& diagnostics) {
  Units units{.has_keys = true};
  units.degrees = read_choice(table, "angles", {"rad", "deg"}, diagnostics) == "deg";
  units.millimetres = read_choice(table, "lengths", {"m", "mm"}, diagnostics) == "mm";
  return units;
}

}  // namespace flatdyn
