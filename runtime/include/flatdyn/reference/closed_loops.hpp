// SPDX-License-Identifier: BSD-3-Clause
// Closed loops of the reference: the motion of the dependent joints. Φ(q) = 0 says that the points, and the axes, meet
// at which loops were cut; Φ_q q̇ = 0 gives q̇ = G q̇_a, and its derivative q̈ = G q̈_a + γ.
#pragma once

#include "flatdyn/reference/newton_euler_of_tree.hpp"

namespace flatdyn::reference {

namespace detail {

// Whether the joint lies between the base and the link.
template <class S>
bool carries(const Robot<S>& robot, const Joint<S>& joint, int link) {
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    if (robot.joints[j].child != link) continue;
    if (&robot.joints[j] == &joint) return true;
    link = robot.joints[j].parent;
  }
  return false;
}

// Whether the joint moves this end of the loop relative to the loop's carrier.
template <class S>
bool moves_end(const Robot<S>& robot, const Loop<S>& loop, const Joint<S>& joint, int end) {
  return joint.index >= 0 && carries(robot, joint, loop.links[end]) && !carries(robot, joint, loop.carrier);
}

template <class S>
Vector3<S> in_axes(const Loop<S>& loop, const std::vector<Pose<S>>& poses, const Vector3<S>& v) {
  return loop.axes.transpose() * (poses[static_cast<std::size_t>(loop.carrier)].R.transpose() * v);
}

// The components of Φ, or of its derivatives, that joints change: the displacement between the points, m, and cosines
// between the second link's axis and the directions across the first one's.
template <class S>
using Components = Eigen::Matrix<S, 5, 1>;

inline constexpr int kOfPoints = 3;

template <class S>
bool aligns_axes(const Loop<S>& loop) {
  return !loop.rows.empty() && loop.rows.back() >= kOfPoints;
}

template <class S>
VectorX<S> rows_of(const Loop<S>& loop, const Components<S>& v) {
  VectorX<S> result(static_cast<Eigen::Index>(loop.rows.size()));
  for (std::size_t r = 0; r < loop.rows.size(); ++r) result[static_cast<Eigen::Index>(r)] = v[loop.rows[r]];
  return result;
}

template <class S>
Vector3<S> end_of(const Loop<S>& loop, const std::vector<Pose<S>>& poses, int end) {
  const Pose<S>& link = poses[static_cast<std::size_t>(loop.links[end])];
  return link.p + link.R * loop.points[end];
}

template <class S>
Vector3<S> axis_of(const Loop<S>& loop, const std::vector<Pose<S>>& poses) {
  return poses[static_cast<std::size_t>(loop.links[1])].R * loop.axis;
}

template <class S>
Vector3<S> across_of(const Loop<S>& loop, const std::vector<Pose<S>>& poses, int k) {
  return poses[static_cast<std::size_t>(loop.links[0])].R * loop.across[k];
}

// Φ of one loop, the components that joints change: displacements of its ends, m, and cosines between its axes.
template <class S>
VectorX<S> gap_of(const Loop<S>& loop, const std::vector<Pose<S>>& poses) {
  Components<S> gap;
  gap.template head<3>() = in_axes(loop, poses, Vector3<S>(end_of(loop, poses, 1) - end_of(loop, poses, 0)));
  for (int k = 0; k < 2; ++k) gap[kOfPoints + k] = across_of(loop, poses, k).dot(axis_of(loop, poses));
  return rows_of(loop, gap);
}

// The column of a moving joint among those of all joints: a floating base has none.
template <class S>
int column_of(const Robot<S>& robot, const Joint<S>& joint) {
  return joint.index - robot.base_size();
}

// The Jacobian of one loop, with a column for each joint.
template <class S>
MatrixX<S> loop_jacobian_of_joints(const Robot<S>& robot, const Loop<S>& loop, const std::vector<Pose<S>>& poses) {
  MatrixX<S> J = MatrixX<S>::Zero(static_cast<Eigen::Index>(loop.rows.size()), robot.joint_count());
  for (int end = 0; end < 2; ++end) {
    const Vector3<S> p = end_of(loop, poses, end);
    for (const Joint<S>& joint : robot.joints) {
      if (!moves_end(robot, loop, joint, end)) continue;
      const Pose<S>& parent = poses[static_cast<std::size_t>(joint.parent)];
      const Vector3<S> z = parent.R * joint.R_0 * joint.axis, origin = parent.p + parent.R * joint.p_0;
      const bool slides = joint.type == JointType::prismatic;
      Components<S> column = Components<S>::Zero();
      column.template head<3>() = in_axes(loop, poses, slides ? z : Vector3<S>(z.cross(p - origin)));
      for (int k = 0; k < 2 && !slides; ++k) {
        column[kOfPoints + k] = across_of(loop, poses, k).dot(z.cross(axis_of(loop, poses)));
      }
      J.col(column_of(robot, joint)) += (end == 0 ? S(-1) : S(1)) * rows_of(loop, column);
    }
  }
  return J;
}

// The second derivative of e·a for both directions e across the axis while q̈ = 0: e·ä + 2 ė·ȧ + ë·a.
template <class S>
Eigen::Matrix<S, 2, 1> axis_drift(const Loop<S>& loop, const LinkMotion<S>& first, const LinkMotion<S>& second) {
  const auto change = [](const LinkMotion<S>& link, const Vector3<S>& v) {
    return Vector3<S>(link.R * link.omega.cross(v));
  };
  const auto second_change = [](const LinkMotion<S>& link, const Vector3<S>& v) {
    return Vector3<S>(link.R * swing(link.omega, link.domega, v));
  };
  const Vector3<S> a = second.R * loop.axis;
  Eigen::Matrix<S, 2, 1> drift;
  for (int k = 0; k < 2; ++k) {
    const Vector3<S> e = first.R * loop.across[k];
    drift[k] = e.dot(second_change(second, loop.axis)) + second_change(first, loop.across[k]).dot(a) +
               S(2) * change(first, loop.across[k]).dot(change(second, loop.axis));
  }
  return drift;
}

// Φ̇_q q̇ of one loop for rates of the joints: the relative acceleration of its points, and of its axes, while q̈ = 0.
// Joints that carry the whole loop, and a floating base, have no effect on it.
template <class S>
VectorX<S> loop_drift_of_joints(const Robot<S>& robot, const Loop<S>& loop, const std::vector<Pose<S>>& poses,
                                const VectorX<S>& positions, VectorX<S> rates) {
  for (const Joint<S>& joint : robot.joints) {
    const bool is_in_loop = moves_end(robot, loop, joint, 0) || moves_end(robot, loop, joint, 1);
    if (joint.index >= 0 && !is_in_loop) rates[joint.index] = S(0);
  }
  rates.head(robot.base_size()).setZero();
  const VectorX<S> none = VectorX<S>::Zero(rates.size());
  const std::vector<LinkMotion<S>> motions = motions_of_tree(robot, positions, rates, none, false);
  Vector3<S> gap = Vector3<S>::Zero();
  for (int end = 0; end < 2; ++end) {
    const LinkMotion<S>& link = motions[static_cast<std::size_t>(loop.links[end])];
    const Vector3<S> a = link.R * (link.ddp + swing(link.omega, link.domega, loop.points[end]));
    gap += end == 0 ? Vector3<S>(-a) : a;
  }
  const auto motion = [&](int end) -> const LinkMotion<S>& {
    return motions[static_cast<std::size_t>(loop.links[end])];
  };
  Components<S> components;
  components.template head<3>() = in_axes(loop, poses, gap);
  components.template tail<2>() = axis_drift(loop, motion(0), motion(1));
  return rows_of(loop, components);
}

// The determinant of a matrix of up to five rows, over any scalar; beyond three rows by the first row.
template <class S>
S determinant(const MatrixX<S>& A) {
  if (A.rows() == 1) return A(0, 0);
  if (A.rows() == 2) return A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
  if (A.rows() == 3) {
    const Vector3<S> a = A.col(0), b = A.col(1), c = A.col(2);
    return a.dot(b.cross(c));
  }
  S sum(0);
  for (Eigen::Index k = 0; k < A.cols(); ++k) {
    MatrixX<S> minor(A.rows() - 1, A.cols() - 1);
    minor.leftCols(k) = A.bottomRows(A.rows() - 1).leftCols(k);
    minor.rightCols(A.cols() - 1 - k) = A.bottomRows(A.rows() - 1).rightCols(A.cols() - 1 - k);
    const S part = A(0, k) * determinant(minor);
    sum += k % 2 == 0 ? part : S(-part);
  }
  return sum;
}

template <class S>
MatrixX<S> dependent_columns(const Loop<S>& loop, const MatrixX<S>& J) {
  MatrixX<S> own(J.rows(), static_cast<Eigen::Index>(loop.dependent.size()));
  for (std::size_t d = 0; d < loop.dependent.size(); ++d) {
    own.col(static_cast<Eigen::Index>(d)) = J.col(loop.dependent[d]);
  }
  return own;
}

// The solution x of Φ_d x = b by Cramer's rule.
template <class S>
VectorX<S> dependent_solution(const Loop<S>& loop, const MatrixX<S>& J, const VectorX<S>& b) {
  const MatrixX<S> own = dependent_columns(loop, J);
  VectorX<S> x(own.cols());
  for (Eigen::Index d = 0; d < own.cols(); ++d) {
    MatrixX<S> replaced = own;
    replaced.col(d) = b;
    x[d] = determinant(replaced) / determinant(own);
  }
  return x;
}

// Completes `values`, loop by loop, such that Φ_q values + extra = 0; each loop solves for its own dependent joints,
// and all others are known by then. `extra(loop, poses)` has an entry per row.
template <class S, class Extra>
VectorX<S> completed(const Robot<S>& robot, const std::vector<Pose<S>>& poses, VectorX<S> values, const Extra& extra) {
  for (const Loop<S>& loop : robot.loops) {
    const MatrixX<S> J = loop_jacobian_of_joints(robot, loop, poses).lazyProduct(robot.coupling);
    const VectorX<S> found = dependent_solution<S>(loop, J, -(J.lazyProduct(values) + extra(loop)));
    for (std::size_t d = 0; d < loop.dependent.size(); ++d)
      values[loop.dependent[d]] = found[static_cast<Eigen::Index>(d)];
  }
  return values;
}

}  // namespace detail

