// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/scene_frames.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "robot/input/common/poses.hpp"

namespace flatdyn {
namespace {

// The angles, of which decimals near a multiple of pi/12 are taken for it.
Vec3 angles_of(const SceneFrame& frame, ReadContext& context) {
  Vec3 rpy = frame.rpy;
  const Spot spot{frame.place, fmt::format("frame \"{}\", rpy", frame.name)};
  for (std::size_t k = 0; k < rpy.size(); ++k) {
    if (!frame.decimals[k].empty()) rpy[k] = snapped_angle(rpy[k], frame.decimals[k], spot, context);
  }
  return rpy;
}

bool has_link(const Robot& robot, const std::string& name) {
  return std::any_of(robot.links.begin(), robot.links.end(), [&name](const Link& link) { return link.name == name; });
}

void add_frame(const SceneFrame& frame, ReadContext& context, Robot& robot) {
  const std::string what = fmt::format("frame \"{}\"", frame.name);
  if (has_link(robot, frame.name)) {
    context.diagnostics.error(frame.place, what + ": a link, or another frame, has this name", "give it another one");
    return;
  }
  const std::optional<int> parent = find_link(robot, frame.link, what + ", link", context.diagnostics);
  if (!parent) return;
  Joint joint;
  joint.name = frame.name + " (frame)";
  joint.parent = *parent;
  joint.child = static_cast<int>(robot.links.size());
  joint.origin = pose_from_xyz_rpy(frame.xyz, angles_of(frame, context), frame.place);
  joint.place = frame.place;
  robot.links.push_back({frame.name, {}, frame.place});
  robot.joints.push_back(joint);
}

}  // namespace

std::string problem_of_frame_name(const std::string& name) {
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
  if (name.empty() || name.front() == ' ' || name.back() == ' ') return "its name is empty, or has a blank at an end";
  if (std::any_of(name.begin(), name.end(), is_control)) return "its name has control characters";
  if (name.find(',') != std::string::npos) return "its name has a comma, which divides the names of functions";
  return name.find(" --") == std::string::npos ? "" : "its name looks like an option";
}

void add_frames(ReadContext& context, Robot& robot) {
  for (const SceneFrame& frame : robot.scene.frames) {
    if (!frame.name.empty() && !frame.link.name.empty())
      add_frame(frame, context, robot);  // else said where it is read
  }
}

}  // namespace flatdyn
