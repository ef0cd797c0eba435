// SPDX-License-Identifier: GPL-2.0-or-later
// Joints that follow others by any factors: their closed form by hand, limits and angles, and the same torques as the
// tree with constraint forces.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "code/languages/emit.hpp"
#include "code/languages/readers.hpp"
#include "code/readback/emitted_text.hpp"
#include "derivation/closed_form/closed_form.hpp"
#include "derivation/closed_functions.hpp"
#include "derivation/notation/derive.hpp"
#include "derivation/parameters/base_parameters.hpp"
#include "flatdyn/reference/newton_euler.hpp"
#include "functions/exact_proof.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "proof/verify/verify.hpp"
#include "robot/model/angles.hpp"
#include "robot/model/states.hpp"
#include "support/identified_arm.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "symbolic/textbook_robots.hpp"
#include "truth/definition/sampled_base.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

// An arm with a gripper of two fingers, a rack that a joint drives, and a joint that follows two others.
const char* const kMachine = R"(name = "machine"
[[link]]
joint = "shoulder"
xyz = [0, 0, 0.3]
rpy = [0.2, "pi/2", 0]
mass = 3
com = [0.2, 0.1, 0]
inertia = { xx = 0.03, yy = 0.04, zz = 0.05, xy = 0.002 }
inertia_about = "com"
viscous = 0.3
[[link]]
joint = "elbow"
position = "elbow - shoulder + 0.4"
xyz = [0.4, 0, 0]
mass = 2
com = [0.2, 0, 0.05]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02 }
inertia_about = "com"
coulomb = 0.2
[link.motor]
mass = 0.4
inertia = 1e-4
gear_ratio = 40
[[link]]
joint = "wrist"
position = "2*elbow - shoulder"
coulomb = 0.1
xyz = [0.3, 0, 0]
rpy = ["pi/2", 0, 0.3]
mass = 1
com = [0, 0.03, 0.1]
inertia = { xx = 0.004, yy = 0.003, zz = 0.002 }
inertia_about = "com"
armature = 0.01
[[link]]
name = "left"
joint = "left_finger"
type = "prismatic"
axis = [0, 1, 0]
xyz = [0, 0, 0.2]
mass = 0.1
viscous = 0.5
[[link]]
name = "right"
joint = "right_finger"
parent = "link3"
type = "prismatic"
axis = [0, -1, 0]
position = "1.5*left_finger + 0.01"
coulomb = 0.2
xyz = [0, 0, 0.2]
mass = 0.12
com = [0.01, 0, 0]
viscous = 0.7
[[link]]
joint = "rack"
parent = "link1"
type = "prismatic"
axis = [1, 0, 0]
position = "0.05*elbow - 0.02*shoulder"
mass = 0.5
[tip]
link = "left"
)";

class Machine : public ::testing::Test {
 protected:
  const LoadedRobot model_ = testing::model_of_toml(kMachine);
};

TEST_F(Machine, HasACoordinateForEachIndependentJoint) {
  const Mechanism& mechanism = model_.mechanism;
  EXPECT_EQ(mechanism.size(), 3);
  EXPECT_EQ(mechanism.body_count(), 6);
  std::vector<std::string> names;
  for (const Body& body : mechanism.joints()) names.push_back(body.joint);
  EXPECT_EQ(names, (std::vector<std::string>{"shoulder", "elbow", "left_finger"}));
}

TEST_F(Machine, EveryFunctionIsTheLagrangians) {
  for (const FunctionRow& entry : function_table()) {
    // The robot has three coordinates: the operational functions have tests of their own below.
    if (!entry.applies_to(model_.mechanism) || entry.traits.uses_task) continue;
    const Function function = derive_function(model_.mechanism, entry.name);
    EXPECT_TRUE(prove_exactly(model_.mechanism, function).equal) << entry.name;
  }
}

// The joint stays where it is held, and the joints that follow its coordinate are placed accordingly.
TEST_F(Machine, IsHeldAtAJointsPosition) {
  std::string text = kMachine;
  text.insert(text.find("[[link]]"), "[fixed]\nelbow = 0.25\n");
  const Mechanism held = testing::model_of_toml(text).mechanism;
  ASSERT_EQ(held.size(), 2);  // the elbow's coordinate is shoulder + 0.25 - 0.4
  const auto body = [&](const std::string& joint) {
    return static_cast<std::size_t>(
        std::find_if(held.bodies.begin(), held.bodies.end(), [&](const Body& each) { return each.joint == joint; }) -
        held.bodies.begin());
  };
  EXPECT_EQ(held.coupling[body("wrist")], (std::vector<Number>{1, 0}));  // 2 (shoulder - 0.15) - shoulder
  EXPECT_TRUE(vanishes(held.offsets[body("wrist")] + Number(3) / 10));
  EXPECT_EQ(held.coupling[body("rack")], (std::vector<Number>{Number(3) / 100, 0}));
}

