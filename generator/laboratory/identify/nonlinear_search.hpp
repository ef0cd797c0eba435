// SPDX-License-Identifier: GPL-2.0-or-later
// Unknowns in which the torques are not linear: the direction of gravity, the time by which torques are late, the
// speeds of friction laws, and the torques that drives carry, which friction may depend on. Each has a first value by a
// hypothesis on a sample of rows (hypothesis.hpp). Then all are corrected together with all other parameters over all
// rows, by the method of Gauss and Newton: their derivatives are columns of the equations, so that the parameters'
// covariance has their uncertainty in it. The carried torques are made anew from the parameters in each round; their
// uncertainty counts as none beside that of c.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "base/diagnostics/progress.hpp"
#include "laboratory/identify/least_squares.hpp"
#include "laboratory/identify/measurement.hpp"
#include "laboratory/identify/torque_equations.hpp"

namespace flatdyn {

struct NonlinearOptions {
  bool gravity = false, delay = false;
  FrictionLaw law = FrictionLaw::coulomb;  // its speeds are unknown, if it has some
  bool offsets = false;
  bool springs = false;

  std::optional<double> temperature{};    // FurtherParameters::temperature
  std::vector<bool> even_temperatures{};  // FurtherParameters::even_temperatures

  bool any() const { return gravity || delay || !is_linear(law); }
};

// How the search reads the logs, and changes the robot.
struct NonlinearAccess {
  // delay: by which torques are late, s.
  std::function<Measurement(const TorqueEquations& equations, double delay)> measured;
  // g_0 in the base frame, m/s².
  std::function<LoadedRobot(const Eigen::Vector3d& gravity)> robot_with;
};

// Gravity that was found.
struct FoundGravity {
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();         // in the base frame, m/s²
  Eigen::Matrix3Xd told = Eigen::Matrix3Xd::Identity(3, 3);  // GravityFit::told
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();      // (m/s²)²; NaN where it counts as exact
};

struct NonlinearUnknowns {
  std::optional<FoundGravity> gravity{};
  double delay = 0;                                                   // s
  double delay_deviation = std::numeric_limits<double>::quiet_NaN();  // s; NaN where the delay counts as exact
  std::vector<double> speed_deviations{};  // by joint, rad/s or m/s; NaN where a speed counts as exact
  std::vector<bool> friction_told{};       // by joint, FrictionSpeeds::are_told; empty if the law has no speeds
  bool converged = true;                   // whether the corrections became small
};

struct NonlinearFit {
  LoadedRobot robot;                   // with the gravity that was found
  std::unique_ptr<TorqueModel> model;  // of this robot
  FurtherParameters further{};         // with the columns of the corrections, which have become small
  NonlinearUnknowns unknowns{};
};

// Finds the unknowns. `robot` has closed loops only if gravity is not among them. Throws Failure(usage) for a delay of
// logs that have all derivatives, and are used as they are.
NonlinearFit nonlinear_fit(LoadedRobot robot, ParameterSet set, const NonlinearOptions& options,
                           const NonlinearAccess& logs, Progress& progress);

// Sets the standard deviations from the estimate of the equations. That of the delay counts that samples do not tell
// when within their step friction jumps.
void set_deviations(NonlinearUnknowns& unknowns, const TorqueEquations& equations, const Estimate& estimate,
                    const Measurement& measurement);

// Gives infinite standard deviations to the friction parameters that are not determined (`friction_told`).
void leave_friction_open(Estimate& estimate, const NonlinearUnknowns& unknowns, const TorqueEquations& equations);

}  // namespace flatdyn
