// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/loop_axes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "robot/model/assembly.hpp"
#include "robot/model/loop_sample.hpp"
#include "robot/model/rational_rotation.hpp"

namespace flatdyn {
namespace {

using Real = LoopSample::Real;

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
  for (const int each : path_to(tree, body)) {
    const Body& joint = tree.bodies[static_cast<std::size_t>(each)];
    pose = placed(pose, rotation_z(joint.beta) * rotation_x(joint.alpha) * rotation_z(joint.theta), joint.p);
  }
  return pose;
}

ExactPose link_at_zero(const Mechanism& tree, const std::string& link) {
  const LinkFrame& frame = frame_of(tree, link);
  return placed(pose_at_zero(tree, frame.body), frame.R, frame.p);
}

Real at_zero(const Input& input) { return input.kind == InputKind::q ? Real(0) : LoopSample::drawn(input); }

bool has_angles_in_symbols(const Mechanism& tree) {
  return std::any_of(tree.bodies.begin(), tree.bodies.end(), [](const Body& body) {
    return has_symbols(body.beta.c) || has_symbols(body.alpha.c) || has_symbols(body.theta.c);
  });
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

bool is_determined_by_points(const Loop& loop, const Robot& robot, Diagnostics& diagnostics) {
  if (!loop.axes) return true;
  const Mechanism tree = with_coupling(open_mechanism(robot));
  const LoopClosure closure = closure_of(loop, tree);
  const LoopSample anywhere(tree, closure);
  const std::vector<Real> gap = anywhere.gap();
  const bool is_parallel = std::all_of(gap.begin() + LoopClosure::kOfPoints, gap.end(), LoopSample::is_zero);
  if (is_parallel) return true;
  const Real cosine = LoopSample(tree, closure, at_zero).cosine();
  if (LoopSample::is_zero(anywhere.cosine() - cosine)) {
    diagnostics.error(
        loop.place,
        fmt::format(
            "{}: its axes are never parallel: the angle between them is {:.4g} rad at all positions of the joints",
            name_of(loop), static_cast<double>(acos(cosine))),
        "check the axes: the loop's joints turn about parallel ones");
  }
  return false;
}

// Near enough that they cannot be meant to point the other way; without that, nothing is taken for granted.
int sense_of_axes(const Robot& robot, const Mechanism& tree, const LoopClosure& loop) {
  if (has_angles_in_symbols(tree)) return 0;
  const std::vector<double> assembled = assembled_positions(robot, tree);
  const auto value_of = [&assembled](const Input& input) {
    return input.kind == InputKind::q ? Real(assembled[static_cast<std::size_t>(input.index)])
                                      : LoopSample::drawn(input);
  };
  constexpr double kNear = 0.97;
  const auto cosine = static_cast<double>(LoopSample(tree, loop, value_of).cosine());
  return cosine > kNear ? 1 : cosine < -kNear ? -1 : 0;
}

}  // namespace flatdyn
