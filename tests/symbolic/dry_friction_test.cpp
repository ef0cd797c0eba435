// SPDX-License-Identifier: GPL-2.0-or-later
// Robots with dry friction that changes with the rate: every function that has friction against its definition in exact
// arithmetic, before and after the passes, and against the reference.
#include <gtest/gtest.h>

#include <cmath>

#include "base/diagnostics/diagnostics.hpp"
#include "flatdyn/reference/load_friction.hpp"
#include "functions/deviation/expected.hpp"
#include "functions/exact_proof.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "graph/passes/passes.hpp"
#include "robot/model/joint_friction.hpp"
#include "robot/model/states.hpp"
#include "support/agreement.hpp"
#include "support/mutants.hpp"
#include "support/robot_models.hpp"
#include "support/simple_robots.hpp"
#include "support/written_model.hpp"
#include "truth/definition/as_read.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

// A law on each joint, with numbers and with symbols.
const char* const kRubbedArm = R"(name = "arm"
[[link]]
joint = "shoulder"
rpy = [0.3, "pi/2", 0]
mass = 3
com = [0.2, 0.1, 0]
viscous = 0.3
coulomb = "F_1"
coulomb_speed = "v_1"
[[link]]
joint = "rail"
type = "prismatic"
axis = [1, 1, 0]
xyz = [0.4, 0, 0]
mass = 2
com = [0.2, 0, 0.05]
coulomb = 0.7
coulomb_speed = 0.03
static = "F_t"
stribeck_speed = 0.2
[[link]]
joint = "wrist"
xyz = [0.3, 0.1, 0]
rpy = ["pi/2", 0, 0]
mass = 1
com = [0.1, 0.05, 0]
coulomb = { forward = 0.4, backward = "F_m" }
coulomb_speed = 0.5
)";

// Offsets, and laws with signs.
const char* const kArmWithOffsets = R"(name = "offsets"
[[link]]
joint = "a"
mass = 1
com = [0.1, 0.02, 0]
coulomb = 0.54
coulomb_speed = 0.4
coulomb_offset = 0.04
[[link]]
joint = "b"
rpy = ["pi/2", 0, 0]
xyz = [0.2, 0, 0]
mass = 0.5
com = [0.1, 0, 0.01]
coulomb = 0.3
coulomb_speed = "v_b"
coulomb_offset = "phi_b"
)";

const char* const kArmWithSigns = R"(name = "signs"
[[link]]
joint = "a"
mass = 1
com = [0.1, 0.02, 0]
coulomb = { forward = 0.5, backward = 0.3 }
[[link]]
joint = "b"
rpy = ["pi/2", 0, 0]
xyz = [0.2, 0, 0]
mass = 0.5
com = [0.1, 0, 0.01]
coulomb = 0.2
static = 0.6
stribeck_speed = "v_s"
)";

// The second joint follows the first, the fourth both of the others; a tendon runs over two.
const char* const kRubbedHand = R"(name = "hand"
[[link]]
joint = "a"
mass = 1
com = [0.1, 0.02, 0]
[[link]]
joint = "b"
xyz = [0.2, 0, 0]
mass = 0.5
com = [0.1, 0, 0.01]
coulomb = { forward = 0.4, backward = 0.1 }
coulomb_speed = 0.1
position = "2*a + pi/7"
[[link]]
joint = "c"
xyz = [0.2, 0, 0]
rpy = ["pi/2", 0, 0]
mass = 0.5
com = [0.1, 0, 0.01]
coulomb = 0.6
[[tendon]]
name = "along"
length = "a + 3/2*c"
coulomb = 0.3
coulomb_speed = 0.25
static = 0.5
stribeck_speed = 0.1
)";

const std::string kRubbedLoop =
    testing::four_bar_with("coulomb = 0.5\ncoulomb_speed = 0.1", "coulomb = 0.2\ncoulomb_speed = 0.3");

const std::string kRubbedBird =
    testing::bird_with("coulomb = 0.3\ncoulomb_speed = 0.2\nstatic = 0.4\nstribeck_speed = 0.1\n");

struct RubbedRobot {
  const char* name;
  const char* text;
};

const std::vector<std::string> kRubbedFunctions = {
    "inverse_dynamics", "inverse_dynamics_tip_force",   "bias",
    "forward_dynamics", "inverse_dynamics_derivatives", "forward_dynamics_derivatives",
    "regressor",        "adaptive_regressor",           "inverse_dynamics_base"};

