// SPDX-License-Identifier: GPL-2.0-or-later
// Torques along a trajectory, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "laboratory/trajectory/torque_terms.hpp"
#include "report/plot/time_table.hpp"

namespace flatdyn {

// Values by point, and for each point by joint.
using ByPoint = std::vector<std::vector<double>>;

// Columns t, q1, …, qd1, …, qdd1, …, h_e1, … (if the tip pushes), tau1, … . q is that of positions_along() the
// trajectory, so it has all joints of closed loops, as readers expect.
TimeTable trajectory_table(const Trajectory& trajectory, const ByPoint& q, const ByPoint& tau);
// The same table, followed by every term as a column with its name.
TimeTable torque_table(const Trajectory& trajectory, const ByPoint& q, const TorqueHistory& history);

// The largest torques by joint and kind of contribution.
std::string describe_torques(const Mechanism& mechanism, const Trajectory& trajectory, const TorqueHistory& history);
nlohmann::ordered_json torques_json(const Mechanism& mechanism, const Trajectory& trajectory,
                                    const TorqueHistory& history);

// Panels for positions, rates, accelerations and torques of trajectory_table().
std::vector<PanelColumns> motion_panels(const Mechanism& mechanism, bool tip_force);
// A picture with those panels and, per joint, one with the contributions to its torque: term by term or, if there are
// many, by kind.
std::string torque_plot(const Mechanism& mechanism, const Trajectory& trajectory, const ByPoint& q,
                        const TorqueHistory& history, PictureFormat format);

// A warning for each limit of the robot that the motion exceeds: positions, rates, accelerations, torques.
Diagnostics exceeded_limits(const Mechanism& mechanism, const Trajectory& trajectory, const ByPoint& tau,
                            const std::string& file);

}  // namespace flatdyn
