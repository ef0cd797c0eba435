// SPDX-License-Identifier: GPL-2.0-or-later
#include "certify/input_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "certify/rounding.hpp"
#include "diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

// The absolute value of a limit. A limit of 0 means that nobody gave one, except for positions.
double size_of(const Body& body, const std::optional<Value>& limit, const char* what) {
  const bool is_position = std::string(what) == "position";
  if (!limit || has_symbols(limit->number) || (vanishes(limit->number) && !is_position)) {
    throw Failure(ExitCode::unsupported, fmt::format("joint \"{}\" has no limit of {}", body.joint, what),
                  "give it in the robot file, or in [limits] of the scene");
  }
  return std::abs(nearest_double(limit->number)) * kRoundingMargin;
}

double limit_of(const Body& body, InputKind kind) {
  switch (kind) {
    case InputKind::q:
      return std::max(size_of(body, body.limits.lower, "position"), size_of(body, body.limits.upper, "position"));
    case InputKind::qd:
    case InputKind::v:
      return size_of(body, body.limits.velocity, "velocity");
    case InputKind::qdd:
    case InputKind::a:
      return size_of(body, body.limits.acceleration, "acceleration");
    case InputKind::tau:
      return size_of(body, body.limits.effort, "effort");
    case InputKind::h_e:
      throw Failure(ExitCode::unsupported, "it reads tip forces, which have no limit");
    case InputKind::parameter:
      throw Failure(ExitCode::unsupported, "the robot has free symbols", "give them numbers");
    default:
      throw Failure(ExitCode::unsupported, "it reads inputs that have no limit");
  }
}

}  // namespace

InputLimits input_limits(const Mechanism& mechanism, const std::string& scalar) {
  const bool is_float = scalar == "float";
  return [&mechanism, is_float](const Input& input) {
    // Free symbols and tip forces do not belong to a joint.
    const bool is_of_joint = input.kind != InputKind::h_e && input.kind != InputKind::parameter;
    const auto joint = static_cast<std::size_t>(is_of_joint && input.index < mechanism.size() ? input.index : 0);
    const double limit = limit_of(mechanism.joints()[joint], input.kind);
    return is_float ? std::max(limit, double(static_cast<float>(limit))) : limit;
  };
}

}  // namespace flatdyn