class DryFrictionOfRobots : public ::testing::TestWithParam<RubbedRobot> {
 protected:
  LoadedRobot model_ = testing::model_of_toml(GetParam().text);
  const Mechanism& mechanism_ = model_.mechanism;
  const Choices choices_ = uniform_choices(mechanism_, Grouping::i_yy);

  bool is_made(const std::string& name) const {
    const FunctionRow& row = *find_row(name);
    const bool is_linear = std::all_of(mechanism_.bodies.begin(), mechanism_.bodies.end(),
                                       [](const Body& body) { return body.dry.is_linear(); });
    return row.applies_to(mechanism_) && (is_linear || !row.needs_linear_friction());
  }
  void expect_proof(const Function& function, int points = 2) const {
    const ExactResult result = prove_exactly(mechanism_, function, {.points = points});
    EXPECT_TRUE(result.equal) << function.name << ": " << result.summary();
    EXPECT_LT(result.failure_log2, -60) << function.name;
  }
};

TEST_P(DryFrictionOfRobots, IsThatWhichWasRead) {
  const AsReadResult result = prove_as_read(model_.robot, mechanism_, 1);
  EXPECT_TRUE(result.holds && result.is_exact) << result.summary();
  LoadedRobot other = model_;
  for (Joint& joint : other.robot.joints) {
    for (auto* value : {&joint.law.speed, &joint.law.backward, &joint.law.stribeck_speed}) {
      if (*value) (*value)->number += GiNaC::numeric(1, 1000);
    }
  }
  EXPECT_FALSE(prove_as_read(other.robot, mechanism_, 1).holds);
}

// In each of the ways in which they can be derived, before and after the passes.
TEST_P(DryFrictionOfRobots, FunctionsAreProven) {
  for (const std::string& name : kRubbedFunctions) {
    if (!is_made(name)) continue;
    for (FormulationIndex way = 0; way < kFormulationCount; ++way) {
      const std::optional<Function> function = formulation(mechanism_, name, way, choices_);
      if (!function) continue;
      expect_proof(*function);
      if (way == 0) expect_proof(run_passes(*function));
    }
  }
}

TEST_P(DryFrictionOfRobots, DerivativesAreProven) {
  if (mechanism_.has_loops()) return;
  for (const std::string stem : {"inverse_dynamics", "bias", "forward_dynamics"}) {
    for (const std::string prefix : {"jac:", "jvp:", "vjp:", "hessian:"}) {
      const std::optional<Function> function = formulation(mechanism_, prefix + stem, 0, choices_);
      if (!function) continue;
      expect_proof(*function, 1);
      if (stem == "inverse_dynamics") expect_proof(run_passes(*function), 1);
    }
  }
}

TEST_P(DryFrictionOfRobots, FunctionsAgreeWithTheReference) {
  const ExpectedValues expected(model_.robot, mechanism_, 1);
  for (const std::string& name : kRubbedFunctions) {
    if (!is_made(name)) continue;
    const Function function = *formulation(mechanism_, name, 0, choices_);
    std::vector<State> states = with_parameters(random_states(mechanism_, 3, 7), expected.symbols());
    draw_own_arguments(states, {&function, 1}, 3);
    testing::expect_the_reference(expected, mechanism_, function, states);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, DryFrictionOfRobots,
                         ::testing::Values(RubbedRobot{"arm", kRubbedArm}, RubbedRobot{"offsets", kArmWithOffsets},
                                           RubbedRobot{"signs", kArmWithSigns}, RubbedRobot{"coupled", kRubbedHand},
                                           RubbedRobot{"loop", kRubbedLoop.c_str()},
                                           RubbedRobot{"floating", kRubbedBird.c_str()}),
                         [](const auto& each) { return std::string(each.param.name); });

// Drives that lose a share of their torque: one that is smooth, one with a sign, one whose share is a symbol.
constexpr const char* kGearedArm = R"(name = "geared"
[[link]]
joint = "shoulder"
mass = 3
com = [0.2, 0, 0]
viscous = 0.5
coulomb = 1.2
coulomb_speed = 0.05
load_friction = 0.08
[[link]]
joint = "elbow"
xyz = [0.5, 0, 0]
mass = 2
com = [0.2, 0, 0]
load_friction = 0.3
[[link]]
joint = "wrist"
xyz = [0.4, 0, 0]
axis = [1, 0, 0]
mass = 1
com = [0.1, 0.02, 0]
load_friction = "loss"
)";

