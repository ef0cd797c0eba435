// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/path_torques.hpp"

#include "functions/planning/make_functions.hpp"
#include "laboratory/trajectory/tip_torque.hpp"

namespace flatdyn {
namespace {

enum : std::size_t { kInverseDynamics, kInertiaMatrix, kGravityTorques, kTipJacobian };

}  // namespace

PathTorques::PathTorques(const LoadedRobot& model, bool tip_force, Progress& progress)
    : n_(static_cast<std::size_t>(model.mechanism.size())),
      closed_(model),
      tau_(n_),
      B_(n_ * n_),
      g_(n_),
      J_(tip_force ? 6 * n_ : 0) {
  // At rest the bias is gravity and springs.
  std::vector<std::string> names = {"inverse_dynamics", "inertia_matrix",
                                    model.mechanism.has_springs() ? "bias" : "gravity"};
  if (tip_force) names.emplace_back("jacobian");
  for (const Function& function : derive_numeric_functions(model, names, "a trajectory", progress))
    tapes_.emplace_back(function);
  friction_ = joint_friction(model.mechanism);
  refuse_smooth_friction();
}

// Smooth friction depends on the pace, and not in proportion to it.
void PathTorques::refuse_smooth_friction() const {
  if (friction_.smooth.empty()) return;
  throw Failure(FailureKind::unsupported, "smooth friction (coulomb_speed) is not supported here",
                "leave out coulomb_speed: friction that jumps at rest is bounded there");
}

void PathTorques::run(const TrajectoryPoint& point) {
  TapeInputs given;
  given[InputKind::q] = closed_.at(point);
  given[InputKind::qd] = point.qd;
  given[InputKind::qdd] = point.qdd;
  if (!tapes_[kInverseDynamics].run(given, tau_)) closed_.refuse_singular();
  if (!point.h_e.empty()) tapes_[kTipJacobian].run(given, J_);
}

PathCoefficients PathTorques::coefficients(const Trajectory& trajectory) {
  PathCoefficients result{n_, {}, {}, {}, {}, {}};
  for (std::vector<double>* part : {&result.m, &result.a, &result.b, &result.d, &result.a_before}) {
    part->reserve(n_ * trajectory.points.size());
  }
  const std::vector<double> rest(n_, 0);
  for (const TrajectoryPoint& point : trajectory.points) {
    run(point);
    TapeInputs given;
    given[InputKind::q] = closed_.at(point);
    tapes_[kInertiaMatrix].run(given, B_);
    given[InputKind::qd] = rest;
    tapes_[kGravityTorques].run(given, g_);
    for (std::size_t i = 0; i < n_; ++i) {
      const double rate = point.qd[i], coulomb = friction_.coulomb[i] * static_cast<double>((rate > 0) - (rate < 0));
      double m = 0, change = 0;
      for (std::size_t j = 0; j < n_; ++j) {
        m += B_[i * n_ + j] * point.qd[j];
        if (!point.qdd_before.empty()) change += B_[i * n_ + j] * (point.qdd_before[j] - point.qdd[j]);
      }
      result.m.push_back(m);
      result.a.push_back(tau_[i] - g_[i] - friction_.viscous[i] * rate - coulomb);
      result.a_before.push_back(result.a.back() + change);
      result.b.push_back(friction_.viscous[i] * rate);
      result.d.push_back(g_[i] + coulomb + tip_torque(J_, point.h_e, i));
    }
  }
  return result;
}

std::vector<std::vector<double>> PathTorques::torques(const Trajectory& trajectory) {
  std::vector<std::vector<double>> all;
  for (const TrajectoryPoint& point : trajectory.points) {
    run(point);
    std::vector<double>& tau = all.emplace_back(tau_);
    for (std::size_t i = 0; i < n_; ++i) tau[i] += tip_torque(J_, point.h_e, i);
  }
  return all;
}

}  // namespace flatdyn
