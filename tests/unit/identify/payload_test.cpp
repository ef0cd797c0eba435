// SPDX-License-Identifier: GPL-2.0-or-later
// A known payload, found from torques and from a sensor at the wrist.
#include "laboratory/identify/payload.hpp"

#include <gtest/gtest.h>

#include "laboratory/identify/fit_quality.hpp"
#include "laboratory/identify/wrist.hpp"
#include "support/observed.hpp"
#include "support/practical_bench.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn {
namespace {

using Eigen::VectorXd;
using testing::observed;
using testing::simulated;

// 1.5 kg at (0.03, -0.02, 0.1) m: m, m l, Î about the frame's origin.
VectorXd known_payload() {
  VectorXd ten(10);
  ten << 1.5, 0.045, -0.03, 0.15, 0.0206, 0.0009, -0.0045, 0.0214, 0.003, 0.0069;
  return ten;
}

Inertial as_inertial(const VectorXd& ten) {
  const auto exact = [](double value) { return exact_decimal(fmt::format("{}", value)); };
  Inertial body;
  body.mass.number = exact(ten(0));
  for (int k = 0; k < 3; ++k) {
    body.centre_of_mass[static_cast<std::size_t>(k)] = exact(ten(1 + k)) / exact(ten(0));
  }
  int at = 4;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) body.tensor[i][j] = body.tensor[j][i] = exact(ten(at++));
  }
  body.about = Inertial::About::frame_origin;
  return body;
}

LoadedRobot with_payload(LoadedRobot model) {
  model.robot.links[static_cast<std::size_t>(model.robot.tip)].inertials.push_back(as_inertial(known_payload()));
  model.mechanism = make_mechanism(model.robot);
  return model;
}

TEST(Payload, IsTheChangeOfTheLastLink) {
  Progress quiet(true);
  for (const char* robot : {"puma560.toml", "ur5.urdf"}) {
    const LoadedRobot model = testing::model_of(robot);
    const TorqueModel torque(model, ParameterSet::given, quiet);
    const VectorXd without = Eigen::Map<const VectorXd>(torque.file_values().data(), torque.parameters());
    const auto samples = simulated(with_payload(model), {.samples = 800});
    const PayloadEstimate found = estimate_payload(payload_problem(torque, model, observed(torque, samples)));
    EXPECT_LT((found.values - known_payload()).cwiseAbs().maxCoeff(), 1e-9) << robot;
    EXPECT_LT((found.body - known_payload()).cwiseAbs().maxCoeff(), 1e-5) << robot;
  }
}

// The arm's own parameters in the file are wrong; the log without payload gives the right ones.
TEST(Payload, IsFoundAgainstALogWithoutIt) {
  Progress quiet(true);
  const LoadedRobot truth = testing::model_of("puma560.toml");
  LoadedRobot wrong = truth;
  for (Body& body : wrong.mechanism.bodies) body.inertia.mass = body.inertia.mass * 2 + 1;
  const TorqueModel torque(wrong, ParameterSet::given, quiet);
  const VectorXd file = Eigen::Map<const VectorXd>(torque.file_values().data(), torque.parameters());
  const auto samples = simulated(with_payload(truth), {.samples = 800, .noise = 0.01, .seed = 3});
  const auto found_against = [&](int samples_without) {
    const Observations without = observed(torque, simulated(truth, {.samples = samples_without, .noise = 0.01}));
    return estimate_payload(payload_problem(torque, observed(torque, samples), without, file));
  };
  const PayloadEstimate found = found_against(800);
  EXPECT_NEAR(found.values(0), 1.5, 0.01);
  EXPECT_LT((found.values - known_payload()).cwiseAbs().maxCoeff(), 0.02);
  // The uncertainty that a short log without payload leaves is part of the payload's intervals.
  const PayloadEstimate rough = found_against(80);
  EXPECT_GT(rough.standard_deviations(0), 1.5 * found.standard_deviations(0));
  for (Eigen::Index k = 0; k < 10; ++k) {
    for (const PayloadEstimate* each : {&found, &rough}) {
      EXPECT_LT(std::abs(each->values(k) - known_payload()(k)), 5 * each->standard_deviations(k)) << k;
    }
  }
}

