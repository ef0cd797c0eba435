// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/simulate/contact.hpp"

#include <gtest/gtest.h>

#include <random>

namespace flatdyn {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd state_vector(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

MatrixXd pair() {
  MatrixXd B = MatrixXd::Constant(2, 2, 1);
  B.diagonal() = state_vector({2, 3});
  return B;
}

TEST(Contact, HoldsAJointUpToItsDryFriction) {
  const MatrixXd B = MatrixXd::Constant(1, 1, 2);
  const VectorXd coulomb = VectorXd::Constant(1, 3), rest = VectorXd::Zero(1);
  for (const double r : {-3.0, 0.0, 2.9}) {
    const VectorXd torque = VectorXd::Constant(1, r);
    const Contacts contacts = decided_contacts(B, torque, coulomb, rest, {0});
    EXPECT_TRUE(contacts[0].held);
    const ContactMotion motion = motion_of(B, torque, coulomb, contacts);
    EXPECT_EQ(motion.qdd(0), 0);
    EXPECT_EQ(motion.lambda(0), -r);
  }
  for (const double r : {-5.0, 5.0}) {
    const VectorXd torque = VectorXd::Constant(1, r);
    const Contacts contacts = decided_contacts(B, torque, coulomb, rest, {0});
    EXPECT_EQ(contacts[0].sliding, r > 0 ? 1 : -1);
    EXPECT_DOUBLE_EQ(motion_of(B, torque, coulomb, contacts).qdd(0), r > 0 ? 1 : -1);
  }
}

// The other joint's motion drags a joint that its own torque would not move.
TEST(Contact, DecidesUponCoupledJointsTogether) {
  const VectorXd coulomb = state_vector({0.5, 0}), r = state_vector({0, 6});
  const Contacts contacts = decided_contacts(pair(), r, coulomb, VectorXd::Zero(2), {0, 0});
  EXPECT_FALSE(contacts[0].held);
  EXPECT_EQ(contacts[0].sliding, -1);
  EXPECT_FALSE(contacts[1].held);
  EXPECT_EQ(contacts[1].sliding, 0);  // it has no dry friction
}

TEST(Contact, AStopPushesAndNeverPulls) {
  const MatrixXd B = MatrixXd::Identity(1, 1);
  const VectorXd none = VectorXd::Zero(1);
  EXPECT_TRUE(decided_contacts(B, VectorXd::Constant(1, -2), none, none, {-1})[0].held);
  EXPECT_FALSE(decided_contacts(B, VectorXd::Constant(1, 2), none, none, {-1})[0].held);
  EXPECT_TRUE(decided_contacts(B, VectorXd::Constant(1, 2), none, none, {1})[0].held);
}

TEST(Contact, AnImpactTakesTheSpeedThatGoesThroughTheStopAndSharesTheRest) {
  const VectorXd before = state_vector({-1, 0}), after = speeds_after_impact(pair(), before, {-1, 0});
  EXPECT_EQ(after(0), 0);
  EXPECT_NEAR(after(1), -1.0 / 3, 1e-15);  // B q̇ is kept along the other joint: 1·(−1) = 3·q̇_2
  EXPECT_EQ(speeds_after_impact(pair(), -before, {-1, 0}), -before);
}

// Coulomb's law, for random arms: holding forces stay within F_s, and sliding is opposed by all of it.
TEST(Contact, KeepsCoulombsLaw) {
  std::mt19937 engine(1);
  std::normal_distribution<double> normal;
  const auto random = [&](int rows, int cols) {
    MatrixXd values(rows, cols);
    for (double& value : values.reshaped()) value = normal(engine);
    return values;
  };
  int held = 0, sliding = 0;
  for (int k = 0; k < 300; ++k) {
    const int n = 1 + k % 8;
    const MatrixXd A = random(n, n), B = A * A.transpose() + 0.1 * MatrixXd::Identity(n, n);
    const VectorXd r = random(n, 1), coulomb = random(n, 1).cwiseAbs();
    const Contacts contacts =
        decided_contacts(B, r, coulomb, VectorXd::Zero(n), std::vector<int>(static_cast<std::size_t>(n)));
    const ContactMotion motion = motion_of(B, r, coulomb, contacts);
    EXPECT_LE((B * motion.qdd - r - motion.lambda).norm(), 1e-11 * (1 + r.norm()));
    for (int i = 0; i < n; ++i) {
      const JointContact& contact = contacts[static_cast<std::size_t>(i)];
      (contact.held ? held : sliding) += 1;
      EXPECT_LE(std::abs(motion.lambda(i)), coulomb(i) * (1 + 1e-9));
      EXPECT_LE(motion.qdd(i) * motion.lambda(i), 1e-12);
    }
  }
  EXPECT_GT(held, 100);
  EXPECT_GT(sliding, 100);
}

}  // namespace
}  // namespace flatdyn
