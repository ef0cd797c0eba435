// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/toml_parts.hpp"

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

// What is not given stays as it is in `motor`.
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

Limits read_limits(TomlTable& table, JointType type) {
  const Quantity position = type == JointType::prismatic ? Quantity::length : Quantity::angle;
  Limits limits;
  limits.lower = table.limit("lower", position);
  limits.upper = table.limit("upper", position);
  limits.velocity = table.limit("velocity", Quantity::other);
  limits.acceleration = table.limit("acceleration", Quantity::other);
  limits.effort = table.limit("effort", Quantity::other);
  table.reject_unknown_keys();
  return limits;
}

Motor motor_with_defaults(const Place& place) {
  Motor motor;
  for (Value* value : {&motor.mass, &motor.inertia_axial, &motor.inertia_transverse}) *value = {0, place};
  motor.gear_ratio = {1, place};
  return motor;
}

template <class T>
void replace_if_given(T& old, const T& given) {
  if (given) old = given;
}

}  // namespace

std::optional<Inertial> read_inertial(TomlTable& table, Diagnostics& diagnostics) {
  Inertial inertial;
  inertial.place = table.place();
  inertial.mass = table.number_or_zero("mass", Quantity::mass);
  inertial.centre_of_mass = table.vector("com", Quantity::length, zero_vector());
  std::optional<TomlTable> tensor = table.table("inertia");
  if (tensor) {
    inertial.tensor = read_tensor(*tensor);
    inertial.place = tensor->place();
  }
  read_about(table, tensor.has_value(), inertial, diagnostics);
  const bool given = table.has("mass") || table.has("com") || tensor;
  return given ? std::optional<Inertial>(inertial) : std::nullopt;
}

std::optional<Reference> read_joint_properties(TomlTable& table, Joint& joint) {
  std::optional<Reference> carrier;
  if (auto viscous = table.number("viscous", Quantity::viscous_friction)) joint.viscous = *viscous;
  if (auto coulomb = table.number("coulomb", Quantity::coulomb_friction)) joint.coulomb = *coulomb;
  const Quantity reflected = joint.type == JointType::prismatic ? Quantity::mass : Quantity::inertia;
  if (auto armature = table.number("armature", reflected)) joint.armature = *armature;
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
  return carrier;
}

}  // namespace flatdyn
