// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters of random trees: from regrouping, from samples in prime fields, and from the numeric rank of the
// reference's regressor in 50 digits.
#include "derivation/parameters/base_parameters.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "support/names.hpp"
#include "support/robot_models.hpp"
#include "support/robots.hpp"
#include "support/written_model.hpp"
#include "truth/definition/sampled_base.hpp"
#include "truth/reference/regressor_by_columns.hpp"

namespace flatdyn {
namespace {

using Matrix = reference::MatrixX<Real50>;

// The rank of Y sampled in 50 digits: of the columns in `set`, or of Y_b.
Eigen::Index numeric_rank(const Robot& robot, const Mechanism& mechanism, RegressorColumns kind,
                          const std::vector<bool>& columns) {
  const SymbolValues symbols = random_symbol_values(robot, 1);
  const RegressorReference<Real50> reference(mechanism, reference_robot<Real50>(robot, symbols), symbols, kind);
  const auto wanted = static_cast<Eigen::Index>(std::count(columns.begin(), columns.end(), true));
  const int states = 2 + 2 * static_cast<int>(wanted) / std::max(1, mechanism.size());
  Matrix stacked(states * mechanism.size(), wanted);
  Eigen::Index row = 0;
  for (const State& state : random_states(mechanism, states, 3)) {
    const Matrix Y = reference.matrix(widened<Real50>(state));
    Eigen::Index col = 0;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k]) stacked.col(col++).segment(row, Y.rows()) = Y.col(static_cast<Eigen::Index>(k));
    }
    row += Y.rows();
  }
  Eigen::ColPivHouseholderQR<Matrix> qr(stacked);
  qr.setThreshold(Real50("1e-35"));
  return qr.rank();
}

void expect_three_ways(const Robot& robot, const Mechanism& mechanism, ParameterSet set) {
  const BaseParameters base = base_parameters(mechanism, set);
  const SampledComparison sampled = compare_with_samples(mechanism, base, set);
  EXPECT_TRUE(sampled.equal) << mechanism.name << ": " << base.size() << ", sampled " << sampled.rank;
  EXPECT_EQ(numeric_rank(robot, mechanism, RegressorColumns::all, parameters_in(mechanism, set)), base.size())
      << mechanism.name;
}

class RandomTrees : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomTrees, HaveTheSameBaseParametersThreeWays) {
  const Robot robot = testing::random_tree(GetParam(), 5, GetParam() % 2 == 0);
  const Mechanism mechanism = make_mechanism(robot);
  expect_three_ways(robot, mechanism, ParameterSet::full);
  expect_three_ways(robot, mechanism, ParameterSet::inertial);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomTrees, ::testing::Range(1u, 25u));

// A joint whose z axis is turned from the base's by roll and pitch.
struct Placed {
  JointType type;
  Number pitch, roll;
};

// A chain in which each joint is turned from the base's axes as given, so that equal ones are parallel; lengths and
// inertias are generic. The turn is made of two parts and undone by one, so that individually rational cosines and
// sines do not cancel.
Robot placed_chain(const std::vector<Placed>& joints) {
  testing::Numbers numbers(4);
  Robot robot;
  robot.name = "placed";
  robot.links.push_back({"base", {}, {}});
  robot.root = 0;
  robot.gravity = {0, 0, -10};
  const auto about_x = Displacement::Kind::rotation_x, about_y = Displacement::Kind::rotation_y;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string n = std::to_string(i + 1);
    robot.links.push_back(
        testing::link("link" + n, numbers.positive(), numbers.vector(), testing::real_tensor(numbers)));
    const Number third = joints[i].roll / 3;
    const Pose origin{{testing::translation(numbers.vector()), testing::rotation(about_y, joints[i].pitch),
                       testing::rotation(about_x, third), testing::rotation(about_x, joints[i].roll - third)},
                      {}};
    const int parent = static_cast<int>(i);
    robot.joints.push_back(testing::joint("joint" + n, joints[i].type, parent, parent + 1, origin, {0, 0, 1}));
    robot.joints.back().link_offset.displacements = {testing::rotation(about_x, -joints[i].roll),
                                                     testing::rotation(about_y, -joints[i].pitch)};
  }
  robot.tip = static_cast<int>(joints.size());
  return robot;
}

constexpr auto kTurn = JointType::revolute, kSlide = JointType::prismatic;

