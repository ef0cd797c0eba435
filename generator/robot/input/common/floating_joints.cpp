// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/floating_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "robot/input/common/held_position.hpp"
#include "robot/input/common/joint_parts.hpp"

namespace flatdyn {
namespace {

// Whether the joint is on a root without a body.
bool is_on_empty_root(const Robot& robot, const Joint& joint) {
  const bool is_moved = std::any_of(robot.joints.begin(), robot.joints.end(),
                                    [&](const Joint& other) { return other.child == joint.parent; });
  return !is_moved && robot.links[static_cast<std::size_t>(joint.parent)].inertials.empty();
}

// Parts of a robot, by their indices.
struct PartsOfJoint {
  std::set<int> joints, links;
};

// The joint's root link, and what stands still on it.
class Surroundings {
 public:
  Surroundings(const Robot& robot, const ReadContext& context, int free_joint)
      : robot_(robot), context_(context), free_joint_(free_joint) {
    add(robot.joints[static_cast<std::size_t>(free_joint)].parent);
    parts_.joints.insert(free_joint);
  }

  const PartsOfJoint& parts() const { return parts_; }
  // Whether the free joint's own link hangs on what stands still, too, which the validation reports.
  bool has_child() const { return parts_.links.count(robot_.joints[static_cast<std::size_t>(free_joint_)].child) > 0; }
  const std::vector<std::string>& moving() const { return moving_; }  // the other joints that move and are not held

 private:
  // Files that are wrong have links that hang on themselves, or on nothing.
  void add(int link) {
    if (link < 0 || !parts_.links.insert(link).second) return;
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const Joint& joint = robot_.joints[j];
      if (joint.parent != link || static_cast<int>(j) == free_joint_) continue;
      if (joint.type != JointType::fixed && !is_held(joint.name, context_)) moving_.push_back(joint.name);
      parts_.joints.insert(static_cast<int>(j));
      add(joint.child);
    }
  }

  const Robot& robot_;
  const ReadContext& context_;
  int free_joint_;
  PartsOfJoint parts_;
  std::vector<std::string> moving_;
};

template <class T>
std::vector<T> others_of(const std::vector<T>& all, const std::set<int>& left_out) {
  std::vector<T> rest;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (left_out.count(static_cast<int>(k)) == 0) rest.push_back(all[k]);
  }
  return rest;
}

void leave_out(const PartsOfJoint& parts, Robot& robot) {
  robot.joints = others_of(robot.joints, parts.joints);
  robot.links = others_of(robot.links, parts.links);
  const auto close_gaps = [&parts](int& link) {
    link -= static_cast<int>(std::distance(parts.links.begin(), parts.links.lower_bound(link)));
  };
  for (Joint& joint : robot.joints) {
    close_gaps(joint.parent);
    close_gaps(joint.child);
    if (joint.motor) close_gaps(joint.motor->carrier);
  }
}

void note_standing(const Robot& robot, const PartsOfJoint& parts, int root, Diagnostics& diagnostics) {
  for (const int link : parts.links) {
    if (link == root) continue;
    const Link& left_out = robot.links[static_cast<std::size_t>(link)];
    diagnostics.note(left_out.place, "link \"" + left_out.name + "\" stands still beside the floating robot: left out",
                     "what does not move has no part in its dynamics", "links beside a floating robot, left out");
  }
}

// Reports loops to links that are left out, which stand still.
void refuse_loops_to(const PartsOfJoint& parts, const Robot& robot, Diagnostics& diagnostics) {
  for (const Loop& loop : robot.loops) {
    for (const Reference& end : loop.links) {
      const bool is_left_out = std::any_of(parts.links.begin(), parts.links.end(), [&](int link) {
        return robot.links[static_cast<std::size_t>(link)].name == end.name;
      });
      if (!is_left_out) continue;
      diagnostics.unsupported(
          loop.place,
          fmt::format("{}: link \"{}\" stands still beside the robot, whose base floats: what holds the robot is no "
                      "loop of its joints",
                      name_of(loop), end.name),
          "leave the loop out, and say in a scene that the robot touches something there ([[contact]]); or give --base "
          "fixed");
    }
  }
}

