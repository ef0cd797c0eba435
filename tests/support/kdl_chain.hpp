// SPDX-License-Identifier: GPL-2.0-or-later
// The reference's robot as one of the Orocos Kinematics and Dynamics Library, which has no rotors (its joints' inertia
// is our armature) and no friction.
#pragma once

#include <kdl/chain.hpp>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/jntarray.hpp>
#include <string>
#include <vector>

#include "flatdyn/reference/kinematics.hpp"
#include "support/joint_dynamics_peer.hpp"

namespace flatdyn::testing {

inline KDL::Vector kdl(const reference::Vector3<double>& v) { return {v.x(), v.y(), v.z()}; }

inline KDL::Frame kdl(const reference::Matrix3<double>& R, const reference::Vector3<double>& p) {
  return {KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)), kdl(p)};
}

inline KDL::JntArray kdl(const reference::VectorX<double>& v) {
  KDL::JntArray array(static_cast<unsigned>(v.size()));
  array.data = v;
  return array;
}

inline KDL::RigidBodyInertia kdl(const reference::Link<double>& link) {
  KDL::RigidBodyInertia sum = KDL::RigidBodyInertia::Zero();
  for (const auto& body : link.inertials) {
    const auto& I = body.inertia;
    sum = sum + KDL::RigidBodyInertia(body.mass, kdl(body.r_C),
                                      KDL::RotationalInertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)));
  }
  return sum;
}

// A joint consists of two segments: its constant displacement, then the motion with the link after it.
inline std::vector<KDL::Segment> segments(const reference::Robot<double>& robot,
                                          const reference::Joint<double>& joint) {
  const std::string name = std::to_string(joint.child);
  const auto type = joint.type == reference::JointType::revolute    ? KDL::Joint::RotAxis
                    : joint.type == reference::JointType::prismatic ? KDL::Joint::TransAxis
                                                                    : KDL::Joint::Fixed;
  const KDL::Joint still("still" + name, KDL::Joint::Fixed);
  const KDL::Joint moving = type == KDL::Joint::Fixed ? KDL::Joint("joint" + name, KDL::Joint::Fixed)
                                                      : KDL::Joint("joint" + name, KDL::Vector::Zero(), kdl(joint.axis),
                                                                   type, 1, 0, joint.armature);
  return {KDL::Segment("origin" + name, still, kdl(joint.R_0, joint.p_0)),
          KDL::Segment("link" + name, moving, kdl(joint.R_1, joint.p_1),
                       kdl(robot.links[static_cast<std::size_t>(joint.child)]))};
}

inline KDL::Chain kdl_chain(const reference::Robot<double>& robot) {
  KDL::Chain chain;
  for (const auto& joint : robot.joints) {
    for (const auto& segment : segments(robot, joint)) chain.addSegment(segment);
  }
  chain.addSegment(KDL::Segment("tip", KDL::Joint("to_tip", KDL::Joint::Fixed), kdl(robot.R_tip, robot.p_tip)));
  return chain;
}

class KdlChainPeer : public JointDynamicsPeer {
 public:
  explicit KdlChainPeer(const reference::Robot<double>& robot)
      : chain_(kdl_chain(robot)), gravity_(kdl(robot.gravity)), result_(static_cast<unsigned>(robot.joint_count())) {}

  Vector inverse_dynamics(const Vector& q, const Vector& qd, const Vector& qdd) override {
    KDL::ChainIdSolver_RNE(chain_, gravity_).CartToJnt(kdl(q), kdl(qd), kdl(qdd), none_, result_);
    return result_.data;
  }
  Matrix inertia_matrix(const Vector& q) override {
    KDL::JntSpaceInertiaMatrix B(static_cast<int>(result_.rows()));
    KDL::ChainDynParam(chain_, gravity_).JntToMass(kdl(q), B);
    return B.data;
  }
  Vector gravity(const Vector& q) override {
    KDL::ChainDynParam(chain_, gravity_).JntToGravity(kdl(q), result_);
    return result_.data;
  }
  Vector forward_dynamics(const Vector& q, const Vector& qd, const Vector& tau) override {
    KDL::ChainFdSolver_RNE(chain_, gravity_).CartToJnt(kdl(q), kdl(qd), kdl(tau), none_, result_);
    return result_.data;
  }

 private:
  KDL::Chain chain_;
  KDL::Vector gravity_;
  KDL::JntArray result_;
  KDL::Wrenches none_ = KDL::Wrenches(chain_.getNrOfSegments(), KDL::Wrench::Zero());
};

}  // namespace flatdyn::testing
