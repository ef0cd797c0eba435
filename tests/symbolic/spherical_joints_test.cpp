// SPDX-License-Identifier: GPL-2.0-or-later
// Robots with spherical joints: every function against its definition in exact arithmetic and against the reference,
// Euler's equations, and what the files say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "flatdyn/reference/kinematics.hpp"
#include "functions/deviation/expected.hpp"
#include "functions/exact_proof.hpp"
#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/planning/make_functions.hpp"
#include "graph/count.hpp"
#include "robot/model/spherical_joint.hpp"
#include "robot/model/states.hpp"
#include "support/agreement.hpp"
#include "support/robot_models.hpp"
#include "support/spherical_robots.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/reference_point.hpp"

namespace flatdyn {
namespace {

LoadedRobot of_file(const std::string& file) {
  return load_robot(std::filesystem::path(FLATDYN_SOURCE_DIR) / "docs" / "examples" / file, {});
}

// Two spherical joints, one on the other, at the end of an arm that turns.
constexpr const char* kTwoBalls = R"(
[[link]]
joint = "turn"
xyz = [0.1, 0, 0.2]
mass = 1
com = [0.1, 0.2, 0]
inertia = { xx = 0.1, yy = 0.1, zz = 0.2 }
inertia_about = "com"
[[link]]
joint = "first"
type = "spherical"
xyz = [0.3, 0, 0]
rpy = [0.3, 0.4, 0.5]
mass = 2
com = [0, 0.1, 0.2]
inertia = { xx = 0.1, yy = 0.2, zz = 0.25, xy = 0.01 }
inertia_about = "com"
[[link]]
joint = "second"
type = "spherical"
xyz = [0, 0.3, 0.1]
mass = 1
com = [0.1, 0, 0.3]
inertia = { xx = 0.1, yy = 0.2, zz = 0.25, yz = 0.02 }
inertia_about = "com"
viscous = 0.2
)";

struct SphericalSubject {
  const char* name;
  LoadedRobot (*model)();
  bool has_all_functions;  // whether those on request are looked at, too
};

class SphericalJoints : public ::testing::TestWithParam<SphericalSubject> {
 protected:
  LoadedRobot model_ = GetParam().model();
  const Mechanism& mechanism_ = model_.mechanism;
};

// In each of the ways in which it can be derived.
TEST_P(SphericalJoints, FunctionsAreProven) {
  for (const FunctionRow& row : function_table()) {
    if (!row.applies_to(mechanism_) || (row.traits.on_request && !GetParam().has_all_functions)) continue;
    if (row.traits.uses_task && mechanism_.size() < 6) continue;  // the tip cannot move in all directions
    for (const Grouping grouping : {Grouping::none, Grouping::i_yy}) {
      const Choices choices = uniform_choices(mechanism_, grouping);
      for (FormulationIndex way = 0; way <= row.derivation.alternatives.size(); ++way) {
        const std::optional<Function> function = formulation(mechanism_, row.name, way, choices);
        if (!function) continue;
        const ExactResult result = prove_exactly(mechanism_, *function);
        EXPECT_TRUE(result.equal) << row.name << ", way " << way << ": " << result.summary();
      }
    }
  }
}

TEST_P(SphericalJoints, FunctionsAgreeWithTheReference) {
  Progress silent(true);
  Diagnostics none;
  const ExpectedValues expected(model_.robot, mechanism_, 1);
  for (const OptimisedFunction& made : make_functions(model_, {}, silent, none)) {
    const Function& function = made.function;
    testing::expect_the_reference(expected, mechanism_, function, random_states(mechanism_, 3, 7));
  }
}

// No base parameter is one too many: their columns are independent over some motions.
TEST_P(SphericalJoints, BaseParametersAreIndependent) {
  const std::optional<Function> Y = formulation(mechanism_, "base_regressor", 0, {});
  ASSERT_TRUE(Y);
  const Eigen::Index rows = mechanism_.size(), columns = static_cast<Eigen::Index>(Y->outputs.front().cols);
  GraphEvaluator<double> graph(*Y);
  Eigen::MatrixXd stacked(0, columns);
  for (const State& state : random_states(mechanism_, 60, 3)) {
    const std::optional<std::vector<double>> entries = graph(with_unit_quaternions(mechanism_, state));
    ASSERT_TRUE(entries);
    using ByRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    stacked.conservativeResize(stacked.rows() + rows, columns);
    stacked.bottomRows(rows) = Eigen::Map<const ByRows>(entries->data(), rows, columns);
  }
  EXPECT_EQ(Eigen::FullPivHouseholderQR<Eigen::MatrixXd>(stacked).rank(), columns);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, SphericalJoints,
    ::testing::Values(
        SphericalSubject{"pendulum", [] { return of_file("spherical_pendulum.toml"); }, true},
        SphericalSubject{"wrist", [] { return of_file("ball_wrist.toml"); }, false},
        SphericalSubject{"two", [] { return testing::model_of_toml(kTwoBalls); }, false},
        SphericalSubject{"floating_pendulum",
                         [] { return testing::model_of_toml(std::string(testing::kTrunk) + testing::kHanging); }, true},
        SphericalSubject{"floating", [] { return testing::model_of_toml(std::string(testing::kTrunk) + kTwoBalls); },
                         false}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(SphericalPendulum, CostsWhatEulersEquationsDo) {
  const LoadedRobot model = of_file("spherical_pendulum.toml");
  PipelineOptions options;
  options.functions = {"inverse_dynamics", "inertia_matrix"};
  Progress silent(true);
  Diagnostics none;
  const std::vector<OptimisedFunction> made = make_functions(model, options, silent, none);
  // I ω̇ + ω × I ω with three moments of inertia: 9 products and 6 sums; gravity: two entries of R at the centre of
  // mass; friction.
  EXPECT_LE(count_operations(made[0].function).arithmetic(), 35);
  EXPECT_EQ(count_operations(made[1].function).arithmetic(), 0);
}

TEST(SphericalJoint, HasFourPositionsAndThreeVelocities) {
  const Mechanism mechanism = of_file("ball_wrist.toml").mechanism;
  EXPECT_EQ(mechanism.position_count(), 8);
  EXPECT_EQ(mechanism.size(), 7);
  EXPECT_THAT(mechanism.spherical, ::testing::ElementsAre(2));
  EXPECT_THAT(mechanism.quaternions(), ::testing::ElementsAre(2));
  std::vector<std::string> positions, velocities;
  for (int p = 0; p < mechanism.position_count(); ++p) positions.push_back(mechanism.position_name(p));
  for (const Body& body : mechanism.joints()) velocities.push_back(body.joint);
  EXPECT_THAT(positions, ::testing::ElementsAre("waist", "shoulder", "wrist.qw", "wrist.qx", "wrist.qy", "wrist.qz",
                                                "knuckle", "slide"));
  EXPECT_THAT(velocities,
              ::testing::ElementsAre("waist", "shoulder", "wrist.wx", "wrist.wy", "wrist.wz", "knuckle", "slide"));
}

// |q|² = 1 + e: the rotation is R + e (R - 1).
TEST(SphericalJoint, TurnsTooFarWhereItsQuaternionIsTooLong) {
  const double length = std::sqrt(1 + 1e-3);
  const std::array<double, 4> unit = {0.1, 0.7, -0.1, 0.7};
  std::array<double, 4> longer = unit;
  for (double& entry : longer) entry *= length;
  const auto R = rotation_of_quaternion(unit), found = rotation_of_quaternion(longer);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(found[i][j], R[i][j] + 1e-3 * (R[i][j] - (i == j ? 1 : 0)), 1e-15);
    }
  }
}

}  // namespace
}  // namespace flatdyn
