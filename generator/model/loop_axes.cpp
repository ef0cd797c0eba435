// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/loop_axes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/joint_points.hpp"
#include "model/loop_sample.hpp"
#include "model/rational_rotation.hpp"

namespace flatdyn {
namespace {

using Real = LoopSample::Real;

const LinkFrame& frame_of(const Mechanism& tree, const std::string& link) {
  return *std::find_if(tree.links.begin(), tree.links.end(),
                       [&link](const LinkFrame& each) { return each.link == link; });
}

// A pose in the base frame, in exact numbers.
struct ExactPose {
  Mat3 R = identity_matrix();
  Vec3 p = zero_vector();
};

ExactPose placed(const ExactPose& a, const Mat3& R, const Vec3& p) {
  return {expanded(a.R * R), expanded(a.p + a.R * p)};
}

ExactPose pose_at_zero(const Mechanism& tree, int body) {
  ExactPose pose;
  for (const int each : way_to(tree, body)) {
    const Body& joint = tree.bodies[static_cast<std::size_t>(each)];
    pose = placed(pose, rotation_z(joint.beta) * rotation_x(joint.alpha) * rotation_z(joint.theta), joint.p);
  }
  return pose;
}

ExactPose link_at_zero(const Mechanism& tree, const std::string& link) {
  const LinkFrame& frame = frame_of(tree, link);
  return placed(pose_at_zero(tree, frame.body), frame.R, frame.p);
}

// The axes of one loop in the base frame, unit.
struct AxisPair {
  std::array<Vector3<Real>, 2> axes;

  Real cosine() const { return dot(axes[0], axes[1]); }
  bool is_parallel() const {
    const Vector3<Real> across = cross(axes[0], axes[1]);
    return std::all_of(across.begin(), across.end(), LoopSample::is_zero);
  }
};

Real at_zero(const Input& input) { return input.kind == InputKind::q ? Real(0) : LoopSample::drawn(input); }

AxisPair axes_at(const Mechanism& tree, const Loop& loop, Real (*value_of)(const Input&)) {
  RealArithmetic<Real> arithmetic(value_of);
  const NumberMap<RealArithmetic<Real>> number(tree.symbols, arithmetic);
  const std::vector<Pose3<Real>> poses = body_poses(mechanism_over(tree, arithmetic), joint_points(tree, arithmetic));
  AxisPair pair;
  for (std::size_t e = 0; e < 2; ++e) {
    const LinkFrame& link = frame_of(tree, loop.links[e].name);
    const Vec3 axis = expanded(link.R * unit((*loop.axes)[e]));
    const Vector3<Real> in_body = {number(axis[0]), number(axis[1]), number(axis[2])};
    pair.axes[e] = link.body < 0 ? in_body : times(poses[static_cast<std::size_t>(link.body)].R, in_body);
  }
  return pair;
}

void check_axes(const Mechanism& tree, const Loop& loop, Diagnostics& diagnostics) {
  const AxisPair anywhere = axes_at(tree, loop, LoopSample::drawn), zero = axes_at(tree, loop, at_zero);
  if (anywhere.is_parallel()) return;
  if (LoopSample::is_zero(anywhere.cosine() - zero.cosine())) {
    diagnostics.error(
        loop.place,
        fmt::format(
            "{}: its axes are never parallel: the angle between them is {:.4g} rad at all positions of the joints",
            name_of(loop), static_cast<double>(acos(zero.cosine()))),
        "check the axes: the loop's joints turn about parallel ones");
    return;
  }
  diagnostics.unsupported(
      loop.place,
      name_of(loop) +
          ": its joints do not by themselves keep its axes parallel, so that it takes more than its "
          "points: revolute joints in space are not supported yet as what closes a loop",
      "cut the loop at another joint: a ball joint (type=\"spherical\"), or in a plane");
}

}  // namespace

void close_at_zero(Robot& robot) {
  if (std::none_of(robot.loops.begin(), robot.loops.end(), [](const Loop& loop) { return loop.meets_at_zero; })) return;
  Robot free = robot;
  for (Joint& joint : free.joints) joint.coupled.reset();
  const Mechanism tree = open_mechanism(free);
  for (Loop& loop : robot.loops) {
    if (!loop.meets_at_zero) continue;
    const ExactPose first = link_at_zero(tree, loop.links[0].name), second = link_at_zero(tree, loop.links[1].name);
    const Vec3 met = first.p + first.R * rationalised(loop.points[0]);
    loop.points[1] = expanded(transpose(second.R) * (met - second.p));
  }
}

void check_loop_axes(const Robot& robot, Diagnostics& diagnostics) {
  if (std::none_of(robot.loops.begin(), robot.loops.end(), [](const Loop& loop) { return loop.axes.has_value(); })) {
    return;
  }
  const Mechanism tree = open_mechanism(robot);
  for (const Loop& loop : robot.loops) {
    if (loop.axes) check_axes(tree, loop, diagnostics);
  }
}

}  // namespace flatdyn
