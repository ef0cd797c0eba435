// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/raw_tree.hpp"

#include <algorithm>
#include <optional>

#include "robot/model/angles.hpp"
#include "robot/model/coupling.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// The constant transform of a joint that is held still.
Transform held_motion(const Joint& joint) {
  if (!joint.held || vanishes(joint.held->position)) return {};
  if (joint.held->type == JointType::prismatic) {
    return {identity_matrix(), expanded(rationalised(joint.held->position) * unit(joint.axis))};
  }
  const Mat3 onto_axis = rotation_onto(joint.axis);
  return {expanded(onto_axis * rotation_z(planar_rotation(joint.held->position)) * transpose(onto_axis)),
          zero_vector()};
}

// The constant transform along or about z of a coupled joint when all coordinates are zero.
Transform offset_motion(const Joint& joint, const Number& offset) {
  if (!joint.coupled || vanishes(offset)) return {};
  if (joint.type == JointType::prismatic) return {identity_matrix(), {0, 0, rationalised(offset)}};
  return {rotation_z(planar_rotation(offset)), zero_vector()};
}

void add_lengths(const Vec3& p, Number& sum) {
  for (const Number& each : p) {
    const Number length = rationalised(each);
    if (is_rational(length)) sum += GiNaC::abs(length);
  }
}

void add_lengths(const Pose& pose, Number& sum) {
  for (const Displacement& displacement : pose.displacements) add_lengths(displacement.translation, sum);
}

// The sum of the robot's numeric lengths: where some of them cancel, rounding residues are small compared with it.
Number reach_of(const Robot& robot) {
  Number reach = 0;
  for (const Joint& joint : robot.joints) {
    add_lengths(joint.origin, reach);
    add_lengths(joint.link_offset, reach);
    if (joint.motor) add_lengths(joint.motor->position, reach);
    if (joint.held && joint.held->type == JointType::prismatic) add_lengths({joint.held->position, 0, 0}, reach);
  }
  for (const Link& link : robot.links) {
    for (const Inertial& inertial : link.inertials) {
      add_lengths(inertial.frame, reach);
      add_lengths(inertial.centre_of_mass, reach);
    }
  }
  add_lengths(robot.tip_offset, reach);
  return reach;
}

bool is_along_z(const Mat3& R) {
  const Vec3 axis = snap_residue_to_zero(Vec3{R[0][2], R[1][2], R[2][2]}, 1);
  return vanishes(axis[0]) && vanishes(axis[1]);
}

bool is_across_z(const Mat3& R) { return vanishes(snap_residue_to_zero(R[2][2], 1)); }

bool is_symbolic(const Mat3& R) {
  return std::any_of(R.begin(), R.end(), [](const Vec3& row) {
    return std::any_of(row.begin(), row.end(), [](const Number& entry) { return has_symbols(entry); });
  });
}

bool has_rational_angles(const Mat3& R) {
  const Mat3 again = from_zxz(R);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!again[i][j].is_equal(R[i][j])) return false;
    }
  }
  return true;
}

// Adds the bodies, parents before children.
class BodyWalk {
 public:
  explicit BodyWalk(RawTree& tree) : tree_(tree) {}

  void walk(int link) {
    for (std::size_t j = 0; j < tree_.robot.joints.size(); ++j) {
      if (tree_.robot.joints[j].parent == link) attach(static_cast<int>(j));
    }
  }