// Whether joint `index` carries all that moves, from a root without a body: then it is left out with that root.
bool float_on(int index, ReadContext& context, Robot& robot, std::vector<LeftOutJoint>& left_out) {
  Diagnostics& diagnostics = context.diagnostics;
  const Joint joint = robot.joints[static_cast<std::size_t>(index)];
  if (joint.parent < 0 || joint.child < 0 || !is_on_empty_root(robot, joint)) return false;
  const Surroundings around(robot, context, index);
  if (around.has_child()) return false;
  if (const std::vector<std::string>& beside = around.moving(); !beside.empty()) {
    diagnostics.unsupported(
        joint.place,
        fmt::format("joint \"{}\" moves freely, but does not carry all that moves: joint{} \"{}\" {} beside it",
                    joint.name, beside.size() > 1 ? "s" : "", fmt::join(beside, "\", \""),
                    beside.size() > 1 ? "are" : "is"),
        fmt::format("hold what is beside it still, which leaves it out: --fix {}; or this joint: --fix {}",
                    fmt::join(beside, " --fix "), joint.name));
    return true;
  }
  note_standing(robot, around.parts(), joint.parent, diagnostics);
  if (!joint.origin.displacements.empty()) {
    diagnostics.note(joint.place, "joint \"" + joint.name + "\": its origin has no effect, as the base floats",
                     "the pose of the base is part of the state");
  }
  robot.floating_base = true;
  refuse_loops_to(around.parts(), robot, diagnostics);
  for (const int other : around.parts().joints) {  // one that was to be held does stand still
    const Joint& beside = robot.joints[static_cast<std::size_t>(other)];
    std::erase_if(context.held_joints, [&](const HeldJoint& held) {
      if (held.joint == beside.name) left_out.push_back({held, beside.type});
      return held.joint == beside.name;
    });
  }
  leave_out(around.parts(), robot);
  for (Joint& follower : robot.joints) {
    if (follower.coupled) put_in_left_out(left_out, context, *follower.coupled);
  }
  return true;
}

}  // namespace

void put_in_left_out(const std::vector<LeftOutJoint>& joints, ReadContext& context, Coupled& coupled) {
  for (const LeftOutJoint& joint : joints) {
    std::erase_if(coupled.terms, [&](const Coupled::Term& term) {
      if (term.joint.name != joint.held.joint) return false;
      coupled.offset += term.factor * held_position(joint.held, joint.type, context);
      return true;
    });
  }
}

std::vector<LeftOutJoint> take_floating_joints(const std::vector<int>& joints, ReadContext& context, Robot& robot) {
  std::vector<LeftOutJoint> left_out;
  if (joints.size() == 1 && float_on(joints.front(), context, robot, left_out)) return left_out;
  for (const int index : joints) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(index)];
    context.diagnostics.unsupported(
        joint.place,
        "joint \"" + joint.name + "\" moves freely: that is supported for one joint only, which carries all that moves",
        "hold it still: give the option --fix " + joint.name);
  }
  return left_out;
}

bool floats_in_tree(const Robot& robot, const Joint& joint) {
  return joint.parent >= 0 && joint.child >= 0 && !is_on_empty_root(robot, joint);
}

void split_floating_joint(const std::string& name, Robot& robot) {
  const auto place = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&name](const Joint& joint) { return joint.name == name; });
  const Joint whole = *place;
  std::vector<Joint> parts;
  for (std::size_t k = 0; k < 3; ++k) {
    parts.push_back(part_of_joint(whole, std::string(".") + "xyz"[k], JointType::prismatic));
    parts.back().axis = zero_vector();
    parts.back().axis[k] = 1;
  }
  parts.push_back(part_of_joint(whole, ".turn", JointType::spherical));
  const auto next = robot.joints.erase(place);
  const std::vector<Joint> joined = joined_in_tree(whole, parts, robot);
  robot.joints.insert(next, joined.begin(), joined.end());
}

}  // namespace flatdyn
