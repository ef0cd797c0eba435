// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "robot/model/validate.hpp"

namespace flatdyn {

namespace {

// The limit on a tree's size: walks from the root recurse as deep as the tree, and code for more joints would be
// useless.
constexpr std::size_t kMostJoints = 2000;

template <class Named>
void report_duplicates(const std::vector<Named>& all, const std::string& kind, Diagnostics& diagnostics) {
  std::map<std::string, int> line_of_name;
  for (const Named& one : all) {
    const auto [first, inserted] = line_of_name.emplace(one.name, one.place.line);
    if (inserted || one.name.empty()) continue;  // an empty name has been reported by the reader
    diagnostics.error(one.place,
                      fmt::format("two {}s are called \"{}\" (the first is in line {})", kind, one.name, first->second),
                      "names must differ: rename one of them");
  }
}

// By link: the index of the joint that moves it, -1 for a root.
std::vector<int> joints_above(const Robot& robot, Diagnostics& diagnostics) {
  std::vector<int> joint_above(robot.links.size(), -1);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    int& above = joint_above[static_cast<std::size_t>(joint.child)];
    if (above < 0) {
      above = static_cast<int>(j);
      continue;
    }
    const Joint& first = robot.joints[static_cast<std::size_t>(above)];
    diagnostics.error(
        joint.place,
        fmt::format("link \"{}\" is the child of two joints, \"{}\" (line {}) and \"{}\"",
                    robot.links[static_cast<std::size_t>(joint.child)].name, first.name, first.place.line, joint.name),
        "a link has one parent: leave one joint out, and write it as a loop, <loop> in URDF, [[loop]] in TOML");
  }
  return joint_above;
}

// A link from which the path towards the base never reaches a root; -1 if there is none.
int link_in_cycle(const Robot& robot, const std::vector<int>& joint_above) {
  enum class State { unknown, on_the_way, ends };
  std::vector<State> state(robot.links.size(), State::unknown);
  for (std::size_t start = 0; start < robot.links.size(); ++start) {
    std::vector<std::size_t> way;
    std::size_t link = start;
    while (state[link] == State::unknown) {
      state[link] = State::on_the_way;
      way.push_back(link);
      const int joint = joint_above[link];
      if (joint < 0) break;
      link = static_cast<std::size_t>(robot.joints[static_cast<std::size_t>(joint)].parent);
      if (state[link] == State::on_the_way) return static_cast<int>(link);
    }
    for (const std::size_t passed : way) state[passed] = State::ends;
  }
  return -1;
}

void report_cycle(const Robot& robot, const std::vector<int>& joint_above, int start, Diagnostics& diagnostics) {
  std::string names;
  int link = start;
  const Joint* joint = nullptr;
  do {
    joint = &robot.joints[static_cast<std::size_t>(joint_above[static_cast<std::size_t>(link)])];
    names = " -> \"" + robot.links[static_cast<std::size_t>(link)].name + "\"" + names;
    link = joint->parent;
  } while (link != start);
  diagnostics.error(joint->place,
                    "the links form a cycle: \"" + robot.links[static_cast<std::size_t>(start)].name + "\"" + names,
                    "the joints must form a tree; cut the cycle at one of its joints");
}

void find_root(Robot& robot, const std::vector<int>& joint_above, Diagnostics& diagnostics) {
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    if (joint_above[link] >= 0) continue;
    if (robot.root < 0) {
      robot.root = static_cast<int>(link);
      continue;
    }
    const Link& root = robot.links[static_cast<std::size_t>(robot.root)];
    diagnostics.error(robot.links[link].place,
                      fmt::format("two links have no parent, \"{}\" (line {}) and \"{}\": there must be one root",
                                  root.name, root.place.line, robot.links[link].name),
                      "join them by a joint (type=\"fixed\" if they do not move), or delete one of them");
  }
}

bool all_named(const Robot& robot) {
  return std::none_of(robot.links.begin(), robot.links.end(), [](const Link& link) { return link.name.empty(); });
}

bool find_tree(Robot& robot, Diagnostics& diagnostics) {
  if (robot.links.empty()) {
    diagnostics.error({robot.file, 0}, "the robot has no links", "add a link for the base and one for each joint");
    return false;
  }
  if (robot.joints.size() > kMostJoints) {
    diagnostics.unsupported(
        {robot.file, 0},
        fmt::format("the robot has {} joints; more than {} are not supported", robot.joints.size(), kMostJoints),
        "leave out what does not move, or cut the robot in parts");
    return false;
  }
  report_duplicates(robot.links, "link", diagnostics);
  report_duplicates(robot.joints, "joint", diagnostics);
  for (const Joint& joint : robot.joints) {
    if (joint.parent < 0 || joint.child < 0) return false;  // reported where it was read
  }
  const std::vector<int> joint_above = joints_above(robot, diagnostics);
  if (const int link = link_in_cycle(robot, joint_above); link >= 0) {
    report_cycle(robot, joint_above, link, diagnostics);
    return false;
  }
  // With a name missing or used twice, joints may be attached to the wrong link; consequences of that are not reported.
  if (!diagnostics.has_errors() && all_named(robot)) find_root(robot, joint_above, diagnostics);
  return robot.root >= 0;
}

}  // namespace

bool validate_tree(Robot& robot, Diagnostics& all) {
  Diagnostics diagnostics;  // findings about the tree alone, as other errors do not matter here
  const bool is_tree = find_tree(robot, diagnostics) && !diagnostics.has_errors();
  for (const Diagnostic& diagnostic : diagnostics.all()) all.add(diagnostic);
  return is_tree;
}

}  // namespace flatdyn
