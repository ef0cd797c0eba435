// SPDX-License-Identifier: GPL-2.0-or-later
// The reference's robot as one of DART. The base of a floating robot has an orientation of its own in the world, and
// gravity is turned with it, so that quantities in world axes are never those in base axes.
//
// The relative Jacobians of DART's FreeJoint and BallJoint are constant: the identity, or its first columns, to the
// spatial velocity (omega, then v) of the child relative to the parent, in the child's axes. So the velocities of a
// FreeJoint are the twist of the base in base axes, its accelerations are the derivatives of these components, and its
// forces are moment and force in the same axes: flatdyn's numbers, in another order. Those of a BallJoint are flatdyn's
// of a spherical joint. The positions of both are a rotation vector, and the place of the base in the world's axes; the
// velocities are not their derivatives.
#pragma once

#include <cmath>
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <string>
#include <vector>

#include "support/joint_dynamics_peer.hpp"

namespace flatdyn::testing {

class DartTree : public JointDynamicsPeer {
 public:
  using Vector3 = reference::Vector3<double>;
  using Matrix3 = reference::Matrix3<double>;

  // `turn`: the rotation vector of a floating base's orientation. The robot's gravity is in base axes.
  explicit DartTree(const reference::Robot<double>& robot, const Vector3& turn = Vector3(0.5, -1.2, 0.8))
      : robot_(robot), skeleton_(dart::dynamics::Skeleton::create()), bodies_(robot.links.size(), nullptr) {
    if (robot.floating_base) add_base();
    for (const Joint& joint : robot.joints) add(joint);
    positions_ = Vector::Zero(static_cast<Eigen::Index>(skeleton_->getNumDofs()));
    Vector3 gravity = robot.gravity;
    if (robot.floating_base) {
      positions_.head<6>() << turn, Vector3(0.3, -0.2, 1.1);
      gravity = dart::math::expMapRot(turn) * gravity;
    }
    skeleton_->setGravity(gravity);
  }

  Vector inverse_dynamics(const Vector& q, const Vector& qd, const Vector& qdd) override {
    set_positions(q);
    skeleton_->setVelocities(in_dart(qd));
    skeleton_->setAccelerations(in_dart(qdd));
    skeleton_->computeInverseDynamics();
    return from_dart(skeleton_->getForces());
  }

  Matrix inertia_matrix(const Vector& q) override {
    set_positions(q);
    const Matrix& found = skeleton_->getMassMatrix();
    return Matrix::NullaryExpr(found.rows(), found.cols(),
                               [&](Eigen::Index i, Eigen::Index j) { return found(address(i), address(j)); });
  }

  Vector gravity(const Vector& q) override {
    set_positions(q);
    return from_dart(skeleton_->getGravityForces());
  }

  Vector bias(const Vector& q, const Vector& qd) {
    set_positions(q);
    skeleton_->setVelocities(in_dart(qd));
    return from_dart(skeleton_->getCoriolisAndGravityForces());
  }

  Vector forward_dynamics(const Vector& q, const Vector& qd, const Vector& tau) override {
    set_positions(q);
    skeleton_->setVelocities(in_dart(qd));
    skeleton_->setForces(in_dart(tau));
    skeleton_->computeForwardDynamics();
    return from_dart(skeleton_->getAccelerations());
  }

 private:
  using Joint = reference::Joint<double>;
  using Body = dart::dynamics::BodyNode;

  static Eigen::Isometry3d frame(const Matrix3& R, const Vector3& p) {
    Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
    placed.linear() = R;
    placed.translation() = p;
    return placed;
  }

  // DART reports duplicate names on stdout.
  template <class DartJoint>
  typename DartJoint::Properties properties_of(int link) const {
    typename DartJoint::Properties properties;
    properties.mName = "joint" + std::to_string(link);
    return properties;
  }

  template <class DartJoint>
  typename DartJoint::Properties properties_of(const Joint& joint) const {
    typename DartJoint::Properties properties = properties_of<DartJoint>(joint.child);
    properties.mT_ParentBodyToJoint = frame(joint.R_0, joint.p_0);
    properties.mT_ChildBodyToJoint = frame(joint.R_1, joint.p_1).inverse();
    return properties;
  }

