// SPDX-License-Identifier: GPL-2.0-or-later
// Robots with joint springs: every function against its definition in exact arithmetic and against the reference, and
// both against what springs are: forces with a potential, each on its own joint.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "derivation/parameters/parameters.hpp"
#include "flatdyn/reference/kinematics.hpp"
#include "functions/deviation/expected.hpp"
#include "functions/exact_proof.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/units.hpp"
#include "robot/model/states.hpp"
#include "support/agreement.hpp"
#include "support/robot_models.hpp"
#include "support/simple_robots.hpp"
#include "support/written_model.hpp"
#include "truth/definition/as_read.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

// A turn, a slide and a turn, each with a spring, one with friction and one with a rotor on the link before it.
const char* const kArm = R"(name = "arm"
[[link]]
joint = "shoulder"
rpy = [0.3, "pi/2", 0]
mass = 3
com = [0.2, 0.1, 0]
inertia = { xx = 0.03, yy = 0.04, zz = 0.05, xy = 0.002 }
inertia_about = "com"
viscous = 0.3
stiffness = "k"
spring_reference = "pi/5"
[[link]]
joint = "rail"
type = "prismatic"
axis = [1, 1, 0]
xyz = [0.4, 0, 0]
mass = 2
com = [0.2, 0, 0.05]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02 }
inertia_about = "com"
stiffness = 250
spring_reference = -0.1
[[link]]
joint = "wrist"
xyz = [0.3, 0.1, 0]
rpy = ["pi/2", 0, 0]
mass = 1
com = [0.1, 0.05, 0]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02 }
inertia_about = "com"
coulomb = 0.1
stiffness = 1.5
motor = { mass = 0.1, inertia = 1e-4, gear_ratio = 20 }
)";

// The second joint has a spring and follows the first; the third has one and follows both.
const char* const kCoupled = R"(name = "hand"
[[link]]
joint = "a"
mass = 1
com = [0.1, 0.02, 0]
stiffness = 3
spring_reference = 0.2
[[link]]
joint = "b"
xyz = [0.2, 0, 0]
mass = 0.5
com = [0.1, 0, 0.01]
stiffness = 4
spring_reference = -0.5
viscous = 0.01
position = "2*a + pi/7"
[[link]]
joint = "c"
xyz = [0.2, 0, 0]
rpy = ["pi/2", 0, 0]
mass = 0.5
com = [0.1, 0, 0.01]
[[link]]
joint = "d"
xyz = [0.2, 0, 0]
mass = 0.25
com = [0.1, 0, 0.01]
stiffness = 2
spring_reference = 0.3
position = "c - a + 0.1"
)";

// A four-bar linkage that is no parallelogram, with springs at a joint that leads and at one that follows.
const std::string kLoop =
    testing::four_bar_with("stiffness = 5\nspring_reference = 0.4", "stiffness = 7\nspring_reference = -0.3");

const std::string kFloating = testing::bird_with("stiffness = 6\nspring_reference = 0.25\n", R"([[link]]
joint = "tail"
parent = "base"
type = "prismatic"
xyz = [-0.2, 0, 0]
mass = 0.2
stiffness = 40
)");

// Tendons over joints of two limbs and of one, with springs, friction and armature.
const char* const kTendons = R"(
[[link]]
joint = "upper"
xyz = [0.1, 0.2, 0]
mass = 0.3
com = [0.2, 0.1, 0]
inertia = { xx = 0.003, yy = 0.004, zz = 0.005 }
inertia_about = "com"
[[link]]
joint = "lower"
xyz = [0.2, 0, 0]
rpy = ["pi/2", 0, 0]
mass = 0.2
com = [0.1, 0.05, 0]
viscous = 0.1
[[link]]
joint = "tail"
parent = "base"
type = "prismatic"
xyz = [-0.2, 0, 0]
mass = 0.2
stiffness = 40
[[tendon]]
name = "crossing"
length = "2*lower - tail"
stiffness = "k"
spring_reference = 0.2
viscous = 1.5
armature = 0.04
[[tendon]]
name = "along"
length = "upper + 3/2*lower"
stiffness = 12
coulomb = 0.3
)";
const std::string kTendonsOnAFixedBase = std::string("name = \"hand\"") + kTendons;
const std::string kTendonsOnAFloatingBase =
    std::string(
        "name = \"bird\"\n[base]\nmotion = \"floating\"\nmass = 1.5\ncom = [0.01, 0.02, -0.03]\n"
        "inertia = { xx = 0.02, yy = 0.03, zz = 0.04 }\ninertia_about = \"com\"\n") +
    kTendons;

struct SprungRobot {
  const char* name;
  const char* text;
};

class Springs : public ::testing::TestWithParam<SprungRobot> {
 protected:
  LoadedRobot model_ = testing::model_of_toml(GetParam().text);
  const Mechanism& mechanism_ = model_.mechanism;

  // The task takes all joints of these arms.
  bool is_made(const std::string& name) const {
    return find_row(name)->applies_to(mechanism_) && name != "null_space_torque";
  }
};

