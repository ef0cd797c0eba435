// SPDX-License-Identifier: GPL-2.0-or-later
// The canonical mechanism: a tree of moving bodies in exact numbers. Fixed joints are merged, every joint axis is z of
// its body's frame, constant rotations are exactly orthonormal (rational), and rotors are part of the link that carries
// them (augmented links, 7.2.2). Frames follow the modified DH convention as far as the geometry allows.
#pragma once

#include <iterator>
#include <string>
#include <vector>

#include "robot/model/body_tree.hpp"
#include "robot/model/chart.hpp"
#include "robot/model/contact.hpp"

namespace flatdyn {

class JointRange;

// A tree of bodies in its coordinates, and what is around it.
struct Mechanism : BodyTree, Chart, MechanismScene {
  // Whether the coordinate of a body's joint is one around the present pose, where it is zero: q has no such entry.
  bool is_around_pose(int i) const { return is_of_base(i) || is_of_spherical(i); }
  // The first entries of q of all spherical joints' quaternions.
  std::vector<int> quaternions() const;
  // The last of the bodies that are the motion of a floating base: its link.
  const Body& base_link() const { return body(base_bodies() - 1); }
  // Whether torques depend on gravity in the axes of a floating base.
  bool has_base_gravity() const;
  // Entries of q.
  int position_count() const {
    if (is_coupled()) return static_cast<int>(coordinates.size());
    return body_count() - base_bodies() + static_cast<int>(spherical.size());
  }
  int angle_count() const { return position_count() + static_cast<int>(angles.size()); }
  // The number of entries of q̇, q̈ and τ.
  int size() const {
    if (has_loops()) return base_bodies() + static_cast<int>(independent.size());
    return is_coupled() ? base_bodies() + position_count() : body_count();
  }
  // The joints that the entries of q̇ belong to, in order, without the motion of a floating base.
  JointRange joints() const;
  // The entry of q that is integrated from entry k of q̇, which must not be the base's. For those of a spherical joint,
  // x, y and z of its quaternion, one for each.
  int position_of(int k) const {
    const int joint = k - base_bodies();
    return has_loops() ? independent[static_cast<std::size_t>(joint)] : joint + spherical_up_to(k);
  }
  // The body of an entry of q; for w of a quaternion, the first one of the spherical joint.
  int body_at(int position) const {
    return is_coupled() ? coordinates[static_cast<std::size_t>(position)] : body_of_position(position);
  }
  // The position of body i's joint is offset_of(i) + Σ_p position_factor(i, p) q_p, and its rate, where loops do not
  // decide it, Σ_k rate_factor(i, k) q̇_k. Not for positions of joints that are around the present pose.
  Number offset_of(int i) const { return is_coupled() ? offsets[static_cast<std::size_t>(i)] : Number(0); }
  Number position_factor(int i, int position) const;
  Number rate_factor(int i, int k) const;
  // The name of an entry of q: of the joint, or "JOINT.qw" to "JOINT.qz" for a spherical one.
  std::string position_name(int position) const;
  std::vector<std::string> position_names() const;
  // The names of the joints that the entries of q̇ belong to, without the motion of a floating base.
  std::vector<std::string> joint_names() const;
  // The first entry of q of the spherical joint of which body i is one.
  int quaternion_of(int i) const { return position_of(i + 1 - body(i).spherical) - 1; }
  // Whether an entry of q is one of a quaternion, the first of the four that are from `first` on.
  bool is_of_quaternion(int position) const { return !is_coupled() && is_of_spherical(body_at(position)); }
  int body_of(int k) const { return k < base_bodies() ? k : body_at(position_of(k)); }
  const Body& joint_at(int position) const { return body(body_at(position)); }
  const Body& joint(int k) const { return body(body_of(k)); }
  // The bodies that joints of one axis move, which may have springs.
  std::vector<int> bodies_on_one_axis() const;
  bool has_load_friction() const;    // whether a drive loses a share of the torque that it passes on
  bool has_prismatic_joint() const;  // not counting the motion of a floating base
  // Whether entries of q or q̇ are lengths, so that the unit of length is not free.
  bool has_lengths() const { return floating_base || has_prismatic_joint(); }

 private:
  // How many spherical joints have their first body at k or before it.
  int spherical_up_to(int k) const;
  int body_of_position(int position) const;
};

class JointRange {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Body;
    using difference_type = std::ptrdiff_t;
    using pointer = const Body*;
    using reference = const Body&;

    Iterator(const Mechanism& mechanism, int k) : mechanism_(&mechanism), k_(k) {}
    const Body& operator*() const { return mechanism_->joint(k_); }
    Iterator& operator++() {
      ++k_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return k_ == other.k_; }

   private:
    const Mechanism* mechanism_;
    int k_;
  };

  explicit JointRange(const Mechanism& mechanism) : mechanism_(mechanism) {}
  Iterator begin() const { return {mechanism_, mechanism_.base_bodies()}; }
  Iterator end() const { return {mechanism_, mechanism_.size()}; }
  std::size_t size() const { return static_cast<std::size_t>(mechanism_.size() - mechanism_.base_bodies()); }
  const Body& operator[](std::size_t k) const {
    return mechanism_.joint(static_cast<int>(k) + mechanism_.base_bodies());
  }

 private:
  const Mechanism& mechanism_;
};

inline JointRange Mechanism::joints() const { return JointRange(*this); }

// Robot → Mechanism. Throws Failure(unsupported) for a robot that cannot be made canonical.
Mechanism make_mechanism(const Robot& robot);

}  // namespace flatdyn
