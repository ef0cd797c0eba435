// SPDX-License-Identifier: GPL-2.0-or-later
// Generated functions with Eigen's types, beside the same functions with plain arrays.
#include "flatdyn/eigen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "five_bar.hpp"
#include "panda.hpp"
#include "planar_2r.hpp"

namespace flatdyn {
namespace {

namespace arm = panda::functions;
using JointVector = Eigen::Matrix<double, 7, 1>;

const JointVector kQ = JointVector::LinSpaced(-0.9, 1.1), kQd = JointVector::LinSpaced(0.7, -0.8),
                  kQdd = JointVector::LinSpaced(0.2, 2.1);

// Entry (i, j) of a matrix of either order is the function's entry columns * i + j.
template <class Matrix>
void expect_rows(const Matrix& matrix, const std::vector<double>& rows) {
  ASSERT_EQ(static_cast<std::size_t>(matrix.size()), rows.size());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      EXPECT_EQ(matrix(i, j), rows[static_cast<std::size_t>(matrix.cols() * i + j)]) << i << ", " << j;
    }
  }
}

template <class Function, class Matrix>
void expect_both_orders(const std::vector<double>& rows) {
  const auto by_columns = eigen<Function>(kQ);
  const auto by_rows = eigen<Function, Eigen::RowMajor>(kQ);
  static_assert(std::is_same_v<decltype(by_columns), const Matrix>);
  static_assert(decltype(by_rows)::IsRowMajor && !decltype(by_columns)::IsRowMajor);
  expect_rows(by_columns, rows);
  expect_rows(by_rows, rows);
}

TEST(InEigen, MatricesAreOfTheFunctionsShapeInEitherOrder) {
  std::vector<double> B(49), J(42), c(196);
  panda::inertia_matrix(kQ.data(), B.data());
  panda::jacobian(kQ.data(), J.data());
  panda::christoffel(kQ.data(), c.data());
  expect_both_orders<arm::inertia_matrix, Eigen::Matrix<double, 7, 7>>(B);
  expect_both_orders<arm::jacobian, Eigen::Matrix<double, 6, 7>>(J);
  expect_both_orders<arm::christoffel, Eigen::Matrix<double, 7, 28>>(c);
}

// With data(), this is a silent mistake: J is not its transpose.
TEST(InEigen, JacobianTimesRatesIsTheTwist) {
  const Eigen::Matrix<double, 6, 1> twist = eigen<arm::jacobian>(kQ) * kQd;
  const double h = 1e-6;
  const auto [R, p] = eigen<arm::forward_kinematics>(kQ);
  const auto [R_next, p_next] = eigen<arm::forward_kinematics>(kQ + h * kQd);
  EXPECT_LT((twist.head<3>() - (p_next - p) / h).norm(), 1e-5);
  EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_GT(twist.head<3>().norm(), 0.1);
}

TEST(InEigen, ChristoffelSymbolsGiveTheCoriolisMatrix) {
  const auto c = eigen<arm::christoffel>(kQ);
  const auto C = eigen<arm::coriolis_matrix>(kQ, kQd);
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) {
      double sum = 0;
      for (int k = 0; k < 7; ++k) sum += c(i, std::max(j, k) * (std::max(j, k) + 1) / 2 + std::min(j, k)) * kQd[k];
      EXPECT_NEAR(C(i, j), sum, 1e-13);
    }
  }
}

TEST(InEigen, NumbersAndVectorsComeAsTheyAre) {
  const auto B = eigen<arm::inertia_matrix>(kQ);
  const double energy = eigen<arm::kinetic_energy>(kQ, kQd);
  EXPECT_NEAR(energy, 0.5 * kQd.dot(B * kQd), 1e-13);
  const JointVector tau = eigen<arm::inverse_dynamics>(kQ, kQd, kQdd);
  EXPECT_LT((tau - B * kQdd - eigen<arm::bias>(kQ, kQd)).norm(), 1e-12);
  const std::optional<JointVector> solved = eigen<arm::forward_dynamics>(kQ, kQd, tau);
  ASSERT_TRUE(solved);
  EXPECT_LT((*solved - kQdd).norm(), 1e-10);
}

// Expressions, parts of longer vectors, and vectors of a Map; in float.
TEST(InEigen, TakesWhatHasTheLength) {
  const JointVector g = eigen<arm::gravity>(kQ);
  Eigen::VectorXd longer = Eigen::VectorXd::Constant(9, 5.0);
  longer.segment<7>(1) = kQ;
  EXPECT_EQ(eigen<arm::gravity>(longer.segment<7>(1)), g);
  EXPECT_EQ(eigen<arm::gravity>(Eigen::Map<const JointVector>(longer.data() + 1)), g);
  EXPECT_EQ(eigen<arm::gravity>(2.0 * kQ - kQ), eigen<arm::gravity>(JointVector(2.0 * kQ - kQ)));
  const Eigen::Matrix<double, 9, 9> wide = longer.asDiagonal();
  EXPECT_EQ(eigen<arm::gravity>(wide.diagonal().segment<7>(1)), g);
  const Eigen::Matrix<float, 7, 1> in_float = eigen<arm::gravity>(kQ.cast<float>());
  EXPECT_LT((in_float.cast<double>() - g).norm(), 1e-4);
}

// Parameters come first, sines and cosines last; false gives no value.
TEST(InEigen, HandsOnWhatIsNoVector) {
  namespace planar = planar_2r::functions;
  planar_2r::Parameters<> parameters{};
  const Eigen::Vector2d q(0.3, -0.4), zero(0, 0), sine = q.array().sin(), cosine = q.array().cos();
  EXPECT_FALSE(eigen<planar::forward_dynamics>(parameters, q, zero, zero));
  parameters.g = parameters.a_1 = parameters.l_1 = parameters.m_l1 = parameters.m_l2 = parameters.l_2 = 1;
  const Eigen::Vector2d g = eigen<planar::gravity>(parameters, q);
  EXPECT_NE(g[1], 0);
  const planar_2r::GivenSinCos<double> given{sine.data(), cosine.data()};
  EXPECT_EQ(eigen<planar::gravity>(parameters, Eigen::Vector2d(9, 9), given), g);
  EXPECT_TRUE(eigen<planar::forward_dynamics>(parameters, q, zero, g));
}

// q is longer than qd if loops are closed.
TEST(InEigen, KnowsTheLengthsOfClosedLoops) {
  Eigen::Matrix<double, five_bar::position_count, 1> q = Eigen::Matrix<double, five_bar::position_count, 1>::Zero();
  const auto phi = eigen<five_bar::functions::loop_closure>(q);
  std::vector<double> rows(static_cast<std::size_t>(phi.size()));
  five_bar::loop_closure(q.data(), rows.data());
  expect_rows(phi, rows);
}

// A function that writes the diagonal only, as for a scene that needs no more.
struct Diagonal {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[2], Scalar (&D)[2][3]);
  static constexpr bool leaves_out = true;
  void operator()(const double* q, double* D) const noexcept {
    D[0] = q[0];
    D[4] = q[1];
  }
};

TEST(InEigen, WhatAFunctionLeavesOutIsZero) {
  const Eigen::Vector2d q(3, 5);
  expect_rows(eigen<Diagonal>(q), {3, 0, 0, 0, 5, 0});
  expect_rows(eigen<Diagonal, Eigen::RowMajor>(q), {3, 0, 0, 0, 5, 0});
}

}  // namespace
}  // namespace flatdyn
