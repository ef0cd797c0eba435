// SPDX-License-Identifier: GPL-2.0-or-later
// What a robot is drawn from: points that its joints move, lines between them, and the joints' axes.
#pragma once

#include <utility>
#include <vector>

#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/robot.hpp"

namespace flatdyn {

struct Drawing {
  struct Follower {
    int point = 0;  // on its axis
    bool prismatic = false;
  };

  // "drawing" of q: `points` (3 per point, m), `axes` (3 per joint, then per follower, unit: z of its body) and
  // `gravity` (m/s^2), all in the base frame. After the passes.
  Function function;
  int points = 0;
  std::vector<std::pair<int, int>> lines;  // between points
  std::vector<int> joints;                 // by joint in the order of q: the point that lies on its axis
  std::vector<Follower> followers;         // joints that q has no entry for
};

// One point per written link, its frame's origin, with a line along every joint of the file, fixed ones too; and the
// centres of mass of last links whose frames are at their joints, as in URDF. `mechanism`: made of `robot`.
Drawing drawing_of(const Robot& robot, const Mechanism& mechanism);

}  // namespace flatdyn
