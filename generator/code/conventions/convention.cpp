// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/conventions/convention.hpp"

#include <fmt/format.h>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

const std::vector<Convention>& conventions() {
  static const std::vector<Convention> all = {
      {.name = "pose",
       .whose = "flatdyn itself, with the base's pose instead of gravity in base axes",
       .scalar_first = true,
       .linear_in_world = false,
       .angular_in_world = false,
       .angular_first = false},
      {.name = "pinocchio",
       .whose = "Pinocchio",
       .scalar_first = false,
       .linear_in_world = false,
       .angular_in_world = false,
       .angular_first = false},
      {.name = "mujoco",
       .whose = "MuJoCo",
       .scalar_first = true,
       .linear_in_world = true,
       .angular_in_world = false,
       .angular_first = false},
      {.name = "mixed",
       .whose = "iDynTree (its mixed representation)",
       .scalar_first = true,
       .linear_in_world = true,
       .angular_in_world = true,
       .angular_first = false},
      {.name = "featherstone",
       .whose = "Featherstone's spatial vectors in the base's coordinates, as RobCoGen has them",
       .scalar_first = true,
       .linear_in_world = false,
       .angular_in_world = false,
       .angular_first = true}};
  return all;
}

std::vector<std::string> convention_names() {
  std::vector<std::string> names;
  for (const Convention& convention : conventions()) names.emplace_back(convention.name);
  return names;
}

const Convention& convention_of(const std::string& name) {
  for (const Convention& convention : conventions()) {
    if (convention.name == name) return convention;
  }
  throw Failure(FailureKind::bug, fmt::format("no convention \"{}\"", name));
}

}  // namespace flatdyn
