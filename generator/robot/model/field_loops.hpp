// SPDX-License-Identifier: GPL-2.0-or-later
// Closed loops over any field, by their definition: the closure Φ of each loop (robot/model/mechanism.hpp) from the
// poses of the bodies in the base frame, and G from Φ_q G = 0, so that q̇ = G q̇_a with q̇_a of the independent joints.
#pragma once

#include <utility>
#include <vector>

#include "robot/model/body_poses.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {

template <class S, class F>
class LoopGeometry {
 public:
  LoopGeometry(const MechanismOver<F>& mechanism, const std::vector<JointPoint<S>>& q)
      : mechanism_(mechanism), poses_(body_poses(mechanism, q)) {}

  // All components of Φ, those that the joints do not change, too.
  std::vector<S> gap(const FieldLoop<F>& loop) const {
    const Vector3<S> way = in_axes(loop, minus(end(loop, 1), end(loop, 0)));
    std::vector<S> components(way.begin(), way.end());
    if (loop.components > 3) {
      const Vector3<S> axis = turned(loop, 1, loop.axis);
      for (const Vector3<F>& e : loop.across) components.push_back(dot(turned(loop, 0, e), axis));
    }
    return components;
  }

  // Their derivatives by each entry of q, a row for each component. Of e·a: what turns a by ω changes it by
  // e·(ω × a) = ω·(a × e), what turns e by as much less.
  Matrix<S> jacobian(const FieldLoop<F>& loop) const {
    Matrix<S> J(loop.components, mechanism_.position_count());
    const std::vector<Vector3<S>> normals = normals_of(loop);
    for (std::size_t e = 0; e < 2; ++e) {
      const Vector3<S> p = end(loop, e);
      for (int i = loop.bodies[e]; i != loop.carrier; i = mechanism_.bodies[static_cast<std::size_t>(i)].parent) {
        const Vector3<S> moved = in_axes(loop, moved_by(i, p));
        std::vector<S> column(moved.begin(), moved.end());
        for (const Vector3<S>& normal : normals) column.push_back(turned_by(i, normal));
        for (int k = 0; k < J.cols(); ++k) {
          for (int row = 0; row < J.rows(); ++row) {
            const S part = column[static_cast<std::size_t>(row)] * factor(i, k);
            J(row, k) += e == 0 ? -part : part;
          }
        }
      }
    }
    return J;
  }

  // The cosine of the angle between its axes: e_1 × e_2 and a.
  S cosine(const FieldLoop<F>& loop) const {
    return dot(cross(turned(loop, 0, loop.across[0]), turned(loop, 0, loop.across[1])), turned(loop, 1, loop.axis));
  }

  // Φ_q of one loop: the rows that count.
  Matrix<S> rows(const FieldLoop<F>& loop) const {
    const Matrix<S> all = jacobian(loop);
    Matrix<S> J(static_cast<int>(loop.rows.size()), all.cols());
    for (int r = 0; r < J.rows(); ++r) {
      for (int k = 0; k < J.cols(); ++k) J(r, k) = all(static_cast<int>(loop.rows[static_cast<std::size_t>(r)]), k);
    }
    return J;
  }

 private:
  const F& factor(int body, int position) const {
    return mechanism_.tree_coupling[static_cast<std::size_t>(body)][static_cast<std::size_t>(position)];
  }

  Vector3<S> end(const FieldLoop<F>& loop, std::size_t e) const {
    const Vector3<F>& p = loop.points[e];
    if (loop.bodies[e] < 0) return {S(p[0]), S(p[1]), S(p[2])};
    const Pose3<S>& body = poses_[static_cast<std::size_t>(loop.bodies[e])];
    return plus(body.p, times(body.R, p));
  }

  // A direction in the body of an end, in the base frame.
  Vector3<S> turned(const FieldLoop<F>& loop, std::size_t e, const Vector3<F>& v) const {
    if (loop.bodies[e] < 0) return {S(v[0]), S(v[1]), S(v[2])};
    return times(poses_[static_cast<std::size_t>(loop.bodies[e])].R, v);
  }

  // a × e_1 and a × e_2, if axes meet.
  std::vector<Vector3<S>> normals_of(const FieldLoop<F>& loop) const {
    std::vector<Vector3<S>> normals;
    if (loop.components == 3) return normals;
    const Vector3<S> axis = turned(loop, 1, loop.axis);
    for (const Vector3<F>& e : loop.across) normals.push_back(cross(axis, turned(loop, 0, e)));
    return normals;
  }

  Vector3<S> axis_of(int i) const {
    const Matrix3<S>& R = poses_[static_cast<std::size_t>(i)].R;
    return {R[0][2], R[1][2], R[2][2]};
  }
  bool slides(int i) const { return mechanism_.bodies[static_cast<std::size_t>(i)].prismatic; }

  Vector3<S> moved_by(int i, const Vector3<S>& p) const {
    return slides(i) ? axis_of(i) : cross(axis_of(i), minus(p, poses_[static_cast<std::size_t>(i)].p));
  }
  S turned_by(int i, const Vector3<S>& normal) const { return slides(i) ? S{} : dot(axis_of(i), normal); }