std::vector<testing::SimulatedSample> with_noise(std::vector<testing::SimulatedSample> samples, double deviation,
                                                 testing::Uniform& random) {
  for (testing::SimulatedSample& each : samples) {
    for (double& tau : each.tau) tau += deviation * random.normal();
  }
  return samples;
}

// Every row of the log with the payload is repeated three times, which adds no information: a correlation of 3. The
// other log has a fifth of its noise.
TEST(Payload, HasHonestIntervalsWhereLogsHaveDifferentNoise) {
  constexpr int kRuns = 200, kTimes = 3;
  constexpr double kTwoSided95 = 1.959964;
  Progress quiet(true);
  const LoadedRobot model = testing::model_of("ur5.urdf");
  const TorqueModel torque(model, ParameterSet::given, quiet);
  const VectorXd file = Eigen::Map<const VectorXd>(torque.file_values().data(), torque.parameters());
  const auto loaded = simulated(with_payload(model), {.samples = 100}), free = simulated(model, {.samples = 100});
  testing::Uniform random(1);
  int inside = 0;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<testing::SimulatedSample> repeated;
    for (const auto& each : with_noise(loaded, 0.5, random)) repeated.insert(repeated.end(), kTimes, each);
    Observations with = observed(torque, repeated);
    with.set_correlation(kTimes);
    const Observations without = observed(torque, with_noise(free, 0.1, random));
    const PayloadEstimate found = estimate_payload(payload_problem(torque, with, without, file));
    const Eigen::ArrayXd error = (found.values - known_payload()).cwiseAbs();
    inside += static_cast<int>((error <= kTwoSided95 * found.standard_deviations.array()).count());
  }
  const double part = static_cast<double>(inside) / (10.0 * kRuns);
  EXPECT_GE(part, 0.93);
  EXPECT_LE(part, 0.97);
}

// A robot that only stands still tells the mass and its centre, but not the inertia.
TEST(Payload, KeepsItsCentreWhereOnlyPosesWereMeasured) {
  Progress quiet(true);
  const LoadedRobot model = testing::model_of("panda.urdf");
  const TorqueModel torque(model, ParameterSet::given, quiet);
  const VectorXd without = Eigen::Map<const VectorXd>(torque.file_values().data(), torque.parameters());
  const auto samples = simulated(with_payload(model), {.samples = 400, .noise = 0.01, .standing = true});
  const PayloadEstimate found = estimate_payload(payload_problem(torque, model, observed(torque, samples)));
  for (Eigen::Index k = 0; k < 4; ++k) {
    EXPECT_NEAR(found.body(k), known_payload()(k), 0.01) << k;
    EXPECT_TRUE(std::isfinite(found.standard_deviations(k))) << k;
  }
  for (Eigen::Index k = 4; k < 10; ++k) EXPECT_TRUE(std::isinf(found.standard_deviations(k))) << k;
  EXPECT_LT(found.largest_misfit, 1);
}

// The robot has friction and rotors that its file lacks, and moves differently with the payload and without it.
TEST(Payload, IsFoundInSpiteOfFrictionThatTheFileLacks) {
  testing::PracticalBench& bench = testing::ur5();
  const auto loaded = practical_motion(bench.arm(), with_payload(bench.arm().truth()), {.seconds = 15});
  const Measurement with = bench.measured(loaded, testing::kEncoderStep, 1);
  const Measurement without = bench.measured(bench.motion({.seconds = 15, .motion = 2}), testing::kEncoderStep, 1);
  const VectorXd file = bench.equations().file_values();
  for (const PayloadProblem& problem :
       {payload_problem(bench.model(), bench.plain(), with.observations),
        payload_problem(bench.model(), with.observations, without.observations, file)}) {
    const PayloadEstimate found = estimate_payload(problem);
    for (Eigen::Index k = 0; k < 10; ++k) {
      EXPECT_NEAR(found.values(k), known_payload()(k), 4 * found.standard_deviations(k)) << k;
    }
    EXPECT_LT(found.standard_deviations(0), 0.05 * known_payload()(0));
    std::vector<MeasuredLog> logs = with.logs;
    logs.insert(logs.end(), without.logs.begin(), without.logs.end());
    for (const JointFit& fit : fit_quality(problem.observations, logs, found.unknowns, problem.acceleration_rows)) {
      EXPECT_LT(fit.ratio, 1.4);
    }
  }
}

