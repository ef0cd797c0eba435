// SPDX-License-Identifier: BSD-3-Clause
// Closed loops of the reference: how the joints that depend on others move with them. Φ(q) = 0 says that the points
// meet where loops were cut, and axes where these were; Φ_q q̇ = 0 gives q̇ = G q̇_a, and its derivative q̈ = G q̈_a + γ.
#pragma once

#include "flatdyn/reference/newton_euler_of_tree.hpp"

namespace flatdyn::reference {

namespace detail {

// Whether a joint is between a link and the base.
template <class S>
bool carries(const Robot<S>& robot, const Joint<S>& joint, int link) {
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    if (robot.joints[j].child != link) continue;
    if (&robot.joints[j] == &joint) return true;
    link = robot.joints[j].parent;
  }
  return false;
}

// Whether a joint moves one end of a loop against the carrier.
template <class S>
bool moves_end(const Robot<S>& robot, const Loop<S>& loop, const Joint<S>& joint, int end) {
  return joint.index >= 0 && carries(robot, joint, loop.links[end]) && !carries(robot, joint, loop.carrier);
}

template <class S>
Vector3<S> in_axes(const Loop<S>& loop, const std::vector<Pose<S>>& poses, const Vector3<S>& v) {
  return loop.axes.transpose() * (poses[static_cast<std::size_t>(loop.carrier)].R.transpose() * v);
}

// Of Φ or its derivatives: what lies between the points, m, and cosines of the second link's axis with what is across
// the first one's.
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

// Φ, the components that joints change.
template <class S>
VectorX<S> gap_of(const Loop<S>& loop, const std::vector<Pose<S>>& poses) {
  Components<S> gap;
  gap.template head<3>() = in_axes(loop, poses, Vector3<S>(end_of(loop, poses, 1) - end_of(loop, poses, 0)));
  for (int k = 0; k < 2; ++k) gap[kOfPoints + k] = across_of(loop, poses, k).dot(axis_of(loop, poses));
  return rows_of(loop, gap);
}

// Of one loop, a column for each joint.
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
      J.col(joint.index) += (end == 0 ? S(-1) : S(1)) * rows_of(loop, column);
    }
  }
  return J;
}

// Of e·a of both directions across, from how the two links turn: e·ä + 2 ė·ȧ + ë·a.
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

// Φ̇_q q̇ of one loop, of the joints' rates: what its points, and axes, accelerate against each other if no joint does.
// Joints that carry the loop as a whole stand still for it.
template <class S>
VectorX<S> loop_drift_of_joints(const Robot<S>& robot, const Loop<S>& loop, const std::vector<Pose<S>>& poses,
                                const VectorX<S>& positions, VectorX<S> rates) {
  for (const Joint<S>& joint : robot.joints) {
    const bool is_in_loop = moves_end(robot, loop, joint, 0) || moves_end(robot, loop, joint, 1);
    if (joint.index >= 0 && !is_in_loop) rates[joint.index] = S(0);
  }
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

// Of up to five rows, over any scalar; beyond three by the first row.
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

// x of Φ_d x = b, by Cramer's rule.
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

// Where all joints but the dependent ones of later loops are known: loop by loop, Φ_q values + extra = 0. `extra(loop,
// poses)`, by row.
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

// Φ, loop by loop: m, and cosines where axes meet.
template <class S>
VectorX<S> loop_closure(const Robot<S>& robot, const VectorX<S>& q) {
  VectorX<S> room;
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, of_joints(robot, q, room));
  std::vector<S> entries;
  for (const Loop<S>& loop : robot.loops) {
    const VectorX<S> rows = detail::gap_of(loop, poses);
    entries.insert(entries.end(), rows.begin(), rows.end());
  }
  return Eigen::Map<const VectorX<S>>(entries.data(), static_cast<Eigen::Index>(entries.size()));
}

// Φ_q.
template <class S>
MatrixX<S> loop_jacobian(const Robot<S>& robot, const VectorX<S>& q) {
  VectorX<S> room;
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, of_joints(robot, q, room));
  MatrixX<S> J(0, q.size());
  for (const Loop<S>& loop : robot.loops) {
    const MatrixX<S> rows = detail::loop_jacobian_of_joints(robot, loop, poses).lazyProduct(robot.coupling);
    J.conservativeResize(J.rows() + rows.rows(), Eigen::NoChange);
    J.bottomRows(rows.rows()) = rows;
  }
  return J;
}

// G, m × n.
template <class S>
MatrixX<S> loop_motion(const Robot<S>& robot, const VectorX<S>& q) {
  VectorX<S> room;
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, of_joints(robot, q, room));
  MatrixX<S> G(q.size(), robot.size());
  for (Eigen::Index a = 0; a < G.cols(); ++a) {
    const VectorX<S> unit = VectorX<S>::Unit(q.size(), robot.independent[static_cast<std::size_t>(a)]);
    const auto nothing = [](const Loop<S>& loop) -> VectorX<S> {
      return VectorX<S>::Zero(static_cast<Eigen::Index>(loop.rows.size()));
    };
    G.col(a) = detail::completed(robot, poses, unit, nothing);
  }
  return G;
}

