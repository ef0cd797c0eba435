// SPDX-License-Identifier: GPL-2.0-or-later
// The moving frames of a mechanism in one derivation: sines and cosines, and the transformation of vectors between
// frames.
#pragma once

#include <optional>

#include "derivation/kernel/joint_angles.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Whether the frame of a link turns with it. In still axes, those that a turning frame has at the joint's angle zero,
// the motion that the parent imposes on the link needs no rotation, but the link's inertial parameters are rotated
// instead. That costs less if they are few, or symmetric about the joint's axis. It pays at the end of a branch, and
// where the next joints are parallel, as these then turn by the sum of the angles.
enum class Axes { turning, still };

// Whether body i may have still axes: its joint is revolute, and the joints of its children are parallel to it.
bool can_be_still(const Mechanism& mechanism, int i);

class Frames {
 public:
  // `axes`: by body; empty: all turn. A body that cannot be still turns.
  Frames(const Mechanism& mechanism, Derivation& derivation, const std::vector<Axes>& axes = {});

  // Transforms a vector from the parent's frame to frame i.
  Vec3 to_child(int i, const Vec3& v, const std::string& name);
  // Transforms a vector from frame i to the parent's frame.
  Vec3 to_parent(int i, const Vec3& v, const std::string& name);
  // to_child() and to_parent() in two steps. Between them, the axes are those of frame i but for the rotation by the
  // joint's own angle: z is z of frame i, and the other axes do not depend on q_i. For the first body of a spherical
  // joint they are those of frame i.
  Vec3 down_to_axis(int i, const Vec3& v, const std::string& name);
  Vec3 up_to_axis(int i, const Vec3& v, const std::string& name);
  Vec3 up_from_axis(int i, const Vec3& v, const std::string& name);
  Mat3 down_to_axis(int i, const Mat3& tensor, const std::string& name);  // any tensor
  Mat3 up_to_axis(int i, const Mat3& tensor, const std::string& name);    // symmetric
  // Transforms a symmetric tensor from frame i to the parent's frame: R T R^T.
  Mat3 to_parent(int i, const Mat3& tensor, const std::string& name);

  // The joint's displacement along z in frame i, m: q_i for a prismatic joint, 0 for a revolute one.
  Number slide(int i) const { return slide_[static_cast<std::size_t>(i)]; }
  // The displacement of frame i's origin at q_i = 0, in the parent's frame, m, without the slide along z of frame i.
  // Its entries are numbers if the parent's frame turns with the parent.
  const Vec3& p(int i) const { return p_[static_cast<std::size_t>(i)]; }
  // The same in axes of frame i, where it depends on the joint's own angle only; nothing unless the parent's axes are
  // still and those of frame i turn.
  const std::optional<Vec3>& p_in_own_axes(int i) const { return p_in_own_axes_[static_cast<std::size_t>(i)]; }
  // The unit vector z of frame i in the parent's frame; constant but for the first body of a spherical joint.
  Vec3 axis_in_parent(int i) const;

  const Mechanism& mechanism() const { return mechanism_; }
  // The parameters of the augmented link, in axes of frame i, about its origin.
  const InertialParameters& inertia(int i) const { return inertia_[static_cast<std::size_t>(i)]; }

  // z_m of the rotor that drives joint i, in the frame of the body that carries it.
  const Vec3& rotor_axis(int i) const { return rotor_axis_[static_cast<std::size_t>(i)]; }

  // The label of body i in names.
  std::string label(int i) const { return flatdyn::label(i, mechanism_.base_bodies()); }
  const Body& body(int i) const { return mechanism_.bodies[static_cast<std::size_t>(i)]; }
  Derivation& derivation() { return derivation_; }

 private:
  struct Turn {
    PlanarRotation beta, alpha, gamma;  // gamma: theta plus, for a revolute joint, q
    std::string angles;                 // labels of the joints whose angles gamma is the sum of: "2_3"
    // With coupled joints: gamma is a sum of these multiples of coordinates and a constant.
    std::vector<Number> multiples{};
    PlanarRotation constant{};
    // For the first body of a spherical joint: the rotation after gamma, and z of frame i in the parent's frame.
    std::optional<Mat3> free{};
    Vec3 axis = zero_vector();
  };

  Turn turn_by_joint(int i);
  void turn_freely(int i, Turn& turn);
  Mat3 turned_freely(const Mat3& R, const Mat3& T, const std::string& name);
  void hold(int i);
  void pass_to_child(const Turn& held, int child);
  void pass_multiples_to_child(const Turn& held, int child);

  const Turn& turn_of(int i) const { return turns_[static_cast<std::size_t>(i)]; }

  const Mechanism& mechanism_;
  Derivation& derivation_;
  std::vector<Turn> turns_;
  std::vector<Number> slide_;
  std::vector<Vec3> p_;
  std::vector<std::optional<Vec3>> p_in_own_axes_;
  std::vector<InertialParameters> inertia_;
  std::vector<Vec3> rotor_axis_;
};

}  // namespace flatdyn
