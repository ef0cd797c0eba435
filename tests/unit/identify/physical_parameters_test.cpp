// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/physical_parameters.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "laboratory/identify/link_shape.hpp"
#include "support/identified_arm.hpp"
#include "support/names.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;
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

TEST(LinkShape, DivergesFromTheFileByNothingThatTheFileDoesNotHave) {
  LinkShape link = some_link();
  link.in_file[1] = false;
  LinkShape::Vector y = LinkShape::Vector::Zero();
  y(kInertialPerBody + 1) = 1;
  link.move(y.data());
  EXPECT_NEAR(link.divergence(), 1 - std::log(2), 1e-14);
  EXPECT_NEAR(link.divergence_from_file(), 0, 1e-14);
  y(kInertialPerBody) = 1;
  link.move(y.data());
  EXPECT_NEAR(link.divergence_from_file(), 1 - std::log(2), 1e-14);
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

// kg m², from the base to the tip; F_v and F_s are as large, in N m s/rad and N m.
constexpr double kRotors[] = {0.6, 0.7, 0.5, 0.4, 0.2, 0.15, 0.1};

Mechanism with_rotors(Mechanism mechanism, double factor) {
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    Body& body = mechanism.bodies[i];
    body.armature = body.viscous = body.coulomb = exact_decimal(fmt::format("{}", factor * kRotors[i]));
  }
  return mechanism;
}

// The links of a rough robot file: some weigh half, some three times as much.
Mechanism with_other_links(Mechanism mechanism) {
  bool is_light = true;
  for (Body& body : mechanism.bodies) {
    const Number factor = is_light ? Number(1) / 2 : Number(3);
    body.inertia.mass = factor * body.inertia.mass;
    body.inertia.first_moment = factor * body.inertia.first_moment;
    for (Vec3& row : body.inertia.inertia) row = factor * row;
    is_light = !is_light;
  }
  return mechanism;
}

// An arm whose file has neither rotors nor friction. The Kinova is there if the folder of real robots is.
class RotorsOfAnArm : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const char* given = std::getenv("FLATDYN_EXTRA_ROBOTS");
    const fs::path sources(FLATDYN_SOURCE_DIR);
    const fs::path extra = given != nullptr ? fs::path(given) : sources / ".." / "shared" / "robots";
    const fs::path own = sources / "robots" / GetParam(), file = fs::exists(own) ? own : extra / GetParam();
    if (!fs::exists(file)) GTEST_SKIP() << "no such file: " << file;
    plain_ = load_robot(file, {}).mechanism;
    truth_ = with_rotors(plain_, 1);
    base_ = base_parameters(truth_);
  }

  VectorXd pi_b_of(const Mechanism& mechanism) const { return values_of(base_values(mechanism, base_)); }

  // The links from π_b of `truth`, known to this share of itself and of 0.1, with `noise` standard deviations of noise.
  PhysicalParameters found(const Mechanism& file, const Mechanism& truth, double share, double noise) const {
    VectorXd pi_b = pi_b_of(truth);
    const VectorXd deviations = share * (pi_b.cwiseAbs().array() + 0.1);
    testing::Uniform draw(3);
    for (Index k = 0; k < pi_b.size(); ++k) pi_b(k) += noise * deviations(k) * draw.normal();
    const PhysicalParameters result = physical_parameters(file, base_, known(pi_b, deviations));
    expect_bodies(result.pi);
    EXPECT_TRUE(result.converged);
    return result;
  }

  Mechanism plain_, truth_;
  BaseParameters base_;
};

constexpr double kExact = 1e-7, kRough = 1e-2;

TEST_P(RotorsOfAnArm, LeaveLinksThatAreRightWhereTheyAreWhenTheFileHasNone) {
  const PhysicalParameters links = found(plain_, truth_, kExact, 0);
  EXPECT_LT(links.largest_misfit, 1e-3);
  EXPECT_LT(links.divergence, 1e-6);
  for (int i = 0; i < truth_.size(); ++i) {
    for (const Parameter which : {Parameter::Im, Parameter::Fv, Parameter::Fs}) {
      const int place = index_of(i, which);
      EXPECT_NEAR(links.pi[static_cast<std::size_t>(place)], kRotors[i], 1e-4 * kRotors[i]) << parameter_name(place);
    }
  }
}

TEST_P(RotorsOfAnArm, AreFoundFromARoughFileThatHasNone) {
  const Mechanism file = with_other_links(plain_);
  EXPECT_LT(found(file, truth_, kExact, 0).largest_misfit, 0.1);
  EXPECT_LT(found(file, truth_, kRough, 1).largest_misfit, 3);
}

TEST_P(RotorsOfAnArm, AreFoundFromARoughFileThatHasOthers) {
  const Mechanism file = with_rotors(with_other_links(plain_), 0.3);
  EXPECT_LT(found(file, truth_, kExact, 0).largest_misfit, 0.1);
  EXPECT_LT(found(file, truth_, kRough, 1).largest_misfit, 3);
}

// Base parameters with a link's inertia in them may go to a rotor by as much as the search gives it to start with.
TEST_P(RotorsOfAnArm, StaySmallWhereThereAreNone) {
  const PhysicalParameters links = found(plain_, plain_, kExact, 0);
  EXPECT_LT(links.largest_misfit, 0.1);
  EXPECT_LT(links.divergence, 1);
  EXPECT_LT(found(plain_, plain_, kRough, 1).largest_misfit, 3);
  const VectorXd pi_b = pi_b_of(plain_);
  for (int row = 0; row < base_.size(); ++row) {
    for (const auto& [place, coefficient] : base_.combination[static_cast<std::size_t>(row)]) {
      if (parameter_of(place) != Parameter::Im) continue;
      EXPECT_LT(links.pi[static_cast<std::size_t>(place)], 0.02 * pi_b(row) + 1e-6) << parameter_name(place);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Arms, RotorsOfAnArm, ::testing::Values("ur5.urdf", "panda.urdf", "strict/kinovaGen3V12.urdf"),
                         testing::name_of_text<const char*>);

// Nothing is known of the last joints: they get no rotors and no friction.
TEST(PhysicalParameters, HaveNoRotorsThatTheMotionDoesNotTell) {
  const LoadedRobot model = testing::model_of("ur5.urdf");
  const BaseParameters base = base_parameters(model.mechanism, ParameterSet::full);
  Estimate estimate = known(values_of(base_values(model.mechanism, base)), VectorXd::Ones(base.size()));
  constexpr int kKnown = 2;  // joints
  for (Index k = 0; k < base.size(); ++k) {
    if (joint_of(base.columns[static_cast<std::size_t>(k)]) >= kKnown) estimate.root_information.col(k).setZero();
  }
  const PhysicalParameters found = physical_parameters(model.mechanism, base, estimate);
  for (int i = kKnown; i < model.mechanism.size(); ++i) {
    for (const Parameter which : {Parameter::Im, Parameter::Fv, Parameter::Fs}) {
      const int place = index_of(i, which);
      EXPECT_LT(found.pi[static_cast<std::size_t>(place)], 1e-8) << parameter_name(place);
    }
  }
}

}  // namespace
}  // namespace flatdyn