TEST(Followers, HaveLimitsThatBoundTheirLeader) {
  const Mechanism mechanism = testing::model_of_toml(R"(name = "belt"
[[link]]
joint = "drive"
mass = 1
limits = { lower = -1, upper = 1, velocity = 2, effort = 5 }
[[link]]
joint = "own"
mass = 1
position = "2*own"
limits = { lower = -1, upper = 0.4, velocity = 3, effort = 7 }
[[link]]
joint = "a-b"
mass = 1
position = "-2*drive + 0.1"
limits = { lower = -0.9, upper = 4, velocity = 3 }
[[link]]
joint = "last"
mass = 1
position = "'a-b' - own"
)")
                                  .mechanism;
  const auto number = [](const std::optional<Value>& value) { return nearest_double(value->number); };
  const Limits drive = mechanism.joint(0).limits, own = mechanism.joint(1).limits;
  EXPECT_DOUBLE_EQ(number(drive.lower), -1);
  EXPECT_DOUBLE_EQ(number(drive.upper), 0.5);
  EXPECT_DOUBLE_EQ(number(drive.velocity), 1.5);
  EXPECT_DOUBLE_EQ(number(drive.effort), 5);
  EXPECT_DOUBLE_EQ(number(own.lower), -0.5);
  EXPECT_DOUBLE_EQ(number(own.upper), 0.2);
  EXPECT_DOUBLE_EQ(number(own.velocity), 1.5);
  EXPECT_DOUBLE_EQ(number(own.effort), 14);
}

// A crank that drives a rack: the coordinate is an angle in one case and a length in the other.
TEST(CrankAndRack, HaveTheSameClosedForm) {
  const Mechanism mechanism = testing::model_of_toml(R"(name = "rack"
[[link]]
joint = "crank"
mass = 1
com = [0.2, 0, 0]
[[link]]
joint = "rack"
type = "prismatic"
position = "rack + 1.45*crank"
rpy = ["pi/2", 0, 0]
mass = 1
)")
                                  .mechanism;
  for (const char* name : {"inverse_dynamics", "christoffel", "coriolis_matrix", "inertia_matrix", "bias"}) {
    const Function recursive = derive_function(mechanism, name);
    const std::optional<Function> closed =
        closed_variant(mechanism, recursive, row_of(recursive).derivation.closed_form);
    ASSERT_TRUE(closed.has_value()) << name;
    EXPECT_TRUE(prove_exactly(mechanism, *closed).equal) << name;
  }
}

TEST_F(Machine, OperationalFunctionsAreTheLagrangians) {
  Mechanism mechanism = model_.mechanism;
  mechanism.task.rows = {0, 2};
  for (const char* name : {"operational_inertia", "operational_bias", "null_space_torque"}) {
    EXPECT_TRUE(prove_exactly(mechanism, derive_function(mechanism, name)).equal) << name;
  }
}

TEST_F(Machine, BaseParametersAreThoseOfTheSamples) {
  const BaseParameters base = base_parameters(model_.mechanism);
  const SampledComparison sampled = compare_with_samples(model_.mechanism, base, ParameterSet::given);
  EXPECT_TRUE(sampled.equal);
  EXPECT_EQ(sampled.rank, base.size());
}

// Two links in a plane; the second turns by 2/3 of the first one's angle.
constexpr const char* kFraction = R"(name = "fraction"
gravity = [0, "-g", 0]
[[link]]
joint = "a"
mass = "m_1"
com = ["l_1", 0, 0]
[[link]]
joint = "b"
position = "2/3*a"
xyz = ["a_1", 0, 0]
mass = "m_2"
com = ["l_2", 0, 0]
)";

