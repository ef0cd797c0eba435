// SPDX-License-Identifier: GPL-2.0-or-later
// The rows of friction cones against what they stand for: the wrenches of forces inside pyramids at the points and at
// the corners of surfaces.
#include "robot/model/friction_cone.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "robot/model/number.hpp"

namespace flatdyn {
namespace {

using Wrench = Eigen::Matrix<double, 6, 1>;
using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;

constexpr double kFriction = 0.6, kHalfLength = 0.12, kHalfWidth = 0.05;

Eigen::MatrixXd numbers_of(const std::vector<ConeRow>& rows) {
  Eigen::MatrixXd A(static_cast<Eigen::Index>(rows.size()), 6);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      A(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = nearest_double(rows[i][k]);
    }
  }
  return A;
}

Eigen::MatrixXd rows_of_surface() {
  return numbers_of(surface_cone(exact_decimal("0.6"), exact_decimal("0.12"), exact_decimal("0.05")));
}

// The edges of the cone of wrenches: forces on the four edges of a pyramid at each of four corners.
Wrenches edges_of_surface() {
  const double mu = kFriction / std::sqrt(2.0);
  Wrenches edges(6, 16);
  int next = 0;
  for (const int corner : {0, 1, 2, 3}) {
    const Eigen::Vector3d p((corner & 1) != 0 ? kHalfLength : -kHalfLength,
                            (corner & 2) != 0 ? kHalfWidth : -kHalfWidth, 0);
    for (const int edge : {0, 1, 2, 3}) {
      const Eigen::Vector3d f((edge & 1) != 0 ? mu : -mu, (edge & 2) != 0 ? mu : -mu, 1);
      edges.col(next++) << f, p.cross(f);
    }
  }
  return edges;
}

TEST(FrictionCone, OfAPointIsThePyramidInsideTheCone) {
  const Eigen::MatrixXd A = numbers_of(point_cone(exact_decimal("0.6")));
  ASSERT_EQ(A.rows(), 4);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int inside = 0;
  for (int k = 0; k < 2000; ++k) {
    const Wrench w = Wrench::NullaryExpr([&] { return uniform(random); });
    const bool holds = (A * w).maxCoeff() <= 0;
    EXPECT_EQ(holds, std::abs(w[0]) + std::abs(w[1]) <= kFriction * w[2]);
    if (!holds) continue;
    EXPECT_LE(w.head<2>().norm(), kFriction * w[2]);
    ++inside;
  }
  EXPECT_GT(inside, 50);
}

// Every row is a face of the cone: all edges are on its inner side, and five independent ones on it.
TEST(FrictionCone, OfASurfaceHasTheFacesOfTheConeOfItsCorners) {
  const Eigen::MatrixXd A = rows_of_surface();
  const Wrenches edges = edges_of_surface();
  ASSERT_EQ(A.rows(), 16);
  for (Eigen::Index row = 0; row < A.rows(); ++row) {
    const Eigen::VectorXd distances = (A.row(row) * edges).transpose();
    EXPECT_LE(distances.maxCoeff(), 1e-15) << row;
    Wrenches on_face(6, 0);
    for (Eigen::Index k = 0; k < edges.cols(); ++k) {
      if (distances[k] < -1e-15) continue;
      on_face.conservativeResize(Eigen::NoChange, on_face.cols() + 1);
      on_face.rightCols<1>() = edges.col(k);
    }
    EXPECT_EQ(Eigen::FullPivLU<Eigen::MatrixXd>(on_face).setThreshold(1e-9).rank(), 5) << row;
  }
}

// Whether a wrench is a sum of six edges with weights that are not negative (Carathéodory).
bool is_sum_of_edges(const Wrench& w, const Wrenches& edges) {
  std::vector<bool> chosen(static_cast<std::size_t>(edges.cols()), false);
  std::fill(chosen.begin(), chosen.begin() + 6, true);
  do {
    Eigen::Matrix<double, 6, 6> basis;
    Eigen::Index col = 0;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      if (chosen[k]) basis.col(col++) = edges.col(static_cast<Eigen::Index>(k));
    }
    const Eigen::PartialPivLU<Eigen::Matrix<double, 6, 6>> factors(basis);
    if (std::abs(factors.determinant()) < 1e-12) continue;
    if (Wrench(factors.solve(w)).minCoeff() >= -1e-9) return true;
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return false;
}

// No face is missing: what the rows allow is a sum of forces at the corners.
TEST(FrictionCone, OfASurfaceAllowsNothingElse) {
  const Eigen::MatrixXd A = rows_of_surface();
  const Wrenches edges = edges_of_surface();
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 12; ++k) {
    const Wrench away = Wrench::NullaryExpr([&] { return normal(random); });
    Wrench w = Wrench::Unit(2);
    double most = 0;  // how far one may go from a pure normal force
    for (Eigen::Index row = 0; row < A.rows(); ++row) {
      const double towards = A.row(row) * away;
      if (towards > 0) most = most == 0 ? -A(row, 2) / towards : std::min(most, -A(row, 2) / towards);
    }
    ASSERT_GT(most, 0);
    w += 0.999 * most * away;
    EXPECT_TRUE(is_sum_of_edges(w, edges)) << k;
    w += 0.002 * most * away;
    EXPECT_FALSE(is_sum_of_edges(w, edges)) << k;
  }
}

}  // namespace
}  // namespace flatdyn
