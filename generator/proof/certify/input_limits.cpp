// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/input_limits.hpp"

#include <algorithm>
#include <cmath>

#include "base/diagnostics/diagnostics.hpp"
#include "proof/certify/rounding.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {
namespace {

// The largest component of gravity in the axes of a floating base: its length.
double size_of_gravity(const Vec3& g) {
  if (std::any_of(g.begin(), g.end(), has_symbols)) {
    throw Failure(FailureKind::unsupported, "gravity has free symbols", "give them numbers");
  }
  return std::hypot(nearest_double(g[0]), nearest_double(g[1]), nearest_double(g[2]));
}

double limit_of(const Mechanism& mechanism, const Input& input) {
  const ArgumentRow& row = argument_row(input.kind);
  if (row.is_reference) throw Failure(FailureKind::unsupported, "it reads inputs that have no limit");
  switch (row.quantity) {
    case ArgumentQuantity::position:
      if (mechanism.is_of_quaternion(input.index)) return 1;
      return required_reach(mechanism.joint_at(input.index));
    case ArgumentQuantity::velocity:
      return required_limit(mechanism, input.index, &Limits::velocity);
    case ArgumentQuantity::acceleration:
      return required_limit(mechanism, input.index, &Limits::acceleration);
    case ArgumentQuantity::torque:
      return required_limit(mechanism, input.index, &Limits::effort);
    case ArgumentQuantity::gravity:
      return size_of_gravity(mechanism.gravity);
    case ArgumentQuantity::weight:
    case ArgumentQuantity::direction:
      return 1;
    case ArgumentQuantity::wrench:
      throw Failure(FailureKind::unsupported, "it reads tip forces, which have no limit");
    case ArgumentQuantity::symbol:
      throw Failure(FailureKind::unsupported, "the robot has free symbols", "give them numbers");
    default:
      throw Failure(FailureKind::unsupported, "it reads inputs that have no limit");
  }
}

}  // namespace

InputLimits input_limits(const Mechanism& mechanism, const std::string& scalar) {
  const bool is_float = scalar == "float";
  return [&mechanism, is_float](const Input& input) {
    const double limit = limit_of(mechanism, input) * kRoundingMargin;
    return is_float ? std::max(limit, double(static_cast<float>(limit))) : limit;
  };
}

}  // namespace flatdyn
