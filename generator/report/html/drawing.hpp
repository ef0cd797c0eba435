// SPDX-License-Identifier: GPL-2.0-or-later
// The data of a robot's picture: points that move with the joints, lines between them, and the joints' axes.
#pragma once

#include <utility>
#include <vector>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

struct Drawing {
  struct Follower {
    int point = 0;  // a point on its axis
    bool prismatic = false;
  };

  // The function "drawing" of q, after the passes. Outputs, all in the base frame: `points` (3 per point, m), `axes` (3
  // per joint, then 3 per follower; unit vectors, z of the body) and `g_0` (m/s^2; with a floating base in world axes).
  // Those of a spherical joint, which counts as three, are x, y and z of its child.
  Function function;
  int points = 0;
  std::vector<std::pair<int, int>> lines;  // pairs of points
  std::vector<int> joints;                 // for each entry of q̇ but the base's, a point on its axis
  std::vector<Follower> followers;         // joints without an entry of q
};

// The drawing has one point per link of the file, at its frame's origin, with a line along every joint, fixed ones
// included; and the centres of mass of last links whose frames are at their joints, as in URDF. `mechanism`: made from
// `robot`.
Drawing drawing_of(const Robot& robot, const Mechanism& mechanism);

}  // namespace flatdyn
