// SPDX-License-Identifier: GPL-2.0-or-later
// The operational space where its task is singular: what is left of a pivot of J B^-1 J^T is then a rounding error, of
// the size of all terms that it is a difference of, and functions report that. Near there they do not.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include "functions/planning/formulations.hpp"
#include "graph/tape.hpp"
#include "proof/verify/compiled.hpp"
#include "robot/model/states.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

using testing::model_of;
using testing::model_of_toml;

// A function of the operational space by flatdyn's instructions and, if it is small, as a graph and compiled.
class OperationalFunction {
 public:
  explicit OperationalFunction(LoadedRobot model, const std::string& name = "operational_inertia")
      : model_(std::move(model)),
        functions_({derive_function(model_.mechanism, name)}),
        tape_(functions_[0]),
        results_(tape_.results()) {
    if (model_.mechanism.size() <= kMostJointsCompiled) compiled_.emplace(model_.mechanism, functions_);
  }

  // Whether the function has a value at q.
  bool holds(const std::vector<double>& q) {
    state_.q = q;
    state_.qd.assign(q.size(), 0.1);
    TapeInputs given;
    given[InputKind::q] = state_.q;
    given[InputKind::qd] = state_.qd;
    const bool holds = tape_.run(given, results_);
    if (compiled_) {
      EXPECT_EQ(!std::isnan(compiled_->call(0, state_)[0]), holds);
      EXPECT_EQ(GraphEvaluator<double>(functions_[0])(state_).has_value(), holds);
    }
    return holds;
  }

  // Holds at how many of 300 random positions that `place` changes.
  template <class Place>
  int count(const Place& place) {
    int held = 0;
    for (State& state : random_states(model_.mechanism, kPositions, 1)) {
      place(state.q);
      held += holds(state.q);
    }
    return held;
  }

  static constexpr int kPositions = 300;

 private:
  static constexpr int kMostJointsCompiled = 3;

  LoadedRobot model_;
  std::vector<Function> functions_;
  Tape tape_;
  std::vector<double> results_;
  std::optional<CompiledFunctions> compiled_;
  State state_;
};

// Near a pose in which the tip of a Puma cannot move along one axis, and cannot turn about another: all of the row of
// J B^-1 J^T is what is left of larger terms.
TEST(SingularTask, IsSeenWhereTwoAreSingularAtOnce) {
  OperationalFunction space(model_of("puma560.toml"));
  const std::vector<std::vector<double>> places = {
      {3.14159267748038, 3.1415926533160796, -1.5704878925850312, 1.5687131862717636, 6.0382274549523954e-09,
       -1.4942182539755537},
      {1.7769198078132842e-06, 3.141592653576192, -1.4304225915892146, -2.3264448102002797, 3.1415926442332918,
       -1.5767658695903945},
      {-8.7671510471668419e-08, -0.65002703305195264, -0.1727812521718024, -2.2682487670784215, 3.1415926535181509,
       2.4348693439976077},
      {-1.0759914565269324e-08, 2.4402388087796902, 2.1634387943915438e-06, 0.89705109651109871,
       -1.6046185494234784e-11, -0.11983089166868355}};
  for (const std::vector<double>& q : places) EXPECT_FALSE(space.holds(q)) << q[0];
}

// One direction has one pivot, and where the tip cannot move along it, that pivot is what is left of larger terms.
TEST(SingularTask, IsSeenWhereItIsOneDirection) {
  LoadedRobot model = model_of_toml(R"(name = "one"
[[link]]
mass = 1
com = [0.2, 0, 0]
[tip]
xyz = [0.3, 0.4, 0]
)");
  model.mechanism.task = {{0}, Orientation::angular_velocity};
  OperationalFunction space(model);
  EXPECT_FALSE(space.holds({-0.92729521800161219}));
  EXPECT_TRUE(space.holds({-0.927295}));
  EXPECT_TRUE(space.holds({0.3}));
}

LoadedRobot planar_3r() { return load_robot(FLATDYN_SOURCE_DIR "/docs/examples/planar_3r.toml", {}); }

// x, y and the rotation of an arm of three links: singular where the first two are in line.
TEST(SingularTask, IsSeenWhereAPlanarArmIsStretched) {
  for (const char* name : {"operational_inertia", "operational_bias"}) {
    OperationalFunction space(planar_3r(), name);
    EXPECT_FALSE(space.holds({0.4, 0, 0}));
    EXPECT_EQ(space.count([](std::vector<double>& q) { q[1] = q[2] = 0; }), 0) << name;
    EXPECT_EQ(space.count([](std::vector<double>& q) { q[1] = 0; }), 0) << name;
    EXPECT_EQ(space.count([](std::vector<double>& q) { q[1] = std::numbers::pi; }), 0) << name;
  }
}

TEST(SingularTask, IsNotSeenNearby) {
  OperationalFunction space(planar_3r());
  for (const double off : {1e-5, -1e-5, 1e-3, 1.0}) {
    EXPECT_TRUE(space.holds({0.4, off, 0}));
    EXPECT_EQ(space.count([off](std::vector<double>& q) { q[1] = off; }), OperationalFunction::kPositions) << off;
  }
}

// A wrist in line, an elbow stretched, and both: rows of J B^-1 J^T are then combinations of all others.
TEST(SingularTask, IsSeenWhereASpatialArmIsInLine) {
  OperationalFunction space(model_of("ur5.urdf"));
  EXPECT_EQ(space.count([](std::vector<double>& q) { q[4] = 0; }), 0);
  EXPECT_EQ(space.count([](std::vector<double>& q) { q[2] = 0; }), 0);
  EXPECT_EQ(space.count([](std::vector<double>& q) { q[2] = q[4] = std::numbers::pi; }), 0);
  EXPECT_EQ(space.count([](std::vector<double>&) {}), OperationalFunction::kPositions);
  EXPECT_GT(space.count([](std::vector<double>& q) { q[4] = 1e-4; }), OperationalFunction::kPositions - 5);
}

// A wrist that tilts by q_1 + 0.3, and turns by q_2 about its own z or x: the last angle of ZYZ, or of roll, pitch and
// yaw.
LoadedRobot wrist(const std::string& axis) {
  return model_of_toml(R"(name = "wrist"
[[link]]
joint = "tilt"
axis = [0, 1, 0]
mass = 1
com = [0.1, 0, 0.1]
[[link]]
joint = "turn"
rpy = [0, 0.3, 0]
mass = 1
com = [0.1, 0.05, 0.1]
axis = )" + axis + "\n");
}

// Where theta is zero, or a quarter turn, rounding leaves some 1e-17 of its sine, or its cosine.
TEST(SingularTask, IsSeenWhereItsAnglesAreSingular) {
  for (const auto& [orientation, axis, theta] : {std::tuple(Orientation::zyz, "[0, 0, 1]", 0.0),
                                                 std::tuple(Orientation::rpy, "[1, 0, 0]", std::numbers::pi / 2)}) {
    LoadedRobot model = wrist(axis);
    model.mechanism.task = {{5}, orientation};
    OperationalFunction space(model);
    EXPECT_FALSE(space.holds({theta - 0.3, 0.2})) << axis;
    for (const double off : {1e-7, -1e-6, 1e-3}) EXPECT_TRUE(space.holds({theta + off - 0.3, 0.2})) << axis << off;
  }
}

}  // namespace
}  // namespace flatdyn
