// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/magnitude.hpp"

#include <algorithm>

namespace flatdyn::reference {

namespace detail {
namespace {

// That of a spring's torque at a joint whose position has this absolute value.
double spring_magnitude(const Joint<double>& joint, double q) {
  return std::abs(joint.stiffness) * (q + std::abs(joint.spring_q_0));
}

// That of the dry friction of a joint that moves.
double dry_friction_magnitude(const Joint<double>& joint) {
  const DryFriction<double>& dry = joint.dry;
  const double at_rest = dry.speed > 0 ? std::abs(std::tanh(dry.offset / dry.speed)) : 0;
  return std::abs(joint.coulomb) * (1 + at_rest) + std::abs(dry.excess) + std::abs(dry.asymmetry);
}

// Adds that of a floating base's own armature and friction.
void add_magnitude_of_base(const Robot<double>& robot, const VectorX<double>& qd, const VectorX<double>& qdd,
                           bool friction, VectorX<double>& tau) {
  const double armature = std::abs(robot.base_armature), viscous = std::abs(robot.base_viscous);
  const double v = qd.head<3>().norm(), omega = qd.segment<3>(3).norm();
  tau.head<3>().array() += armature * (qdd.head<3>().norm() + omega * v);
  tau.segment<3>(3).array() += armature * qdd.segment<3>(3).norm();
  if (!friction) return;
  tau.head<3>().array() += viscous * v;
  tau.segment<3>(3).array() += viscous * omega + (omega > 0 ? std::abs(robot.base_coulomb) : 0);
}

// The magnitude of each moving joint's torque for the magnitudes of their motion.
VectorX<double> torque_magnitude_of_tree(const Robot<double>& robot, const VectorX<double>& q,
                                         const VectorX<double>& qd, const VectorX<double>& qdd,
                                         const MagnitudeOptions& options) {
  std::vector<MotionMagnitude> motions(robot.links.size());
  motions[static_cast<std::size_t>(robot.root)] = magnitude_of_root(robot, qd, qdd, options.gravity);
  for (const Joint<double>& joint : robot.joints) {
    motions[static_cast<std::size_t>(joint.child)] =
        moved(motions[static_cast<std::size_t>(joint.parent)], joint, entry_of(joint, q), entry_of(joint, qd),
              entry_of(joint, qdd));
  }
  std::vector<double> f(robot.links.size(), 0), mu(robot.links.size(), 0);
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const MotionMagnitude& motion = motions[l];
    for (const Inertial<double>& body : robot.links[l].inertials) {
      const double F = std::abs(body.mass) * (motion.ddp + motion.swing(body.r_C.norm()));
      f[l] += F;
      mu[l] += body.r_C.norm() * F + body.inertia.norm() * (motion.domega + motion.omega * motion.omega);
    }
  }
  f[static_cast<std::size_t>(robot.tip)] += options.f_e;
  mu[static_cast<std::size_t>(robot.tip)] += options.mu_e + robot.p_tip.norm() * options.f_e;
  VectorX<double> tau = VectorX<double>::Zero(q.size());
  for (const Joint<double>& joint : robot.joints) {
    if (joint.index < 0) continue;
    const double v = entry_of(joint, qd), a = entry_of(joint, qdd);
    if (joint.type == JointType::spherical) {
      if (options.friction) tau.segment<3>(joint.index).array() += std::abs(joint.viscous) * v;
      continue;
    }
    tau[joint.index] += std::abs(joint.armature) * a;
    if (options.friction) tau[joint.index] += std::abs(joint.viscous) * v + (v > 0 ? dry_friction_magnitude(joint) : 0);
    if (options.springs) tau[joint.index] += spring_magnitude(joint, entry_of(joint, q));
    const Rotor<double>& rotor = joint.rotor;
    const MotionMagnitude& carrier = motions[static_cast<std::size_t>(rotor.carrier)];
    const double k = std::abs(rotor.gear_ratio), spin = k * std::abs(rotor.inertia);
    mu[static_cast<std::size_t>(rotor.carrier)] += spin * (a + v * carrier.omega);
    tau[joint.index] += spin * (carrier.domega + k * a);
  }
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    const Joint<double>& joint = robot.joints[j];
    const auto child = static_cast<std::size_t>(joint.child), parent = static_cast<std::size_t>(joint.parent);
    const double at_joint = mu[child] + joint.p_1.norm() * f[child];
    if (joint.type == JointType::revolute) tau[joint.index] += at_joint;
    if (joint.type == JointType::prismatic) tau[joint.index] += f[child];
    if (joint.type == JointType::spherical) tau.segment<3>(joint.index).array() += at_joint;
    const double slide = joint.type == JointType::prismatic ? entry_of(joint, q) : 0;
    f[parent] += f[child];
    mu[parent] += at_joint + (joint.p_0.norm() + slide) * f[child];
  }
  if (robot.floating_base) {
    tau.head<3>().setConstant(f[static_cast<std::size_t>(robot.root)]);
    tau.segment<3>(3).setConstant(mu[static_cast<std::size_t>(robot.root)]);
    add_magnitude_of_base(robot, qd, qdd, options.friction, tau);
  }
  return tau;
}

}  // namespace
}  // namespace detail

