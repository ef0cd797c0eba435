// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/physical_parameters.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "identify/link_shape.hpp"
#include "support/identified_arm.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd values_of(const std::vector<Number>& numbers) {
  VectorXd values(static_cast<Index>(numbers.size()));
  for (std::size_t k = 0; k < numbers.size(); ++k) values(static_cast<Index>(k)) = nearest_double(numbers[k]);
  return values;
}

VectorXd base_of(const BaseParameters& base, const std::vector<double>& pi) {
  VectorXd result = VectorXd::Zero(base.size());
  for (int row = 0; row < base.size(); ++row) {
    for (const auto& [index, coefficient] : base.combination[static_cast<std::size_t>(row)]) {
      result(row) += nearest_double(coefficient) * pi[static_cast<std::size_t>(index)];
    }
  }
  return result;
}

void expect_bodies(const std::vector<double>& pi) {
  for (std::size_t at = 0; at < pi.size(); at += kParametersPerJoint) {
    EXPECT_GT(pi[at], 0) << "mass of link " << at / kParametersPerJoint + 1;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(pseudo_inertia(&pi[at]));
    EXPECT_GT(eigen.eigenvalues().minCoeff(), 0) << "link " << at / kParametersPerJoint + 1;
  }
}

// An estimate in which every base parameter is known by itself, with this standard deviation.
Estimate known(const VectorXd& pi_b, const VectorXd& deviations) {
  Estimate estimate;
  estimate.values = pi_b;
  estimate.root_information = deviations.cwiseInverse().asDiagonal();
  return estimate;
}

TEST(PseudoInertia, IsThatOfPointMasses) {
  // Masses of 2 and 3 kg at (1, 0, 0) and (0, 2, 1).
  const double ten[] = {5, 2, 6, 3, 3 * 5, 0, 0, 2 + 3, -6, 2 + 3 * 4};
  const Eigen::Matrix4d P = pseudo_inertia(ten);
  Eigen::Matrix4d expected = Eigen::Matrix4d::Zero();
  for (const auto& [mass, point] : {std::pair{2.0, Eigen::Vector4d{1, 0, 0, 1}}, {3.0, Eigen::Vector4d{0, 2, 1, 1}}}) {
    expected += mass * point * point.transpose();
  }
  EXPECT_LT((P - expected).norm(), 1e-14);
}

LinkShape some_link() {
  LinkShape link;
  link.L << 0.3, 0, 0, 0, 0.1, 0.2, 0, 0, 0, 0.05, 0.4, 0, 0.2, -0.3, 0.1, 1.5;
  for (double& other : link.others) other = 0.5;
  return link;
}

// A y such that E + sym(y) is safely positive definite.
LinkShape::Vector some_move() {
  LinkShape::Vector y;
  y << 0.3, -0.1, 0.2, 0.15, 0.05, -0.4, 0.1, 0.2, -0.05, 0.6, 0.3, -0.2, 1;
  return y;
}

LinkShape::Vector parameters_of(const LinkShape& link) {
  LinkShape::Vector pi;
  link.parameters(pi.data());
  return pi;
}

TEST(LinkShape, TwiceAsHeavyDivergesBy1_2) {
  LinkShape link = some_link();
  LinkShape::Vector y = LinkShape::Vector::Zero();
  coordinates_of(Eigen::Matrix4d::Identity(), y.data());
  const LinkShape::Vector before = parameters_of(link);
  link.move(y.data());
  EXPECT_LT((parameters_of(link) - 2 * before).head(kInertialPerBody).norm(), 1e-14);
  EXPECT_NEAR(link.divergence(), 4 * (1 - std::log(2)), 1e-14);
  EXPECT_NEAR(link.divergence(), 1.2, 0.05);
}

TEST(LinkShape, MovesByWhatItsChangesSay) {
  LinkShape link = some_link();
  link.move(some_move().data());
  const LinkShape::Vector before = parameters_of(link), y = -0.5 * some_move();
  const LinkShape::Vector expected = before + link.changes() * y;
  link.move(y.data());
  EXPECT_LT((parameters_of(link) - expected).norm(), 1e-14);
}

