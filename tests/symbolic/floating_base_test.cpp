// SPDX-License-Identifier: GPL-2.0-or-later
// Robots with a floating base: every function against its definition in exact arithmetic and against the reference, and
// both against the laws of motion that say nothing of coordinates.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flatdyn/reference/kinematics.hpp"
#include "functions/deviation/expected.hpp"
#include "functions/exact_proof.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/planning/make_functions.hpp"
#include "robot/model/floating_base.hpp"
#include "robot/model/states.hpp"
#include "support/agreement.hpp"
#include "support/floating_robots.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

LoadedRobot floating(const std::string& file) {
  LoadOptions options;
  options.read.floating_base = true;
  return load_robot(std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots" / file, options);
}

struct Subject {
  const char* name;
  LoadedRobot (*model)();
};

class FloatingBase : public ::testing::TestWithParam<Subject> {
 protected:
  LoadedRobot model_ = GetParam().model();
  const Mechanism& mechanism_ = model_.mechanism;

  // Derivatives and steps of large robots take long; the small ones have joints of all kinds.
  bool takes_long(const FunctionRow& row) const {
    return is_large() && (std::string(row.name).ends_with("_derivatives") || row.traits.leaves_rest);
  }
  bool is_large() const {
    constexpr int kSmall = 10;
    return mechanism_.size() > kSmall;
  }
};

// Whether the function has a value for the robot: a task that takes all joints leaves no torque beside it.
bool has(const Mechanism& mechanism, const FunctionRow& row) {
  constexpr int kRowsOfTask = 6;
  const bool is_beside_task = std::string(row.name) == "null_space_torque";
  return row.applies_to(mechanism) && !(is_beside_task && mechanism.size() <= kRowsOfTask);
}

// In each of the ways in which it can be derived.
TEST_P(FloatingBase, FunctionsAreProven) {
  for (const FunctionRow& row : function_table()) {
    if (!has(mechanism_, row) || row.traits.needs_loops || (is_large() && row.traits.leaves_rest)) continue;
    const Choices choices = uniform_choices(mechanism_, Grouping::i_yy);
    for (FormulationIndex way = 0; way <= row.derivation.alternatives.size(); ++way) {
      const std::optional<Function> function = formulation(mechanism_, row.name, way, choices);
      if (!function) continue;
      const ExactResult result = prove_exactly(mechanism_, *function);
      EXPECT_TRUE(result.equal) << row.name << ", way " << way << ": " << result.summary();
    }
  }
}

TEST_P(FloatingBase, FunctionsAgreeWithTheReference) {
  PipelineOptions options;
  for (const FunctionRow& row : function_table()) {
    if (has(mechanism_, row) && !takes_long(row)) options.functions.emplace_back(row.name);
  }
  Progress silent(true);
  Diagnostics none;
  const ExpectedValues expected(model_.robot, mechanism_, 1);
  for (const OptimisedFunction& made : make_functions(model_, options, silent, none)) {
    const Function& function = made.function;
    std::vector<State> states = random_states(mechanism_, 3, 7);
    draw_own_arguments(states, {&function, 1}, 5);
    testing::expect_the_reference(expected, mechanism_, function, states);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Robots, FloatingBase,
    ::testing::Values(Subject{"drone", [] { return testing::model_of_toml(testing::kDrone); }},
                      Subject{"satellite", [] { return testing::model_of_toml(testing::kSatellite); }},
                      Subject{"heavy_satellite", [] { return testing::model_of_toml(testing::heavy_satellite()); }},
                      Subject{"lander", [] { return testing::model_of_toml(testing::kLander); }},
                      Subject{"puma", [] { return floating("puma560.toml"); }},
                      Subject{"quadruped", [] { return floating("quadruped12.urdf"); }}),
    [](const auto& each) { return std::string(each.param.name); });

using Vector = reference::VectorX<Real50>;
using Matrix = reference::MatrixX<Real50>;
using Vector3 = reference::Vector3<Real50>;

// The laws of motion in the reference, which the functions agree with.
class FreeMotion : public ::testing::Test {
 protected:
  FreeMotion() : robot_(reference_robot<Real50>(model_.robot, {})) {
    const State state = random_states(model_.mechanism, 1, 3).front();
    const StateOf<Real50> wide = widened<Real50>(state);
    q_ = vector_of(wide.q), v_ = vector_of(wide.qd), a_ = vector_of(wide.qdd);
    robot_.gravity = vector_of(wide.g_b);
  }

  // The momentum about the base frame's origin, in base axes: the first rows of B ν.
  Vector momentum(const Vector& q, const Vector& v) const { return (reference::inertia_matrix(robot_, q) * v).head(6); }

  LoadedRobot model_ = testing::model_of_toml(testing::kSatellite);
  reference::Robot<Real50> robot_;
  Vector q_, v_, a_;
};

const Real50 kTimeStep("1e-12");

double relative(const Real50& difference, const Real50& size) {
  return Real50(abs(difference / size)).convert_to<double>();
}

// Derivatives along the motion, by central differences.
TEST_F(FreeMotion, HasASkewSymmetricMatrix) {
  const auto n = q_.size();
  const Matrix later = reference::inertia_matrix(robot_, Vector(q_ + kTimeStep * v_.tail(n))),
               earlier = reference::inertia_matrix(robot_, Vector(q_ - kTimeStep * v_.tail(n)));
  const Matrix N = (later - earlier) / (2 * kTimeStep) - 2 * reference::coriolis_matrix(robot_, q_, v_);
  EXPECT_LT(relative((N + N.transpose()).norm(), N.norm()), 1e-18);
}

// C ν is the bias without gravity and friction.
TEST_F(FreeMotion, HasTheTorquesOfItsCoriolisMatrix) {
  const Vector none = Vector::Zero(v_.size());
  const Vector torques = reference::inverse_dynamics(robot_, q_, v_, none, {.gravity = false, .friction = false});
  const Vector product = reference::coriolis_matrix(robot_, q_, v_) * v_;
  EXPECT_LT(relative((product - torques).norm(), torques.norm()), 1e-40);
}

// Newton's and Euler's laws for the robot as a whole, in axes that turn: f = ṗ + ω × p, n = l̇ + ω × l + v × p, with
// the weight at its centre of mass.
TEST_F(FreeMotion, ObeysTheLawOfMomentum) {
  const auto n = q_.size();
  const auto at = [&](const Real50& t) {
    return momentum(Vector(q_ + t * v_.tail(n) + t * t / 2 * a_.tail(n)), Vector(v_ + t * a_));
  };
  const Vector rate = (at(kTimeStep) - at(-kTimeStep)) / (2 * kTimeStep), here = momentum(q_, v_);
  const Vector3 p = here.head(3), l = here.tail(3), v = v_.head(3), omega = v_.segment(3, 3);
  const Vector tau = reference::inverse_dynamics(robot_, q_, v_, a_, {.gravity = false, .friction = false});
  const Vector3 force = rate.head(3) + omega.cross(p), moment = rate.tail(3) + omega.cross(l) + v.cross(p);
  EXPECT_LT(relative((tau.head(3) - force).norm(), force.norm()), 1e-18);
  EXPECT_LT(relative((tau.segment(3, 3) - moment).norm(), moment.norm()), 1e-18);
}

// In free fall all parts fall alike: no joint needs a torque.
TEST_F(FreeMotion, NeedsNoTorqueInFreeFall) {
  Vector falling = Vector::Zero(v_.size());
  falling.head(3) = robot_.gravity;
  const Vector tau = reference::inverse_dynamics(robot_, q_, Vector(Vector::Zero(v_.size())), falling);
  EXPECT_LT(tau.norm().convert_to<double>(), 1e-40);
}

// The power of all forces is the rate of the kinetic energy.
TEST_F(FreeMotion, KeepsAccountOfItsEnergy) {
  const auto n = q_.size();
  const auto energy = [&](const Real50& t) {
    return reference::kinetic_energy(robot_, Vector(q_ + t * v_.tail(n) + t * t / 2 * a_.tail(n)), Vector(v_ + t * a_));
  };
  const Real50 rate = (energy(kTimeStep) - energy(-kTimeStep)) / (2 * kTimeStep);
  const Vector tau = reference::inverse_dynamics(robot_, q_, v_, a_, {.gravity = false, .friction = false});
  EXPECT_LT(relative(rate - v_.dot(tau), rate), 1e-18);
}

// The armature and friction of a base itself are, in the reference, a mass at its origin that nothing attracts, an
// inertia alike about all axes, and forces against its twist.
class BaseJointMotion : public FreeMotion {
 protected:
  BaseJointMotion() {
    base_.armature.number = Number(3) / 2;
    base_.viscous.number = Number(7) / 10;
    base_.coulomb.number = Number(2) / 5;
  }

  Vector torques(const Robot& robot, const reference::Vector3<Real50>& gravity) const {
    reference::Robot<Real50> numbers = reference_robot<Real50>(robot, {});
    numbers.gravity = gravity;
    return reference::inverse_dynamics(numbers, q_, v_, a_);
  }

  BaseJoint base_;
};

TEST_F(BaseJointMotion, IsThatOfABodyWithoutWeight) {
  Robot heavy = model_.robot, light = model_.robot;
  heavy.base_joint = base_;
  Inertial sphere;
  sphere.mass.number = base_.armature.number;
  for (std::size_t k = 0; k < 3; ++k) sphere.tensor[k][k] = base_.armature.number;
  light.links[static_cast<std::size_t>(light.root)].inertials.push_back(sphere);
  Vector expected = torques(light, robot_.gravity);
  expected.head(3) += Real50(3) / 2 * robot_.gravity;
  expected.head(6) += Real50(7) / 10 * v_.head(6);
  for (Eigen::Index k = 3; k < 6; ++k) expected[k] += Real50(2) / 5 * (v_[k] > 0 ? 1 : -1);
  EXPECT_LT(relative((torques(heavy, robot_.gravity) - expected).norm(), expected.norm()), 1e-45);
}

constexpr const char* kUrdf = R"(<robot name="r">
<link name="world"/><link name="body"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>
<link name="arm"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>
<joint name="free" type="floating"><parent link="world"/><child link="body"/></joint>
<joint name="turn" type="continuous"><parent link="body"/><child link="arm"/><axis xyz="0 0 1"/></joint></robot>)";

TEST(FloatingInput, IsAJointOfUrdf) {
  const LoadedRobot model = testing::model_of_urdf(kUrdf);
  EXPECT_TRUE(model.mechanism.floating_base);
  ASSERT_EQ(model.robot.links.size(), 2U);
  EXPECT_EQ(model.robot.links[0].name, "body");
  EXPECT_EQ(model.mechanism.size(), 7);
  EXPECT_EQ(model.mechanism.position_count(), 1);
  EXPECT_EQ(model.mechanism.bodies[5].inertia.mass, 2);
  EXPECT_EQ(model.mechanism.joints()[0].joint, "turn");
}

TEST(FloatingInput, ReadsTheBaseOfToml) {
  const LoadedRobot model = testing::model_of_toml(testing::kSatellite);
  EXPECT_TRUE(model.mechanism.floating_base);
  EXPECT_EQ(model.mechanism.bodies[5].link, "bus");
  const LoadedRobot heavy = testing::model_of_toml(testing::heavy_satellite());
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(heavy.mechanism.bodies[k].armature, Number(3) / 2);
    EXPECT_EQ(heavy.mechanism.bodies[k].viscous, Number(7) / 10);
    EXPECT_EQ(heavy.mechanism.bodies[k].coulomb, k < 3 ? Number(0) : Number(2) / 5);
  }
  const LoadedRobot fixed = testing::model_of_toml("base = \"fixed\"\n[[link]]\nmass = 1\n");
  EXPECT_FALSE(fixed.mechanism.floating_base);
  EXPECT_EQ(fixed.robot.links[0].name, "base");
}

}  // namespace
}  // namespace flatdyn