 private:
  void attach(int joint_index) {
    const Joint& joint = tree_.robot.joints[static_cast<std::size_t>(joint_index)];
    const auto parent = static_cast<std::size_t>(joint.parent), child = static_cast<std::size_t>(joint.child);
    const Transform frame = compose(tree_.link_pose[parent], exact_transform(joint.origin));
    const Transform offset = exact_transform(joint.link_offset);
    if (joint.type == JointType::fixed) {
      tree_.body_of[child] = tree_.body_of[parent];
      tree_.link_pose[child] = compose(compose(frame, held_motion(joint)), offset);
      tree_.merged.push_back(tree_.robot.links[child].name);
    } else if (joint.type == JointType::spherical) {
      attach_spherical(joint_index, frame, offset);
    } else {
      const Transform onto_axis{rotation_onto(joint.axis), zero_vector()};
      const Transform raw =
          compose(compose(frame, onto_axis),
                  offset_motion(joint, tree_.positions[static_cast<std::size_t>(joint_index)].offset));
      tree_.frames.push_back(
          {from_zxz(without_rest_past_slides(raw.R, tree_.body_of[parent])), snap_residue_to_zero(raw.p, tree_.reach)});
      tree_.parent.push_back(tree_.body_of[parent]);
      tree_.joint_of.push_back(joint_index);
      tree_.body_of[child] = static_cast<int>(tree_.frames.size()) - 1;
      tree_.link_pose[child] = compose({transpose(onto_axis.R), zero_vector()}, offset);
    }
    walk(joint.child);
  }

  // Three frames at one point: that of the joint, and two with their axes in another order, of which the last has the
  // joint's axes again.
  void attach_spherical(int joint_index, const Transform& frame, const Transform& offset) {
    const Joint& joint = tree_.robot.joints[static_cast<std::size_t>(joint_index)];
    const auto parent = static_cast<std::size_t>(joint.parent), child = static_cast<std::size_t>(joint.child);
    const Transform cycled{with_columns_cycled(identity_matrix()), zero_vector()};
    for (int k = 0; k < kSphericalBodies; ++k) {
      tree_.frames.push_back(k == 0 ? Transform{from_zxz(frame.R), snap_residue_to_zero(frame.p, tree_.reach)}
                                    : cycled);
      tree_.parent.push_back(k == 0 ? tree_.body_of[parent] : static_cast<int>(tree_.frames.size()) - 2);
      tree_.joint_of.push_back(joint_index);
    }
    tree_.body_of[child] = static_cast<int>(tree_.frames.size()) - 1;
    tree_.link_pose[child] = offset;
  }

  bool is_slide(int body) const {
    return tree_.robot.joints[static_cast<std::size_t>(tree_.joint_of[static_cast<std::size_t>(body)])].type ==
           JointType::prismatic;
  }

  // The rotation R of a body in the frame of `parent`, without rounding residues. A prismatic joint does not turn its
  // descendants, so an axis beyond it is parallel or perpendicular to one before it if the robot's axes are; but since
  // the angles between them have been made rational one by one, a residue may be left.
  Mat3 without_rest_past_slides(const Mat3& R, int parent) const {
    for (const auto fits : {is_along_z, is_across_z}) {
      if (const std::optional<Mat3> found = placed_past_slides(R, parent, fits)) return *found;
    }
    return R;
  }

  // R corrected by the nearest axis before prismatic joints to which the body's axis `fits`; nothing if there is no
  // such axis, or if the corrected angles are not rational. They are rational if all axes between lie in one plane, or
  // if one prismatic joint is between two parallel axes.
  std::optional<Mat3> placed_past_slides(const Mat3& R, int parent, bool (*fits)(const Mat3&)) const {
    Mat3 way = identity_matrix();  // rotation from the parent to `body`
    for (int body = parent; body >= 0 && is_slide(body); body = tree_.parent[static_cast<std::size_t>(body)]) {
      way = expanded(tree_.frames[static_cast<std::size_t>(body)].R * way);
      const Mat3 turned = expanded(way * R);
      if (is_symbolic(turned) || !fits(turned)) continue;
      const Mat3 placed = expanded(transpose(way) * from_zxz(turned));
      if (has_rational_angles(placed)) return placed;
    }
    return std::nullopt;
  }

  RawTree& tree_;
};

}  // namespace

RawTree::RawTree(const Robot& of)
    : robot(of),
      reach(reach_of(of)),
      positions(joint_positions(of)),
      link_pose(of.links.size()),
      body_of(of.links.size(), -1) {
  BodyWalk(*this).walk(of.root);
}

}  // namespace flatdyn