TEST(LinkShape, GradientIsThatOfItsDivergence) {
  LinkShape link = some_link();
  link.move(some_move().data());
  constexpr double kStep = 1e-5;
  for (int k = 0; k < kParametersPerJoint; ++k) {
    const LinkShape::Vector step = kStep * LinkShape::Vector::Unit(k), back = -step;
    LinkShape plus = link, minus = link;
    plus.move(step.data());
    minus.move(back.data());
    EXPECT_NEAR((plus.divergence() - minus.divergence()) / (2 * kStep), link.gradient()(k), 1e-8) << k;
    EXPECT_NEAR((plus.divergence() - 2 * link.divergence() + minus.divergence()) / (kStep * kStep), 1, 1e-4) << k;
  }
}

// With the file's own π_b, nothing has to move.
TEST(PhysicalParameters, OfTheFilesOwnBaseParametersAreTheFiles) {
  const LoadedRobot model = testing::model_of("panda.urdf");
  const BaseParameters base = base_parameters(model.mechanism);
  const VectorXd pi_b = values_of(base_values(model.mechanism, base));
  const PhysicalParameters found =
      physical_parameters(model.mechanism, base, known(pi_b, 1e-3 * pi_b.cwiseAbs().cwiseMax(1e-6)));
  expect_bodies(found.pi);
  EXPECT_LT(found.largest_misfit, 1e-3);
  EXPECT_LT(found.divergence, 1e-3);
}

TEST(PhysicalParameters, AreTheFilesWhereNothingIsKnown) {
  const LoadedRobot model = testing::model_of("ur5.urdf");
  const BaseParameters base = base_parameters(model.mechanism);
  Estimate nothing;
  nothing.values = VectorXd::Ones(base.size());
  nothing.root_information = MatrixXd(0, base.size());
  const PhysicalParameters found = physical_parameters(model.mechanism, base, nothing);
  expect_bodies(found.pi);
  EXPECT_EQ(found.largest_misfit, 0);
  EXPECT_LT(found.divergence, 1e-9);
}

// The masses are those of another robot: physically consistent links agree with its π_b.
TEST(PhysicalParameters, MeetBaseParametersFarFromTheFile) {
  const LoadedRobot truth = testing::model_of("panda.urdf");
  const BaseParameters base = base_parameters(truth.mechanism);
  const VectorXd pi_b = values_of(base_values(truth.mechanism, base));
  Mechanism wrong = truth.mechanism;
  for (Body& body : wrong.bodies) {
    body.inertia.mass = 1;
    body.inertia.first_moment = zero_vector();
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) body.inertia.inertia[i][j] = i == j ? Number(1) / 100 : Number(0);
    }
  }
  const VectorXd deviations = 1e-3 * pi_b.cwiseAbs() + VectorXd::Constant(pi_b.size(), 1e-5);
  const PhysicalParameters found = physical_parameters(wrong, base, known(pi_b, deviations));
  expect_bodies(found.pi);
  EXPECT_TRUE(found.converged);
  EXPECT_LT((base_of(base, found.pi) - pi_b).cwiseQuotient(deviations).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_GT(found.divergence, 0.1);
}

// No body has a negative moment of inertia: the nearest consistent one is found, and the misfit is reported.
TEST(PhysicalParameters, AreBodiesEvenIfBaseParametersAreNot) {
  const LoadedRobot model = testing::model_of("planar_2r_example_7_2.toml");
  const BaseParameters base = base_parameters(model.mechanism, ParameterSet::inertial);
  VectorXd pi_b = values_of(base_values(model.mechanism, base));
  ASSERT_EQ(parameter_name(base.columns.at(5)), "I2zz");
  pi_b(5) = -0.2;
  const PhysicalParameters found =
      physical_parameters(model.mechanism, base, known(pi_b, VectorXd::Constant(pi_b.size(), 0.01)));
  expect_bodies(found.pi);
  EXPECT_TRUE(found.converged);
  EXPECT_GT(found.largest_misfit, 10);
}

