// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/motion_magnitude.hpp"

#include <algorithm>

namespace flatdyn::reference {

namespace detail {

MotionMagnitude moved(const MotionMagnitude& parent, const Joint<double>& joint, double q, double qd, double qdd) {
  MotionMagnitude child = parent;
  const double slide = joint.type == JointType::prismatic ? std::abs(q) : 0;
  child.ddp += parent.swing(joint.p_0.norm() + slide);
  if (joint.type == JointType::revolute || joint.type == JointType::spherical) {
    child.omega += qd;
    child.domega += qdd + qd * parent.omega;
  } else if (joint.type == JointType::prismatic) {
    child.ddp += qdd + 2 * qd * parent.omega;
  }
  child.ddp += child.swing(joint.p_1.norm());
  return child;
}

double entry_of(const Joint<double>& joint, const VectorX<double>& values) {
  return joint.index < 0 ? 0 : values.segment(joint.index, joint.size()).norm();
}

MotionMagnitude magnitude_of_root(const Robot<double>& robot, const VectorX<double>& qd, const VectorX<double>& qdd,
                                  bool gravity) {
  MotionMagnitude root;
  if (gravity) root.ddp = robot.gravity.norm();
  if (!robot.floating_base) return root;
  root.omega = qd.segment<3>(3).norm();
  root.domega = qdd.segment<3>(3).norm();
  root.ddp += qdd.head<3>().norm() + root.omega * qd.head<3>().norm();
  return root;
}

VectorX<double> of_joints(const Robot<double>& robot, const VectorX<double>& q) {
  VectorX<double> joints = q.cwiseAbs();
  if (robot.coupling.size() > 0) joints = robot.coupling.cwiseAbs() * joints;
  if (!robot.floating_base) return joints;
  VectorX<double> positions = VectorX<double>::Zero(robot.base_size() + joints.size());
  positions.tail(joints.size()) = joints;
  return positions;
}

namespace {

// One value for each row of a loop: `of_points` for its points, `of_axes` for its axes.
VectorX<double> by_row(const Loop<double>& loop, double of_points, double of_axes) {
  VectorX<double> rows(static_cast<Eigen::Index>(loop.rows.size()));
  for (Eigen::Index r = 0; r < rows.size(); ++r) {
    rows[r] = loop.rows[static_cast<std::size_t>(r)] < kOfPoints ? of_points : of_axes;
  }
  return rows;
}

// The magnitude of one loop's Φ_q by joint: for a revolute joint, the length of the path to the end that it turns.
MatrixX<double> loop_jacobian_magnitude(const Robot<double>& robot, const Loop<double>& loop,
                                        const VectorX<double>& positions) {
  MatrixX<double> J = MatrixX<double>::Zero(static_cast<Eigen::Index>(loop.rows.size()), robot.joint_count());
  for (int end = 0; end < 2; ++end) {
    double way = loop.points[end].norm();
    for (int link = loop.links[end]; link != loop.carrier;) {
      const auto joint = std::find_if(robot.joints.begin(), robot.joints.end(),
                                      [link](const Joint<double>& each) { return each.child == link; });
      if (joint == robot.joints.end()) break;
      way += joint->p_1.norm();
      if (moves_end(robot, loop, *joint, end)) {
        const bool slides = joint->type == JointType::prismatic;
        J.col(column_of(robot, *joint)) += slides ? by_row(loop, 1, 0) : by_row(loop, way, 1);
        if (slides) way += std::abs(positions[joint->index]);
      }
      way += joint->p_0.norm();
      link = joint->parent;
    }
  }
  return J;
}

// The length of the path from the carrier of a loop to both of its ends, m.
double length_of(const Robot<double>& robot, const Loop<double>& loop, const VectorX<double>& positions) {
  double length = 0;
  for (int end = 0; end < 2; ++end) {
    length += loop.points[end].norm();
    int link = loop.links[end];
    for (std::size_t j = robot.joints.size(); j-- > 0 && link != loop.carrier;) {
      const Joint<double>& joint = robot.joints[j];
      if (joint.child != link) continue;
      link = joint.parent;
      length += joint.p_0.norm() + joint.p_1.norm();
      if (joint.type == JointType::prismatic) length += positions[joint.index];
    }
  }
  return length;
}

// The magnitude of Φ̇_q q̇ of one loop: the acceleration of its ends, and of its axes.
VectorX<double> loop_drift_magnitude(const Robot<double>& robot, const Loop<double>& loop,
                                     const VectorX<double>& positions, const VectorX<double>& rates) {
  std::vector<MotionMagnitude> motions(robot.links.size());
  for (const Joint<double>& joint : robot.joints) {
    const bool is_in_loop = moves_end(robot, loop, joint, 0) || moves_end(robot, loop, joint, 1);
    const MotionMagnitude& parent = motions[static_cast<std::size_t>(joint.parent)];
    motions[static_cast<std::size_t>(joint.child)] = moved(parent, joint, joint.index < 0 ? 0 : positions[joint.index],
                                                           is_in_loop ? std::abs(rates[joint.index]) : 0, 0);
  }
  double of_points = 0, of_axes = 0, turns = 2;
  for (int end = 0; end < 2; ++end) {
    const MotionMagnitude& link = motions[static_cast<std::size_t>(loop.links[end])];
    of_points += link.ddp + link.swing(loop.points[end].norm());
    of_axes += link.swing(1);
    turns *= link.omega;
  }
  return by_row(loop, of_points, of_axes + turns);
}

// The magnitudes of values of all entries of q that close the loops, Φ_q values + extra = 0, from the known ones of the
// independent entries: errors of the size of all terms, as they appear in the solution. `values`: the solution itself.
template <class Extra>
VectorX<double> completed_magnitude(const Robot<double>& robot, const VectorX<double>& q, VectorX<double> known,
                                    const VectorX<double>& values, const Extra& extra) {
  VectorX<double> room;
  const VectorX<double> positions = of_joints(robot, q);
  const std::vector<Pose<double>> poses = poses_of_tree(robot, positions_of_joints(robot, q, room));
  for (const Loop<double>& loop : robot.loops) {
    const MatrixX<double> own =
        dependent_columns<double>(loop, loop_jacobian_of_joints(robot, loop, poses) * robot.coupling);
    const MatrixX<double> size = loop_jacobian_magnitude(robot, loop, positions) * robot.coupling.cwiseAbs();
    VectorX<double> terms = size * known;
    terms += extra(loop);
    for (const int d : loop.dependent) terms += size.col(d) * std::abs(values[d]);
    const VectorX<double> found = own.inverse().cwiseAbs() * terms;
    for (std::size_t d = 0; d < loop.dependent.size(); ++d) {
      known[loop.dependent[d]] = found[static_cast<Eigen::Index>(d)];
    }
  }
  return known;
}

}  // namespace
}  // namespace detail

MatrixX<double> loop_motion_magnitude(const Robot<double>& robot, const VectorX<double>& q) {
  const MatrixX<double> G = loop_motion(robot, q);
  MatrixX<double> result(G.rows(), G.cols());
  for (Eigen::Index a = 0; a < G.cols(); ++a) {
    const VectorX<double> unit = VectorX<double>::Unit(q.size(), robot.independent[static_cast<std::size_t>(a)]);
    const auto nothing = [](const Loop<double>& loop) { return detail::by_row(loop, 0, 0); };
    result.col(a) = detail::completed_magnitude(robot, q, unit, VectorX<double>(G.col(a)), nothing);
  }
  return result;
}

Eigen::RowVectorXd loop_motion_growth(const Robot<double>& robot, const VectorX<double>& q) {
  const MatrixX<double> G = loop_motion_magnitude(robot, q);
  return (1 + G.maxCoeff()) * G.colwise().sum();
}

namespace detail {

MatrixX<double> motion_magnitude(const Robot<double>& robot, const VectorX<double>& q) {
  if (robot.loops.empty()) return rate_coupling(robot).cwiseAbs();
  return beside_base(robot, MatrixX<double>(robot.coupling.cwiseAbs() * loop_motion_magnitude(robot, q)));
}

VectorX<double> rates_of_joints(const Robot<double>& robot, const VectorX<double>& q, const VectorX<double>& qd) {
  if (robot.coupling.size() == 0) return qd.cwiseAbs();
  return motion_magnitude(robot, q) * qd.cwiseAbs();
}

}  // namespace detail

VectorX<double> loop_drift_magnitude(const Robot<double>& robot, const VectorX<double>& q, const VectorX<double>& qd) {
  const VectorX<double> positions = detail::of_joints(robot, q), rates = detail::rates_of_joints(robot, q, qd);
  const auto drift = [&](const Loop<double>& loop) {
    return detail::loop_drift_magnitude(robot, loop, positions, rates);
  };
  return detail::completed_magnitude(robot, q, VectorX<double>::Zero(q.size()), loop_drift(robot, q, qd), drift);
}

VectorX<double> loop_closure_magnitude(const Robot<double>& robot, const VectorX<double>& q) {
  std::vector<double> entries;
  const VectorX<double> positions = detail::of_joints(robot, q);
  for (const Loop<double>& loop : robot.loops) {
    const VectorX<double> rows = detail::by_row(loop, detail::length_of(robot, loop, positions), 1);
    entries.insert(entries.end(), rows.begin(), rows.end());
  }
  return Eigen::Map<const VectorX<double>>(entries.data(), static_cast<Eigen::Index>(entries.size()));
}

MatrixX<double> loop_jacobian_magnitude(const Robot<double>& robot, const VectorX<double>& q) {
  const VectorX<double> positions = detail::of_joints(robot, q);
  MatrixX<double> J(0, q.size());
  for (const Loop<double>& loop : robot.loops) {
    const MatrixX<double> rows = detail::loop_jacobian_magnitude(robot, loop, positions) * robot.coupling.cwiseAbs();
    J.conservativeResize(J.rows() + rows.rows(), Eigen::NoChange);
    J.bottomRows(rows.rows()) = rows;
  }
  return J;
}

VectorX<double> loop_step_magnitude(const Robot<double>& robot, const VectorX<double>& q) {
  const VectorX<double> positions = detail::of_joints(robot, q);
  const auto gap = [&](const Loop<double>& loop) {
    return detail::by_row(loop, detail::length_of(robot, loop, positions), 1);
  };
  return detail::completed_magnitude(robot, q, VectorX<double>::Zero(q.size()), loop_step(robot, q), gap);
}

namespace detail {

VectorX<double> accelerations_of_joints(const Robot<double>& robot, const VectorX<double>& q, const VectorX<double>& qd,
                                        const VectorX<double>& qdd) {
  VectorX<double> accelerations = rates_of_joints(robot, q, qdd);
  if (robot.loops.empty()) return accelerations;
  accelerations.tail(robot.joint_count()) += robot.coupling.cwiseAbs() * loop_drift_magnitude(robot, q, qd);
  return accelerations;
}

}  // namespace detail

}  // namespace flatdyn::reference