// Φ of all loops: m for points, cosines for axes.
template <class S>
VectorX<S> loop_closure(const Robot<S>& robot, const VectorX<S>& q) {
  VectorX<S> room;
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, positions_of_joints(robot, q, room));
  std::vector<S> entries;
  for (const Loop<S>& loop : robot.loops) {
    const VectorX<S> rows = detail::gap_of(loop, poses);
    entries.insert(entries.end(), rows.begin(), rows.end());
  }
  return Eigen::Map<const VectorX<S>>(entries.data(), static_cast<Eigen::Index>(entries.size()));
}

// Φ_q of all loops.
template <class S>
MatrixX<S> loop_jacobian(const Robot<S>& robot, const VectorX<S>& q) {
  VectorX<S> room;
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, positions_of_joints(robot, q, room));
  MatrixX<S> J(0, q.size());
  for (const Loop<S>& loop : robot.loops) {
    const MatrixX<S> rows = detail::loop_jacobian_of_joints(robot, loop, poses).lazyProduct(robot.coupling);
    J.conservativeResize(J.rows() + rows.rows(), Eigen::NoChange);
    J.bottomRows(rows.rows()) = rows;
  }
  return J;
}

// G, the rates of all entries of q by those of the independent ones, without a floating base's.
template <class S>
MatrixX<S> loop_motion(const Robot<S>& robot, const VectorX<S>& q) {
  VectorX<S> room;
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, positions_of_joints(robot, q, room));
  MatrixX<S> G(q.size(), static_cast<Eigen::Index>(robot.independent.size()));
  for (Eigen::Index a = 0; a < G.cols(); ++a) {
    const VectorX<S> unit = VectorX<S>::Unit(q.size(), robot.independent[static_cast<std::size_t>(a)]);
    const auto nothing = [](const Loop<S>& loop) -> VectorX<S> {
      return VectorX<S>::Zero(static_cast<Eigen::Index>(loop.rows.size()));
    };
    G.col(a) = detail::completed(robot, poses, unit, nothing);
  }
  return G;
}

