// SPDX-License-Identifier: GPL-2.0-or-later
// Gravity's direction, delays and speeds of friction, found together with all other parameters in noisy logs.
#include "laboratory/identify/nonlinear_search.hpp"

#include <gtest/gtest.h>

#include "laboratory/identify/gravity_search.hpp"
#include "laboratory/identify/identification.hpp"
#include "laboratory/identify/row_sample.hpp"
#include "support/practical_bench.hpp"

namespace flatdyn {
namespace {

using Eigen::Vector3d;
using testing::kEncoderStep;
using testing::SimulatedSample;
using Bench = testing::PracticalBench;

constexpr double kDegree = std::numbers::pi / 180;

std::string gravity_setting(const Vector3d& g) {
  return fmt::format("gravity = [{:.12f}, {:.12f}, {:.12f}]\n", g.x(), g.y(), g.z());
}

// The torques of `late` samples before; late < 0: of samples behind.
void delay(std::vector<SimulatedSample>& samples, int late) {
  const std::vector<SimulatedSample> before = samples;
  const auto last = static_cast<int>(samples.size()) - 1;
  for (int k = 0; k <= last; ++k) {
    samples[static_cast<std::size_t>(k)].tau = before[static_cast<std::size_t>(std::clamp(k - late, 0, last))].tau;
  }
}

class NonlinearSearch : public ::testing::Test {
 protected:
  Bench& bench = testing::ur5();
  Progress quiet{true};
  NonlinearFit fit;
  Estimate found;
  std::vector<JointFit> fits;
  std::vector<std::string> names;

  void search(const std::vector<SimulatedSample>& samples, const NonlinearOptions& options) {
    StreamOptions stream;
    const auto measured = [&](const TorqueEquations& equations, double delay) {
      stream.delay = delay;
      return bench.measured(samples, kEncoderStep, 1, 1, stream, &equations);
    };
    const auto robot_with = [&](const Vector3d& gravity) {
      testing::PracticalArm arm = bench.arm();
      arm.settings = gravity_setting(gravity);
      return arm.plain();
    };
    fit = nonlinear_fit(bench.plain(), ParameterSet::full, options, {measured, robot_with}, quiet);
    EXPECT_TRUE(fit.unknowns.converged);
    const TorqueEquations equations(*fit.model, fit.further);
    const Measurement measurement = measured(equations, fit.unknowns.delay);
    found = estimate_of(equations, measurement, {});
    names = equations.names();
    set_deviations(fit.unknowns, equations, found, measurement);
    fits = fit_quality(measurement.observations, measurement.logs, found.values, equations.acceleration_rows());
  }

  void expect_noise_alone() const {
    for (const JointFit& each : fits) EXPECT_LT(each.ratio, 1.3);
  }

  // The root mean square of the errors of π_b, in standard deviations, where the arm has this gravity.
  double error_with(const Vector3d& gravity) const {
    testing::PracticalArm arm = bench.arm();
    arm.settings = gravity_setting(gravity);
    const std::vector<Number> truth = base_values(arm.truth().mechanism, fit.model->base());
    double squares = 0, count = 0;
    for (int k = 0; k < fit.model->parameters(); ++k) {
      if (!std::isfinite(found.standard_deviations(k))) continue;
      squares += std::pow(
          (found.values(k) - nearest_double(truth[static_cast<std::size_t>(k)])) / found.standard_deviations(k), 2);
      ++count;
    }
    return std::sqrt(squares / count);
  }

