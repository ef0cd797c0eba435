// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/joint_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

// The coordinate that a body's joint follows, and its factor.
struct Leader {
  std::size_t coordinate;
  double factor;
};

// Converts an entry of q, counted after the base's six, which stay, to the entry of q̇ from which it is integrated.
// Throws Failure(unsupported) if a closed loop determines it.
Leader rate_of(const Mechanism& mechanism, Leader leader, std::size_t body) {
  const int base = mechanism.base_bodies();
  if (!mechanism.has_loops() || static_cast<int>(leader.coordinate) < base) return leader;
  const auto found =
      std::find(mechanism.independent.begin(), mechanism.independent.end(), static_cast<int>(leader.coordinate) - base);
  if (found != mechanism.independent.end()) {
    return {static_cast<std::size_t>(base + (found - mechanism.independent.begin())), leader.factor};
  }
  throw Failure(FailureKind::unsupported,
                fmt::format("friction of joint \"{}\", which a closed loop moves, is not supported here",
                            mechanism.bodies[body].joint),
                "leave it out (viscous = 0, coulomb = 0), or choose other dependent joints");
}

Leader leader_of(const Mechanism& mechanism, std::size_t body) {
  if (!mechanism.is_coupled()) return {body, 1};
  const std::vector<Number> row = mechanism.rate_coupling()[body];
  std::vector<Leader> leaders;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (!vanishes(row[k])) leaders.push_back({k, nearest_double(row[k])});
  }
  if (leaders.size() == 1) return rate_of(mechanism, leaders.front(), body);
  if (mechanism.bodies[body].is_tendon) {
    throw Failure(FailureKind::unsupported,
                  fmt::format("friction of tendon \"{}\", which acts on several joints, is not supported here",
                              mechanism.bodies[body].joint),
                  "leave it out: viscous = 0 and coulomb = 0, or a scene with friction = false, which leaves out all");
  }
  throw Failure(FailureKind::unsupported,
                fmt::format("friction of joint \"{}\", which follows several coordinates, is not supported here",
                            mechanism.bodies[body].joint),
                "leave it out (viscous = 0, coulomb = 0), or give the joint a coordinate of its own");
}

SmoothFriction smooth_friction(const Body& body, std::size_t coordinate, double factor) {
  const DryFriction& dry = body.dry;
  return {coordinate,
          factor,
          nearest_double(body.coulomb),
          nearest_double(dry.speed),
          nearest_double(dry.offset),
          nearest_double(dry.excess),
          nearest_double(dry.stribeck_speed),
          nearest_double(dry.asymmetry)};
}

[[noreturn]] void refuse_uneven(const Body& body) {
  throw Failure(FailureKind::unsupported,
                fmt::format("friction of joint \"{}\", which changes with the speed or the direction and jumps at "
                            "rest, is not supported here",
                            body.joint),
                "make it smooth: coulomb_speed = ...");
}

[[noreturn]] void refuse_load(const Body& body) {
  throw Failure(FailureKind::unsupported, fmt::format("joint \"{}\": load_friction is not supported here", body.joint),
                "leave it out, and let drive_torque of the generated code add it to torques");
}

}  // namespace

double SmoothFriction::torque(double rate) const {
  const double omega = factor * rate, s = std::tanh((omega + offset) / speed);
  double at_joint = coulomb * (s - std::tanh(offset / speed)) + asymmetry * s * s;
  if (excess != 0) at_joint += excess * s / (1 + omega * omega / (stribeck_speed * stribeck_speed));
  return factor * at_joint;
}

bool JointFriction::is_smooth_at(std::size_t coordinate) const {
  return std::any_of(smooth.begin(), smooth.end(),
                     [coordinate](const SmoothFriction& each) { return each.coordinate == coordinate; });
}

double JointFriction::smooth_torque(std::size_t coordinate, double rate) const {
  double sum = 0;
  for (const SmoothFriction& each : smooth) sum += each.coordinate == coordinate ? each.torque(rate) : 0;
  return sum;
}

JointFriction joint_friction(const Mechanism& mechanism) {
  const auto n = static_cast<std::size_t>(mechanism.size());
  JointFriction friction{std::vector<double>(n, 0), std::vector<double>(n, 0), {}};
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    if (!vanishes(body.dry.load)) refuse_load(body);
    if (vanishes(body.viscous) && !body.has_dry_friction()) continue;
    const auto [k, factor] = leader_of(mechanism, i);
    friction.viscous[k] += factor * factor * nearest_double(body.viscous);
    if (body.dry.is_smooth()) {
      friction.smooth.push_back(smooth_friction(body, k, factor));
    } else if (body.dry.is_linear()) {
      friction.coulomb[k] += std::abs(factor) * nearest_double(body.coulomb);
    } else {
      refuse_uneven(body);
    }
  }
  return friction;
}

}  // namespace flatdyn