TEST_P(Springs, AreThoseThatWereRead) {
  const AsReadResult result = prove_as_read(model_.robot, mechanism_, 1);
  EXPECT_TRUE(result.holds && result.is_exact) << result.summary();
  LoadedRobot stiffer = model_;
  for (Joint& joint : stiffer.robot.joints) joint.spring_reference.number += GiNaC::numeric(1, 1000);
  EXPECT_FALSE(prove_as_read(stiffer.robot, mechanism_, 1).holds);
}

// In each of the ways in which it can be derived.
TEST_P(Springs, FunctionsAreProven) {
  for (const FunctionRow& row : function_table()) {
    if (!is_made(row.name)) continue;
    const Choices choices = uniform_choices(mechanism_, Grouping::i_yy);
    for (FormulationIndex way = 0; way <= row.derivation.alternatives.size(); ++way) {
      const std::optional<Function> function = formulation(mechanism_, row.name, way, choices);
      if (!function) continue;
      const ExactResult result = prove_exactly(mechanism_, *function);
      EXPECT_TRUE(result.equal) << row.name << ", way " << way << ": " << result.summary();
    }
  }
}

TEST_P(Springs, FunctionsAgreeWithTheReference) {
  const ExpectedValues expected(model_.robot, mechanism_, 1);
  for (const char* name :
       {"inverse_dynamics", "inverse_dynamics_tip_force", "gravity", "bias", "forward_dynamics", "potential_energy",
        "inverse_dynamics_derivatives", "forward_dynamics_derivatives", "operational_bias", "inverse_dynamics_base"}) {
    if (!is_made(name)) continue;
    const Function function = *formulation(mechanism_, name, 0, uniform_choices(mechanism_, Grouping::i_yy));
    std::vector<State> states = with_parameters(random_states(mechanism_, 3, 7), expected.symbols());
    draw_own_arguments(states, {&function, 1}, 3);
    testing::expect_the_reference(expected, mechanism_, function, states);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Springs,
                         ::testing::Values(SprungRobot{"arm", kArm}, SprungRobot{"coupled", kCoupled},
                                           SprungRobot{"loop", kLoop.c_str()},
                                           SprungRobot{"floating", kFloating.c_str()},
                                           SprungRobot{"tendons", kTendonsOnAFixedBase.c_str()},
                                           SprungRobot{"tendons_floating", kTendonsOnAFloatingBase.c_str()}),
                         [](const auto& each) { return std::string(each.param.name); });

using Vector = reference::VectorX<Real50>;

// The torques at rest are the derivative of the potential energy, and gravity is the part without springs.
TEST(SpringForces, HaveAPotential) {
  const Real50 h("1e-15");
  for (const char* text : {kArm, kCoupled}) {
    const LoadedRobot model = testing::model_of_toml(text);
    const reference::Robot<Real50> robot =
        reference_robot<Real50>(model.robot, SymbolValues(model.mechanism.symbols.size(), GiNaC::numeric(7, 4)));
    const Vector q = vector_of(widened<Real50>(random_states(model.mechanism, 1, 3).front()).q);
    const Vector rest = Vector::Zero(q.size()), at_rest = reference::bias(robot, q, rest);
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      const Vector step = h * Vector::Unit(q.size(), k);
      const Real50 slope = (reference::potential_energy(robot, Vector(q + step)) -
                            reference::potential_energy(robot, Vector(q - step))) /
                           (2 * h);
      EXPECT_LT(abs(slope - at_rest[k]), Real50("1e-24"));
    }
    EXPECT_GT((at_rest - reference::gravity(robot, q)).norm(), 1);
  }
}

// B = B_without + c a cᵀ, with tail's own stiffness and no inertial parameters of tendons.
TEST(Tendons, AddTheirArmatureAlongTheirLengths) {
  const std::string text = kTendonsOnAFixedBase;
  const LoadedRobot with = testing::model_of_toml(text),
                    without = testing::model_of_toml(text.substr(0, text.find("[[tendon]]")));
  const auto inertia = [](const LoadedRobot& model) {
    const reference::Robot<Real50> robot =
        reference_robot<Real50>(model.robot, SymbolValues(model.mechanism.symbols.size(), GiNaC::numeric(7, 4)));
    Vector q(3);
    q << 0.3, -0.7, 0.2;
    return reference::MatrixX<Real50>(reference::inertia_matrix(robot, q));
  };
  Vector c(3);
  c << 0, 2, -1;
  const reference::MatrixX<Real50> added = inertia(with) - inertia(without);
  EXPECT_LT((added - Real50("0.04") * c * c.transpose()).norm(), Real50("1e-45"));
  EXPECT_EQ(parameter_indices(with.mechanism).size(), parameter_indices(without.mechanism).size() + 2 * 3);
  EXPECT_EQ(unit_of_parameter(with.mechanism, index_of(3, Parameter::Im)), "kg");  // it runs over a slide, too
  EXPECT_EQ(unit_of_parameter(with.mechanism, index_of(4, Parameter::Im)), "kg m^2");
}

}  // namespace
}  // namespace flatdyn
