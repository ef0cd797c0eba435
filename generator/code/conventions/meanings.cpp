// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/conventions/meanings.hpp"

#include <fmt/format.h>

#include "code/emit/writer.hpp"

namespace flatdyn {
namespace {

const char* axes(bool in_world) { return in_world ? "world axes" : "base axes"; }

// "base: force (world axes, N), moment (base axes, N m); joints: N m or N".
std::string meaning_of_base(const Convention& convention, const char* linear, const char* linear_unit,
                            const char* angular, const char* angular_unit, const std::string& joints) {
  const std::string first = fmt::format("{} ({}, {})", linear, axes(convention.linear_in_world), linear_unit);
  const std::string second = fmt::format("{} ({}, {})", angular, axes(convention.angular_in_world), angular_unit);
  return fmt::format("base: {}, {}; joints: {}", convention.angular_first ? second : first,
                     convention.angular_first ? first : second, joints);
}

const char* quaternion_order(const Convention& convention) {
  return convention.scalar_first ? "w, x, y, z" : "x, y, z, w";
}

const char* momenta(const Convention& convention) {
  return convention.angular_first ? "moment of momentum about r_G, momentum" : "momentum, its moment about r_G";
}

}  // namespace

std::string meaning_of_pose(const Convention& convention, JointCounts counts) {
  const std::string order = quaternion_order(convention);
  std::string joints = "rad or m";
  if (counts.spherical) joints += fmt::format(", spherical ones a unit quaternion ({})", order);
  if (!counts.has_base()) return "joint positions: " + joints;
  return fmt::format("base: position (world axes, m), quaternion ({}); joints: {}", order, joints);
}

std::string meaning_of_velocity(const Convention& convention, JointCounts counts) {
  if (!counts.has_base()) return input_argument(InputKind::v, counts).meaning;
  return meaning_of_base(
      convention, "linear", "m/s", "angular", "rad/s",
      std::string("rad/s or m/s") + (counts.spherical ? ", spherical ones angular velocity in the child's axes" : ""));
}

std::string meaning_of_force(const Convention& convention, JointCounts counts) {
  if (!counts.has_base()) return input_argument(InputKind::tau, counts).meaning;
  return meaning_of_base(
      convention, "force", "N", "moment", "N m",
      std::string("N m or N") + (counts.spherical ? ", spherical ones moment in the child's axes" : ""));
}

std::string meaning_of_input(InputKind kind, const Convention& convention, JointCounts counts,
                             const Function& function) {
  if (kind == InputKind::q) return meaning_of_pose(convention, counts);
  const std::string own = input_argument(kind, counts, function).meaning;
  if (!counts.has_base()) return own;
  switch (kind) {
    case InputKind::v:
      return meaning_of_velocity(convention, counts);
    case InputKind::a:
      return "derivatives of the entries of v";
    case InputKind::tau:
      return meaning_of_force(convention, counts);
    default:
      return with_replaced(convention.angular_first
                               ? with_replaced(own, "force (N), then moment (N m)", "moment (N m), then force (N)")
                               : own,
                           "base frame", "world axes");
  }
}

std::string meaning_of_output(const Output& output, const Convention& convention, JointCounts counts) {
  const std::string order = convention.angular_first ? "angular, then linear" : "linear, then angular";
  switch (output.quantity) {
    case OutputQuantity::joint_torque:
      return meaning_of_force(convention, counts);
    case OutputQuantity::contact_force:
    case OutputQuantity::contact_impulse:
    case OutputQuantity::contact_jacobian:
    case OutputQuantity::contact_acceleration:
      return with_replaced(output.meaning, "base axes", "world axes");
    case OutputQuantity::number:
      if (output.layout != Layout::matrix) return output.meaning;
      if (output.rows == 3) return "rotation matrix of the frame, from its axes to world axes";
      return with_replaced(with_replaced(output.meaning, "in the base frame", "from their axes to world axes"),
                           "base frame", "world");
    case OutputQuantity::position:
      if (output.name == "p_c") return "position of each contact in the world, m";
      if (output.name == "p" && output.rows != 3) return with_replaced(output.meaning, "base frame", "world");
      return output.name == "r_G" ? "centre of mass in the world, m" : "position of the frame's origin in the world, m";
    case OutputQuantity::tip_jacobian:
      return output.rows == 3 ? "velocity of the centre of mass by v, world axes"
                              : "geometric Jacobian in world axes, by v: " + order;
    case OutputQuantity::tip_acceleration:
      return "acceleration while a is zero, world axes: " + order;
    case OutputQuantity::momentum_per_rate:
      return fmt::format("{}, by v, world axes", momenta(convention));
    case OutputQuantity::force_and_moment:
      return fmt::format("rates of these while a is zero, world axes: {}", momenta(convention));
    default:
      return output.meaning;
  }
}

}  // namespace flatdyn