  double value_of(const std::string& name) const {
    const auto at = std::find(names.begin(), names.end(), name);
    return found.values(at - names.begin());
  }
};

TEST_F(NonlinearSearch, FindsLongDelaysOfBothSigns) {
  const std::vector<SimulatedSample> sound = bench.motion({.seconds = 12});
  for (const int late : {40, -20}) {
    std::vector<SimulatedSample> samples = sound;
    delay(samples, late);
    search(samples, {.delay = true});
    EXPECT_NEAR(fit.unknowns.delay, late / 1000.0, 3.5 * fit.unknowns.delay_deviation);
    EXPECT_GT(fit.unknowns.delay_deviation, 1e-5);
    EXPECT_LT(fit.unknowns.delay_deviation, 1.2e-4);
    EXPECT_LT(error_with({0, 0, -9.81}), 1.5);
    expect_noise_alone();
  }
}

// Friction is 8 to 18 % of the torque that a drive carries, which friction itself and rotors are no part of.
TEST_F(NonlinearSearch, FindsFrictionThatGrowsWithTheLoad) {
  const auto share = [](int joint) { return 0.08 + 0.02 * joint; };
  const auto& [file, joints, middle, viscous, coulomb, armature, noise, settings] = bench.arm();
  std::vector<int> is_parameter;
  for (int i = 1; i <= 6; ++i) {
    const std::vector<std::string>& all = bench.equations().names();
    is_parameter.push_back(static_cast<int>(std::ranges::count(all, fmt::format("Im{}", i))));
  }
  std::vector<SimulatedSample> samples = bench.motion({});
  for (SimulatedSample& sample : samples) {
    for (int i = 0; i < 6; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double sign = sample.qd(i) < 0 ? -1 : 1;
      const double carried = sample.tau(i) - viscous[at] * sample.qd(i) - coulomb[at] * sign -
                             is_parameter[at] * armature[at] * sample.qdd(i);
      sample.tau(i) += share(i) * std::abs(carried) * sign;
    }
  }
  search(samples, {.law = FrictionLaw::load});
  expect_noise_alone();
  for (const int i : TorqueEquations(*fit.model, fit.further).carried_rotors())
    is_parameter[static_cast<std::size_t>(i)]++;
  EXPECT_EQ(is_parameter, std::vector<int>(6, 1));
  EXPECT_LT(error_with({0, 0, -9.81}), 1.5);
  for (int i = 0; i < 6; ++i) {
    const auto at = std::ranges::find(names, fmt::format("c{}", i + 1)) - names.begin();
    ASSERT_LT(at, found.values.size());
    EXPECT_NEAR(found.values(at), share(i), 3.5 * found.standard_deviations(at)) << i;
    const double told = i < 5 ? 0.03 : 1;  // the last drive carries hardly anything
    EXPECT_LT(found.standard_deviations(at), told) << i;
  }
}

// Each of the unknowns shifts the others, so that one found after the other would be off. The intervals have the
// uncertainty of all in them.
TEST_F(NonlinearSearch, FindsAllUnknownsTogether) {
  constexpr double kSpeed = 0.08, kShare = 0.4;
  const double offsets[] = {1, -2, 0.5, 0.3, -0.2, 0.1};
  const Vector3d gravity(9.81 * std::sin(15 * kDegree), 0, -9.81 * std::cos(15 * kDegree));
  testing::PracticalArm arm = bench.arm();
  arm.settings = gravity_setting(gravity);
  std::vector<SimulatedSample> samples = practical_motion(arm, arm.truth(), {.seconds = 12});
  for (SimulatedSample& sample : samples) {
    for (int i = 0; i < 6; ++i) {
      const double qd = sample.qd(i), part = qd / kSpeed;
      sample.tau(i) += offsets[i] + kShare * arm.coulomb[static_cast<std::size_t>(i)] * std::exp(-part * part) *
                                        ((qd > 0) - (qd < 0));
    }
  }
  delay(samples, 6);
  search(samples, {.gravity = true, .delay = true, .law = FrictionLaw::stribeck, .offsets = true});
  EXPECT_NEAR(fit.unknowns.delay, 0.006, 3.5 * fit.unknowns.delay_deviation);
  const FoundGravity& of = *fit.unknowns.gravity;
  EXPECT_NEAR(of.gravity.norm(), 9.81, 1e-6);
  EXPECT_EQ(of.told.cols(), 3);
  EXPECT_GT(std::sqrt(of.covariance(0, 0)), 1e-3);
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(of.gravity[d], gravity[d], 3.5 * std::sqrt(of.covariance(d, d)) + 1e-9) << d;
  }
  EXPECT_LT(std::sqrt(of.covariance.trace()), 0.03);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(fit.further.speeds[i], kSpeed, 4 * fit.unknowns.speed_deviations[i]) << i;
    EXPECT_LT(fit.unknowns.speed_deviations[i], 0.1 * kSpeed) << i;
    EXPECT_NEAR(value_of(fmt::format("offset{}", i + 1)), offsets[i], 0.2) << i;
  }
  EXPECT_LT(error_with(gravity), 1.5);
  expect_noise_alone();
}

// The gravity that is found in a noisy log of a robot file with another gravity.
GravityFit gravity_found_by(LoadedRobot robot, const Vec3& gravity) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("flatdyn-gravity-{}.csv", ::getpid());
  testing::write_log(path, testing::simulated(robot, {.samples = 2000, .noise = 2}));
  robot.robot.gravity = robot.mechanism.gravity = gravity;
  Progress quiet{true};
  const TorqueModel model(robot, ParameterSet::given, quiet);
  const TorqueEquations equations(model);
  Diagnostics diagnostics;
  const Measurement measurement = measure(equations, robot.mechanism, {path}, {}, quiet, diagnostics);
  std::filesystem::remove(path);
  return gravity_direction(robot, sample_of(equations, measurement));
}

// All axes point along z, and so does a part of gravity, which no torque depends on.
TEST(GravityDirection, KeepsTheComponentAlongAxesThatAllJointsShare) {
  const GravityFit fit = gravity_found_by(testing::model_of("planar_2r_example_7_2.toml"), {0, -9, 3});
  EXPECT_DOUBLE_EQ(fit.gravity.z(), 3);
  EXPECT_NEAR(std::hypot(fit.gravity.x(), fit.gravity.y()), 9, 1e-9);
  EXPECT_EQ(fit.told.cols(), 2);
  const std::vector<Vector3d> untold = untold_directions(fit.told);
  ASSERT_EQ(untold.size(), 1u);
  EXPECT_NEAR((untold.front() - Vector3d::UnitZ()).norm(), 0, 1e-9);
}

// Where gravity comes from and where the centre of mass lies are one unknown of a pendulum.
TEST(GravityDirection, KeepsWhatAPendulumDoesNotTell) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("flatdyn-pendulum-{}.toml", ::getpid());
  std::ofstream(path) << "gravity = [0, \"-9.81\", 0]\ndh = \"standard\"\n[[link]]\na = 1\nmass = 50\n"
                         "com = [-0.4, 0.1, 0]\ninertia = { yy = 10, zz = 10 }\ninertia_about = \"com\"\n";
  const LoadedRobot pendulum = load_robot(path, {});
  std::filesystem::remove(path);
  const GravityFit fit = gravity_found_by(pendulum, {3, -9, 0});
  EXPECT_NEAR((fit.gravity - Vector3d(3, -9, 0)).norm(), 0, 1e-9);
  EXPECT_LE(fit.told.cols(), 1);
}

}  // namespace
}  // namespace flatdyn
