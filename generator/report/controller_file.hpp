// SPDX-License-Identifier: GPL-2.0-or-later
// A planned motion as the controllers of robots take it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "laboratory/identify/planned_motion.hpp"

namespace flatdyn {

enum class Controller {
  ur,      // URScript: servoj() for every sample, positions in rad
  franka,  // CSV: the seven positions of every millisecond in rad, one line each, without a heading
  ros      // trajectory_msgs/JointTrajectory as JSON, which is YAML, too: positions, velocities and accelerations, SI
};

// A controller that takes motions in a file.
struct ControllerRow {
  Controller controller;
  const char* name;            // of the option
  const char* suffix;          // of the file, behind the excitation's name
  std::optional<int> joints;   // that the robot must have; none: any
  std::optional<double> rate;  // samples a second that the controller takes; none: any
};

std::vector<std::string> controller_names();
const ControllerRow& controller_row(const std::string& name);  // of one of these names

// The file for a robot with a fixed base whose joints all have one coordinate.
std::string controller_text(const ControllerRow& row, const MotionEquations& equations, const PlannedMotion& motion);

}  // namespace flatdyn
