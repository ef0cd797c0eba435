// SPDX-License-Identifier: GPL-2.0-or-later
// Closed loops: four-bar linkage, slider-crank, five-bar, Andrews' squeezer, and loops in space, cut at a point or
// along an axis; and on floating bases. Their functions against the Lagrangian, against the tree with the forces that
// hold the loops, and against numbers from elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <span>

#include "base/system/temporary_folder.hpp"
#include "flatdyn/reference/closed_loops.hpp"
#include "flatdyn/reference/kinematics.hpp"
#include "functions/deviation/expected.hpp"
#include "functions/exact_proof.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "laboratory/identify/measurement.hpp"
#include "laboratory/trajectory/closed_positions.hpp"
#include "robot/model/assembly.hpp"
#include "robot/model/states.hpp"
#include "support/agreement.hpp"
#include "support/identified_arm.hpp"
#include "support/spatial_loops.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using reference::VectorX;

// A four-bar linkage on a turntable, its plane tilted, its coupler geared to a fan; and a platform that ends in a ball
// joint on a post: three dependent joints about axes of their own.
constexpr const char* kSpatial = R"(name = "spatial"
gravity = [0.3, 0.2, -9.81]
[[link]]
name = "table"
joint = "turn"
xyz = [0.1, 0.2, 0.3]
mass = 2
com = [0.1, 0.1, 0]
inertia = { zz = 0.2 }
inertia_about = "com"
coulomb = 0.3
[[link]]
name = "plate"
joint = "bolt"
type = "fixed"
xyz = [0.2, 0, 0.1]
rpy = [0.5, 0.3, -0.2]
[[link]]
name = "crank"
joint = "crank"
mass = 1
com = [0.1, 0.02, 0]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02, xy = 0.003 }
inertia_about = "com"
viscous = 0.2
motor = { inertia = 1e-4, gear_ratio = 50 }
[[link]]
name = "coupler"
joint = "coupler"
xyz = [0.3, 0, 0]
mass = 0.5
com = [0.2, 0.05, 0.01]
inertia = { zz = 0.01 }
inertia_about = "com"
coulomb = 0.1
[[link]]
name = "fan"
joint = "fan"
xyz = [0.1, 0.1, 0]
mass = 0.2
com = [0.03, 0, 0]
position = "2*coupler - crank"
[[link]]
name = "rocker"
joint = "rocker"
parent = "plate"
xyz = [0.5, 0.05, 0]
mass = 0.7
com = [0.2, 0, 0]
viscous = 0.05
[[link]]
name = "arm"
joint = "arm"
parent = "base"
xyz = [-0.3, 0, 0]
axis = [1, 0.2, 0]
mass = 0.4
com = [0.1, 0, 0]
[[link]]
name = "stick"
joint = "stick"
xyz = [0, 0.4, 0.1]
axis = [0, 1, 0.5]
mass = 0.3
com = [0.1, 0, 0.1]
[[link]]
name = "ram"
joint = "ram"
type = "prismatic"
xyz = [0.1, 0, 0]
axis = [1, 0, 1]
mass = 0.2
[[loop]]
links = ["coupler", "rocker"]
from = [0.5, 0, 0]
to = [0.4, 0, 0]
dependent = ["coupler", "rocker"]
[[loop]]
links = ["ram", "rocker"]
from = [0.2, 0.1, 0]
to = [0.1, 0.3, 0.2]
dependent = ["arm", "stick", "ram"]
[tip]
link = "fan"
xyz = [0.05, 0.02, 0.01]
)";

constexpr const char* kHopperInALoop = "../docs/examples/five_bar_hopper.toml";

// The base of kSpatial as a body that moves freely.
const std::string kFloatingBase = R"([base]
motion = "floating"
mass = 9
com = [0.1, -0.2, 0.05]
inertia = { xx = 0.8, yy = 0.9, zz = 0.7, xy = 0.05, yz = -0.03 }
inertia_about = "com"
)";

LoadedRobot loop_model(const std::string& name) {
  if (name == "hopper") return testing::model_of(kHopperInALoop);
  const std::map<std::string, std::string> written = {{"spatial", kSpatial},
                                                      {"floating_spatial", kSpatial + kFloatingBase},
                                                      {"cut_at_hinge", testing::kCutAtHinge},
                                                      {"cylinders", testing::kCylinders},
                                                      {"spherical", testing::kSphericalFourBar}};
  const auto found = written.find(name);
  return found == written.end() ? testing::model_of(name) : testing::model_of_toml(found->second);
}

