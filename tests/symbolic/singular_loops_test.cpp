// SPDX-License-Identifier: GPL-2.0-or-later
// Positions of closed loops in which dependent joints do not follow: the graph and the reference say so.
#include <gtest/gtest.h>

#include "flatdyn/reference/closed_loops.hpp"
#include "functions/planning/formulations.hpp"
#include "proof/verify/verify.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using reference::VectorX;

// Crank and rod in line, and the slider driving: the loop does not say how fast the crank turns.
TEST(SingularLoop, IsSaidSo) {
  std::string text = testing::text_of_robot("slider_crank.toml");
  const std::string dependent = R"(dependent = ["theta_2", "x"])";
  text.replace(text.find(dependent), dependent.size(), R"(dependent = ["theta_1", "theta_2"])");
  const LoadedRobot model = testing::model_of_toml(text);
  const Function motion = derive_function(model.mechanism, "loop_motion");
  EXPECT_EQ(motion.loop_conditions, 1);
  const Function forward = derive_function(model.mechanism, "forward_dynamics");  // its pivot is not compared
  ASSERT_EQ(forward.pivot_scales.size(), forward.validity_conditions.size());
  EXPECT_FALSE(has_scale(forward, 0));
  EXPECT_TRUE(has_scale(forward, forward.validity_conditions.size() - 1));
  GraphEvaluator<double> graph(motion);
  State state;
  state.qd = state.qdd = {1};
  state.q = {0, 0, 0.45};
  EXPECT_FALSE(graph(state).has_value());
  state.q = {1e-7, -1e-7, 0.45};
  EXPECT_FALSE(graph(state).has_value());
  state.q = {1e-4, -1e-4, 0.45};
  EXPECT_TRUE(graph(state).has_value());
  const auto robot = reference_robot<double>(model.robot, {});
  VectorX<double> q(3);
  q << 0.1, 0.1, 0.5;  // farther than the links reach
  const VectorX<double> before = q;
  EXPECT_FALSE(reference::close_loops(robot, q, 1e-12));
  EXPECT_EQ(q, before);
}

// A rod and a rocker of one length: folded onto each other, the rod's axis goes through the rocker's end. Nothing says
// then how far the rod turns, though the columns are at a right angle for all that rounding tells.
TEST(SingularLoop, IsOneWhoseAxisGoesThroughThePoint) {
  const LoadedRobot model = testing::model_of_toml(R"(name = "fold"
gravity = [0, -9.81, 0]
[[link]]
name = "crank"
joint = "a"
mass = 1
com = [0.05, 0, 0]
[[link]]
name = "rod"
joint = "b"
xyz = [0.1, 0, 0]
mass = 1
com = [0.15, 0, 0]
[[link]]
name = "rocker"
joint = "c"
xyz = [0.3, 0, 0]
mass = 1
com = [0.15, 0, 0]
[[loop]]
links = ["rocker", "base"]
from = [0.3, 0, 0]
to = [0.25, 0, 0]
dependent = ["b", "c"]
[assembly]
a = 0.5
b = 1.0
c = -2
)");
  const auto robot = reference_robot<double>(model.robot, {});
  VectorX<double> q(3);
  q << 0.3, 1.5707963267948966, 3.141592653589793;
  EXPECT_LT(reference::loop_regularity(robot, q), 1e-9);
  q << 0.3, 1, -2;
  EXPECT_GT(reference::loop_regularity(robot, q), 0.5);
  std::vector<Function> functions;
  for (const char* name : {"gravity", "inverse_dynamics", "loop_motion"}) {
    functions.push_back(derive_function(model.mechanism, name));
  }
  Progress quiet(true);
  EXPECT_TRUE(verify(model.robot, model.mechanism, functions, {}, quiet).passed());
}

}  // namespace
}  // namespace flatdyn
