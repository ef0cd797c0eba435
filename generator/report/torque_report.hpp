// SPDX-License-Identifier: GPL-2.0-or-later
// Torques along a trajectory, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "plot/time_table.hpp"
#include "trajectory/torque_terms.hpp"

namespace flatdyn {

// By point, and there by joint.
using ByPoint = std::vector<std::vector<double>>;

// t, q1, …, qd1, …, qdd1, …, h_e1, … (where the tip pushes), tau1, … . q is of positions_along() the trajectory, so
// that of all joints where loops are closed, as it is read again.
TimeTable trajectory_table(const Trajectory& trajectory, const ByPoint& q, const ByPoint& tau);
// The same, and behind it every term by its name.
TimeTable torque_table(const Trajectory& trajectory, const ByPoint& q, const TorqueHistory& history);

// Largest torques by joint and kind of contribution.
std::string describe_torques(const Mechanism& mechanism, const Trajectory& trajectory, const TorqueHistory& history);
nlohmann::ordered_json torques_json(const Mechanism& mechanism, const Trajectory& trajectory,
                                    const TorqueHistory& history);

// Positions, rates, accelerations and torques, of trajectory_table().
std::vector<PanelColumns> motion_panels(const Mechanism& mechanism, bool tip_force);
// The same; then a panel per joint with what its torque is made of, term by term or,
// where these are many, by kind.
std::string torque_plot(const Mechanism& mechanism, const Trajectory& trajectory, const ByPoint& q,
                        const TorqueHistory& history, PictureFormat format);

// A warning for each limit of the robot that the motion exceeds: positions, rates, accelerations, torques.
Diagnostics exceeded_limits(const Mechanism& mechanism, const Trajectory& trajectory, const ByPoint& tau,
                            const std::string& file);

}  // namespace flatdyn