// Only one joint moves, and the file's masses are wrong: the links agree with all that this motion tells.
TEST(PhysicalParameters, AgreeWithAllThatAPoorMotionTells) {
  const testing::Arm arm("puma560.toml");
  Mechanism wrong = arm.robot.mechanism;
  for (Body& body : wrong.bodies) body.inertia.mass = body.inertia.mass + 1;
  const Observations observations =
      arm.observed(testing::simulated(arm.robot, {.samples = 500, .noise = 0.1, .moving = false}));
  const Estimate found = estimate(observations, values_of(base_values(wrong, arm.torque.base())));
  ASSERT_FALSE(found.damped.empty());
  const PhysicalParameters bodies = physical_parameters(wrong, arm.torque.base(), found);
  expect_bodies(bodies.pi);
  EXPECT_LT(bodies.largest_misfit, 1);
  const VectorXd pi_b = base_of(arm.torque.base(), bodies.pi);
  for (const JointObservations& joint : observations.joints) EXPECT_LT(joint.rms_residual(pi_b), 0.2);
}

// Slender rods are almost flat bodies, and the file from which the search starts has thick ones.
TEST(PhysicalParameters, OfSlenderRodsAreFound) {
  const testing::Arm arm("finger.toml");
  Mechanism thick = arm.robot.mechanism;
  for (Body& body : thick.bodies) {
    for (std::size_t i = 0; i < 3; ++i) body.inertia.inertia[i][i] = body.inertia.inertia[i][i] + Number(1) / 100000;
  }
  const VectorXd truth = values_of(dynamic_parameters(arm.robot.mechanism));
  const Observations observations = arm.observed(testing::simulated(arm.robot, {.samples = 400}));
  const Estimate known = estimate(observations, VectorXd::Zero(arm.torque.parameters()));
  for (const Mechanism& start : {arm.robot.mechanism, thick}) {
    const PhysicalParameters found = physical_parameters(start, arm.torque.base(), known);
    expect_bodies(found.pi);
    EXPECT_TRUE(found.converged);
    EXPECT_LT(found.largest_misfit, 0.1);
    const auto last = static_cast<Index>(found.pi.size()) - kParametersPerJoint;
    const Eigen::Map<const VectorXd> pi(found.pi.data(), last + kParametersPerJoint);
    EXPECT_LT((pi - truth).segment(last + 4, 6).cwiseAbs().maxCoeff(), 1e-9);
  }
}

// A link that consists almost only of the rotor that it carries is physically consistent without it, too.
TEST(PhysicalParameters, LeaveABodyWhenRotorsAreTakenOut) {
  const LoadedRobot model = testing::model_of("planar_2r_example_7_2.toml");
  Mechanism light = model.mechanism;
  const std::size_t carrier = 0, joint = 1;
  ASSERT_EQ(light.bodies[joint].rotor->carrier, static_cast<int>(carrier));
  const BaseParameters base = base_parameters(light);
  VectorXd pi_b = values_of(base_values(light, base));
  const auto rotor = std::find(base.columns.begin(), base.columns.end(), index_of(1, Parameter::Im));
  ASSERT_NE(rotor, base.columns.end());
  pi_b(std::distance(base.columns.begin(), rotor)) = 20;  // kg m², ten times the link's
  const PhysicalParameters found = physical_parameters(light, base, known(pi_b, 1e-3 * pi_b.cwiseAbs().cwiseMax(1e-3)));
  std::vector<double> body(found.pi.begin(), found.pi.begin() + kInertialPerBody);
  const double I_m = found.pi[static_cast<std::size_t>(index_of(1, Parameter::Im))];
  EXPECT_NEAR(I_m, 20, 0.5);
  body[static_cast<std::size_t>(Parameter::Izz)] -= I_m;  // its axis is z
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(pseudo_inertia(body.data()));
  EXPECT_GT(eigen.eigenvalues().minCoeff(), 0);
}

}  // namespace
}  // namespace flatdyn
