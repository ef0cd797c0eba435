// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of the robot file that were snapped to exact ones, with the effect of each (verify/snap_effect.hpp).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/robot.hpp"

namespace flatdyn {

// The detail in texts for people.
enum class SnapDetail { one_line, each };

// The snaps as text, "" if there are none. torque_changes: one per snap, N m, or N for prismatic joints.
std::string describe_snaps(const std::vector<Snap>& snaps, const std::vector<double>& torque_changes,
                           SnapDetail detail);

// A snap without its place: 'joint "j", origin, rpy: 1.5708 snapped to pi/2: off by -3.7e-06 rad, changes torques by up
// to 1e-05'.
std::string snap_text(const Snap& snap, double torque_change);

nlohmann::ordered_json snaps_json(const std::vector<Snap>& snaps, const std::vector<double>& torque_changes);

}  // namespace flatdyn
