// SPDX-License-Identifier: GPL-2.0-or-later
// Steps in time of robots with a floating base or spherical joints: proven, and of their order on a body with a ball
// joint, whose place and orientation are followed.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/system/temporary_folder.hpp"
#include "functions/exact_proof.hpp"
#include "functions/formulation.hpp"
#include "functions/function_table.hpp"
#include "graph/tape.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

Mechanism example(const std::string& file) { return testing::model_of("../docs/examples/" + file).mechanism; }

class TurningSteps : public ::testing::TestWithParam<const char*> {};

TEST_P(TurningSteps, AreProvenAndRefutedWhereTheyAreWrong) {
  const Mechanism mechanism = example(GetParam());
  int steps = 0;
  for (const FunctionRow& row : function_table()) {
    if (!std::string(row.name).starts_with("step")) continue;
    ++steps;
    Function function = derive_function(mechanism, row.name);
    const ExactResult result = prove_exactly(mechanism, function, {.points = 1});
    EXPECT_TRUE(result.equal) << row.name << ": " << result.summary();
    EXPECT_LT(result.failure_log2, -20) << row.name;
    const NodeId h = function.graph.input({InputKind::h, 0});
    for (Output& output : function.outputs) {
      NodeId& entry = output.entries.back();
      entry = function.graph.sum({{1, entry}, {Rational(1, 1000000), h}});
    }
    EXPECT_EQ(prove_exactly(mechanism, function, {.points = 1}).mismatches.size(), function.outputs.size()) << row.name;
  }
  EXPECT_EQ(steps, 6);
}

INSTANTIATE_TEST_SUITE_P(Robots, TurningSteps, ::testing::Values("spherical_pendulum.toml", "floating_body.toml"));

TEST(DerivativesOfTurningSteps, AreProvenAlongTurns) {
  const Mechanism mechanism = example("spherical_pendulum.toml");
  for (const char* name : {"vjp:step:rk4", "jac:step:semi_implicit_euler", "jvp:step:implicit_midpoint"}) {
    const ExactResult result = prove_exactly(mechanism, derive_function(mechanism, name), {.points = 1});
    EXPECT_TRUE(result.equal) << name << ": " << result.summary();
  }
}

// The state of a body with a ball joint in the world.
struct Flight {
  Eigen::Vector3d place{0, 0, 0};
  Eigen::Quaterniond turn{0.5, 0.1, -0.7, 0.5};
  std::vector<double> q{0.8, 0.0, 0.6, 0.0}, v{0.3, -0.2, 0.5, 1.5, -2, 1, 2, 1, -3};
};

const char* const kTumbling = R"(
name = "tumbling"
[base]
motion = "floating"
mass = 2
com = [0.02, 0.01, -0.03]
inertia = { xx = 0.02, yy = 0.03, zz = 0.025 }
inertia_about = "com"
[[link]]
joint = "ball"
type = "spherical"
xyz = [0.2, 0.05, 0.1]
mass = 1
com = [0.1, 0.02, 0.05]
inertia = { xx = 0.004, yy = 0.006, zz = 0.005, xy = 0.001 }
inertia_about = "com"
viscous = 0.05
)";

class Tumbling {
 public:
  explicit Tumbling(const std::string& function)
      : takes_end_(function == "step:implicit_midpoint"), step_(derived(function)) {}

  Flight after(Flight x, double h) {
    std::vector<double> v_end = x.v, next;
    for (int k = 0; k < (takes_end_ ? 6 : 1); ++k) {
      next = results(x, h, v_end);
      v_end.assign(next.begin() + 4, next.begin() + 13);
    }
    x.q.assign(next.begin(), next.begin() + 4);
    x.v = v_end;
    x.place += x.turn * Eigen::Vector3d(next[13], next[14], next[15]);
    const Eigen::Quaterniond turn(next[16], next[17], next[18], next[19]);
    EXPECT_NEAR(turn.norm(), 1, 1e-14);
    x.turn = (x.turn * turn).normalized();
    return x;
  }

  // The motion over a tenth of a second.
  Flight in(int steps) {
    Flight x;
    x.turn.normalize();
    for (int k = 0; k < steps; ++k) x = after(x, 0.1 / steps);
    return x;
  }

 private:
  static Function derived(const std::string& function) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "tumbling.toml";
    std::ofstream(file) << kTumbling;
    return derive_function(load_robot(file, {}).mechanism, function);
  }

  std::vector<double> results(const Flight& x, double h, const std::vector<double>& v_end) {
    const Eigen::Vector3d g = x.turn.conjugate() * Eigen::Vector3d(0, 0, -9.81);
    const std::vector<double> tau = {1, 2, -3, 0.1, -0.2, 0.05, 0.3, -0.1, 0.2}, g_b = {g[0], g[1], g[2]}, length = {h};
    TapeInputs given;
    given[InputKind::q] = x.q;
    given[InputKind::v] = x.v;
    given[InputKind::tau] = tau;
    given[InputKind::g_b] = g_b;
    given[InputKind::h] = length;
    given[InputKind::v_end] = v_end;
    std::vector<double> next(step_.results());
    EXPECT_TRUE(step_.run(given, next));
    return next;
  }

  bool takes_end_;
  Tape step_;
};

double distance_between(const Flight& a, const Flight& b) {
  double largest = (a.place - b.place).cwiseAbs().maxCoeff();
  largest = std::max(largest, a.turn.angularDistance(b.turn));
  for (std::size_t k = 0; k < a.q.size(); ++k) largest = std::max(largest, std::abs(a.q[k] - b.q[k]));
  for (std::size_t k = 0; k < a.v.size(); ++k) largest = std::max(largest, std::abs(a.v[k] - b.v[k]));
  return largest;
}

TEST(TurningStepOrders, AreThoseOfTheMethods) {
  const Flight truth = Tumbling("step:rk4").in(2000);
  const auto gain = [&truth](const char* function) {
    Tumbling motion(function);
    return distance_between(motion.in(40), truth) / distance_between(motion.in(80), truth);
  };
  EXPECT_NEAR(gain("step:semi_implicit_euler"), 2, 0.2);
  EXPECT_NEAR(gain("step:implicit_midpoint"), 4, 0.2);
  EXPECT_NEAR(gain("step:rk4"), 16, 1.5);
}

// A step back ends at the start.
TEST(TurningMidpoint, IsSymmetric) {
  Tumbling motion("step:implicit_midpoint");
  Flight start;
  start.turn.normalize();
  EXPECT_LT(distance_between(motion.after(motion.after(start, 0.02), -0.02), start), 1e-7);
}

}  // namespace
}  // namespace flatdyn
