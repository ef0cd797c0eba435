// SPDX-License-Identifier: GPL-2.0-or-later
// From a start to a motion, integrated over time, with rows at equal intervals.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "laboratory/simulate/motion_equation.hpp"

namespace flatdyn {

// A floating base in a row: its pose, and momenta in world axes.
struct BaseRow {
  BasePose pose;
  Momentum momentum, impulse;  // impulse: what forces have added since the start
  Eigen::Vector3d gravity;     // in base axes, m/s^2
};

struct SimulationRow {
  double time = 0;                    // s
  Eigen::VectorXd q, qd, qdd, tau;    // q includes dependent joints; tau as commanded
  Eigen::VectorXd friction;           // force on each joint by −F_v q̇, dry friction and its stop, N m (N)
  double kinetic = 0, potential = 0;  // J
  double work = 0, dissipated = 0;    // J since the start: work of tau, and energy dissipated by friction and stops
  std::optional<BaseRow> base{};      // of a floating base
};

struct SimulatedMotion {
  std::vector<SimulationRow> rows;
  std::vector<MotionEvent> events;
  long steps = 0, evaluations = 0;  // evaluations of B and n
  double end = 0;                   // s
  bool at_limit = false;            // AtLimits::end ended it
  bool interrupted = false;
};

// The largest deviation, in J, of a row's energy balance from the first row's: the energy lost or gained by
// integration.
double energy_error(const SimulatedMotion& motion);

// The same of each component of the momenta less what forces have added, kg m/s and kg m²/s, with a floating base.
Momentum momentum_error(const SimulatedMotion& motion);

// Runs a simulation. `interrupted` is called after each step. Throws Failure(input) if the motion exceeds the range of
// doubles.
SimulatedMotion simulate(const Simulation& simulation, JointDynamics& dynamics,
                         const std::function<bool(double time)>& interrupted);

}  // namespace flatdyn
