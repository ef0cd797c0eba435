// SPDX-License-Identifier: GPL-2.0-or-later
// The kinds of inputs that functions have, a row for each: everything that is the same for all functions and languages.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace flatdyn {

// weights and direction: of products with derivatives. h: the length of a step in time; qd_end: rates at its end.
// parameter: a free symbol of the robot; stored: a value that an earlier stage has computed. The others have a row
// below that says what they are.
enum class InputKind : std::uint8_t {
  q,
  qd,
  qdd,
  tau,
  h_e,
  parameter,
  qd_r,
  qdd_r,
  pi_b,
  g_b,
  v,
  a,
  v_r,
  a_r,
  weights,
  direction,
  h,
  qd_end,
  v_end,
  stored
};

// The physical quantity of an argument's entries. Limits, sizes and ranges belong to it.
enum class ArgumentQuantity : std::uint8_t {
  position,      // rad or m
  velocity,      // rad/s or m/s
  acceleration,  // rad/s² or m/s²
  torque,        // N m or N
  wrench,        // N, then N m
  gravity,       // m/s²
  base_parameter,
  weight,     // of an output's entry, without a unit
  direction,  // a rate of change of an argument's entry, in its unit
  duration,   // s
  symbol,
  stored
};

// The number of an argument's entries.
enum class ArgumentLength : std::uint8_t {
  positions,
  velocities,
  wrench,
  vector,
  base_parameters,
  own,  // the function says it: Function::own
  one,
  symbols,
  none
};
inline constexpr int kWrenchLength = 6, kVectorLength = 3;

struct ArgumentRow {
  InputKind kind;
  const char* name;  // in generated code: "qd"
  ArgumentQuantity quantity;
  ArgumentLength length;
  InputKind in_state;               // the kind of a state's numbers that it takes: qd for v
  InputKind with_quasi_velocities;  // the kind that robots with a floating base or spherical joints have instead
  bool is_reference = false;        // of a reference motion, not of the robot's own
  const char* meaning = "";         // for people, with units
  const char* meaning_with_base = nullptr;  // with a floating base, where that is another one
  const char* of_spherical_joints = "";     // added if there are some
};