VectorX<double> torque_magnitude(const Robot<double>& robot, const VectorX<double>& q, const VectorX<double>& qd,
                                 const VectorX<double>& qdd, const MagnitudeOptions& options) {
  const VectorX<double> tau =
      detail::torque_magnitude_of_tree(robot, detail::of_joints(robot, q), detail::rates_of_joints(robot, q, qd),
                                       detail::accelerations_of_joints(robot, q, qd, qdd), options);
  return robot.coupling.size() == 0 ? tau : VectorX<double>(detail::motion_magnitude(robot, q).transpose() * tau);
}

MatrixX<double> inertia_magnitude(const Robot<double>& robot, const VectorX<double>& q) {
  const Eigen::Index n = robot.size();
  const VectorX<double> zero = VectorX<double>::Zero(n);
  MatrixX<double> B(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    B.col(j) = torque_magnitude(robot, q, zero, VectorX<double>::Unit(n, j),
                                {.gravity = false, .friction = false, .springs = false});
  }
  return B;
}

MatrixX<double> christoffel_magnitude(const Robot<double>& robot, const VectorX<double>& q) {
  const Eigen::Index n = robot.size();
  const VectorX<double> zero = VectorX<double>::Zero(n);
  MatrixX<double> c(n, n * (n + 1) / 2);
  for (Eigen::Index k = 0; k < n; ++k) {
    for (Eigen::Index j = 0; j <= k; ++j) {
      VectorX<double> qd = VectorX<double>::Unit(n, j);
      if (j != k) qd += VectorX<double>::Unit(n, k);
      c.col(k * (k + 1) / 2 + j) =
          torque_magnitude(robot, q, qd, zero, {.gravity = false, .friction = false, .springs = false});
    }
  }
  return c;
}

MatrixX<double> coriolis_magnitude(const Robot<double>& robot, const VectorX<double>& q, const VectorX<double>& qd) {
  const Eigen::Index n = robot.size();
  const MatrixX<double> c = christoffel_magnitude(robot, q);
  MatrixX<double> C = MatrixX<double>::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const Eigen::Index low = std::min(j, k), high = std::max(j, k);
      C.col(j) += c.col(high * (high + 1) / 2 + low) * std::abs(qd[k]);
    }
  }
  if (!robot.floating_base && !has_spherical_joints(robot)) return C;
  const MatrixX<double> B = inertia_magnitude(robot, q);
  for (const Joint<double>& joint : robot.joints) {
    if (joint.type != JointType::spherical) continue;
    const VectorX<double> more = B.middleCols<3>(joint.index).rowwise().sum() * detail::entry_of(joint, qd) / 2;
    for (int k = 0; k < 3; ++k) C.col(joint.index + k) += more;
  }
  if (!robot.floating_base) return C;
  const double v = qd.head<3>().norm(), omega = qd.segment<3>(3).norm();
  for (Eigen::Index j = 0; j < 6; ++j) {
    C.col(j) += B.leftCols<3>().rowwise().sum() * (j < 3 ? omega : v) / 2;
    if (j >= 3) C.col(j) += B.middleCols<3>(3).rowwise().sum() * omega / 2;
  }
  return C;
}