class Loops : public ::testing::TestWithParam<const char*> {
 protected:
  const LoadedRobot model_ = loop_model(GetParam());
  const SymbolValues symbols_ = random_symbol_values(model_.robot, 3);
};

bool is_for_loops(const FunctionRow& entry) { return !entry.traits.uses_task; }

TEST_P(Loops, EveryFunctionIsTheLagrangians) {
  for (const FunctionRow& entry : function_table()) {
    if (!is_for_loops(entry) || !entry.applies_to(model_.mechanism)) continue;
    const Function function = derive_function(model_.mechanism, entry.name);
    EXPECT_TRUE(prove_exactly(model_.mechanism, function).equal) << entry.name;
  }
}

// In 50 digits, at positions where the loops are open.
TEST_P(Loops, EveryFunctionIsTheReferences) {
  const ExpectedValues values(model_.robot, model_.mechanism, 7);
  for (const FunctionRow& entry : function_table()) {
    if (!is_for_loops(entry) || !entry.applies_to(model_.mechanism)) continue;
    const Function function = derive_function(model_.mechanism, entry.name);
    std::vector<State> states =
        with_parameters(random_states(model_.mechanism, costs_many_recursions(function) ? 1 : 4, 11), values.symbols());
    draw_own_arguments(states, {&function, 1}, 5);
    testing::expect_the_reference(values, model_.mechanism, function, states);
  }
}

VectorX<double> vector(const std::vector<double>& v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

// The tree with the loops as constraints whose forces are found with the accelerations,
// [B_t Φ_qᵀ; Φ_q 0] [q̈_t; -λ] = [τ_t - n_t; -Φ̇_q q̇]: derivatives of Φ by differences.
TEST_P(Loops, MoveAsTheTreeWithConstraintForces) {
  const auto closed = reference_robot<double>(model_.robot, symbols_);
  auto tree = closed;
  tree.loops.clear();
  const int m = tree.size(), base = tree.base_size();
  const auto gap = [&closed](const VectorX<double>& q) { return reference::loop_closure<double>(closed, q); };
  int compared = 0;
  for (const State& state : random_states(model_.mechanism, 40, 5)) {
    VectorX<double> q = vector(state.q);
    if (!reference::close_loops(closed, q, 1e-13)) continue;
    const VectorX<double> given = vector(state.qd),
                          rates = reference::loop_motion(closed, q) * given.tail(given.size() - base);
    VectorX<double> qd(m);
    qd << given.head(base), rates;
    constexpr double kStep = 1e-5;
    Eigen::MatrixXd Phi = Eigen::MatrixXd::Zero(gap(q).size(), m);
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      const VectorX<double> dq = kStep * VectorX<double>::Unit(q.size(), k);
      Phi.col(base + k) = (gap(q + dq) - gap(q - dq)) / (2 * kStep);
    }
    const double slow = kStep / (1 + rates.norm());
    const VectorX<double> drift =
        (gap(q + 10 * slow * rates) - 2 * gap(q) + gap(q - 10 * slow * rates)) / (100 * slow * slow);
    if (Phi.jacobiSvd().singularValues().minCoeff() < 1e-2 * Phi.norm()) continue;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(m + Phi.rows(), m + Phi.rows());
    K.topLeftCorner(m, m) = reference::inertia_matrix<double>(tree, q);
    K.topRightCorner(m, Phi.rows()) = Phi.transpose();
    K.bottomLeftCorner(Phi.rows(), m) = Phi;
    VectorX<double> right(K.rows());
    right.head(m) = -reference::bias<double>(tree, q, qd);
    const auto entry_of = [&](int a) {
      return a < base ? a : base + closed.independent[static_cast<std::size_t>(a - base)];
    };
    for (int a = 0; a < closed.size(); ++a) right[entry_of(a)] += state.tau[static_cast<std::size_t>(a)];
    right.tail(Phi.rows()) = -drift;
    const VectorX<double> all = K.fullPivLu().solve(right).head(m);
    const VectorX<double> found = reference::forward_dynamics<double>(closed, q, given, vector(state.tau));
    for (int a = 0; a < closed.size(); ++a) EXPECT_NEAR(found[a], all[entry_of(a)], 2e-4 * (1 + all.norm()));
    ++compared;
  }
  EXPECT_GE(compared, 3);
}

