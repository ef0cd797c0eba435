// SPDX-License-Identifier: GPL-2.0-or-later
// Logs that have q, q̇ and q̈ are not filtered, and only the residuals tell whether q̈ is noisy: intervals are honest
// either way.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "laboratory/identify/identification.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn {
namespace {

using testing::SimulatedSample;

class AllDerivatives : public ::testing::Test {
 protected:
  Progress quiet{true};
  LoadedRobot robot = testing::model_of("ur5.urdf");
  TorqueModel model{robot, ParameterSet::full, quiet};
  TorqueEquations equations{model};
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("flatdyn-derivatives-{}.csv", ::getpid());

  ~AllDerivatives() override { std::filesystem::remove(path); }

  // The share of 95 % intervals that hold the truth; `noise`: standard deviation of q̈, rad/s².
  double share_inside(double noise) {
    constexpr double kTwoSided95 = 1.959964;
    constexpr unsigned kRuns = 15;
    int inside = 0, told = 0;
    for (unsigned run = 1; run <= kRuns; ++run) {
      std::vector<SimulatedSample> samples = testing::simulated(robot, {.samples = 800, .noise = 0.3, .seed = run});
      testing::Uniform draw(1000 + run);
      for (SimulatedSample& sample : samples) {
        for (double& qdd : sample.qdd) qdd += noise * draw.normal();
      }
      write_log(path, samples);
      Diagnostics found;
      const Measurement measurement = measure(equations, robot.mechanism, {path}, {}, quiet, found);
      EXPECT_FALSE(found.has_errors());
      const Estimate estimate = estimate_of(equations, measurement, {});
      for (int k = 0; k < model.parameters(); ++k) {
        if (!std::isfinite(estimate.standard_deviations(k))) continue;
        ++told;
        const double error = estimate.values(k) - model.file_values()[static_cast<std::size_t>(k)];
        inside += std::abs(error) <= kTwoSided95 * estimate.standard_deviations(k) ? 1 : 0;
      }
    }
    EXPECT_GT(told, static_cast<int>(kRuns) * model.parameters() / 2);
    return static_cast<double>(inside) / told;
  }
};

TEST_F(AllDerivatives, ThatAreExactWidenNoInterval) {
  const double share = share_inside(0);
  EXPECT_GE(share, 0.93);
  EXPECT_LE(share, 0.975);
}

TEST_F(AllDerivatives, ThatAreNoisyHaveHonestIntervals) { EXPECT_GE(share_inside(0.1), 0.93); }

// The wrist's torques follow q̈ exactly, and those of the other joints do not, as if q̈ were noisy: what compensation
// would take off the wrist's parameters is no noise.
TEST_F(AllDerivatives, AreNotBlamedForWhatTheModelLacks) {
  constexpr int kWrist = 3;
  std::vector<SimulatedSample> samples = testing::simulated(robot, {.samples = 800, .noise = 0.01, .seed = 1});
  testing::Uniform draw(7);
  const Eigen::Map<const Eigen::VectorXd> parameters(model.file_values().data(), model.parameters());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Y(6, model.parameters());
  for (SimulatedSample& sample : samples) {
    for (double& qdd : sample.qdd) qdd += draw.normal();
    model.regressor(sample.q.data(), sample.qd.data(), sample.qdd.data(), Y.data());
    sample.tau.tail(6 - kWrist) = (Y * parameters).tail(6 - kWrist);
    for (double& tau : sample.tau.tail(6 - kWrist)) tau += 0.1 * draw.normal();
  }
  write_log(path, samples);
  Diagnostics said;
  const Measurement measurement = measure(equations, robot.mechanism, {path}, {}, quiet, said);
  const Estimate found = estimate_of(equations, measurement, {}),
                 plain = estimate_of(equations, measurement, {.compensates = false});
  EXPECT_GT(found.growth, 1.1);
  EXPECT_FALSE(found.is_compensated);
  for (const JointObservations& joint : measurement.observations.joints) {
    EXPECT_LE(joint.rms_residual(found.values), 1.001 * joint.rms_residual(plain.values));
  }
}

}  // namespace
}  // namespace flatdyn
