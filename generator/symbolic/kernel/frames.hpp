// SPDX-License-Identifier: GPL-2.0-or-later
// The moving frames of a mechanism inside one derivation: sines and cosines, and vectors carried from frame to frame.
#pragma once

#include <optional>

#include "model/mechanism.hpp"
#include "symbolic/kernel/joint_angles.hpp"

namespace flatdyn {

// Whether the frame of a link turns with it. In axes that stay where the joint's angle is zero, all that moves the link
// is known from its parent without a turn, and its inertial parameters turn instead: that costs less where these are
// few, or alike about the joint's axis. It helps where nobody has to turn after all: at the end of a branch, and where
// the next joints are parallel, which then turn by the sum of the angles.
enum class Axes { turning, still };

// Whether body i may have still axes: its joint is revolute, and the joints that it carries are parallel to it.
bool can_be_still(const Mechanism& mechanism, int i);

class Frames {
 public:
  // `axes`: by body; empty: all turn. Where a body cannot be still, it turns.
  Frames(const Mechanism& mechanism, Derivation& derivation, const std::vector<Axes>& axes = {});

  // A vector given in the parent's frame, in frame i.
  Vec3 to_child(int i, const Vec3& v, const std::string& name);
  // A vector given in frame i, in the parent's frame.
  Vec3 to_parent(int i, const Vec3& v, const std::string& name);
  // down() and up() in two steps, with a stop where only the joint's own angle is left to turn by. There z is z of
  // frame i, and the other axes do not depend on q_i.
  Vec3 down_to_axis(int i, const Vec3& v, const std::string& name);
  Vec3 up_to_axis(int i, const Vec3& v, const std::string& name);
  Vec3 up_from_axis(int i, const Vec3& v, const std::string& name);
  Mat3 down_to_axis(int i, const Mat3& tensor, const std::string& name);  // any tensor
  Mat3 up_to_axis(int i, const Mat3& tensor, const std::string& name);    // symmetric
  // A symmetric tensor given in frame i, in the parent's frame: R T R^T.
  Mat3 to_parent(int i, const Mat3& tensor, const std::string& name);

  // The joint's motion along z in frame i: q_i for a prismatic joint, 0 for a revolute one.
  Number slide(int i) const { return slide_[static_cast<std::size_t>(i)]; }
  // Displacement of frame i's origin at q_i = 0, in the parent's frame; the slide comes on top, along z of frame i.
  // Numbers if the parent's frame turns with it.
  const Vec3& p(int i) const { return p_[static_cast<std::size_t>(i)]; }
  // The same in axes of frame i, if these are turned against the parent's still ones by more than the joint's angle:
  // then they are known by that angle alone. Else nothing.
  const std::optional<Vec3>& p_in_own_axes(int i) const { return p_in_own_axes_[static_cast<std::size_t>(i)]; }
  // z of frame i in the parent's frame: constant.
  Vec3 axis_in_parent(int i) const;

  const Mechanism& mechanism() const { return mechanism_; }
  // Of the augmented link, in axes of frame i, about its origin.
  const InertialParameters& inertia(int i) const { return inertia_[static_cast<std::size_t>(i)]; }

  // z_m of the rotor that drives joint i, in the frame of the body that carries it.
  const Vec3& rotor_axis(int i) const { return rotor_axis_[static_cast<std::size_t>(i)]; }

  const Body& body(int i) const { return mechanism_.bodies[static_cast<std::size_t>(i)]; }
  Derivation& derivation() { return derivation_; }

 private:
  struct Turn {
    PlanarRotation beta, alpha, gamma;  // gamma: theta and, for a revolute joint, q
    std::string angles;                 // of which joints gamma is the sum: "2_3"
    // Where joints are coupled: gamma is by these multiples of coordinates, and by a constant.
    std::vector<Number> multiples{};
    PlanarRotation constant{};
  };

  Turn turn_by_joint(int i);
  void hold(int i);
  void hand_on(const Turn& held, int child);
  void hand_on_multiples(const Turn& held, int child);

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
