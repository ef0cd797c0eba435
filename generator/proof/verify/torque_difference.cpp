// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/torque_difference.hpp"

#include <algorithm>
#include <cmath>

#include "robot/model/rounded_up.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {
namespace {

using Robot50 = reference::Robot<Real50>;
using Link50 = reference::Link<Real50>;
using Joint50 = reference::Joint<Real50>;

double size_of(const Real50& number) { return std::abs(number.convert_to<double>()); }

// A size, and a bound of the difference between the two robots.
struct DifferenceBound {
  double size = 0, difference = 0;

  DifferenceBound& operator+=(const DifferenceBound& b) {
    size += b.size;
    difference += b.difference;
    return *this;
  }
};

DifferenceBound operator+(DifferenceBound a, const DifferenceBound& b) { return a += b; }
DifferenceBound operator*(const DifferenceBound& a, const DifferenceBound& b) {
  return {a.size * b.size, a.difference * b.size + a.size * b.difference + a.difference * b.difference};
}
DifferenceBound operator*(double factor, const DifferenceBound& a) { return {factor * a.size, factor * a.difference}; }

// The bound for two vectors or matrices, by their Frobenius norms.
template <class M>
DifferenceBound bound_of(const M& a, const M& b) {
  return {std::max(size_of(a.norm()), size_of(b.norm())), size_of(M(a - b).norm())};
}
DifferenceBound bound_of(const Real50& a, const Real50& b) {
  return {std::max(size_of(a), size_of(b)), size_of(a - b)};
}

// A rotation, which keeps lengths.
DifferenceBound rotation(double difference) { return {1, difference}; }

// The inertial parameters of a link about its frame's origin.
struct LinkBound {
  DifferenceBound mass, first_moment, inertia;
};

LinkBound bound_of(const Link50& a, const Link50& b) {
  struct Sum {
    Real50 mass = 0;
    reference::Vector3<Real50> first_moment = reference::Vector3<Real50>::Zero();
    reference::Matrix3<Real50> inertia = reference::Matrix3<Real50>::Zero();
  };
  const auto sum_of = [](const Link50& link) {
    Sum sum;
    for (const auto& body : link.inertials) {
      const auto& r = body.r_C;
      sum.mass += body.mass;
      sum.first_moment += body.mass * r;
      sum.inertia += body.inertia + body.mass * (r.dot(r) * reference::Matrix3<Real50>::Identity() - r * r.transpose());
    }
    return sum;
  };
  const Sum x = sum_of(a), y = sum_of(b);
  return {bound_of(x.mass, y.mass), bound_of(x.first_moment, y.first_moment), bound_of(x.inertia, y.inertia)};
}

// The motion of a link's frame: ω, ω̇ and p̈ - g_0.
struct MotionDifference {
  DifferenceBound omega, domega, ddp;
};

struct WrenchDifference {
  DifferenceBound force, moment;
};

class TorqueDifference {
 public:
  TorqueDifference(const Robot50& a, const Robot50& b, const std::vector<MotionLimits>& limits,
                   const MotionOfBase& base)
      : a_(a), b_(b), limits_(limits), base_(base), motions_(a.links.size()), wrenches_(a.links.size()) {}

  double largest() {
    MotionDifference& root = motions_[index(a_.root)];
    root = {{base_.omega, 0}, {base_.domega, 0}, bound_of(a_.gravity, b_.gravity)};
    root.ddp.size += base_.ddp;
    for (std::size_t j = 0; j < a_.joints.size(); ++j) move(j);
    for (std::size_t l = 0; l < a_.links.size(); ++l) load(l);
    for (std::size_t j = 0; j < a_.joints.size(); ++j) drive(j);
    double worst = 0;
    for (std::size_t j = a_.joints.size(); j-- > 0;) worst = std::max(worst, hand_on(j));
    const WrenchDifference& on_base = wrenches_[index(a_.root)];
    if (a_.floating_base) worst = std::max({worst, on_base.force.difference, on_base.moment.difference});
    return worst * kRoundingMargin;
  }

 private:
  static constexpr double kOfAxis = 6;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  // Entries of `limits_` are those of q, without a floating base.
  MotionLimits limits_of(const Joint50& joint) const {
    return joint.index < 0 ? MotionLimits{} : limits_[index(joint.index - a_.base_size())];
  }

  DifferenceBound axis(std::size_t j) const { return {1, bound_of(a_.joints[j].axis, b_.joints[j].axis).difference}; }

  // The rotation of the child in the parent: |Rot(u_a, q) - Rot(u_b, q)| <= 6 |u_a - u_b|.
  DifferenceBound rotation_of(std::size_t j) const {
    const Joint50 &a = a_.joints[j], &b = b_.joints[j];
    const double of_axis = a.index < 0 ? 0 : kOfAxis * axis(j).difference;
    return rotation(bound_of(a.R_0, b.R_0).difference + of_axis + bound_of(a.R_1, b.R_1).difference);
  }

  // The rotation from the joint's axis to the child, and back.
  DifferenceBound axis_in_child(std::size_t j) const {
    return rotation(bound_of(a_.joints[j].R_1, b_.joints[j].R_1).difference) * axis(j);
  }

  // The displacement of the child's origin, in parent axes.
  DifferenceBound step(std::size_t j) const {
    const Joint50 &a = a_.joints[j], &b = b_.joints[j];
    const DifferenceBound before = rotation(bound_of(a.R_0, b.R_0).difference);
    const bool slides = a.type == reference::JointType::prismatic;
    const DifferenceBound turned = slides ? before : rotation(before.difference + kOfAxis * axis(j).difference);
    DifferenceBound sum = bound_of(a.p_0, b.p_0) + turned * bound_of(a.p_1, b.p_1);
    if (slides) sum += limits_of(a).position * (before * axis(j));
    return sum;
  }