// The rates of the moving joints, after a floating base's, by the entries of q̇: A, or A G if loops are closed.
template <class S>
MatrixX<S> motion_of_joints(const Robot<S>& robot, const VectorX<S>& q) {
  if (robot.loops.empty()) return rate_coupling(robot);
  return beside_base(robot, MatrixX<S>(robot.coupling.lazyProduct(loop_motion(robot, q))));
}

// γ, the accelerations of all entries of q while q̈_a = 0.
template <class S>
VectorX<S> loop_drift(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd) {
  VectorX<S> room;
  const VectorX<S>& positions = positions_of_joints(robot, q, room);
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, positions);
  const VectorX<S> rates = motion_of_joints(robot, q).lazyProduct(qd);
  const auto drift = [&](const Loop<S>& loop) {
    return detail::loop_drift_of_joints<S>(robot, loop, poses, positions, rates);
  };
  return detail::completed(robot, poses, VectorX<S>(VectorX<S>::Zero(q.size())), drift);
}

// The change of q by one Newton step towards closed loops.
template <class S>
VectorX<S> loop_step(const Robot<S>& robot, const VectorX<S>& q) {
  VectorX<S> room;
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, positions_of_joints(robot, q, room));
  const auto gap = [&](const Loop<S>& loop) { return detail::gap_of(loop, poses); };
  return detail::completed(robot, poses, VectorX<S>(VectorX<S>::Zero(q.size())), gap);
}

