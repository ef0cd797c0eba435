// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/dynamics_references.hpp"

#include "flatdyn/reference/load_friction.hpp"
#include "truth/reference/acceleration_magnitude.hpp"
#include "truth/reference/magnitude.hpp"

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

// Those of τ + c |τ| s, or of what it is solved for.
std::vector<double> drive_magnitude(const At& at) {
  const ref::VectorX<double> shares = ref::detail::lost_shares(at.robot, at.qd).cwiseAbs();
  return row_by_row(ref::VectorX<double>(at.tau.cwiseAbs().cwiseProduct((shares.array() + 1).matrix())));
}

std::vector<double> magnitude_from_drive(const At& at) {
  const ref::VectorX<double> shares = ref::detail::lost_shares(at.robot, at.qd).cwiseAbs();
  return row_by_row(ref::VectorX<double>(at.tau.cwiseAbs().array() / (1 - shares.array())));
}

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

constexpr int kTwist = 6;

// The accelerations of the joints, with zeros or the given ones of the base.
template <class S>
ref::VectorX<S> accelerations_with(const ReferencePoint<S>& at, const ref::VectorX<S>& of_base) {
  ref::VectorX<S> a = at.qdd;
  a.template head<kTwist>() = of_base;
  return a;
}

// The acceleration of a floating base on which no force acts, then all torques, whose first six are zero.
template <class S>
std::vector<S> dynamics_of_free_base(const ReferencePoint<S>& at) {
  const ref::VectorX<S> zero = ref::VectorX<S>::Zero(kTwist);
  const ref::VectorX<S> needed = ref::inverse_dynamics(at.robot, at.q, at.qd, accelerations_with(at, zero));
  const ref::MatrixX<S> B = ref::inertia_matrix(at.robot, at.q).topLeftCorner(kTwist, kTwist);
  const ref::VectorX<S> a_b = B.ldlt().solve(ref::VectorX<S>(-needed.template head<kTwist>()));
  ref::VectorX<S> tau = ref::inverse_dynamics(at.robot, at.q, at.qd, accelerations_with(at, a_b));
  tau.template head<kTwist>() = zero;
  std::vector<S> entries = row_by_row(a_b);
  const std::vector<S> torques = row_by_row(tau);
  entries.insert(entries.end(), torques.begin(), torques.end());
  return entries;
}

// The wrench that the base needs goes through the inverse of its part of B, and from there to the joints.
std::vector<double> magnitude_of_free_base(const At& at) {
  const std::vector<double> own = dynamics_of_free_base(at);
  const ref::VectorX<double> zero = ref::VectorX<double>::Zero(kTwist),
                             a_b = Eigen::Map<const Eigen::VectorXd>(own.data(), kTwist);
  const ref::MatrixX<double> inertia = ref::inertia_magnitude(at.robot, at.q);
  const ref::MatrixX<double> inverse =
      ref::inertia_matrix(at.robot, at.q).topLeftCorner(kTwist, kTwist).inverse().cwiseAbs();
  const ref::VectorX<double> needed = ref::torque_magnitude(at.robot, at.q, at.qd, accelerations_with(at, zero));
  const ref::VectorX<double> of_base =
      inverse * (needed.head(kTwist) + inertia.topLeftCorner(kTwist, kTwist) * a_b.cwiseAbs());
  std::vector<double> entries = row_by_row(of_base);
  const std::vector<double> torques = row_by_row(ref::VectorX<double>(needed + inertia.leftCols(kTwist) * of_base));
  entries.insert(entries.end(), torques.begin(), torques.end());
  return entries;
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

constinit const NumericReference drive_torque =
    computed_by([](const auto& at) { return row_by_row(ref::drive_torque(at.robot, at.qd, at.tau)); },
                [](const At& at) { return drive_magnitude(at); });

constinit const NumericReference torque_from_drive =
    computed_by([](const auto& at) { return row_by_row(ref::torque_from_drive(at.robot, at.qd, at.tau)); },
                [](const At& at) { return magnitude_from_drive(at); });

constinit const NumericReference bias =
    computed_by([](const auto& at) { return row_by_row(ref::bias(at.robot, at.q, at.qd)); },
                [](const At& at) { return row_by_row(ref::torque_magnitude(at.robot, at.q, at.qd, no_motion(at))); });

constinit const NumericReference forward_dynamics =
    computed_by([](const auto& at) { return row_by_row(ref::forward_dynamics(at.robot, at.q, at.qd, at.tau)); },
                [](const At& at) { return row_by_row(acceleration_magnitude(at)); });

constinit const NumericReference inverse_dynamics_floating = computed_by(
    [](const auto& at) { return dynamics_of_free_base(at); }, [](const At& at) { return magnitude_of_free_base(at); });

constinit const NumericReference momentum = computed_by(
    [](const auto& at) {
      auto B = ref::inertia_matrix(at.robot, at.q);
      return row_by_row((B * at.qd).eval());
    },
    [](const At& at) {
      return row_by_row(ref::VectorX<double>(ref::inertia_magnitude(at.robot, at.q) * at.qd.cwiseAbs()));
    });

constinit const NumericReference coriolis_transpose_qd = computed_by(
    [](const auto& at) {
      auto C = ref::coriolis_matrix(at.robot, at.q, at.qd);
      return row_by_row((C.transpose() * at.qd).eval());
    },
    [](const At& at) {
      const ref::MatrixX<double> C = ref::coriolis_magnitude(at.robot, at.q, at.qd);
      return row_by_row(ref::VectorX<double>(C.transpose() * at.qd.cwiseAbs()));
    },
    kManyRecursions);

constinit const NumericReference kinetic_energy =
    computed_by([](const auto& at) { return std::vector{ref::kinetic_energy(at.robot, at.q, at.qd)}; },
                [](const At& at) { return kinetic_magnitude(at); });

constinit const NumericReference potential_energy =
    computed_by([](const auto& at) { return std::vector{ref::potential_energy(at.robot, at.q)}; },
                [](const At& at) { return std::vector{ref::potential_magnitude(at.robot, at.q)}; });

}  // namespace references
}  // namespace flatdyn