MatrixX<double> position_derivative_magnitude(const Robot<double>& robot, const VectorX<double>& q,
                                              const VectorX<double>& qd, const VectorX<double>& qdd) {
  const MagnitudeOptions options{.friction = false, .springs = false};
  const VectorX<double> positions = detail::of_joints(robot, q), rates = detail::rates_of_joints(robot, q, qd),
                        accelerations = detail::accelerations_of_joints(robot, q, qd, qdd);
  const VectorX<double> here = detail::torque_magnitude_of_tree(robot, positions, rates, accelerations, options);
  MatrixX<double> result = here.replicate(1, positions.size());
  for (const Joint<double>& joint : robot.joints) {
    if (joint.type != JointType::prismatic || joint.index < 0) continue;
    VectorX<double> further = positions;
    further[joint.index] += 1;
    result.col(joint.index) = detail::torque_magnitude_of_tree(robot, further, rates, accelerations, options) - here;
  }
  if (robot.floating_base) {
    const VectorX<double> none = VectorX<double>::Zero(rates.size());
    result.leftCols<3>().setZero();
    result.middleCols<3>(3) = detail::torque_magnitude_of_tree(robot, positions, none, none, options).replicate<1, 3>();
  }
  for (const Joint<double>& joint : robot.joints) {
    if (joint.index >= 0) result(joint.index, joint.index) += std::abs(joint.stiffness);
  }
  if (robot.coupling.size() == 0) return result;
  const MatrixX<double> A = detail::motion_magnitude(robot, q);
  result = MatrixX<double>(A.transpose() * result * A);
  if (!robot.loops.empty()) {
    result.rightCols(robot.size() - robot.base_size()) += A.transpose() * here * loop_motion_growth(robot, q);
  }
  return result;
}

double dry_friction_slope_magnitude(const Joint<double>& joint) {
  const DryFriction<double>& dry = joint.dry;
  double magnitude = 0;
  if (dry.speed > 0) {
    magnitude = (std::abs(joint.coulomb) + std::abs(dry.excess) + 2 * std::abs(dry.asymmetry)) / dry.speed;
  }
  if (dry.stribeck_speed > 0) magnitude += std::abs(dry.excess) / dry.stribeck_speed;
  return magnitude;
}

MatrixX<double> rate_derivative_magnitude(const Robot<double>& robot, const VectorX<double>& q,
                                          const VectorX<double>& qd) {
  VectorX<double> viscous = VectorX<double>::Zero(robot.base_size() + robot.joint_count());
  for (const Joint<double>& joint : robot.joints) {
    viscous.segment(std::max(joint.index, 0), joint.size())
        .setConstant(std::abs(joint.viscous) + dry_friction_slope_magnitude(joint));
  }
  viscous.head(robot.base_size()).setConstant(std::abs(robot.base_viscous));
  MatrixX<double> friction = viscous.asDiagonal();
  if (robot.coupling.size() > 0) {
    const MatrixX<double> A = detail::motion_magnitude(robot, q);
    friction = MatrixX<double>(A.transpose() * friction * A);
  }
  return 2 * coriolis_magnitude(robot, q, qd) + friction;
}