  template <class DartJoint>
  typename DartJoint::Properties along_axis(const Joint& joint) const {
    typename DartJoint::Properties properties = properties_of<DartJoint>(joint);
    properties.mAxis = joint.axis;
    return properties;
  }

  // Adds a link and returns the index of its joint's first entry among DART's velocities.
  template <class DartJoint>
  int add_link(int link, Body* parent, const typename DartJoint::Properties& properties) {
    const Body::AspectProperties named("link" + std::to_string(link));
    const auto [joint, body] = skeleton_->createJointAndBodyNodePair<DartJoint>(parent, properties, named);
    body->setInertia(inertia_of(robot_.links[static_cast<std::size_t>(link)]));
    bodies_[static_cast<std::size_t>(link)] = body;
    return joint->getNumDofs() == 0 ? 0 : static_cast<int>(joint->getIndexInSkeleton(0));
  }

  static dart::dynamics::Inertia inertia_of(const reference::Link<double>& link) {
    Eigen::Matrix6d sum = Eigen::Matrix6d::Zero();
    for (const auto& part : link.inertials) {
      sum += dart::dynamics::Inertia(part.mass, part.r_C, part.inertia).getSpatialTensor();
    }
    return dart::dynamics::Inertia(sum);
  }

  void add_base() {
    add_link<dart::dynamics::FreeJoint>(robot_.root, nullptr, properties_of<dart::dynamics::FreeJoint>(robot_.root));
    addresses_ = {3, 4, 5, 0, 1, 2};
  }

  // A base that is fixed is the world.
  void add(const Joint& joint) {
    const int first = added(joint, bodies_[static_cast<std::size_t>(joint.parent)]);
    for (int k = 0; k < joint.size(); ++k) addresses_.push_back(first + k);
  }

  int added(const Joint& joint, Body* parent) {
    namespace dynamics = dart::dynamics;
    switch (joint.type) {
      case reference::JointType::revolute:
        return add_link<dynamics::RevoluteJoint>(joint.child, parent, along_axis<dynamics::RevoluteJoint>(joint));
      case reference::JointType::prismatic:
        return add_link<dynamics::PrismaticJoint>(joint.child, parent, along_axis<dynamics::PrismaticJoint>(joint));
      case reference::JointType::spherical:
        return add_link<dynamics::BallJoint>(joint.child, parent, properties_of<dynamics::BallJoint>(joint));
      case reference::JointType::fixed:
        break;
    }
    return add_link<dynamics::WeldJoint>(joint.child, parent, properties_of<dynamics::WeldJoint>(joint));
  }

  // The index among DART's velocities of an entry of q̇.
  int address(Eigen::Index entry) const { return addresses_[static_cast<std::size_t>(entry)]; }

  Vector in_dart(const Vector& v) const {
    Vector result(v.size());
    for (Eigen::Index k = 0; k < v.size(); ++k) result[address(k)] = v[k];
    return result;
  }
  Vector from_dart(const Vector& v) const {
    return Vector::NullaryExpr(v.size(), [&](Eigen::Index k) { return v[address(k)]; });
  }

  // The rotation vector of a unit quaternion w, x, y, z, by a turn of π at most.
  static Vector3 rotation_vector(const Eigen::Vector4d& quaternion) {
    const Vector3 r = quaternion.tail<3>() * (quaternion[0] < 0 ? -1 : 1);
    const double sine = r.norm();
    return sine > 0 ? Vector3(r * (2 * std::atan2(sine, std::abs(quaternion[0])) / sine)) : Vector3(r);
  }

  // Sets the joints' positions; the base stays where it is.
  void set_positions(const Vector& q) {
    Eigen::Index entry = 0;
    for (const Joint& joint : robot_.joints) {
      if (joint.index < 0) continue;
      const int first = address(joint.index);
      if (joint.type == reference::JointType::spherical) {
        positions_.segment<3>(first) = rotation_vector(q.segment<4>(entry));
        entry += 4;
      } else {
        positions_[first] = q[entry++];
      }
    }
    skeleton_->setPositions(positions_);
  }

  const reference::Robot<double>& robot_;
  dart::dynamics::SkeletonPtr skeleton_;
  std::vector<Body*> bodies_;   // by link; none for a base that is fixed
  std::vector<int> addresses_;  // by entry of q̇
  Vector positions_;            // DART's
};

}  // namespace flatdyn::testing
