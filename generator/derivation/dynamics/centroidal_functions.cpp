// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/centroidal_functions.hpp"

#include "derivation/dynamics/composite.hpp"
#include "robot/model/floating_base.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kLinear = 3, kTwist = 6;

// The whole robot as one body, in the base frame.
InertialParameters whole_robot(DerivationContext& context) {
  return composites(context.frames)[static_cast<std::size_t>(context.mechanism.base_bodies() - 1)];
}

Vec3 centre_of(DerivationContext& context, const InertialParameters& robot) {
  const Number per_mass = context.derivation.quotient(1, robot.mass, "per_mass");
  return context.derivation.named(per_mass * robot.first_moment, "r_G");
}

// n - r_G × f.
Vec3 about_centre(const Vec3& centre, const Vec3& force, const Vec3& moment) { return moment - cross(centre, force); }

// Column k of the base's rows of B.
Wrench momentum_of(const Rows& B, std::size_t k) { return {{B[0][k], B[1][k], B[2][k]}, {B[3][k], B[4][k], B[5][k]}}; }

void add_column(const Vec3& linear, const Vec3& angular, std::size_t k, Rows& matrix) {
  for (std::size_t i = 0; i < kLinear; ++i) {
    matrix[i][k] = linear[i];
    matrix[i + kLinear][k] = angular[i];
  }
}

}  // namespace

Function derive_centroidal_momentum_matrix(const Mechanism& mechanism, const Choices& choices) {
  return derived(without_base_joint(mechanism), choices, [](DerivationContext& context) {
    Derivation& d = context.derivation;
    const auto n = static_cast<std::size_t>(context.size());
    const Rows B = context.inertia();
    const Vec3 centre = centre_of(context, whole_robot(context));
    Rows A(kTwist, std::vector<Number>(n, 0));
    for (std::size_t k = 0; k < n; ++k) {
      const Wrench momentum = momentum_of(B, k);
      // The momentum of a translation passes through the centre of mass.
      const Vec3 angular = k < kLinear ? zero_vector() : about_centre(centre, momentum.f, momentum.mu);
      add_column(momentum.f, d.named(angular, "h_" + context.frames.label(static_cast<int>(k))), k, A);
    }
    return finished(context,
                    {matrix_output("A_G", static_cast<int>(kTwist), context.size(), context.nodes(A),
                                   "momentum and moment of momentum about the centre of mass by v, base axes")});
  });
}

Function derive_centroidal_bias(const Mechanism& mechanism, const Choices& choices) {
  return derived(without_base_joint(mechanism), choices, [](DerivationContext& context) {
    const Motion motion{context.joint_motion(InputKind::qd), context.joint_drift(), zero_vector(), false};
    const std::vector<Number> n = torques(context.frames, motion);
    const Vec3 force = {n[0], n[1], n[2]};
    const Vec3 moment = about_centre(centre_of(context, whole_robot(context)), force, {n[3], n[4], n[5]});
    return finished(context, {vector_output("b_G", context.nodes({n[0], n[1], n[2], moment[0], moment[1], moment[2]}),
                                            "rates of momentum and of its moment about the centre of mass while a is "
                                            "zero, base axes")});
  });
}

Function derive_centre_of_mass(const Mechanism& mechanism, const Choices& choices) {
  return derived(without_base_joint(mechanism), choices, [](DerivationContext& context) {
    const auto n = static_cast<std::size_t>(context.size());
    const Rows B = context.inertia();
    const InertialParameters robot = whole_robot(context);
    const Vec3 centre = centre_of(context, robot);
    const Number per_mass = context.derivation.quotient(1, robot.mass, "per_mass");
    Rows J(kLinear, std::vector<Number>(n, 0));
    for (std::size_t i = 0; i < kLinear; ++i) {
      for (std::size_t k = 0; k < n; ++k) J[i][k] = k < kLinear ? Number(i == k ? 1 : 0) : per_mass * B[i][k];
    }
    return finished(context, {vector_output("r_G", context.nodes({centre[0], centre[1], centre[2]}),
                                            "centre of mass, from the base frame's origin, base axes, m"),
                              matrix_output("J_G", static_cast<int>(kLinear), context.size(), context.nodes(J),
                                            "velocity of the centre of mass by v, base axes")});
  });
}

}  // namespace flatdyn