  Vector3<S> in_axes(const FieldLoop<F>& loop, Vector3<S> v) const {
    if (loop.carrier >= 0) v = times(transposed(poses_[static_cast<std::size_t>(loop.carrier)].R), v);
    return times(transposed(loop.axes), v);
  }

  const MechanismOver<F>& mechanism_;
  std::vector<Pose3<S>> poses_;
};

// By its first row. For matrices of up to five.
template <class S>
S determinant(const Matrix<S>& A) {
  if (A.rows() == 1) return A(0, 0);
  S sum{};
  for (int k = 0; k < A.cols(); ++k) {
    Matrix<S> minor(A.rows() - 1, A.cols() - 1);
    for (int i = 1; i < A.rows(); ++i) {
      for (int j = 0, to = 0; j < A.cols(); ++j) {
        if (j != k) minor(i - 1, to++) = A(i, j);
      }
    }
    const S part = A(0, k) * determinant(minor);
    sum += k % 2 == 0 ? part : -part;
  }
  return sum;
}

// Some of the columns.
template <class S>
Matrix<S> columns_of(const Matrix<S>& A, const std::vector<int>& columns) {
  Matrix<S> result(A.rows(), static_cast<int>(columns.size()));
  for (int i = 0; i < A.rows(); ++i) {
    for (int k = 0; k < result.cols(); ++k) result(i, k) = A(i, columns[static_cast<std::size_t>(k)]);
  }
  return result;
}

// x of A x = b, by Cramer's rule.
template <class S>
std::vector<S> solved(const Matrix<S>& A, const std::vector<S>& b) {
  const S det = determinant(A);
  std::vector<S> x;
  for (int k = 0; k < A.cols(); ++k) {
    Matrix<S> replaced = A;
    for (int row = 0; row < A.rows(); ++row) replaced(row, k) = b[static_cast<std::size_t>(row)];
    x.push_back(determinant(replaced) / det);
  }
  return x;
}

// G, m × n, loop by loop.
template <class S, class F>
Matrix<S> loop_motion(const MechanismOver<F>& mechanism, const std::vector<JointPoint<S>>& q) {
  const LoopGeometry<S, F> geometry(mechanism, q);
  Matrix<S> G(mechanism.position_count(), static_cast<int>(mechanism.independent.size()));
  for (int a = 0; a < G.cols(); ++a) G(mechanism.independent[static_cast<std::size_t>(a)], a) = S(F(1));
  for (const FieldLoop<F>& loop : mechanism.loops) {
    const Matrix<S> J = geometry.rows(loop), own = columns_of(J, loop.dependent);
    const Matrix<S> rest = times(J, G);  // of dependent joints that are still at rest
    for (int a = 0; a < G.cols(); ++a) {
      std::vector<S> wanted;
      for (int row = 0; row < own.rows(); ++row) wanted.push_back(-rest(row, a));
      const std::vector<S> rates = solved(own, wanted);
      for (std::size_t d = 0; d < rates.size(); ++d) G(loop.dependent[d], a) = rates[d];
    }
  }
  return G;
}

// A G: how the bodies' joints move with the independent coordinates, after the columns of a floating base.
template <class S, class F>
std::vector<std::vector<S>> closed_coupling(const MechanismOver<F>& mechanism, const std::vector<JointPoint<S>>& q) {
  const Matrix<S> G = loop_motion(mechanism, q);
  const auto base = static_cast<std::size_t>(mechanism.base_bodies);
  std::vector<std::vector<S>> result;
  for (const std::vector<F>& row : mechanism.tree_coupling) {
    result.emplace_back(base + static_cast<std::size_t>(G.cols()), S{});
    if (result.size() <= base) result.back()[result.size() - 1] = S(F(1));
    for (int k = 0; k < G.rows(); ++k) {
      for (int a = 0; a < G.cols(); ++a) {
        result.back()[base + static_cast<std::size_t>(a)] += G(k, a) * row[static_cast<std::size_t>(k)];
      }
    }
  }
  return result;
}

// The entries of q̇, or of q̈, of the independent joints, without those of a floating base.
template <class F>
std::vector<F> without_base(const MechanismOver<F>& mechanism, const std::vector<F>& values) {
  return {values.begin() + mechanism.base_bodies, values.end()};
}

// With the loops closed at these positions of the joints.
template <class F>
MechanismOver<F> closed_at(MechanismOver<F> mechanism, const std::vector<JointPoint<F>>& q) {
  if (mechanism.has_loops()) mechanism.coupling = closed_coupling(mechanism, q);
  return mechanism;
}

// Accelerations of the joints that independent rates q̇_r have while the joints move at these rates and q̈ is zero:
// d(A G)/dt q̇_r.
template <class F>
std::vector<F> joint_drift(const MechanismOver<F>& mechanism, const std::vector<JointPoint<F>>& q,
                           const std::vector<F>& joint_rates, const std::vector<F>& qd_r) {
  std::vector<F> drift(q.size(), F(0));
  if (!mechanism.has_loops()) return drift;
  const auto coupling = closed_coupling(mechanism, moving(q, joint_rates));
  for (std::size_t i = 0; i < drift.size(); ++i) {
    for (std::size_t a = 0; a < qd_r.size(); ++a) drift[i] += coupling[i][a].derivative * qd_r[a];
  }
  return drift;
}

}  // namespace flatdyn