TEST(LoadFriction, IsProvenAndAgreesWithTheReference) {
  const LoadedRobot model = testing::model_of_toml(kGearedArm);
  const ExpectedValues values(model.robot, model.mechanism, 7);
  for (const char* name : {"drive_torque", "torque_from_drive", "jac:drive_torque", "vjp:torque_from_drive"}) {
    const Function function = derive_function(model.mechanism, name);
    EXPECT_TRUE(prove_exactly(model.mechanism, function).equal) << name;
    std::vector<State> states = with_parameters(random_states(model.mechanism, 4, 11), values.symbols());
    draw_own_arguments(states, {&function, 1}, 5);
    testing::expect_the_reference(values, model.mechanism, function, states);
  }
}

// One function undoes the other, in each of the four quadrants, and the drive takes more where it drives.
TEST(LoadFriction, IsUndone) {
  const LoadedRobot model = testing::model_of_toml(kGearedArm);
  const SymbolValues symbols = random_symbol_values(model.robot, 3);
  const auto robot = reference_robot<double>(model.robot, symbols);
  for (const double rate : {-0.7, -0.01, 0.0, 0.02, 0.9}) {
    for (const double torque : {-4.0, -0.1, 0.0, 3.0}) {
      const reference::VectorX<double> qd = reference::VectorX<double>::Constant(3, rate),
                                       tau = reference::VectorX<double>::Constant(3, torque),
                                       drive = reference::drive_torque(robot, qd, tau);
      EXPECT_NEAR((reference::torque_from_drive(robot, qd, drive) - tau).norm(), 0, 1e-14);
      for (int k = 0; k < 3; ++k) EXPECT_GE((drive[k] - tau[k]) * rate, 0) << rate << " " << torque;
      EXPECT_NEAR(drive[1], torque + 0.3 * std::abs(torque) * ((rate > 0) - (rate < 0)), 1e-14);
    }
  }
}

TEST(LoadFriction, IsOfRobotsThatHaveIt) {
  EXPECT_THROW(derive_function(testing::model_of("scara.toml").mechanism, "drive_torque"), Failure);
  EXPECT_THROW(derive_function(testing::model_of_toml(testing::four_bar_with("load_friction = 0.1", "")).mechanism,
                               "drive_torque"),
               Failure);
}

// A sign that flips, a term that is lost and a wrong operand, in what the passes leave.
TEST(DryFriction, EveryWrongOperationIsFound) {
  const LoadedRobot model = testing::model_of_toml(kArmWithOffsets);
  const Function function =
      run_passes(*formulation(model.mechanism, "bias", 0, uniform_choices(model.mechanism, Grouping::i_yy)));
  int mutants = 0;
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    if (function.graph[id].op != Op::sum || is_scaled(function.graph[id])) continue;
    for (const testing::MutantKind kind : {testing::MutantKind::flip_sign, testing::MutantKind::drop_term}) {
      if (kind == testing::MutantKind::drop_term && function.graph[id].terms.size() < 2) continue;
      const Function wrong = testing::mutant(function, id, kind);
      EXPECT_FALSE(prove_exactly(model.mechanism, wrong, {.points = 1}).equal) << "node " << id;
      ++mutants;
    }
  }
  EXPECT_GT(mutants, 30);
}

// The published form of Gaz et al. (2019): φ_1/(1 + exp(-φ_2 (q̇ + φ_3))) - φ_1/(1 + exp(-φ_2 φ_3)).
TEST(DryFriction, OffsetsAreThoseOfALogisticFunction) {
  const LoadedRobot model = testing::model_of_toml(
      "name = \"m\"\n[[link]]\njoint = \"j\"\nmass = 1\ncom = [0.1, 0, 0]\n"
      "coulomb = \"0.54615/2\"\ncoulomb_speed = \"2/5.1181\"\ncoulomb_offset = 0.039533\n");
  const JointFriction friction = joint_friction(model.mechanism);
  for (const double rate : {-3.0, -0.2, 0.0, 0.01, 0.7}) {
    const auto logistic = [](double x) { return 0.54615 / (1 + std::exp(-5.1181 * (x + 0.039533))); };
    EXPECT_NEAR(friction.smooth_torque(0, rate), logistic(rate) - logistic(0), 1e-15);
  }
}

}  // namespace
}  // namespace flatdyn