INSTANTIATE_TEST_SUITE_P(Robots, Loops,
                         ::testing::Values("slider_crank.toml", "four_bar.toml", "five_bar.toml",
                                           "andrews_squeezer.toml", "spatial", "cut_at_hinge", "cylinders", "spherical",
                                           "hopper", "floating_spatial"),
                         [](const auto& robot) {
                           const std::string name = robot.param;
                           return name.substr(0, name.find('.'));
                         });

// Turns about two more directions, so that a plate turns about any.
constexpr const char* kWrist = R"([[link]]
joint = "pitch"
axis = [1, 0, 0.5]
xyz = [0.05, 0.1, 0]
mass = 0.3
com = [0.1, 0.05, 0.02]
[[link]]
joint = "roll"
axis = [0.3, 1, -0.2]
xyz = [0.05, 0, 0.1]
mass = 0.2
com = [0.01, 0.05, 0.02]
)";

// On a plate that is tilted and moves in space, so that the links have all ten parameters.
std::string carried(const std::string& loop, const std::string& wrist = kWrist) {
  return R"(name = "carried"
gravity = [0.3, -9, 2]
[[link]]
joint = "cart"
type = "prismatic"
axis = [1, 0, 0]
mass = 2
[[link]]
joint = "yaw"
axis = [0, 1, 1]
mass = 1
com = [0.1, 0.05, 0.02]
inertia = { xx = 0.1, yy = 0.12, zz = 0.11, xy = 0.01, xz = 0.003, yz = -0.004 }
inertia_about = "com"
)" + wrist +
         R"([[link]]
name = "plate"
type = "fixed"
xyz = [0.1, 0.02, 0.03]
rpy = [0.3, 0.4, 0.5]
[[link]]
name = "crank"
joint = "t1"
parent = "plate"
mass = 0.4
com = [0.1, 0.01, 0.02]
inertia = { xx = 0.01, yy = 0.012, zz = 0.011, xy = 0.001, xz = 0.0003, yz = -0.0004 }
inertia_about = "com"
[[link]]
name = "coupler"
joint = "t2"
xyz = [0.2, 0, 0]
mass = 0.5
com = [0.2, 0.03, -0.02]
inertia = { xx = 0.04, yy = 0.052, zz = 0.062, xy = 0.001, xz = 0.0003, yz = -0.0004 }
inertia_about = "com"
[[link]]
name = "last"
joint = "t3"
parent = "plate"
xyz = [0.4, 0, 0]
mass = 0.45
com = [0.13, 0.01, 0.02]
inertia = { xx = 0.01, yy = 0.012, zz = 0.011, xy = 0.001, xz = 0.0003, yz = -0.0004 }
inertia_about = "com"
)" + loop;
}

constexpr const char* kPin = R"([[loop]]
links = ["coupler", "last"]
from = [0.45, 0, 0]
to = [0.35, 0, 0]
dependent = ["t2", "t3"]
[assembly]
t1 = 0.9
t2 = -0.5
t3 = 1.2
)";

constexpr const char* kSlide = R"(type = "prismatic"
axis = [1, 0, 0]
[[loop]]
links = ["coupler", "last"]
from = [0.45, 0, 0]
to = [0, 0.05, 0]
dependent = ["t2", "t3"]
[assembly]
t1 = 0.9
t2 = -1.2
)";

// The singular values of Y_b at closed positions so far round the assembly, from the largest down, columns scaled to 1.
Eigen::VectorXd singular_values(const LoadedRobot& model, double range) {
  const Function regressor = derive_function(model.mechanism, "base_regressor");
  const auto columns = static_cast<Eigen::Index>(regressor.outputs[0].cols);
  const auto n = static_cast<std::size_t>(model.mechanism.size());
  GraphEvaluator<double> graph(regressor);
  ClosedPositions closed(model);
  const std::vector<double> assembled = assembled_positions(model.robot, model.mechanism);
  Eigen::MatrixXd stacked(0, columns);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> drawn(-1, 1);
  const auto base = static_cast<std::size_t>(model.mechanism.base_bodies());
  for (int k = 0; k < 60; ++k) {
    State state;
    std::vector<double> q_a;
    for (std::size_t i = 0; i < n; ++i) {
      state.qd.push_back(drawn(random));
      state.qdd.push_back(drawn(random));
      if (i < base) continue;
      const int p = model.mechanism.position_of(static_cast<int>(i));
      q_a.push_back(assembled[static_cast<std::size_t>(p)] + range * drawn(random));
    }
    if (base > 0) state.g_b = {drawn(random), drawn(random), drawn(random)};
    const std::span<const double> q = closed.of(q_a);
    state.q.assign(q.begin(), q.end());
    const std::vector<double> Y = *graph(state);
    stacked.conservativeResize(stacked.rows() + static_cast<Eigen::Index>(n), Eigen::NoChange);
    stacked.bottomRows(static_cast<Eigen::Index>(n)) = Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(
        Y.data(), static_cast<Eigen::Index>(n), columns);
  }
  for (auto column : stacked.colwise()) column.normalize();
  return stacked.jacobiSvd().singularValues();
}

