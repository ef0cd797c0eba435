// SPDX-License-Identifier: GPL-2.0-or-later
// The identified robot as a file: TOML over the given robot file.
#pragma once

#include <filesystem>
#include <string>

#include "functions/load/loaded_robot.hpp"
#include "laboratory/identify/physical_parameters.hpp"

namespace flatdyn {

struct IdentifiedSpring {
  double stiffness = 0;       // k, N m/rad or N/m
  double relaxed_torque = 0;  // k q_0, N m or N
};

struct IdentifiedRobot {
  std::filesystem::path file;               // where it will be written; the robot file is named relative to it
  std::vector<std::string> comments;        // lines for its top
  std::vector<std::string> settings;        // TOML lines that repeat the options that shaped the model
  std::vector<IdentifiedSpring> springs{};  // by joint, if they were estimated
};

// The text has mass, centre of mass and inertia of every moving link, and I_m, F_v and F_s where `set` includes them;
// springs with a stiffness above 0, and none elsewhere, where they were estimated.
// Everything else that moves with a link (merged links, masses of rotors, a payload) is part of it and has no mass of
// its own.
std::string identified_robot_text(const LoadedRobot& model, ParameterSet set, const PhysicalParameters& parameters,
                                  const IdentifiedRobot& about);

}  // namespace flatdyn