double reach(const Robot<double>& robot, const VectorX<double>& coordinates) {
  const VectorX<double> q = detail::of_joints(robot, coordinates);
  double length = robot.p_tip.norm();
  int link = robot.tip;
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    const Joint<double>& joint = robot.joints[j];
    if (joint.child != link) continue;
    link = joint.parent;
    length += joint.p_0.norm() + joint.p_1.norm();
    if (joint.type == JointType::prismatic) length += std::abs(q[joint.index]);
  }
  return length;
}

MatrixX<double> jacobian_magnitude(const Robot<double>& robot, const VectorX<double>& q) {
  const double way = reach(robot, q);
  MatrixX<double> J = MatrixX<double>::Zero(6, robot.base_size() + robot.joint_count());
  if (robot.floating_base) {
    J.topLeftCorner<3, 3>().setOnes();
    J.topRows<3>().middleCols<3>(3).setConstant(way);
    J.bottomRows<3>().middleCols<3>(3).setOnes();
  }
  int link = robot.tip;
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    const Joint<double>& joint = robot.joints[j];
    if (joint.child != link) continue;
    link = joint.parent;
    if (joint.type == JointType::prismatic) J.col(joint.index).head<3>().setOnes();
    if (joint.type == JointType::revolute) J.col(joint.index) << way, way, way, 1, 1, 1;
    for (int k = 0; joint.type == JointType::spherical && k < 3; ++k) J.col(joint.index + k) << way, way, way, 1, 1, 1;
  }
  if (robot.coupling.size() > 0) J = MatrixX<double>(J * detail::motion_magnitude(robot, q));
  return J;
}

Eigen::Vector2d tip_acceleration_magnitude(const Robot<double>& robot, const VectorX<double>& coordinates,
                                           const VectorX<double>& coordinate_rates) {
  const VectorX<double> q = detail::of_joints(robot, coordinates),
                        qd = detail::rates_of_joints(robot, coordinates, coordinate_rates),
                        qdd = detail::accelerations_of_joints(robot, coordinates, coordinate_rates,
                                                              VectorX<double>::Zero(robot.size()));
  std::vector<detail::MotionMagnitude> motions(robot.links.size());
  motions[static_cast<std::size_t>(robot.root)] = detail::magnitude_of_root(robot, qd, qdd, false);
  for (const Joint<double>& joint : robot.joints) {
    const auto entry = [&joint](const VectorX<double>& v) { return detail::entry_of(joint, v); };
    motions[static_cast<std::size_t>(joint.child)] =
        detail::moved(motions[static_cast<std::size_t>(joint.parent)], joint, entry(q), entry(qd), entry(qdd));
  }
  const detail::MotionMagnitude& tip = motions[static_cast<std::size_t>(robot.tip)];
  return {tip.ddp + tip.swing(robot.p_tip.norm()), tip.domega};
}

double potential_magnitude(const Robot<double>& robot, const VectorX<double>& coordinates) {
  const VectorX<double> q = detail::of_joints(robot, coordinates);
  std::vector<double> way(robot.links.size(), 0);
  for (const Joint<double>& joint : robot.joints) {
    const double slide = joint.type == JointType::prismatic ? std::abs(q[joint.index]) : 0;
    way[static_cast<std::size_t>(joint.child)] =
        way[static_cast<std::size_t>(joint.parent)] + joint.p_0.norm() + slide + joint.p_1.norm();
  }
  double U = 0;
  for (const Joint<double>& joint : robot.joints) {
    if (joint.index < 0) continue;
    const double stretch = std::abs(q[joint.index]) + std::abs(joint.spring_q_0);
    U += detail::spring_magnitude(joint, std::abs(q[joint.index])) * stretch / 2;
  }
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    for (const Inertial<double>& body : robot.links[l].inertials) {
      U += std::abs(body.mass) * robot.gravity.norm() * (way[l] + body.r_C.norm());
    }
  }
  return U;
}

}  // namespace flatdyn::reference