// By hand: link 2 turns by 5/3 of q, its angle to link 1 is 2/3 of q.
TEST(FollowerByAFraction, HasTheClosedFormByHand) {
  const Mechanism mechanism = testing::model_of_toml(kFraction).mechanism;
  const ClosedForm form = closed_form(mechanism);
  const auto symbol = [&](const char* name) { return testing::symbol(mechanism, name); };
  const Number m1 = symbol("m_1"), m2 = symbol("m_2"), l1 = symbol("l_1"), l2 = symbol("l_2"), a1 = symbol("a_1");
  ASSERT_EQ(form.c.size(), 2U);
  const Number c = form.c[0], s = form.s[0], c_b = form.c[1], s_b = form.s[1], turn = Number(5) / 3;
  const auto is_same = [&](const Number& a, const Number& b) { return reduced(a - b, form).is_zero(); };
  EXPECT_TRUE(is_same(form.B[0][0], m1 * l1 * l1 + m2 * (a1 * a1 + turn * turn * l2 * l2 + 2 * turn * a1 * l2 * c_b)));
  EXPECT_TRUE(is_same(form.g[0], symbol("g") * ((m1 * l1 + m2 * a1) * c + turn * m2 * l2 * (c * c_b - s * s_b))));
  EXPECT_TRUE(is_same(form.christoffel(0, 0, 0), -turn * Number(2) / 3 * m2 * a1 * l2 * s_b));
}

TEST(FollowerByAFraction, AsksForTheSineOfTheFraction) {
  const LoadedRobot model = testing::model_of_toml(kFraction);
  EXPECT_THAT(derive_text(model.mechanism), ::testing::HasSubstr("cos(2/3 q_1)"));
  EXPECT_THAT(derive_text(model.mechanism), ::testing::HasSubstr("cos(5/3 q_1)"));
  const std::string header = emit_header(model.mechanism, {derive_function(model.mechanism, "gravity")}, {});
  EXPECT_THAT(header, ::testing::HasSubstr("and then of 2/3 q[0],\n// by which coupled joints turn."));
  EXPECT_THAT(header, ::testing::HasSubstr("angle[1] = Scalar(0.6666666666666666) * q[0];"));
}

// A gripper whose fingers turn by arbitrary fractions, one of them across the axis of the joint that carries it.
constexpr const char* kGripper = R"(name = "gripper"
[[link]]
joint = "wrist"
mass = 1
com = [0.1, 0.02, 0.03]
inertia = { xx = 0.01, yy = 0.02, zz = 0.015, xy = 0.001 }
inertia_about = "com"
[[link]]
joint = "left"
xyz = [0.2, 0, 0.1]
rpy = ["pi/2", 0, 0]
mass = 0.2
com = [0.05, 0, 0.01]
inertia = { xx = 0.001, yy = 0.002, zz = 0.002, xz = 0.0001 }
inertia_about = "com"
[[link]]
joint = "right"
parent = "link1"
xyz = [0.2, 0, -0.1]
rpy = ["pi/2", 0, 0]
position = "-0.28833*left + 0.1"
mass = 0.3
com = [0.05, 0.01, 0]
inertia = { xx = 0.001, yy = 0.002, zz = 0.003, yz = 0.0001 }
inertia_about = "com"
)";

TEST(FollowerByAFraction, BaseParametersAreThoseOfTheSamples) {
  const Mechanism mechanism = testing::model_of_toml(kGripper).mechanism;
  const BaseParameters base = base_parameters(mechanism);
  const SampledComparison sampled = compare_with_samples(mechanism, base, ParameterSet::given);
  EXPECT_TRUE(sampled.equal);
  EXPECT_EQ(sampled.rank, base.size());
}

TEST(FollowerByAFraction, EveryFunctionIsTheLagrangians) {
  const Mechanism mechanism = testing::model_of_toml(kGripper).mechanism;
  for (const FunctionRow& entry : function_table()) {
    if (!entry.applies_to(mechanism) || entry.traits.uses_task) continue;  // the robot has two coordinates
    EXPECT_TRUE(prove_exactly(mechanism, derive_function(mechanism, entry.name)).equal) << entry.name;
  }
}

TEST(FollowerByAFraction, IsIdentified) {
  testing::expect_recovery(testing::Arm(testing::model_of_toml(kGripper)), "gripper");
}