// In the order of InputKind, which is that of seeds of known answers, too.
inline constexpr auto kArgumentRows = std::to_array<ArgumentRow>({
    {.kind = InputKind::q,
     .name = "q",
     .quantity = ArgumentQuantity::position,
     .length = ArgumentLength::positions,
     .in_state = InputKind::q,
     .with_quasi_velocities = InputKind::q,
     .meaning = "joint positions, rad or m",
     .of_spherical_joints = "; of a spherical joint a unit quaternion w, x, y, z"},
    {.kind = InputKind::qd,
     .name = "qd",
     .quantity = ArgumentQuantity::velocity,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::qd,
     .with_quasi_velocities = InputKind::v,
     .meaning = "joint velocities, rad/s or m/s"},
    {.kind = InputKind::qdd,
     .name = "qdd",
     .quantity = ArgumentQuantity::acceleration,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::qdd,
     .with_quasi_velocities = InputKind::a,
     .meaning = "joint accelerations, rad/s^2 or m/s^2"},
    {.kind = InputKind::tau,
     .name = "tau",
     .quantity = ArgumentQuantity::torque,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::tau,
     .with_quasi_velocities = InputKind::tau,
     .meaning = "joint torques or forces, N m or N",
     .meaning_with_base = "force and moment on the base (base axes, N, N m), then joint torques",
     .of_spherical_joints = "; of a spherical joint the moment in the child's axes"},
    {.kind = InputKind::h_e,
     .name = "h_e",
     .quantity = ArgumentQuantity::wrench,
     .length = ArgumentLength::wrench,
     .in_state = InputKind::h_e,
     .with_quasi_velocities = InputKind::h_e,
     .meaning = "force (N), then moment (N m), that the tip exerts on its environment, base frame"},
    {.kind = InputKind::parameter,
     .name = "parameter",
     .quantity = ArgumentQuantity::symbol,
     .length = ArgumentLength::symbols,
     .in_state = InputKind::parameter,
     .with_quasi_velocities = InputKind::parameter},
    {.kind = InputKind::qd_r,
     .name = "qd_r",
     .quantity = ArgumentQuantity::velocity,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::qd_r,
     .with_quasi_velocities = InputKind::v_r,
     .is_reference = true,
     .meaning = "reference velocities, rad/s or m/s"},
    {.kind = InputKind::qdd_r,
     .name = "qdd_r",
     .quantity = ArgumentQuantity::acceleration,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::qdd_r,
     .with_quasi_velocities = InputKind::a_r,
     .is_reference = true,
     .meaning = "reference accelerations, rad/s^2 or m/s^2"},
    {.kind = InputKind::pi_b,
     .name = "pi_b",
     .quantity = ArgumentQuantity::base_parameter,
     .length = ArgumentLength::base_parameters,
     .in_state = InputKind::pi_b,
     .with_quasi_velocities = InputKind::pi_b,
     .meaning = "base parameters, SI units; which they are is said above"},
    {.kind = InputKind::g_b,
     .name = "g_b",
     .quantity = ArgumentQuantity::gravity,
     .length = ArgumentLength::vector,
     .in_state = InputKind::g_b,
     .with_quasi_velocities = InputKind::g_b,
     .meaning = "gravity in base axes, m/s^2: R^T g_0 with R from base axes to world axes"},
    {.kind = InputKind::v,
     .name = "v",
     .quantity = ArgumentQuantity::velocity,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::qd,
     .with_quasi_velocities = InputKind::v,
     .meaning = "joint velocities, rad/s or m/s",
     .meaning_with_base = "velocity of the base (linear, then angular; base axes), then of the joints",
     .of_spherical_joints = "; of a spherical joint the angular velocity in the child's axes"},
    {.kind = InputKind::a,
     .name = "a",
     .quantity = ArgumentQuantity::acceleration,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::qdd,
     .with_quasi_velocities = InputKind::a,
     .meaning = "derivatives of the entries of v"},
    {.kind = InputKind::v_r,
     .name = "v_r",
     .quantity = ArgumentQuantity::velocity,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::qd_r,
     .with_quasi_velocities = InputKind::v_r,
     .is_reference = true,
     .meaning = "reference velocities, with entries as those of v"},
    {.kind = InputKind::a_r,
     .name = "a_r",
     .quantity = ArgumentQuantity::acceleration,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::qdd_r,
     .with_quasi_velocities = InputKind::a_r,
     .is_reference = true,
     .meaning = "derivatives of the entries of v_r"},
    {.kind = InputKind::weights,
     .name = "weights",
     .quantity = ArgumentQuantity::weight,
     .length = ArgumentLength::own,
     .in_state = InputKind::weights,
     .with_quasi_velocities = InputKind::weights,
     .meaning = "weights"},
    {.kind = InputKind::direction,
     .name = "direction",
     .quantity = ArgumentQuantity::direction,
     .length = ArgumentLength::own,
     .in_state = InputKind::direction,
     .with_quasi_velocities = InputKind::direction,
     .meaning = "a direction"},
    {.kind = InputKind::h,
     .name = "h",
     .quantity = ArgumentQuantity::duration,
     .length = ArgumentLength::one,
     .in_state = InputKind::h,
     .with_quasi_velocities = InputKind::h,
     .meaning = "length of the step, s"},
    {.kind = InputKind::qd_end,
     .name = "qd_end",
     .quantity = ArgumentQuantity::velocity,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::qd_end,
     .with_quasi_velocities = InputKind::v_end,
     .is_reference = true,
     .meaning = "joint velocities at the end of the step, rad/s or m/s, as far as they are known"},
    {.kind = InputKind::v_end,
     .name = "v_end",
     .quantity = ArgumentQuantity::velocity,
     .length = ArgumentLength::velocities,
     .in_state = InputKind::qd_end,
     .with_quasi_velocities = InputKind::v_end,
     .is_reference = true,
     .meaning = "velocities at the end of the step, with entries as those of v, as far as they are known"},
    {.kind = InputKind::stored,
     .name = "stored",
     .quantity = ArgumentQuantity::stored,
     .length = ArgumentLength::none,
     .in_state = InputKind::stored,
     .with_quasi_velocities = InputKind::stored},
});

constexpr const ArgumentRow& argument_row(InputKind kind) { return kArgumentRows[static_cast<std::size_t>(kind)]; }

// The row of an array of this name in generated code; nullptr if there is no such array.
constexpr const ArgumentRow* find_argument(const std::string& name) {
  for (const ArgumentRow& row : kArgumentRows) {
    const bool is_array = row.length != ArgumentLength::symbols && row.length != ArgumentLength::none;
    if (is_array && name == row.name) return &row;
  }
  return nullptr;
}

// The kind of rates and accelerations of a robot: qd and qdd, or v and a if they are not all derivatives of q; the same
// of reference ones.
constexpr InputKind with_base(InputKind kind, bool quasi_velocities) {
  return quasi_velocities ? argument_row(kind).with_quasi_velocities : kind;
}

// Whether the numbers are the robot's own velocities, or accelerations.
constexpr bool is_of_motion(InputKind kind, ArgumentQuantity quantity) {
  return argument_row(kind).quantity == quantity && !argument_row(kind).is_reference;
}
constexpr bool is_velocity(InputKind kind) { return is_of_motion(kind, ArgumentQuantity::velocity); }
constexpr bool is_acceleration(InputKind kind) { return is_of_motion(kind, ArgumentQuantity::acceleration); }

// Whether its length depends on the function.
constexpr bool is_of_function(InputKind kind) {
  const ArgumentLength length = argument_row(kind).length;
  return length == ArgumentLength::base_parameters || length == ArgumentLength::own;
}

// Whether each entry belongs to a joint, or to the base.
constexpr bool is_by_joint(InputKind kind) {
  const ArgumentLength length = argument_row(kind).length;
  return length == ArgumentLength::positions || length == ArgumentLength::velocities;
}

}  // namespace flatdyn
