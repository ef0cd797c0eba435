// SPDX-License-Identifier: GPL-2.0-or-later
#include "reference/dynamics_references.hpp"

#include "reference/acceleration_magnitude.hpp"
#include "reference/magnitude.hpp"

namespace flatdyn {

reference::MatrixX<double> absolute_inverse(const ReferencePoint<double>& at) {
  return reference::inertia_matrix(at.robot, at.q).inverse().cwiseAbs();
}

reference::VectorX<double> acceleration_magnitude(const ReferencePoint<double>& at) {
  const auto zero = reference::VectorX<double>::Zero(at.robot.size());
  const reference::VectorX<double> qdd = reference::forward_dynamics(at.robot, at.q, at.qd, at.tau).cwiseAbs();
  const reference::VectorX<double> terms = reference::torque_magnitude(at.robot, at.q, at.qd, zero) +
                                           at.tau.cwiseAbs() + reference::inertia_magnitude(at.robot, at.q) * qdd;
  return absolute_inverse(at) * terms;
}

namespace references {
namespace {

namespace ref = reference;
using At = ReferencePoint<double>;

ref::VectorX<double> no_motion(const At& at) { return ref::VectorX<double>::Zero(at.robot.size()); }

// T = ½ q̇ᵀ B q̇ with magnitudes.
std::vector<double> kinetic_magnitude(const At& at) {
  const ref::VectorX<double> rate = at.qd.cwiseAbs();
  return {0.5 * rate.dot(ref::inertia_magnitude(at.robot, at.q) * rate)};
}

// The same with the force at the tip.
std::vector<double> tip_force_magnitude(const At& at) {
  const ref::MagnitudeOptions tip{.f_e = at.h_e.f_e.norm(), .mu_e = at.h_e.mu_e.norm()};
  return row_by_row(ref::torque_magnitude(at.robot, at.q, at.qd, at.qdd, tip));
}

constexpr bool kManyRecursions = true;

}  // namespace

constinit const NumericReference inverse_dynamics =
    computed_by([](const auto& at) { return row_by_row(ref::inverse_dynamics(at.robot, at.q, at.qd, at.qdd)); },
                [](const At& at) { return row_by_row(ref::torque_magnitude(at.robot, at.q, at.qd, at.qdd)); });

constinit const NumericReference inverse_dynamics_tip_force =
    computed_by([](const auto& at) { return row_by_row(ref::inverse_dynamics(at.robot, at.q, at.qd, at.qdd, at.h_e)); },
                [](const At& at) { return tip_force_magnitude(at); });

constinit const NumericReference inertia_matrix =
    computed_by([](const auto& at) { return row_by_row(ref::inertia_matrix(at.robot, at.q)); },
                [](const At& at) { return row_by_row(ref::inertia_magnitude(at.robot, at.q)); });

constinit const NumericReference christoffel =
    computed_by([](const auto& at) { return row_by_row(ref::christoffel(at.robot, at.q)); },
                [](const At& at) { return row_by_row(ref::christoffel_magnitude(at.robot, at.q)); }, kManyRecursions);

constinit const NumericReference coriolis_matrix = computed_by(
    [](const auto& at) { return row_by_row(ref::coriolis_matrix(at.robot, at.q, at.qd)); },
    [](const At& at) { return row_by_row(ref::coriolis_magnitude(at.robot, at.q, at.qd)); }, kManyRecursions);

constinit const NumericReference gravity = computed_by(
    [](const auto& at) { return row_by_row(ref::gravity(at.robot, at.q)); },
    [](const At& at) {
      return row_by_row(ref::torque_magnitude(at.robot, at.q, no_motion(at), no_motion(at), {.springs = false}));
    });

constinit const NumericReference bias =
    computed_by([](const auto& at) { return row_by_row(ref::bias(at.robot, at.q, at.qd)); },
                [](const At& at) { return row_by_row(ref::torque_magnitude(at.robot, at.q, at.qd, no_motion(at))); });

constinit const NumericReference forward_dynamics =
    computed_by([](const auto& at) { return row_by_row(ref::forward_dynamics(at.robot, at.q, at.qd, at.tau)); },
                [](const At& at) { return row_by_row(acceleration_magnitude(at)); });

constinit const NumericReference kinetic_energy =
    computed_by([](const auto& at) { return std::vector{ref::kinetic_energy(at.robot, at.q, at.qd)}; },
                [](const At& at) { return kinetic_magnitude(at); });

constinit const NumericReference potential_energy =
    computed_by([](const auto& at) { return std::vector{ref::potential_energy(at.robot, at.q)}; },
                [](const At& at) { return std::vector{ref::potential_magnitude(at.robot, at.q)}; });

}  // namespace references
}  // namespace flatdyn