// Moves the dependent joints in q such that all loops are closed within the tolerance (m for points, 1 for axes) by
// Newton's method, with halved steps if a full one does not reduce the gap. Returns false and leaves q unchanged if the
// loops cannot be closed from here, or are singular.
template <class S>
bool close_loops(const Robot<S>& robot, VectorX<S>& q, const S& tolerance) {
  constexpr int kMostSteps = 50, kMostHalvings = 20;
  VectorX<S> tried = q;
  S gap = robot.loops.empty() ? S(0) : S(loop_closure(robot, tried).norm());
  for (int step = 0; step < kMostSteps && gap > tolerance; ++step) {
    VectorX<S> change = loop_step(robot, tried);
    S next = S(loop_closure(robot, VectorX<S>(tried + change)).norm());
    for (int half = 0; half < kMostHalvings && !(next < gap); ++half) {
      change /= S(2);
      next = S(loop_closure(robot, VectorX<S>(tried + change)).norm());
    }
    if (!(next < gap)) return false;
    tried += change;
    gap = next;
  }
  if (!(gap <= tolerance)) return false;
  q = tried;
  return true;
}

// The regularity below which the rates of dependent joints are meaningless. Generated functions use a bound of their
// own, relative to the largest determinant that links of these lengths allow.
inline constexpr double kSingularLoop = 1e-6;