// γ, of every entry of q.
template <class S>
VectorX<S> loop_drift(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd) {
  VectorX<S> room;
  const VectorX<S>& positions = of_joints(robot, q, room);
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, positions);
  const VectorX<S> rates = robot.coupling.lazyProduct(loop_motion(robot, q).lazyProduct(qd));
  const auto drift = [&](const Loop<S>& loop) {
    return detail::loop_drift_of_joints<S>(robot, loop, poses, positions, rates);
  };
  return detail::completed(robot, poses, VectorX<S>(VectorX<S>::Zero(q.size())), drift);
}

// Newton's step.
template <class S>
VectorX<S> loop_step(const Robot<S>& robot, const VectorX<S>& q) {
  VectorX<S> room;
  const std::vector<Pose<S>> poses = detail::poses_of_tree(robot, of_joints(robot, q, room));
  const auto gap = [&](const Loop<S>& loop) { return detail::gap_of(loop, poses); };
  return detail::completed(robot, poses, VectorX<S>(VectorX<S>::Zero(q.size())), gap);
}

// q with its dependent joints moved so that all loops are closed to within the tolerance, m and 1, by Newton's method
// with halved steps where a full one does not lessen the gap. False, and q is as it was, if that is not reached: the
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

// Below this regularity, rates of dependent joints mean nothing any more. Generated functions have a bound of their
// own, against the largest determinant that links of these lengths allow.
inline constexpr double kSingularLoop = 1e-6;

namespace detail {

// 1 × joints: the lengths that a loop's columns have where links are stretched out.
template <class S>
MatrixX<S> stretched_lengths(const Robot<S>& robot, const Loop<S>& loop, const VectorX<S>& positions) {
  using std::abs;
  MatrixX<S> lengths = MatrixX<S>::Zero(1, robot.joint_count());
  for (int end = 0; end < 2; ++end) {
    S distance = loop.points[end].norm();
    for (auto joint = robot.joints.rbegin(); joint != robot.joints.rend(); ++joint) {
      if (!moves_end(robot, loop, *joint, end)) continue;
      const bool slides = joint->type == JointType::prismatic;
      lengths(0, joint->index) += slides ? S(1) : distance;
      distance += joint->p_0.norm() + (slides ? S(abs(positions[joint->index])) : S(0));
    }
  }
  return lengths;
}

// Where axes meet, the rows of points are divided by a length, so that they are comparable, and columns have 1 beside
// what they have of it. `J`, `lengths`: by joint.
template <class S>
void compare_rows(const Robot<S>& robot, const Loop<S>& loop, MatrixX<S>& J, MatrixX<S>& lengths) {
  using std::max;
  if (!aligns_axes(loop)) return;
  S length(0);
  for (const Joint<S>& joint : robot.joints) {
    if (joint.index >= 0 && joint.type == JointType::revolute) length = max(length, lengths(0, joint.index));
  }
  if (!(length > S(0))) length = S(1);
  for (std::size_t r = 0; r < loop.rows.size(); ++r) {
    if (loop.rows[r] < kOfPoints) J.row(static_cast<Eigen::Index>(r)) /= length;
  }
  lengths /= length;
  for (const Joint<S>& joint : robot.joints) {
    const bool turns = joint.index >= 0 && joint.type == JointType::revolute;
    if (turns && (moves_end(robot, loop, joint, 0) || moves_end(robot, loop, joint, 1)))
      lengths(0, joint.index) += S(1);
  }
}

}  // namespace detail

// How far the loops are from being singular: the smallest determinant that is divided by, against the product of the
// lengths of its columns. 1 if there are no loops. A column that is short because an axis goes through the loop's point
// makes a loop singular, too: it counts as a thousandth of what the links allow at least.
template <class S>
S loop_regularity(const Robot<S>& robot, const VectorX<S>& q) {
  using std::abs;
  using std::max;
  using std::min;
  VectorX<S> room;
  const VectorX<S>& positions = of_joints(robot, q, room);
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

// How the joints move with the coordinates: A, or A G.
template <class S>
MatrixX<S> motion_of_joints(const Robot<S>& robot, const VectorX<S>& q) {
  return robot.loops.empty() ? robot.coupling : MatrixX<S>(robot.coupling.lazyProduct(loop_motion(robot, q)));
}

// Rates of the moving joints; `room` holds them where they are not the coordinates'.
template <class S>
const VectorX<S>& rates_of_joints(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd, VectorX<S>& room) {
  if (robot.loops.empty()) return of_joints(robot, qd, room);
  room = motion_of_joints(robot, q).lazyProduct(qd);
  return room;
}

template <class S>
const VectorX<S>& accelerations_of_joints(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd,
                                          const VectorX<S>& qdd, VectorX<S>& room) {
  if (robot.loops.empty()) return of_joints(robot, qdd, room);
  room = motion_of_joints(robot, q).lazyProduct(qdd) + robot.coupling.lazyProduct(loop_drift(robot, q, qd));
  return room;
}

// Torques at the coordinates, of those at the joints.
template <class S>
VectorX<S> at_coordinates(const Robot<S>& robot, const VectorX<S>& q, VectorX<S> tau) {
  if (robot.coupling.size() == 0) return tau;
  if (robot.loops.empty()) return robot.coupling.transpose().lazyProduct(tau);
  return motion_of_joints(robot, q).transpose().lazyProduct(tau);
}

}  // namespace flatdyn::reference
