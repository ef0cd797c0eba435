// SPDX-License-Identifier: GPL-2.0-or-later
// Robots whose links touch something that does not move: every function against its definition in exact arithmetic and
// against the reference, and the laws that connect them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/system/temporary_folder.hpp"
#include "flatdyn/reference/contacts.hpp"
#include "functions/deviation/expected.hpp"
#include "functions/exact_proof.hpp"
#include "functions/function_table.hpp"
#include "functions/load/bad_input.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/planning/make_functions.hpp"
#include "robot/model/states.hpp"
#include "support/floating_robots.hpp"
#include "support/robot_models.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

struct TouchingRobot {
  std::string name, robot, scene;  // a robot of robots/, or the text of one; the text of the scene
  bool floats = true;
};

constexpr const char* kFourFeet = R"(
[[contact]]
link = "FL_FOOT"
friction = 0.6
[[contact]]
link = "FR_FOOT"
friction = 0.4
[[contact]]
link = "HL_FOOT"
[[contact]]
link = "HR_FOOT"
)";
// A surface and a point, neither of which is at a frame's origin.
constexpr const char* kHandAndPanel = R"(
[[contact]]
link = "link2"
type = "surface"
position = [0.1, 0.2, -0.3]
friction = 0.7
size = [0.2, 0.1]
[[contact]]
link = "link3"
position = [0, 0.5, 0.1]
friction = 0.3
normal = "link"
)";
// More than the arm can follow.
constexpr const char* kTwoHandles = R"(
contact_damping = 0.1
[[contact]]
link = "link6"
position = [0, 0.1, 0.2]
friction = 0.5
[[contact]]
name = "other"
link = "link6"
type = "surface"
)";

LoadedRobot touching(const TouchingRobot& what) {
  const TemporaryFolder folder;
  const std::filesystem::path scene = folder.path() / "scene.toml";
  std::ofstream(scene) << what.scene;
  std::filesystem::path robot = std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots" / what.robot;
  if (what.robot.starts_with("name =")) {
    robot = folder.path() / "robot.toml";
    std::ofstream(robot) << what.robot;
  }
  LoadOptions options;
  options.read.scene_file = scene.string();
  if (what.floats) options.read.floating_base = true;
  return load_robot(robot, options);
}

class AtContacts : public ::testing::TestWithParam<TouchingRobot> {
 protected:
  std::vector<std::string> functions() const {
    std::vector<std::string> names;
    for (const FunctionRow& row : function_table()) {
      if (row.traits.needs_contacts && row.applies_to(model_.mechanism)) names.emplace_back(row.name);
    }
    return names;
  }

  LoadedRobot model_ = touching(GetParam());
};

TEST_P(AtContacts, FunctionsAreProven) {
  for (const std::string& name : functions()) {
    const ExactResult result = prove_exactly(model_.mechanism, derive_function(model_.mechanism, name));
    EXPECT_TRUE(result.equal) << name << ": " << result.summary();
  }
}

// From the equations of the held motion or, where the base has armature, from its graph; `condition` has none.
TEST_P(AtContacts, JacobianOfTheHeldMotionIsProven) {
  const Function jacobian = derive_function(model_.mechanism, "jac:constrained_forward_dynamics");
  const ExactResult result = prove_exactly(model_.mechanism, jacobian, {.points = 1});
  EXPECT_TRUE(result.equal) << result.summary();
  EXPECT_EQ(jacobian.outputs.size(), 2 * (jacobian.inputs.size()));
}