// Every follower has a factor of its own, so there are more angles than a short function has lines.
TEST(FollowerByAFraction, HasItsAnglesInPartsWhereFunctionsAreShort) {
  constexpr int kFollowers = 40, kMostLines = 30;
  std::string text = "name = \"fan\"\n[[link]]\njoint = \"a\"\nmass = 1\ncom = [0.1, 0, 0]\n";
  for (int k = 1; k <= kFollowers; ++k) {
    text += fmt::format("[[link]]\nparent = \"link1\"\nposition = \"0.{:02}*a\"\nmass = 1\ncom = [0.1, 0, 0]\n", k);
    text += "axis = [0, 1, 0]\n";
  }
  const Mechanism mechanism = testing::model_of_toml(text).mechanism;
  ASSERT_EQ(mechanism.angle_count(), kFollowers + 1);
  EmitOptions options;
  options.most_lines = kMostLines;
  const Function function = derive_function(mechanism, "gravity");
  const std::string header = emit_header(mechanism, {function}, options);
  int functions = 0;
  for (std::size_t at = header.find("void angles"); at != std::string::npos; at = header.find("void angles", at + 1)) {
    const std::string body = header.substr(at, header.find("\n}", at) + 2 - at);
    EXPECT_LT(std::count(body.begin(), body.end(), '\n'), kMostLines) << body;
    ++functions;
  }
  EXPECT_EQ(functions, 3);
  EXPECT_EQ(EmittedText(header, header_reader()).operations(0, function).outputs.size(), 1U);
}

// The reference loses as much: the angle itself is rounded.
TEST(FollowerByAFraction, MayBeOffByAsManyLastPlacesAsItTurnsMore) {
  std::string text = kGripper;
  text.replace(text.find("-0.28833"), 8, "-200.5");
  const LoadedRobot model = testing::model_of_toml(text);
  EXPECT_EQ(largest_angle_factor(model.mechanism), 200.5);
  EXPECT_EQ(largest_angle_factor(testing::model_of_toml(kGripper).mechanism), 1);
  Progress quiet(true);
  VerifyOptions options;
  options.states = 20;
  const VerifyReport report =
      verify(model.robot, model.mechanism, {derive_function(model.mechanism, "gravity")}, options, quiet);
  EXPECT_TRUE(report.passed());
  EXPECT_GT(report.functions.front().reference.largest, 16);
}

TEST_F(Machine, IsIdentifiedInItsCoordinates) { testing::expect_recovery(testing::Arm(model_), "machine"); }

// Each joint follows the two before it: without memoisation, the first would be visited 1e12 times.
TEST(Followers, AreFollowedOnceEach) {
  std::string text = "name = \"rabbits\"\n";
  for (int i = 1; i <= 60; ++i) {
    text += "[[link]]\ntype = \"prismatic\"\nmass = 1\n";
    if (i > 2) text += "position = \"joint" + std::to_string(i - 1) + " + joint" + std::to_string(i - 2) + "\"\n";
  }
  const Mechanism mechanism = testing::model_of_toml(text).mechanism;
  EXPECT_EQ(mechanism.coupling.back()[1], GiNaC::fibonacci(59));
}

// The tree with the couplings as constraints Φ = q_joint - A q = 0, whose forces are found with the accelerations: [B_t
// Φᵀ; Φ 0] [q̈_t; λ] = [τ_t - n_t; 0]. The rows of Φ are a basis of the space normal to the columns of A.
TEST_F(Machine, MovesAsTheTreeWithConstraintForces) {
  using namespace reference;
  const reference::Robot<double> coupled = reference_robot<double>(model_.robot, {});
  reference::Robot<double> tree = coupled;
  tree.coupling.resize(0, 0);
  const Eigen::MatrixXd A = coupled.coupling;
  const Eigen::MatrixXd normal = A.transpose().fullPivLu().kernel().transpose();
  ASSERT_EQ(normal.rows(), 3);
  for (const State& state : random_states(model_.mechanism, 20, 5)) {
    const auto vector = [](const std::vector<double>& v) {
      return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())));
    };
    const Eigen::VectorXd q = vector(state.q), qd = vector(state.qd), tau = vector(state.tau);
    const Eigen::VectorXd q_t = A * q, qd_t = A * qd, tau_t = A * (A.transpose() * A).ldlt().solve(tau);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(9, 9);
    K.topLeftCorner(6, 6) = inertia_matrix<double>(tree, q_t);
    K.topRightCorner(6, 3) = normal.transpose();
    K.bottomLeftCorner(3, 6) = normal;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(9);
    right.head(6) = tau_t - bias<double>(tree, q_t, qd_t);
    const Eigen::VectorXd qdd_t = K.fullPivLu().solve(right).head(6);
    const Eigen::VectorXd expected = A * forward_dynamics<double>(coupled, q, qd, tau);
    EXPECT_LT((qdd_t - expected).norm(), 1e-8 * (1 + expected.norm()));
  }
}

}  // namespace
}  // namespace flatdyn
