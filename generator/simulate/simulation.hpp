// SPDX-License-Identifier: GPL-2.0-or-later
// What is to be simulated, as written: docs/simulation-format.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "model/mechanism.hpp"
#include "model/robot.hpp"
#include "trajectory/trajectory.hpp"

namespace flatdyn {

enum class AtLimits {
  go_on,  // joints move beyond their range
  stop,   // and do not bounce
  end,    // the simulation is over
};

enum class IntegrationMethod {
  adaptive,  // Dormand and Prince's pair of order 5 and 4, steps as long as the tolerance lets them be
  rk4,       // the classical method of order 4 with steps of one length: what firmware can do
};

// Torques over time, by row one number per joint.
struct TorqueSamples {
  enum class Between { hold, linear };
  Between between = Between::linear;
  std::vector<double> times;
  std::vector<std::vector<double>> torques;
};

// K_P (q_d − q) + K_D (q̇_d − q̇): torques, to which g(q) may be added; or, with q̈_d, the accelerations that computed
// torque makes of the model.
struct FeedbackLaw {
  enum class Kind { pd, computed_torque };
  Kind kind = Kind::pd;
  std::vector<double> kp, kd, position;  // by joint
  bool gravity = false;                  // pd: plus g(q)
  std::optional<Trajectory> trajectory;  // instead of a position
};

struct Simulation {
  double duration = 10;                  // s
  double rate = 1000;                    // rows of the result per second
  std::vector<double> q, qd;             // at the start: rad, rad/s (m, m/s)
  std::vector<double> constant;          // torques, N m (N); with one of the next two, added to them
  std::optional<TorqueSamples> samples;  // at most one of these two
  std::optional<FeedbackLaw> feedback;
  double period = 0;      // s between torques of a feedback law; 0: at all times
  bool saturate = false;  // torques end at the joints' effort limits
  AtLimits at_limits = AtLimits::go_on;
  IntegrationMethod method = IntegrationMethod::adaptive;
  double tolerance = 1e-9;         // adaptive: of q and q̇ per step, relative and absolute
  std::vector<std::string> files;  // that it was read from
  double step = 1e-3;              // rk4, s; made shorter, so that rows fall on steps
};

// All at rest at q = 0, or where its loops are assembled, and without torques; then what the file says. What is wrong
// goes into `diagnostics`. Throws Failure(io) if a file cannot be read.
Simulation resting(const Robot& robot, const Mechanism& mechanism);
void read_simulation(const std::string& file, const Robot& robot, const Mechanism& mechanism, Simulation& simulation,
                     Diagnostics& diagnostics);

// Columns time and tau1, tau2, … or tau_JOINT, …, in s and N m (N); times rise.
TorqueSamples read_torques(const std::string& file, const Mechanism& mechanism, Diagnostics& diagnostics);

}  // namespace flatdyn
