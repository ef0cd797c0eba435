// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of the robot file that were snapped to exact ones, with the effect of each (proof/verify/snap_effect.hpp).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "proof/verify/snap_effect.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// The detail in texts for people.
enum class SnapDetail { one_line, each };

// The snaps as text, "" if there are none.
std::string describe_snaps(const std::vector<Snap>& snaps, const SnapEffects& effects, SnapDetail detail);

// A snap without its place: 'joint "j", origin, rpy: 1.5708 snapped to pi/2: off by -3.7e-06 rad, changes no torque by
// more than 1.3e-05 N m'; without a proven bound, 'changes torques by up to 1.0e-05 N m at random states'.
std::string snap_text(const Snap& snap, const SnapEffect& effect);

nlohmann::ordered_json snaps_json(const std::vector<Snap>& snaps, const SnapEffects& effects);

}  // namespace flatdyn
