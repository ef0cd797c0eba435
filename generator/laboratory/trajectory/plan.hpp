// SPDX-License-Identifier: GPL-2.0-or-later
// The contents of a trajectory file (docs/trajectory-format.md): postures, and the moves from one to the next. SI.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "laboratory/trajectory/tip_kinematics.hpp"
#include "laboratory/trajectory/velocity_profile.hpp"

namespace flatdyn {

// Positions by joint, rad or m; a joint that is not named keeps its position, which is 0 at the start.
using JointPosture = std::vector<std::optional<double>>;

// A posture given by the place of the tip. A planar arm of two links has a closed form and needs the elbow; for other
// robots the search starts at `guess`, or else at the previous positions.
struct TipPosture {
  Eigen::Vector3d p;
  std::optional<Elbow> elbow;
  std::optional<JointPosture> guess;
  Place place;
};

using Posture = std::variant<JointPosture, TipPosture>;

// The given keys of a profile, each with its line.
struct PlacedProfile {
  VelocityShape shape = VelocityShape::triangular;
  // One number for all joints, or one per joint.
  std::map<std::string, std::vector<double>> given;
  std::map<std::string, Place> places;
  Place place;
};

// A move of the joints by velocity profiles.
struct JointMove {
  Posture to;
  bool relative = false;  // `to` is a displacement
  PlacedProfile profile;
};

// A straight line of the tip, base axes, m.
struct LineMove {
  Eigen::Vector3d to;
  bool relative = false;
  bool hold_orientation = false;
  PlacedProfile profile;
};

struct Dwell {
  double duration = 0;  // s
};

struct Segment {
  std::variant<JointMove, LineMove, Dwell> motion;
  Place place;
};

// A constant force, N, and moment, N m, that the tip exerts on its environment, in base axes or in those of the tip.
struct TipForce {
  std::array<double, 6> h_e{};
  bool in_tip_axes = false;
};

struct TrajectoryPlan {
  std::string file;
  double rate = 1000;  // samples per second
  Posture start;
  std::optional<TipForce> tip_force;
  std::vector<Segment> segments;
};

}  // namespace flatdyn
