// SPDX-License-Identifier: GPL-2.0-or-later
// Logs of poses: one line for each, far apart in time, all rates zero.
#include <gtest/gtest.h>
#include <unistd.h>

#include "laboratory/identify/fit_quality.hpp"
#include "laboratory/identify/identification.hpp"
#include "laboratory/identify/payload.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn {
namespace {

using Eigen::VectorXd;
using testing::SimulatedSample;

constexpr double kNoise = 0.01;  // N m

class Poses : public ::testing::Test {
 protected:
  Progress quiet{true};
  LoadedRobot robot = testing::model_of("ur5.urdf");
  TorqueModel model{robot, ParameterSet::given, quiet};
  TorqueEquations equations{model};
  std::filesystem::path path = std::filesystem::temp_directory_path() / fmt::format("flatdyn-poses-{}.csv", ::getpid());

  ~Poses() override { std::filesystem::remove(path); }

  // Random poses, `time` seconds apart.
  std::vector<SimulatedSample> poses_of(const LoadedRobot& real, int count, double time, unsigned seed) const {
    const reference::Robot<double> reference = reference_robot<double>(real.robot, {});
    testing::Uniform draw(seed);
    const VectorXd rest = VectorXd::Zero(6);
    std::vector<SimulatedSample> samples;
    for (int k = 0; k < count; ++k) {
      SimulatedSample sample{time * k, rest, rest, rest, {}};
      for (double& q : sample.q) q = 1.5 * draw();
      sample.tau = reference::inverse_dynamics<double>(reference, sample.q, rest, rest);
      for (double& tau : sample.tau) tau += kNoise * draw.normal();
      samples.push_back(std::move(sample));
    }
    return samples;
  }
  Measurement measured(const std::vector<SimulatedSample>& samples) {
    write_log(path, samples);
    Diagnostics found;
    Measurement measurement = measure(equations, robot.mechanism, {path}, {}, quiet, found);
    EXPECT_TRUE(found.all().empty()) << "neither errors nor warnings";
    return measurement;
  }
};

TEST_F(Poses, TellAllThatGravityActsOn) {
  constexpr double kTwoSided95 = 1.959964;
  constexpr int kRuns = 60, kTold = 10;
  int inside = 0;
  for (int run = 1; run <= kRuns; ++run) {
    const Measurement measurement = measured(poses_of(robot, 40, run % 2 == 0 ? 10 : 0.01, static_cast<unsigned>(run)));
    const Estimate found = estimate_of(equations, measurement, {});
    EXPECT_TRUE(found.hidden.empty());
    int told = 0;
    for (int k = 0; k < model.parameters(); ++k) {
      const double deviation = found.standard_deviations(k);
      if (!std::isfinite(deviation)) continue;
      ++told;
      const double error = std::abs(found.values(k) - model.file_values()[static_cast<std::size_t>(k)]);
      inside += error <= kTwoSided95 * deviation ? 1 : 0;
    }
    EXPECT_EQ(told, kTold);
    for (const JointObservations& joint : measurement.observations.joints) {
      EXPECT_LT(joint.rms_residual(found.values), 1.5 * kNoise);
    }
  }
  const double share = static_cast<double>(inside) / (kTold * kRuns);
  EXPECT_GE(share, 0.91);
  EXPECT_LE(share, 0.98);
}

TEST_F(Poses, HaveNoNoiseButTheirResiduals) {
  const Measurement measurement = measured(poses_of(robot, 40, 10, 1));
  const Estimate found = estimate_of(equations, measurement, {});
  for (const JointFit& fit :
       fit_quality(measurement.observations, measurement.logs, found.values, equations.acceleration_rows())) {
    EXPECT_TRUE(fit.is_sound());
    EXPECT_LT(fit.expected, 1.5 * kNoise);
  }
}

TEST_F(Poses, TellAPayloadsMass) {
  LoadedRobot loaded = robot;
  Inertial body;
  body.mass.number = exact_decimal("1.3");
  loaded.robot.links[static_cast<std::size_t>(loaded.robot.tip)].inertials.push_back(body);
  const Measurement with = measured(poses_of(loaded, 20, 10, 1)), without = measured(poses_of(robot, 20, 10, 2));
  const PayloadEstimate found =
      estimate_payload(payload_problem(model, with.observations, without.observations, equations.file_values()));
  EXPECT_NEAR(found.values(0), 1.3, 4 * found.standard_deviations(0));
  EXPECT_LT(found.standard_deviations(0), 0.05);
}

}  // namespace
}  // namespace flatdyn
