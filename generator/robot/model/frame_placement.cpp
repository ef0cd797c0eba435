// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/frame_placement.hpp"

#include <optional>

#include "robot/model/angles.hpp"

namespace flatdyn {
namespace {

// The displacement from the parent's final origin to body i's raw origin, along the parent's raw axes.
Vec3 raw_displacement(const RawTree& tree, const std::vector<Placement>& placements, std::size_t i) {
  const int parent = tree.parent[i];
  const Vec3 origin = parent < 0 ? zero_vector() : placements[static_cast<std::size_t>(parent)].shift;
  return tree.frames[i].p - origin;
}

class Placer {
 public:
  explicit Placer(const RawTree& tree) : tree_(tree), placements_(tree.frames.size()) {
    for (std::size_t i = 0; i < placements_.size(); ++i) place(i);
  }

  std::vector<Placement> placements() && { return std::move(placements_); }

 private:
  // The child that the frame of body i is fitted to: the first of those with the most descendants.
  std::optional<std::size_t> main_child(std::size_t i) const {
    std::vector<int> weight(tree_.frames.size(), 1);
    std::optional<std::size_t> best;
    for (std::size_t k = tree_.frames.size(); k-- > i + 1;) {
      const int parent = tree_.parent[k];
      if (parent < 0) continue;
      weight[static_cast<std::size_t>(parent)] += weight[k];
      if (parent == static_cast<int>(i) && (!best || weight[k] >= weight[*best])) best = k;
    }
    return best;
  }

  JointType type_of_joint(std::size_t i) const {
    return tree_.robot.joints[static_cast<std::size_t>(tree_.joint_of[i])].type;
  }
  bool is_prismatic(std::size_t i) const { return type_of_joint(i) == JointType::prismatic; }
  bool is_spherical(std::size_t i) const { return type_of_joint(i) == JointType::spherical; }

  void place(std::size_t i) {
    if (is_spherical(i)) return;  // its point and its axes are given
    const std::optional<std::size_t> child = main_child(i);
    Placement& placement = placements_[i];
    if (child) {
      const ZxzAngles angles = zxz_angles(tree_.frames[*child].R);
      const bool is_plain_turn = is_spherical(*child) && vanishes(angles.alpha.s) && angles.alpha.c.is_equal(1);
      placement.phase = is_plain_turn ? angles.theta : angles.beta;
    } else if (const PlanarRotation theta = zxz_angles(tree_.frames[i].R).theta; !is_quarter_turn(theta)) {
      placement.phase = inverse(theta);
    }
    if (is_prismatic(i)) {
      // Only the direction of a prismatic axis matters: the frame's origin is put at the parent's.
      placement.shift = expanded(Number(-1) * (transpose(tree_.frames[i].R) * raw_displacement(tree_, placements_, i)));
    } else {
      placement.shift = {0, 0, child ? foot_of_common_normal(i, *child) : nearest_to_parent(i)};
    }
    placement.shift = snap_residue_to_zero(placement.shift, tree_.reach);
  }

  // The point on the axis of body i, measured from its raw origin, where the common normal to the child's axis meets
  // it.
  Number foot_of_common_normal(std::size_t i, std::size_t child) const {
    const Mat3& R = tree_.frames[child].R;
    const Vec3 u = {R[0][2], R[1][2], R[2][2]};
    const Number across = (u[0] * u[0] + u[1] * u[1]).expand();
    const Vec3& p = tree_.frames[child].p;
    if (is_spherical(child)) return p[2];
    if (vanishes(across) || is_prismatic(child)) return nearest_to_parent(i);
    const Number foot = (p[2] - u[2] * (p[0] * u[0] + p[1] * u[1]) / across).expand();
    return is_far(foot, p) ? nearest_to_parent(i) : foot;
  }

  // The point on the axis of body i, measured from its raw origin, to which the transform from the parent's frame needs
  // the fewest numbers.
  Number nearest_to_parent(std::size_t i) const {
    const Mat3& R = tree_.frames[i].R;
    const Vec3 u = {R[0][2], R[1][2], R[2][2]};
    const Vec3 d = raw_displacement(tree_, placements_, i);
    const Number nearest = (-dot(d, u)).expand();
    const Number across = (u[0] * u[0] + u[1] * u[1]).expand();
    if (vanishes(across)) return nearest;
    const Number foot = (-(d[0] * u[0] + d[1] * u[1]) / across).expand();
    return is_far(foot, d) ? nearest : foot;
  }

  // Whether the foot of the common normal is too far away, as with nearly parallel axes: moments about an origin there
  // lose digits.
  static bool is_far(const Number& foot, const Vec3& between) {
    constexpr int kFar = 30;
    const Number excess = foot * foot - kFar * kFar * dot(between, between);
    return !has_symbols(excess) && nearest_double(excess) > 0;
  }

  const RawTree& tree_;
  std::vector<Placement> placements_;
};

}  // namespace

std::vector<Placement> frame_placements(const RawTree& tree) { return Placer(tree).placements(); }

Vec3 displacement(const RawTree& tree, const std::vector<Placement>& placements, std::size_t i) {
  const Vec3 raw = raw_displacement(tree, placements, i) + tree.frames[i].R * placements[i].shift;
  const int parent = tree.parent[i];
  if (parent < 0) return snap_residue_to_zero(expanded(raw), tree.reach);
  const Mat3 back = rotation_z(inverse(placements[static_cast<std::size_t>(parent)].phase));
  return snap_residue_to_zero(expanded(back * raw), tree.reach);
}

}  // namespace flatdyn
