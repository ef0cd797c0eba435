// SPDX-License-Identifier: GPL-2.0-or-later
// A trajectory file as written (docs/trajectory-format.md): postures and what leads from one to the next. SI.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "trajectory/tip_kinematics.hpp"
#include "trajectory/velocity_profile.hpp"

namespace flatdyn {

// By joint; of one that is not named: where it is already, at the start 0.
using JointPosture = std::vector<std::optional<double>>;

// Where the tip is to be; the joints follow. A planar arm of two links has a closed form and needs the elbow; other
// robots a guess of the positions, or take those before.
struct TipPosture {
  Eigen::Vector3d p;
  std::optional<Elbow> elbow;
  std::optional<JointPosture> guess;
  Place place;
};

using Posture = std::variant<JointPosture, TipPosture>;

// Requests of a profile with the line of each key.
struct PlacedProfile {
  VelocityShape shape = VelocityShape::triangular;
  // One number for all joints, or one each.
  std::map<std::string, std::vector<double>> given;
  std::map<std::string, Place> places;
  Place place;
};

struct JointMove {
  Posture to;
  bool relative = false;  // `to` is how far
  PlacedProfile profile;
};

struct LineMove {
  Eigen::Vector3d to;
  bool relative = false;
  bool hold_orientation = false;
  PlacedProfile profile;
};

struct Dwell {
  double duration = 0;
};

struct Segment {
  std::variant<JointMove, LineMove, Dwell> motion;
  Place place;
};

// A constant force and moment that the tip exerts on its environment.
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