// Torques with little noise: the encoder's steps, by way of the masses that the file knows, are most of what is left.
TEST(Payload, HasHonestIntervalsAgainstTheFileWhereTheEncoderIsCoarse) {
  constexpr double kTwoSided95 = 1.959964, kQuiet = 0.05;
  constexpr unsigned kRuns = 8;
  testing::PracticalBench& bench = testing::ur5();
  const auto loaded = practical_motion(bench.arm(), with_payload(bench.arm().truth()), {.seconds = 8});
  int inside = 0;
  for (unsigned run = 1; run <= kRuns; ++run) {
    const Measurement with = bench.measured(loaded, testing::kEncoderStep, kQuiet, run);
    const PayloadProblem problem = payload_problem(bench.model(), bench.plain(), with.observations);
    const PayloadEstimate found = estimate_payload(problem);
    const Eigen::ArrayXd error = (found.values - known_payload()).cwiseAbs();
    inside += static_cast<int>((error <= kTwoSided95 * found.standard_deviations.array()).count());
    for (const JointFit& fit :
         fit_quality(problem.observations, with.logs, found.unknowns, problem.acceleration_rows)) {
      EXPECT_TRUE(fit.is_sound());
    }
  }
  EXPECT_GE(inside / (10.0 * kRuns), 0.91);
}

// Without friction in the model, the payload is far off, and the verdict says that the model does not fit.
TEST(Payload, IsDoubtedWhereTheModelLacksFriction) {
  testing::PracticalBench& bench = testing::ur5();
  Progress quiet(true);
  const TorqueModel model(bench.plain(), ParameterSet::given, quiet);
  const TorqueEquations equations(model);
  const auto loaded = practical_motion(bench.arm(), with_payload(bench.arm().truth()), {.seconds = 15});
  const Measurement with = bench.measured(loaded, testing::kEncoderStep, 1, 1, {}, &equations);
  const PayloadProblem problem = payload_problem(model, bench.plain(), with.observations);
  const PayloadEstimate found = estimate_payload(problem);
  const std::vector<JointFit> fits =
      fit_quality(problem.observations, with.logs, found.unknowns, problem.acceleration_rows);
  for (const JointFit& fit : fits) {
    EXPECT_FALSE(fit.is_sound());
    EXPECT_GT(fit.ratio, 10);
  }
}

// The last joint of the finger follows the one before it, so that q has fewer entries than there are joints.
TEST(Payload, IsFoundByASensorAtTheWristInSpiteOfItsOffsets) {
  for (const char* file : {"panda.urdf", "finger.toml"}) {
    const LoadedRobot model = testing::model_of(file);
    Robot only_payload = model.robot;
    for (Link& link : only_payload.links) link.inertials.clear();
    only_payload.links[static_cast<std::size_t>(only_payload.tip)].inertials.push_back(as_inertial(known_payload()));
    const reference::Robot<double> body = reference_robot<double>(only_payload, {});
    const auto samples = simulated(model, {.samples = 500});
    std::vector<std::vector<double>> h_e;
    for (const testing::SimulatedSample& each : samples) {
      const auto motion = reference::link_motions<double>(body, each.q, each.qd, each.qdd, true);
      Eigen::Vector3d f(1, -2, 3), mu(0.1, 0.2, -0.3);  // the sensor's offsets
      const auto tip = static_cast<std::size_t>(body.tip);
      reference::detail::add_inertial_wrench(body.links[tip], motion[tip], f, mu);
      h_e.push_back({f.x(), f.y(), f.z(), mu.x(), mu.y(), mu.z()});
    }
    const PayloadEstimate found =
        estimate_payload_at_wrist(testing::observed(WristEquations(model), model.mechanism, samples, h_e));
    EXPECT_LT((found.values - known_payload()).cwiseAbs().maxCoeff(), 1e-10) << file;
    EXPECT_EQ(found.untold.cols(), 0) << file;
  }
}

}  // namespace
}  // namespace flatdyn