// Orientations of the joints of a chain; axes that are parallel there must be parallel in exact numbers, too.
std::vector<std::vector<Placed>> oblique_slides() {
  const Number a = exact_decimal("0.3"), b = exact_decimal("-0.8"), c = exact_decimal("1.1"), quarter = GiNaC::Pi / 2;
  const Placed turn{kTurn, 0, 0}, slide{kSlide, a, b};
  return {{turn, slide, turn},
          {turn, slide, turn, turn},
          {turn, slide, turn, slide, turn},
          {turn, slide, slide, turn},
          {turn, {kSlide, 0, a}, {kSlide, 0, c}, turn},
          {turn, {kSlide, 0, a}, {kSlide, 0, b}, {kSlide, 0, c}, turn},
          {turn, slide, {kTurn, GiNaC::Pi, 0}},
          {{kTurn, a, c}, slide, {kTurn, a, c}},
          {{kTurn, a, c}, {kTurn, b, 0}, slide, {kTurn, b, 0}, turn},
          {slide, turn, slide, turn},
          {turn, {kSlide, quarter, a}, {kSlide, quarter, c}, turn},
          {turn, {kSlide, quarter, a}, {kSlide, quarter, c}, {kSlide, quarter, b}, turn},
          {turn, {kSlide, quarter, a}, {kTurn, quarter, c}, turn},
          {turn, {kSlide, 0, a}, {kTurn, 0, quarter}},
          {{kTurn, 0, b}, {kSlide, 0, a}, {kTurn, 0, b - quarter}},
          {{kTurn, a, c}, {kSlide, a, b}, {kTurn, a, c + quarter}}};
}

class ObliqueSlides : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ObliqueSlides, HaveTheSameBaseParametersThreeWays) {
  const Robot robot = placed_chain(oblique_slides()[GetParam()]);
  const Mechanism mechanism = make_mechanism(robot);
  expect_three_ways(robot, mechanism, ParameterSet::full);
  expect_three_ways(robot, mechanism, ParameterSet::inertial);
}

INSTANTIATE_TEST_SUITE_P(Chains, ObliqueSlides, ::testing::Range(std::size_t{0}, oblique_slides().size()));

// Arms of revolute and prismatic joints, some of which follow an earlier one, with friction here and there. The torque
// of a last prismatic joint depends on few parameters.
std::string coupled_arm(unsigned seed) {
  std::mt19937 engine(seed);
  const auto one_of = [&engine](const auto&... choices) {
    const std::array all{std::string(choices)...};
    return all[engine() % all.size()];
  };
  std::string text = "name = \"coupled\"\n";
  std::string leader;
  const unsigned links = 2 + seed % 3;
  for (unsigned i = 0; i < links; ++i) {
    const std::string joint = fmt::format("j{}", i);
    const bool follows = !leader.empty() && engine() % 2 == 0 && i + 1 < links;
    text += fmt::format(
        "[[link]]\njoint = \"{}\"\ntype = \"{}\"\naxis = {}\nxyz = [{}, 0.1, {}]\nmass = 1\ncom = [0.1, 0.02, 0.03]\n"
        "inertia = {{ xx = 0.1, yy = 0.12, zz = 0.14 }}\ninertia_about = \"com\"\n{}{}",
        joint, i + 1 == links ? "prismatic" : one_of("revolute", "revolute", "prismatic"),
        one_of("[0, 0, 1]", "[0, 1, 0]", "[1, 0, 0]", "[0.6, 0.8, 0]", "[0, -0.28, 0.96]"), one_of("0", "0.3"),
        one_of("0", "0.2"), one_of("", "viscous = 0.3\n"), one_of("", "coulomb = 0.2\n"));
    if (follows) text += fmt::format("position = \"{}*{}\"\n", one_of("1", "-1", "2"), leader);
    if (!follows) leader = joint;
  }
  return text;
}

class CoupledArms : public ::testing::TestWithParam<unsigned> {};

TEST_P(CoupledArms, HaveTheSameBaseParametersThreeWays) {
  const LoadedRobot model = testing::model_of_toml(coupled_arm(GetParam()));
  SCOPED_TRACE(coupled_arm(GetParam()));
  expect_three_ways(model.robot, model.mechanism, ParameterSet::given);
  expect_three_ways(model.robot, model.mechanism, ParameterSet::inertial);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CoupledArms, ::testing::Range(1u, 41u));

class RobotsOfTheRepository : public ::testing::TestWithParam<const char*> {};

TEST_P(RobotsOfTheRepository, HaveTheRankOfFiftyDigits) {
  const LoadedRobot model = testing::model_of(GetParam());
  expect_three_ways(model.robot, model.mechanism, ParameterSet::full);
}

TEST_P(RobotsOfTheRepository, HaveABaseRegressorOfFullColumnRank) {
  const LoadedRobot model = testing::model_of(GetParam());
  const int b = base_parameters(model.mechanism).size();
  EXPECT_EQ(numeric_rank(model.robot, model.mechanism, RegressorColumns::base,
                         std::vector<bool>(static_cast<std::size_t>(b), true)),
            b);
}

TEST_P(RobotsOfTheRepository, HaveTheRankOfFiftyDigitsOnATiltedBase) {
  LoadedRobot model = testing::model_of(GetParam());
  model.robot.gravity = {3, 4, -12};
  expect_three_ways(model.robot, make_mechanism(model.robot), ParameterSet::inertial);
}

INSTANTIATE_TEST_SUITE_P(Files, RobotsOfTheRepository,
                         ::testing::Values("panda.urdf", "ur5.urdf", "puma560.toml", "rx90.toml", "scara.toml",
                                           "planar_2r.toml", "cartesian_2.toml", "prismatic_revolute.toml",
                                           "quadruped12.urdf"),
                         testing::name_of_text<const char*>);

}  // namespace
}  // namespace flatdyn
