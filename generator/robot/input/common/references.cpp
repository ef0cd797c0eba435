// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/references.hpp"

#include "base/diagnostics/nearest.hpp"

namespace flatdyn {
namespace {

template <class Named>
int index_called(const std::vector<Named>& all, const char* kind, const std::string& name, const Place& place,
                 const std::string& what, Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return static_cast<int>(i);
    known.push_back(all[i].name);
  }
  diagnostics.error(place, what + ": there is no " + kind + " \"" + name + "\"",
                    hint_for_unknown(name, known, std::string(kind) + "s"));
  return -1;
}

}  // namespace

int link_called(const std::string& name, const Place& place, const std::string& what, const Robot& robot,
                Diagnostics& diagnostics) {
  return index_called(robot.links, "link", name, place, what, diagnostics);
}

int joint_called(const std::string& name, const Place& place, const std::string& what, const Robot& robot,
                 Diagnostics& diagnostics) {
  return index_called(robot.joints, "joint", name, place, what, diagnostics);
}

}  // namespace flatdyn
