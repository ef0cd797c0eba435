// SPDX-License-Identifier: GPL-2.0-or-later
// The description of a simulation as written: docs/simulation-format.md.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "laboratory/trajectory/trajectory.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

enum class AtLimits {
  go_on,  // joints move beyond their range
  stop,   // joints stop at the ends of their range without bouncing
  end,    // the simulation ends
};

enum class IntegrationMethod {
  adaptive,  // Dormand and Prince's pair of order 5 and 4, with steps as long as the tolerance allows
  rk4,       // the classical method of order 4 with constant steps, as firmware can use it
};

// Torques over time: each row has one number per joint.
struct TorqueSamples {
  enum class Between { hold, linear };
  Between between = Between::linear;
  std::vector<double> times;
  std::vector<std::vector<double>> torques;
};

// The torques K_P (q_d − q) + K_D (q̇_d − q̇), plus g(q) if wanted; or, with q̈_d added, accelerations that computed
// torque turns into torques by the model.
struct FeedbackLaw {
  enum class Kind { pd, computed_torque };
  Kind kind = Kind::pd;
  std::vector<double> kp, kd, position;  // per joint
  bool gravity = false;                  // pd: adds g(q)
  std::optional<Trajectory> trajectory;  // used instead of `position`
};

// The pose of a floating base in the world.
struct BasePose {
  std::array<double, 3> position = {0, 0, 0};        // of the base frame's origin, m
  std::array<double, 4> orientation = {1, 0, 0, 0};  // unit quaternion w, x, y, z: from base axes to world axes
};

// Lists by joint begin with six entries of a floating base, as those of `qd` and `constant` do; the six of positions
// and gains have no meaning.
struct Simulation {
  double duration = 10;                  // s
  double rate = 1000;                    // rows of the result per second
  std::vector<double> q, qd;             // start: rad, rad/s (m, m/s)
  std::vector<double> constant;          // torques, N m (N); added to those of `samples` or `feedback`
  std::optional<TorqueSamples> samples;  // at most one of these two is set
  std::optional<FeedbackLaw> feedback;
  double period = 0;      // s between updates of a feedback law; 0: continuous
  bool saturate = false;  // torques are limited to the joints' effort limits
  AtLimits at_limits = AtLimits::go_on;
  IntegrationMethod method = IntegrationMethod::adaptive;
  double tolerance = 1e-9;         // adaptive: error of q and q̇ per step, relative and absolute
  std::vector<std::string> files;  // the files that it was read from
  double step = 1e-3;              // rk4, s; shortened so that rows coincide with steps
  BasePose base;                   // start of a floating base
  std::vector<double> w;           // start of spherical joints: w of their unit quaternions, whose x, y, z are in q
};

// A simulation without torques that starts at rest at q = 0, or where the loops are assembled.
Simulation resting(const Robot& robot, const Mechanism& mechanism);
// Adds the settings of the file. Errors go into `diagnostics`. Throws Failure(io) if a file cannot be read.
void read_simulation(const std::string& file, const Robot& robot, const Mechanism& mechanism, Simulation& simulation,
                     Diagnostics& diagnostics);

// Reads columns time and tau1, tau2, … or tau_JOINT, …, in s and N m (N); times must increase.
TorqueSamples read_torques(const std::string& file, const Mechanism& mechanism, Diagnostics& diagnostics);

}  // namespace flatdyn