namespace detail {

// 1 × joints: the largest lengths of a loop's columns, those of stretched links.
template <class S>
MatrixX<S> stretched_lengths(const Robot<S>& robot, const Loop<S>& loop, const VectorX<S>& positions) {
  using std::abs;
  MatrixX<S> lengths = MatrixX<S>::Zero(1, robot.joint_count());
  for (int end = 0; end < 2; ++end) {
    S distance = loop.points[end].norm();
    for (auto joint = robot.joints.rbegin(); joint != robot.joints.rend(); ++joint) {
      if (!moves_end(robot, loop, *joint, end)) continue;
      const bool slides = joint->type == JointType::prismatic;
      lengths(0, column_of(robot, *joint)) += slides ? S(1) : distance;
      distance += joint->p_0.norm() + (slides ? S(abs(positions[joint->index])) : S(0));
    }
  }
  return lengths;
}

// Where axes meet, the rows of points are divided by a length, so that they are comparable, and 1 is added to the
// lengths of columns of joints that turn. `J`, `lengths`: by joint.
template <class S>
void compare_rows(const Robot<S>& robot, const Loop<S>& loop, MatrixX<S>& J, MatrixX<S>& lengths) {
  using std::max;
  if (!aligns_axes(loop)) return;
  S length(0);
  for (const Joint<S>& joint : robot.joints) {
    if (joint.index >= 0 && joint.type == JointType::revolute)
      length = max(length, lengths(0, column_of(robot, joint)));
  }
  if (!(length > S(0))) length = S(1);
  for (std::size_t r = 0; r < loop.rows.size(); ++r) {
    if (loop.rows[r] < kOfPoints) J.row(static_cast<Eigen::Index>(r)) /= length;
  }
  lengths /= length;
  for (const Joint<S>& joint : robot.joints) {
    const bool turns = joint.index >= 0 && joint.type == JointType::revolute;
    if (turns && (moves_end(robot, loop, joint, 0) || moves_end(robot, loop, joint, 1)))
      lengths(0, column_of(robot, joint)) += S(1);
  }
}

}  // namespace detail

// The distance of the loops from singularity, 0 to 1: the smallest determinant that is divided by, relative to the
// product of the lengths of its columns; 1 if there are no loops. A column that is short because an axis goes through
// the loop's point makes a loop singular, too: its length counts as at least a thousandth of what the links allow.
template <class S>
S loop_regularity(const Robot<S>& robot, const VectorX<S>& q) {
  using std::abs;
  using std::max;
  using std::min;
  VectorX<S> room;
  const VectorX<S>& positions = positions_of_joints(robot, q, room);
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, positions);
  S smallest(1);
  for (const Loop<S>& loop : robot.loops) {
    MatrixX<S> J = detail::loop_jacobian_of_joints(robot, loop, poses);
    MatrixX<S> lengths = detail::stretched_lengths(robot, loop, positions);
    detail::compare_rows(robot, loop, J, lengths);
    const MatrixX<S> own = detail::dependent_columns<S>(loop, J.lazyProduct(robot.coupling));
    const MatrixX<S> stretched = detail::dependent_columns<S>(loop, lengths.lazyProduct(robot.coupling.cwiseAbs()));
    S largest(1);
    for (Eigen::Index k = 0; k < own.cols(); ++k) largest *= max(S(own.col(k).norm()), S(stretched(0, k) / 1000));
    smallest = min(smallest, S(abs(detail::determinant(own)) / largest));
  }
  return smallest;
}

// The rates of the moving joints; stored in `room` if they differ from the coordinates' rates.
template <class S>
const VectorX<S>& rates_of_joints(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd, VectorX<S>& room) {
  if (robot.coupling.size() == 0) return qd;
  room = motion_of_joints(robot, q).lazyProduct(qd);
  return room;
}

template <class S>
const VectorX<S>& accelerations_of_joints(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd,
                                          const VectorX<S>& qdd, VectorX<S>& room) {
  if (robot.loops.empty()) return rates_of_joints(robot, q, qdd, room);
  room = motion_of_joints(robot, q).lazyProduct(qdd);
  room.tail(robot.joint_count()) += robot.coupling.lazyProduct(loop_drift(robot, q, qd));
  return room;
}

// The torques at the coordinates that correspond to torques at the joints.
template <class S>
VectorX<S> at_coordinates(const Robot<S>& robot, const VectorX<S>& q, VectorX<S> tau) {
  if (robot.coupling.size() == 0) return tau;
  return motion_of_joints(robot, q).transpose().lazyProduct(tau);
}

}  // namespace flatdyn::reference
