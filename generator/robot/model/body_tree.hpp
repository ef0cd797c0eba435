// SPDX-License-Identifier: GPL-2.0-or-later
// The moving bodies of a robot, as a tree.
#pragma once

#include <string>
#include <vector>

#include "robot/model/body.hpp"

namespace flatdyn {

struct BodyTree {
  std::string name;
  std::vector<Body> bodies;        // parents before children
  std::vector<WrittenLink> links;  // every written link, in file order
  Vec3 gravity = zero_vector();    // g_0 in the base frame, m/s^2
  InertialParameters base;         // bodies fixed to the base (only the potential energy's constant depends on them)
  std::vector<FreeSymbol> symbols;
  std::vector<std::string> merged;  // names of links that fixed joints have merged into another

  int body_count() const { return static_cast<int>(bodies.size()); }
  const Body& body(int i) const { return bodies[static_cast<std::size_t>(i)]; }
  bool is_of_spherical(int i) const { return body(i).spherical > 0; }
  bool has_springs() const;
};

// The bodies on the path from body `from` (-1: the base), which is left out, outwards to `body`, which is the last.
// `from` must be on the path from the base.
std::vector<int> path_to(const BodyTree& tree, int body, int from = -1);

}  // namespace flatdyn
