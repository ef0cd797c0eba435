// SPDX-License-Identifier: BSD-3-Clause
// The recursive Newton–Euler algorithm of the textbook, (7.107)–(7.114), over any scalar, for trees of joints with any
// axes, in which every joint moves by itself.
#pragma once

#include "flatdyn/reference/robot.hpp"

namespace flatdyn::reference {

// The influences besides the joints' motion. h_e: the force and moment that the tip exerts on the environment, in base
// axes, the moment about the tip's origin, (7.42).
template <class S>
struct Environment {
  bool gravity = true;
  bool friction = true;
  bool springs = true;
  Vector3<S> f_e = Vector3<S>::Zero();   // N
  Vector3<S> mu_e = Vector3<S>::Zero();  // N m
};

template <class S>
struct Pose {
  Matrix3<S> R = Matrix3<S>::Identity();  // in the base frame
  Vector3<S> p = Vector3<S>::Zero();      // m
};

// The motion of a link's frame, in its own axes.
template <class S>
struct LinkMotion {
  Matrix3<S> R = Matrix3<S>::Identity();   // link axes in base axes
  Vector3<S> omega = Vector3<S>::Zero();   // rad/s
  Vector3<S> domega = Vector3<S>::Zero();  // rad/s^2
  Vector3<S> ddp = Vector3<S>::Zero();     // acceleration of the origin, minus g_0, m/s^2
};

namespace detail {

template <class S>
S sign(const S& x) {
  return S((x > S(0)) - (x < S(0)));
}

// The dry friction of a joint at a rate.
template <class S>
S dry_friction(const Joint<S>& joint, const S& v) {
  using std::tanh;
  const DryFriction<S>& dry = joint.dry;
  const bool smooth = dry.speed > S(0);
  const S s = smooth ? S(tanh((v + dry.offset) / dry.speed)) : sign(v);
  S torque = joint.coulomb * s + dry.asymmetry * s * s;
  if (smooth) torque -= joint.coulomb * S(tanh(dry.offset / dry.speed));
  if (!(dry.stribeck_speed > S(0))) return torque;
  const S ratio = v / dry.stribeck_speed;
  return torque + dry.excess * s / (S(1) + ratio * ratio);
}

// ω̇ × r + ω × (ω × r): the acceleration of a point at r relative to the frame's origin.
template <class S>
Vector3<S> swing(const Vector3<S>& omega, const Vector3<S>& domega, const Vector3<S>& r) {
  return domega.cross(r) + omega.cross(omega.cross(r));
}

// The forward recursion over one joint, (7.107)–(7.109).
template <class S>
LinkMotion<S> moved(const LinkMotion<S>& parent, const Joint<S>& joint, const JointPlacement<S>& place, const S& qd,
                    const S& qdd) {
  LinkMotion<S> child;
  const Vector3<S>& z = place.z_parent;
  Vector3<S> omega = parent.omega, domega = parent.domega;
  Vector3<S> ddp = parent.ddp + swing(parent.omega, parent.domega, place.before);
  if (joint.type == JointType::revolute) {
    omega += qd * z;
    domega += qdd * z + qd * parent.omega.cross(z);
  } else if (joint.type == JointType::prismatic) {
    ddp += qdd * z + S(2) * qd * parent.omega.cross(z);
  }
  child.R = parent.R * place.R;
  child.omega = place.R.transpose() * omega;
  child.domega = place.R.transpose() * domega;
  child.ddp = place.R.transpose() * ddp + swing(child.omega, child.domega, place.after);
  return child;
}

// The same over a spherical joint, with the angular velocity of the child relative to the parent, and the derivatives
// of its components, in the child's axes.
template <class S>
LinkMotion<S> turned_freely(const LinkMotion<S>& parent, const JointPlacement<S>& place, const Vector3<S>& relative,
                            const Vector3<S>& rates) {
  LinkMotion<S> child;
  child.R = parent.R * place.R;
  const Vector3<S> carried = place.R.transpose() * parent.omega;
  child.omega = carried + relative;
  child.domega = place.R.transpose() * parent.domega + rates + carried.cross(relative);
  child.ddp = place.R.transpose() * (parent.ddp + swing(parent.omega, parent.domega, place.before)) +
              swing(child.omega, child.domega, place.after);
  return child;
}

// The entries of a spherical joint in the axes of the child link.
template <class S>
Vector3<S> in_child(const Joint<S>& joint, const VectorX<S>& v) {
  return joint.R_1.transpose() * v.template segment<3>(joint.index);
}

// Adds the inertial force and moment about the link's origin, (7.110), (7.112), (7.113).
template <class S>
void add_inertial_wrench(const Link<S>& link, const LinkMotion<S>& motion, Vector3<S>& f, Vector3<S>& mu) {
  for (const Inertial<S>& body : link.inertials) {
    const Vector3<S> F = body.mass * (motion.ddp + swing(motion.omega, motion.domega, body.r_C));
    f += F;
    mu += body.r_C.cross(F) + body.inertia * motion.domega + motion.omega.cross(body.inertia * motion.omega);
  }
}

template <class S>
std::vector<Pose<S>> poses_of_tree(const Robot<S>& robot, const VectorX<S>& q) {
  std::vector<Pose<S>> poses(robot.links.size());
  for (const Joint<S>& joint : robot.joints) {
    const JointPlacement<S> place = placement(joint, joint.index >= 0 ? q[joint.index] : S(0));
    const Pose<S>& parent = poses[static_cast<std::size_t>(joint.parent)];
    Pose<S>& child = poses[static_cast<std::size_t>(joint.child)];
    child.R = parent.R * place.R;
    child.p = parent.p + parent.R * place.before + child.R * place.after;
  }
  return poses;
}

// The motion of the root link: at rest but for gravity, or that of a floating base. The derivatives of the components
// of its velocity are not its acceleration, as its axes turn: p̈ = v̇ + ω × v.
template <class S>
LinkMotion<S> motion_of_root(const Robot<S>& robot, const VectorX<S>& qd, const VectorX<S>& qdd, bool gravity) {
  LinkMotion<S> root;
  if (gravity) root.ddp = -robot.gravity;
  if (!robot.floating_base) return root;
  const Vector3<S> v = qd.template head<3>();
  root.omega = qd.template segment<3>(3);
  root.domega = qdd.template segment<3>(3);
  root.ddp += qdd.template head<3>() + root.omega.cross(v);
  return root;
}

// The links' motion for the motion of all moving joints; a fixed joint changes only the frame.
template <class S>
std::vector<LinkMotion<S>> motions_of_tree(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd,
                                           const VectorX<S>& qdd, bool gravity) {
  std::vector<LinkMotion<S>> motions(robot.links.size());
  motions[static_cast<std::size_t>(robot.root)] = motion_of_root(robot, qd, qdd, gravity);
  for (const Joint<S>& joint : robot.joints) {
    const bool moves = joint.index >= 0;
    const S zero(0);
    const JointPlacement<S> place = placement(joint, moves ? q[joint.index] : zero);
    if (joint.type == JointType::spherical) {
      motions[static_cast<std::size_t>(joint.child)] = turned_freely<S>(
          motions[static_cast<std::size_t>(joint.parent)], place, in_child(joint, qd), in_child(joint, qdd));
      continue;
    }
    motions[static_cast<std::size_t>(joint.child)] =
        moved(motions[static_cast<std::size_t>(joint.parent)], joint, place, moves ? qd[joint.index] : zero,
              moves ? qdd[joint.index] : zero);
  }
  return motions;
}

// Adds what a floating base's own armature and friction need.
template <class S>
void add_torques_of_base(const Robot<S>& robot, const VectorX<S>& qd, const VectorX<S>& qdd, bool friction,
                         VectorX<S>& tau) {
  const Vector3<S> v = qd.template head<3>(), omega = qd.template segment<3>(3);
  tau.template head<3>() += robot.base_armature * (qdd.template head<3>() + omega.cross(v));
  tau.template segment<3>(3) += robot.base_armature * qdd.template segment<3>(3);
  if (!friction) return;
  tau.template head<6>() += robot.base_viscous * qd.template head<6>();
  for (Eigen::Index k = 0; k < 3; ++k) tau[3 + k] += robot.base_coulomb * sign(omega[k]);
}

// The torques at all moving joints for their motion, N m or N.
template <class S>
VectorX<S> torques_of_tree(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd, const VectorX<S>& qdd,
                           const Environment<S>& environment) {
  const std::vector<LinkMotion<S>> motions = motions_of_tree(robot, q, qd, qdd, environment.gravity);
  std::vector<Vector3<S>> f(robot.links.size(), Vector3<S>::Zero()), mu(robot.links.size(), Vector3<S>::Zero());
  for (std::size_t l = 0; l < robot.links.size(); ++l) add_inertial_wrench(robot.links[l], motions[l], f[l], mu[l]);

  const auto tip = static_cast<std::size_t>(robot.tip);
  const Vector3<S> f_e = motions[tip].R.transpose() * environment.f_e;
  f[tip] += f_e;
  mu[tip] += motions[tip].R.transpose() * environment.mu_e + robot.p_tip.cross(f_e);

  VectorX<S> tau = VectorX<S>::Zero(q.size());
  // The spin of rotors acts on their carrier, (7.105), and on their joint, (7.111), (7.114).
  for (const Joint<S>& joint : robot.joints) {
    if (joint.index < 0) continue;
    if (joint.type == JointType::spherical) {
      if (environment.friction) {
        tau.template segment<3>(joint.index) += joint.viscous * qd.template segment<3>(joint.index);
      }
      continue;
    }
    const S &v = qd[joint.index], &a = qdd[joint.index];
    tau[joint.index] += joint.armature * a;
    if (environment.friction) tau[joint.index] += joint.viscous * v + dry_friction(joint, v);
    if (environment.springs) tau[joint.index] += joint.stiffness * (q[joint.index] - joint.spring_q_0);
    const Rotor<S>& rotor = joint.rotor;
    const LinkMotion<S>& carrier = motions[static_cast<std::size_t>(rotor.carrier)];
    const Vector3<S> turning = carrier.omega.cross(rotor.axis);
    const S spin = rotor.gear_ratio * rotor.inertia;
    mu[static_cast<std::size_t>(rotor.carrier)] += spin * a * rotor.axis + spin * v * turning;
    // Only the component of ω̇_m along z_m counts: k_r q̇ ω × z_m is normal to it.
    tau[joint.index] += spin * (carrier.domega.dot(rotor.axis) + rotor.gear_ratio * a);
  }

  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    const Joint<S>& joint = robot.joints[j];
    const auto child = static_cast<std::size_t>(joint.child), parent = static_cast<std::size_t>(joint.parent);
    const JointPlacement<S> place = placement(joint, joint.index >= 0 ? q[joint.index] : S(0));
    const Vector3<S> at_joint = mu[child] + place.after.cross(f[child]);
    if (joint.type == JointType::revolute) tau[joint.index] += at_joint.dot(place.z_child);
    if (joint.type == JointType::prismatic) tau[joint.index] += f[child].dot(place.z_child);
    if (joint.type == JointType::spherical) tau.template segment<3>(joint.index) += joint.R_1 * at_joint;
    const Vector3<S> force = place.R * f[child];
    f[parent] += force;
    mu[parent] += place.R * at_joint + place.before.cross(force);
  }
  if (robot.floating_base) {
    tau.template head<3>() = f[static_cast<std::size_t>(robot.root)];
    tau.template segment<3>(3) = mu[static_cast<std::size_t>(robot.root)];
    add_torques_of_base(robot, qd, qdd, environment.friction, tau);
  }
  return tau;
}

}  // namespace detail

}  // namespace flatdyn::reference