TEST_P(AtContacts, FunctionsAgreeWithTheReference) {
  PipelineOptions options;
  options.functions = functions();
  Progress silent(true);
  Diagnostics none;
  const ExpectedValues expected(model_.robot, model_.mechanism, 1);
  for (const OptimisedFunction& made : make_functions(model_, options, silent, none)) {
    const Expected here = expected.of(made.function);
    GraphEvaluator<Real50> graph(made.function);
    for (const State& state : random_states(model_.mechanism, 3, 7)) {
      const auto values = graph(widened<Real50>(state));
      ASSERT_TRUE(values) << made.function.name;
      const std::vector<Real50> right = here.exact(state);
      const std::vector<double> scale = here.scale(state);
      ASSERT_EQ(values->size(), right.size()) << made.function.name;
      for (std::size_t k = 0; k < right.size(); ++k) {
        const Real50 difference = abs((*values)[k] - right[k]);
        EXPECT_LE(difference.convert_to<double>(), 1e-40 * scale[k]) << made.function.name << " " << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, AtContacts,
                         ::testing::Values(TouchingRobot{"quadruped", "quadruped12.urdf", kFourFeet},
                                           TouchingRobot{"satellite", testing::kSatellite, kHandAndPanel},
                                           TouchingRobot{"heavy_satellite", testing::heavy_satellite(), kHandAndPanel},
                                           TouchingRobot{"puma", "puma560.toml", kTwoHandles, false}),
                         [](const auto& each) { return each.param.name; });

// The proof sees a contact that is a micrometre off.
TEST(Contacts, AreProvenWhereTheyAre) {
  const LoadedRobot model = touching({"satellite", testing::kSatellite, kHandAndPanel});
  Mechanism other = model.mechanism;
  other.contacts[1].frame.p[1] += exact_decimal("1e-6");
  for (const char* name : {"contact_jacobian", "contact_bias", "constrained_forward_dynamics",
                           "contact_inverse_dynamics", "contact_impact"}) {
    EXPECT_FALSE(prove_exactly(other, derive_function(model.mechanism, name)).equal) << name;
  }
}

using Vector = reference::VectorX<Real50>;

// A quadruped on its feet, at a state of motion.
class Standing : public ::testing::Test {
 protected:
  Standing() : robot_(reference_robot<Real50>(model_.robot, {})) {
    const StateOf<Real50> state = widened<Real50>(random_states(model_.mechanism, 1, 3).front());
    q_ = vector_of(state.q), v_ = vector_of(state.qd), tau_ = vector_of(state.tau);
    robot_.gravity = vector_of(state.g_b);
    tau_.head(6).setZero();
  }

  static double size(const Vector& v) { return Real50(v.norm()).convert_to<double>(); }

  LoadedRobot model_ = touching({"quadruped", "quadruped12.urdf", kFourFeet});
  reference::Robot<Real50> robot_;
  Vector q_, v_, tau_;
};

TEST_F(Standing, IsHeldByForcesThatObeyNewtonsLaw) {
  const auto held = reference::constrained_forward_dynamics(robot_, q_, v_, tau_);
  const auto J = reference::contact_jacobian(robot_, q_);
  EXPECT_LT(size(J * held.motion + reference::contact_drift(robot_, q_, v_)), 1e-40);
  const Vector needed = reference::inverse_dynamics(robot_, q_, v_, held.motion);
  EXPECT_LT(size(needed - tau_ - J.transpose() * held.forces), 1e-40);
}

// The smallest forces and their torques cause the same motion, and no other forces go with these torques.
TEST_F(Standing, MovesAlikeBySmallestForces) {
  const auto held = reference::constrained_forward_dynamics(robot_, q_, v_, tau_);
  const auto smallest = reference::contact_inverse_dynamics(robot_, q_, v_, held.motion);
  const auto again = reference::constrained_forward_dynamics(robot_, q_, v_, smallest.motion);
  EXPECT_LT(size(again.motion - held.motion), 1e-38);
  EXPECT_LT(size(again.forces - smallest.forces), 1e-38);
  EXPECT_LT(size(smallest.forces), size(held.forces));
  EXPECT_EQ(size(smallest.motion.head(6)), 0);
}

TEST_F(Standing, LosesEnergyInAnImpact) {
  const auto stopped = reference::contact_impact(robot_, q_, v_);
  EXPECT_LT(size(reference::contact_jacobian(robot_, q_) * stopped.motion), 1e-40);
  const Real50 before = reference::kinetic_energy(robot_, q_, v_),
               after = reference::kinetic_energy(robot_, q_, stopped.motion);
  const Vector lost = v_ - stopped.motion;
  EXPECT_GT(after, 0);
  EXPECT_LT(after, before);
  // The energy that is lost is that of the velocity that is lost (Carnot's theorem).
  EXPECT_LT(Real50(abs(before - after - reference::kinetic_energy(robot_, q_, lost))).convert_to<double>(), 1e-40);
}

std::string refusal(const TouchingRobot& what, const char* function) {
  try {
    const LoadedRobot model = touching(what);
    derive_function(model.mechanism, function);
  } catch (const BadInput& bad) {
    return bad.diagnostics.all().front().message;
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "";
}

TEST(Contacts, AreRefusedWithAReason) {
  using ::testing::HasSubstr;
  constexpr const char* kPuma = "puma560.toml";
  EXPECT_THAT(refusal({"", kPuma, "", false}, "contact_bias"), HasSubstr("is about contacts, and there are none"));
  EXPECT_THAT(refusal({"", kPuma, "[[contact]]\nlink = \"link6\"\n", false}, "contact_inverse_dynamics"),
              HasSubstr("is one of robots with a floating base"));
  EXPECT_THAT(refusal({"", kPuma, "[[contact]]\nlink = \"link9\"\n", false}, "contact_bias"),
              HasSubstr("there is no link \"link9\""));
  EXPECT_THAT(refusal({"", kPuma, "[[contact]]\nlink = \"base\"\n", false}, "contact_bias"),
              HasSubstr("link \"base\" does not move"));
  EXPECT_THAT(
      refusal({"", kPuma, "[[contact]]\nlink = \"link6\"\n[[contact]]\nlink = \"link6\"\n", false}, "contact_bias"),
      HasSubstr("\"link6\" is there twice"));
  constexpr const char* kThreePoints = R"([[contact]]
link = "link6"
[[contact]]
name = "second"
link = "link6"
position = [0.1, 0, 0]
[[contact]]
name = "third"
link = "link6"
position = [0, 0.1, 0]
)";
  EXPECT_THAT(refusal({"", kPuma, "[[contact]]\nlink = \"link1\"\n", false}, "contact_impact"),
              HasSubstr("\"link1\" holds more than the robot can move there"));
  EXPECT_THAT(refusal({"", kPuma, "[[contact]]\nlink = \"link6\"\nname = \"\"\n", false}, "contact_bias"),
              HasSubstr("its name is empty"));
  EXPECT_THAT(refusal({"", kPuma, kThreePoints, false}, "constrained_forward_dynamics"),
              HasSubstr("what \"second\" holds follows from the contacts before it"));
}

// Two points carry no moment about the line through them.
TEST(Contacts, OnALineDoNotCarryABase) {
  EXPECT_THAT(refusal({"", "quadruped12.urdf", "[[contact]]\nlink = \"FL_FOOT\"\n[[contact]]\nlink = \"HR_FOOT\"\n"},
                      "contact_inverse_dynamics"),
              ::testing::HasSubstr("their points are on one line"));
}

// A wrist whose axes are in line cannot turn in every direction that its hand holds: the condition says so.
TEST(Contacts, HaveTheConditionZeroWhereTheyAreSingular) {
  const LoadedRobot model =
      touching({"", "puma560.toml", "[[contact]]\nlink = \"link6\"\ntype = \"surface\"\n", false});
  const Function function = derive_function(model.mechanism, "constrained_forward_dynamics");
  GraphEvaluator<double> graph(function);
  State state = random_states(model.mechanism, 1, 5).front();
  const auto bent = graph(state);
  ASSERT_TRUE(bent);
  EXPECT_GT(bent->back(), 1e-4);
  constexpr std::size_t kWristBend = 4;
  state.q[kWristBend] = 0;
  const auto in_line = graph(state);
  EXPECT_TRUE(!in_line || in_line->back() < 1e-12);
}

}  // namespace
}  // namespace flatdyn
