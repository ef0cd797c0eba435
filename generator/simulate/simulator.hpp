// SPDX-License-Identifier: GPL-2.0-or-later
// From a start to a motion: integrated over time, with rows at even times.
#pragma once

#include <functional>
#include <vector>

#include "simulate/motion_equation.hpp"

namespace flatdyn {

struct SimulationRow {
  double time = 0;                    // s
  Eigen::VectorXd q, qd, qdd, tau;    // q of dependent joints too; tau as given
  Eigen::VectorXd friction;           // on the joint: −F_v q̇, dry friction, and its stop's push; N m (N)
  double kinetic = 0, potential = 0;  // J
  double work = 0, dissipated = 0;    // J since the start: of tau, and by friction and stops
};

struct SimulatedMotion {
  std::vector<SimulationRow> rows;
  std::vector<MotionEvent> events;
  long steps = 0, evaluations = 0;  // of B and n
  double end = 0;                   // s
  bool at_limit = false;            // AtLimits::end has ended it
  bool interrupted = false;
};

// J: by how much the rows' energies do not add up to the first one's, at most. What integration has lost or made.
double energy_error(const SimulatedMotion& motion);

// `interrupted` is asked after each step. Throws Failure(input) where the motion leaves what doubles can hold.
SimulatedMotion simulate(const Simulation& simulation, JointDynamics& dynamics,
                         const std::function<bool(double time)>& interrupted);

}  // namespace flatdyn
