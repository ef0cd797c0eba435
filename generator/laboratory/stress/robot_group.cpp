// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/stress/robot_group.hpp"

#include <fmt/format.h>

#include "base/system/process.hpp"

namespace flatdyn {
namespace {

// Flags that round as everywhere. Little optimisation is enough and compiles fast.
constexpr const char* kGroupFlags = "-std=c++17 -O1 -ffp-contract=off";

std::string entry_name(std::size_t member, std::size_t function) {
  return fmt::format("robot_{}_function_{}", member, function);
}

std::string group_text(const std::vector<RobotGroup::Member>& members) {
  std::string text;
  for (const RobotGroup::Member& member : members) text += member.robot->header() + "\n";
  for (std::size_t m = 0; m < members.size(); ++m) {
    const OneRobot& robot = *members[m].robot;
    for (std::size_t k = 0; k < robot.functions().size(); ++k) {
      text += plain_entry_text(robot.model().mechanism, robot.functions()[k], robot.name_space(), entry_name(m, k));
    }
  }
  return text;
}

}  // namespace

RobotGroup::RobotGroup(std::vector<Member> members) : members_(std::move(members)) {
  write_file(folder_.path() / "group.cpp", group_text(members_));
  compiling_ = std::async(std::launch::async, [path = folder_.path()] {
    return std::make_unique<SharedLibrary>(path, "group", kGroupFlags);
  });
}

std::vector<PlainEntry> RobotGroup::entries(std::size_t member) {
  if (!library_) library_ = compiling_.get();
  std::vector<PlainEntry> entries;
  for (std::size_t k = 0; k < members_[member].robot->functions().size(); ++k) {
    entries.push_back(reinterpret_cast<PlainEntry>(library_->symbol(entry_name(member, k))));
  }
  return entries;
}

}  // namespace flatdyn