// The number of rows of K beyond the rank.
long rows_too_many(const LoadedRobot& model, double range = 0.2) {
  const Eigen::VectorXd values = singular_values(model, range);
  return (values.array() < 1e-12 * values.maxCoeff()).count();
}

TEST(CarriedLoops, HaveTheRankOfTheirBaseParameters) {
  EXPECT_EQ(rows_too_many(testing::model_of_toml(carried(kPin))), 0);
  EXPECT_EQ(rows_too_many(testing::model_of_toml(carried(kSlide))), 0);
}

// Something that turns about one direction only shows less of a slider's moments: K keeps what that hides
// (docs/loops.md).
TEST(CarriedLoops, KeepWhatOneDirectionHides) {
  EXPECT_EQ(rows_too_many(testing::model_of_toml(carried(kPin, ""))), 0);
  EXPECT_EQ(rows_too_many(testing::model_of_toml(carried(kSlide, ""))), 1);
}

// A pin: the mass, and two products of inertia with its direction.
TEST(CarriedLoops, HideThreeParametersInAPin) {
  const LoadedRobot closed = testing::model_of_toml(carried(kPin));
  const BaseParameters base = base_parameters(closed.mechanism);
  EXPECT_EQ(base.shifts.size(), 3U);
  EXPECT_TRUE(prove_exactly(closed.mechanism, derive_function(closed.mechanism, "base_regressor")).equal);
}

TEST(RobotsWithLoops, HaveTheRankOfTheirBaseParameters) {
  EXPECT_EQ(rows_too_many(testing::model_of("slider_crank.toml"), 3), 0);
  EXPECT_EQ(rows_too_many(testing::model_of("five_bar.toml")), 0);
  EXPECT_EQ(rows_too_many(testing::model_of("andrews_squeezer.toml"), 3), 0);
  EXPECT_EQ(rows_too_many(testing::model_of(kHopperInALoop)), 0);
}

// Which way the axes point to each other where the loop is assembled, is known: masses and their moments along the
// axis, which the cut hides, are three rows, and where it is not known two.
TEST(LoopsAlongAxes, HaveTheRankOfTheirBaseParameters) {
  const std::string loop = carried(testing::kHingeOfCarried);
  const LoadedRobot unknown = testing::model_of_toml(loop), same = testing::model_of_toml(loop + R"([assembly]
t1 = 0.9
t2 = -0.497
t3 = 1.209
u1 = 1.113
u2 = 0.336
u3 = 0.011
)"),
                    opposite = testing::model_of_toml(loop + R"([assembly]
t1 = 0.9
t2 = -1.124
t3 = -0.355
u1 = 1.801
u2 = -1.017
u3 = -2.759
)");
  EXPECT_EQ(same.mechanism.loops[0].sense, 1);
  EXPECT_EQ(opposite.mechanism.loops[0].sense, -1);
  EXPECT_EQ(unknown.mechanism.loops[0].sense, 0);
  EXPECT_EQ(rows_too_many(same), 0);
  EXPECT_EQ(rows_too_many(opposite), 0);
  EXPECT_EQ(base_parameters(unknown.mechanism).columns.size(), base_parameters(same.mechanism).columns.size() + 1);
  EXPECT_EQ(rows_too_many(testing::model_of_toml(testing::kSphericalFourBar)), 0);
}

// Without noise, at positions where the loops are closed: all of π_b, so there K has no parameter too many.
TEST(SliderCrank, IsIdentified) {
  testing::expect_recovery(testing::Arm("slider_crank.toml"), "slider_crank",
                           {.samples = 600, .around = {0.3, -0.4, 0.4}});
}

