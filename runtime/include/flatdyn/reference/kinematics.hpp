// SPDX-License-Identifier: BSD-3-Clause
// Poses, Jacobians and energies of the reference.
#pragma once

#include "flatdyn/reference/newton_euler.hpp"

namespace flatdyn::reference {

template <class S>
std::vector<Pose<S>> link_poses(const Robot<S>& robot, const VectorX<S>& coordinates) {
  VectorX<S> room;
  return detail::poses_of_tree(robot, positions_of_joints(robot, coordinates, room));
}

template <class S>
Pose<S> tip_pose(const Robot<S>& robot, const VectorX<S>& q) {
  const Pose<S> link = link_poses(robot, q)[static_cast<std::size_t>(robot.tip)];
  return {link.R * robot.R_tip, link.p + link.R * robot.p_tip};
}

// The geometric Jacobian of the tip, base axes, linear rows first, (7.18), (7.19).
template <class S>
MatrixX<S> jacobian(const Robot<S>& robot, const VectorX<S>& q) {
  const std::vector<Pose<S>> poses = link_poses(robot, q);
  const Vector3<S> p_e = tip_pose(robot, q).p;
  MatrixX<S> J = MatrixX<S>::Zero(6, robot.base_size() + robot.joint_count());
  if (robot.floating_base) {
    J.template leftCols<6>().setIdentity();
    for (int k = 0; k < 3; ++k) J.col(3 + k).template head<3>() = Vector3<S>::Unit(k).cross(p_e);
  }
  int link = robot.tip;
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    const Joint<S>& joint = robot.joints[j];
    if (joint.child != link) continue;
    link = joint.parent;
    if (joint.index < 0) continue;
    const Pose<S>& parent = poses[static_cast<std::size_t>(joint.parent)];
    const Vector3<S> z = parent.R * joint.R_0 * joint.axis;
    const Vector3<S> origin = parent.p + parent.R * joint.p_0;
    if (joint.type == JointType::spherical) {
      const Matrix3<S> axes = parent.R * joint.R_0 * joint.orientation;
      for (int k = 0; k < 3; ++k) {
        const Vector3<S> axis = axes.col(k);
        J.col(joint.index + k).template head<3>() = axis.cross(p_e - origin);
        J.col(joint.index + k).template tail<3>() = axis;
      }
    } else if (joint.type == JointType::prismatic) {
      J.col(joint.index).template head<3>() = z;
    } else {
      J.col(joint.index).template head<3>() = z.cross(p_e - origin);
      J.col(joint.index).template tail<3>() = z;
    }
  }
  if (robot.coupling.size() > 0) J = MatrixX<S>(J.lazyProduct(motion_of_joints(robot, q)));
  return J;
}

// J̇ q̇ of the tip: its acceleration while q̈ = 0, base axes, linear part first.
template <class S>
VectorX<S> jacobian_dot_qd(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd) {
  const VectorX<S> zero = VectorX<S>::Zero(robot.size());
  const LinkMotion<S> tip = link_motions(robot, q, qd, zero, false)[static_cast<std::size_t>(robot.tip)];
  VectorX<S> a(6);
  a.template head<3>() = tip.R * (tip.ddp + detail::swing(tip.omega, tip.domega, robot.p_tip));
  a.template tail<3>() = tip.R * tip.domega;
  return a;
}

// The potential energy, J, (7.36), zero for a mass at the base frame's origin, with ½ k (q - q_0)² of every spring.
template <class S>
S potential_energy(const Robot<S>& robot, const VectorX<S>& q) {
  const std::vector<Pose<S>> poses = link_poses(robot, q);
  S U(0);
  VectorX<S> room;
  const VectorX<S>& positions = positions_of_joints(robot, q, room);
  for (const Joint<S>& joint : robot.joints) {
    if (joint.index < 0) continue;
    const S stretch = positions[joint.index] - joint.spring_q_0;
    U += joint.stiffness * stretch * stretch / S(2);
  }
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    for (const Inertial<S>& body : robot.links[l].inertials) {
      U -= body.mass * robot.gravity.dot(poses[l].p + poses[l].R * body.r_C);
    }
  }
  return U;
}

// The kinetic energy, J, (7.20), (7.30): links with still rotors, then the part of the rotors' spin.
template <class S>
S kinetic_energy(const Robot<S>& robot, const VectorX<S>& coordinates, const VectorX<S>& coordinate_rates) {
  VectorX<S> positions, rates;
  const VectorX<S>&q = positions_of_joints(robot, coordinates, positions),
        &qd = rates_of_joints(robot, coordinates, coordinate_rates, rates);
  struct Velocity {
    Vector3<S> omega = Vector3<S>::Zero(), v = Vector3<S>::Zero();  // link axes
  };
  std::vector<Velocity> velocities(robot.links.size());
  if (robot.floating_base) {
    velocities[static_cast<std::size_t>(robot.root)] = {qd.template segment<3>(3), qd.template head<3>()};
  }
  for (const Joint<S>& joint : robot.joints) {
    const JointPlacement<S> place = placement(joint, joint.index >= 0 ? q[joint.index] : S(0));
    const Velocity& parent = velocities[static_cast<std::size_t>(joint.parent)];
    Vector3<S> omega = parent.omega, v = parent.v + parent.omega.cross(place.before);
    if (joint.type == JointType::revolute) omega += qd[joint.index] * place.z_parent;
    if (joint.type == JointType::prismatic) v += qd[joint.index] * place.z_parent;
    Velocity& child = velocities[static_cast<std::size_t>(joint.child)];
    child.omega = place.R.transpose() * omega;
    if (joint.type == JointType::spherical) child.omega += detail::in_child(joint, qd);
    child.v = place.R.transpose() * v + child.omega.cross(place.after);
  }
  S twice(0);
  if (robot.floating_base) twice += robot.base_armature * qd.template head<6>().squaredNorm();
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Velocity& link = velocities[l];
    for (const Inertial<S>& body : robot.links[l].inertials) {
      const Vector3<S> v_C = link.v + link.omega.cross(body.r_C);
      twice += body.mass * v_C.dot(v_C) + link.omega.dot(body.inertia * link.omega);
    }
  }
  for (const Joint<S>& joint : robot.joints) {
    if (joint.index < 0) continue;
    const S& rate = qd[joint.index];
    twice += joint.armature * rate * rate;
    const S spin = joint.rotor.gear_ratio * rate;
    const Vector3<S>& omega = velocities[static_cast<std::size_t>(joint.rotor.carrier)].omega;
    twice += joint.rotor.inertia * spin * (S(2) * omega.dot(joint.rotor.axis) + spin);
  }
  return twice / S(2);
}

}  // namespace flatdyn::reference
