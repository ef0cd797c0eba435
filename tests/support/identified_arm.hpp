// SPDX-License-Identifier: GPL-2.0-or-later
// A robot of robots/ with its regressor, and the parameters identified from its simulated motion.
#pragma once

#include <gtest/gtest.h>

#include "laboratory/identify/least_squares.hpp"
#include "support/observed.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn::testing {

struct Arm {
  explicit Arm(const std::string& file, ParameterSet set = ParameterSet::given) : Arm(model_of(file), set) {}
  explicit Arm(LoadedRobot model, ParameterSet set = ParameterSet::given)
      : robot(std::move(model)), torque(robot, set, quiet) {}

  Progress quiet{true};
  LoadedRobot robot;
  TorqueModel torque;

  Eigen::VectorXd truth() const {
    return Eigen::Map<const Eigen::VectorXd>(torque.file_values().data(),
                                             static_cast<Eigen::Index>(torque.parameters()));
  }
  Observations observed(const std::vector<SimulatedSample>& samples) const {
    return testing::observed(torque, samples);
  }
};

// Without noise, every base parameter is found to 1e-9 of itself and to `share` of the largest. The torques are those
// of the recursive reference, which is independent of regressors.
inline void expect_recovery(const Arm& arm, const std::string& robot,
                            const SimulationOptions& options = {.samples = 600}, double share = 1e-13) {
  const Eigen::VectorXd truth = arm.truth();
  const Estimate found = estimate(arm.observed(simulated(arm.robot, options)), Eigen::VectorXd::Zero(truth.size()));
  EXPECT_TRUE(found.converged) << robot;
  EXPECT_TRUE(found.damped.empty()) << robot;
  const double size = truth.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < truth.size(); ++k) {
    EXPECT_NEAR(found.values(k), truth(k), 1e-9 * std::abs(truth(k)) + share * size) << robot << ", " << k;
  }
}

inline void expect_recovery(const std::string& robot) { expect_recovery(Arm(robot), robot); }

}  // namespace flatdyn::testing