TEST(FiveBar, IsIdentified) {
  testing::expect_recovery(testing::Arm("five_bar.toml"), "five_bar",
                           {.samples = 600, .amplitude = 0.08, .around = {1.57, -0.71, 1.57, 0.71}});
}

// Its closed loops leave a short way round one position, where some columns are nearly others' combinations.
TEST(AndrewsSqueezer, IsIdentified) {
  testing::expect_recovery(testing::Arm("andrews_squeezer.toml"), "andrews_squeezer",
                           {.samples = 600, .around = {-0.06, 0, 0.455, 0.487, 0.223, 1.23, -0.223}}, 1e-9);
}

// From a log without rates, read as users have them: q of all joints, τ of the crank.
TEST(SliderCrank, IsIdentifiedFromALog) {
  const testing::Arm arm("slider_crank.toml");
  const TemporaryFolder folder;
  testing::write_log(folder.path() / "log.csv",
                     testing::simulated(arm.robot, {.samples = 6000, .rate = 500, .around = {0.3, -0.4, 0.4}}),
                     testing::LogDerivatives::none);
  Progress quiet(true);
  Diagnostics found;
  const Measurement measurement =
      measure(TorqueEquations(arm.torque), arm.robot.mechanism, {folder.path() / "log.csv"}, {}, quiet, found);
  ASSERT_FALSE(found.has_errors());
  const Eigen::VectorXd truth = arm.truth();
  const Estimate estimated = estimate(measurement.observations, Eigen::VectorXd::Zero(truth.size()));
  for (Eigen::Index k = 0; k < truth.size(); ++k) {
    EXPECT_NEAR(estimated.values(k), truth(k), 0.02 * truth.cwiseAbs().maxCoeff()) << k;
  }
}

// x = r cos θ + sqrt(l² - r² sin² θ), and its slope.
TEST(SliderCrank, IsWhereTheTriangleSays) {
  const auto robot = reference_robot<double>(testing::model_of("slider_crank.toml").robot, {});
  for (const double theta : {0.3, 1.2, -2.0, 3.0}) {
    VectorX<double> q(3);
    q << theta, -theta, 0.4;
    ASSERT_TRUE(reference::close_loops(robot, q, 1e-14));
    const double root = std::sqrt(0.09 - 0.0225 * std::pow(std::sin(theta), 2));
    EXPECT_NEAR(q[2], 0.15 * std::cos(theta) + root, 1e-13);
    const double slope = -0.15 * std::sin(theta) * (1 + 0.15 * std::cos(theta) / root);
    EXPECT_NEAR(reference::loop_motion(robot, q)(2, 0), slope, 1e-13);
  }
}

// Initial values of the test set: positions, and the accelerations of the crank and of the rod under the spring and the
// driving torque, 28 digits each.
TEST(AndrewsSqueezer, StartsAsPublished) {
  const LoadedRobot model = testing::model_of("andrews_squeezer.toml");
  const auto robot = reference_robot<Real50>(model.robot, {});
  VectorX<Real50> q(7), qd(1), qdd(1);  // beta, Theta, gamma, delta, Phi, epsilon, Omega
  q << Real50("-0.0617138900142764496358948458001"), 0, Real50("0.455279819163070380255912382449"),
      Real50("0.487364979543842550225598953530"), Real50("0.222668390165885884674473185609"),
      Real50("1.23054744454982119249735015568"), Real50("-0.222668390165885884674473185609");
  qd << 0;
  qdd << Real50("14222.4439199541138705911625887");
  EXPECT_LT(reference::loop_closure(robot, q).norm(), Real50("1e-30"));
  EXPECT_LT(abs(reference::loop_motion(robot, q)(1, 0) * qdd[0] - Real50("-10666.8329399655854029433719415")),
            Real50("1e-22"));
  const reference::Vector3<Real50> pulled =
      reference::Vector3<Real50>(Real50("0.014"), Real50("0.072"), 0) - reference::tip_pose(robot, q).p;
  const Real50 length = pulled.norm();
  reference::Environment<Real50> spring;  // what the tip exerts on it
  spring.f_e = -Real50(4530) * (length - Real50("0.07785")) / length * pulled;
  const VectorX<Real50> tau = reference::inverse_dynamics<Real50>(robot, q, qd, qdd, spring);
  EXPECT_LT(abs(tau[0] - Real50("0.033")), Real50("1e-26"));
}

}  // namespace
}  // namespace flatdyn