  void move(std::size_t j) {
    const Joint50& joint = a_.joints[j];
    const MotionDifference& before = motions_[index(joint.parent)];
    const DifferenceBound R = rotation_of(j), z = axis_in_child(j);
    const MotionLimits limits = limits_of(joint);
    MotionDifference motion{R * before.omega, R * before.domega,
                            R * (before.ddp + (before.domega + before.omega * before.omega) * step(j))};
    if (joint.type == reference::JointType::revolute) {
      motion.domega += limits.acceleration * z + limits.speed * (motion.omega * z);
      motion.omega += limits.speed * z;
    } else if (joint.type == reference::JointType::prismatic) {
      motion.ddp += limits.acceleration * z + 2 * limits.speed * (motion.omega * z);
    }
    motions_[index(joint.child)] = motion;
  }

  // Adds the wrench that the link's inertia needs.
  void load(std::size_t l) {
    const LinkBound link = bound_of(a_.links[l], b_.links[l]);
    const MotionDifference& motion = motions_[l];
    const DifferenceBound swing = motion.domega + motion.omega * motion.omega;
    wrenches_[l].force += link.mass * motion.ddp + swing * link.first_moment;
    wrenches_[l].moment += link.inertia * swing + link.first_moment * motion.ddp;
  }

  // Adds the moment that a spinning rotor needs of its carrier: d/dt (k_r I_m q̇ z_m).
  void drive(std::size_t j) {
    const auto &a = a_.joints[j].rotor, &b = b_.joints[j].rotor;
    if (a.inertia == 0 && b.inertia == 0) return;
    const MotionLimits limits = limits_of(a_.joints[j]);
    const DifferenceBound spin = bound_of(a.gear_ratio, b.gear_ratio) * bound_of(a.inertia, b.inertia);
    const DifferenceBound z{1, bound_of(a.axis, b.axis).difference};
    wrenches_[index(a.carrier)].moment +=
        spin * (limits.acceleration * z + limits.speed * (motions_[index(a.carrier)].omega * z));
  }

  // The difference of the joint's torque; what its child needs is handed on to its parent.
  double hand_on(std::size_t j) {
    const Joint50& joint = a_.joints[j];
    const WrenchDifference& of_child = wrenches_[index(joint.child)];
    const DifferenceBound R = rotation_of(j);
    WrenchDifference& of_parent = wrenches_[index(joint.parent)];
    const DifferenceBound force = R * of_child.force;
    of_parent.force += force;
    of_parent.moment += R * of_child.moment + step(j) * force;
    if (joint.index < 0) return 0;
    const bool slides = joint.type == reference::JointType::prismatic;
    // The axis passes through the joint's own origin, which is p_1 away from the child's.
    const DifferenceBound lever =
        rotation(bound_of(joint.R_1, b_.joints[j].R_1).difference) * bound_of(joint.p_1, b_.joints[j].p_1);
    const DifferenceBound moment = of_child.moment + lever * of_child.force;
    const double by_links = (axis_in_child(j) * (slides ? of_child.force : moment)).difference;
    return by_links + by_rotor(j);
  }

  // k_r² I_m q̈ + k_r I_m ω̇ · z_m of the carrier, and the armature.
  double by_rotor(std::size_t j) const {
    const Joint50 &a = a_.joints[j], &b = b_.joints[j];
    const MotionLimits limits = limits_of(a);
    const DifferenceBound ratio = bound_of(a.rotor.gear_ratio, b.rotor.gear_ratio);
    const DifferenceBound spin = ratio * bound_of(a.rotor.inertia, b.rotor.inertia);
    const DifferenceBound z{1, bound_of(a.rotor.axis, b.rotor.axis).difference};
    const DifferenceBound torque = limits.acceleration * (spin * ratio) +
                                   spin * (motions_[index(a.rotor.carrier)].domega * z) +
                                   limits.acceleration * bound_of(a.armature, b.armature);
    return torque.difference;
  }

  const Robot50 &a_, &b_;
  const std::vector<MotionLimits>& limits_;
  MotionOfBase base_;
  std::vector<MotionDifference> motions_;   // by link
  std::vector<WrenchDifference> wrenches_;  // by link: force, and moment about its frame's origin
};

}  // namespace

std::vector<MotionLimits> largest_motion(const Mechanism& mechanism) {
  std::vector<MotionLimits> all;
  for (const Body& body : mechanism.joints()) {
    const MotionRange range = motion_range(body);
    const double position = body.prismatic ? std::max(std::abs(range.lower), std::abs(range.upper)) : 0;
    all.push_back({position * kRoundingMargin, range.speed * kRoundingMargin, range.acceleration * kRoundingMargin});
  }
  return all;
}

MotionOfBase largest_motion_of_base(const Mechanism& mechanism) {
  if (!mechanism.floating_base) return {};
  constexpr int kLinear = 0, kAngular = 3;
  const double root_3 = std::sqrt(3.0) * kRoundingMargin;  // the length of a vector is at most that of its components
  const MotionRange linear = motion_range(mechanism.joint(kLinear)), angular = motion_range(mechanism.joint(kAngular));
  const double omega = root_3 * angular.speed;
  return {omega, root_3 * angular.acceleration,
          (root_3 * linear.acceleration + omega * root_3 * linear.speed) * kRoundingMargin};
}

double torque_difference_bound(const Robot50& a, const Robot50& b, const std::vector<MotionLimits>& limits,
                               const MotionOfBase& base) {
  return TorqueDifference(a, b, limits, base).largest();
}

}  // namespace flatdyn
