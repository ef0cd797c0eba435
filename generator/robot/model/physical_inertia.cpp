// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/physical_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "robot/model/exact_sign.hpp"

namespace flatdyn {

namespace {

// A symmetric matrix is positive semidefinite if and only if no principal minor is negative.
bool is_positive_semidefinite(const Mat3& a) {
  const auto minor = [&](std::size_t i, std::size_t j) { return Number(a[i][i] * a[j][j] - a[i][j] * a[j][i]); };
  const Number determinant = dot(a[0], cross(a[1], a[2]));
  return !is_negative(a[0][0]) && !is_negative(a[1][1]) && !is_negative(a[2][2]) && !is_negative(minor(0, 1)) &&
         !is_negative(minor(0, 2)) && !is_negative(minor(1, 2)) && !is_negative(determinant);
}

}  // namespace

std::optional<InertiaFault> fault_of_inertia(const Mat3& tensor) {
  for (const Vec3& row : tensor) {
    if (std::any_of(row.begin(), row.end(), has_symbols)) return std::nullopt;
  }
  if (!is_positive_semidefinite(tensor)) return InertiaFault::not_positive_semidefinite;
  // ∫ r r^T dm = tr(I)/2 E - I: each of its eigenvalues is half the sum of two principal moments less the third.
  const Number half_trace = (tensor[0][0] + tensor[1][1] + tensor[2][2]) / 2;
  Mat3 second_moment;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) second_moment[i][j] = (i == j ? half_trace : Number(0)) - tensor[i][j];
  }
  if (!is_positive_semidefinite(second_moment)) return InertiaFault::triangle_inequality;
  return std::nullopt;
}

Mat3 central_tensor(const Inertial& inertial) {
  if (inertial.about == Inertial::About::centre_of_mass) return inertial.tensor;
  return inertial.tensor + steiner(-inertial.mass.number, inertial.centre_of_mass);
}

Vec3 centre_of_mass(const InertialParameters& body) {
  return body.mass.is_zero() ? zero_vector() : expanded(Vec3((1 / body.mass) * body.first_moment));
}

Mat3 central_tensor(const InertialParameters& body) {
  return expanded(body.inertia - steiner(body.mass, centre_of_mass(body)));
}

std::array<double, 3> principal_moments(const Mat3& tensor) {
  Eigen::Matrix3d matrix;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Number entry = tensor[i][j].evalf();
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          GiNaC::ex_to<GiNaC::numeric>(entry).to_double();
    }
  }
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  // Rounding leaves about 1e-19 where a moment is zero; that is not shown.
  const double noise = 1e-12 * moments.cwiseAbs().maxCoeff();
  const auto shown = [&](Eigen::Index i) { return std::abs(moments(i)) < noise ? 0.0 : moments(i); };
  return {shown(2), shown(1), shown(0)};
}

}  // namespace flatdyn
