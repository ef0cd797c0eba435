// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of a floating base as the torques depend on it.
//
// All parts of a robot fall alike, so torques and the base's force depend on the base's velocity v, on its derivative
// and on gravity only by f = v̇ + ω × v - g_b, the specific force at the base frame's origin in base axes: what an
// accelerometer there shows, 9.81 m/s² upwards at rest. So their equations are evaluated with v = 0, without gravity,
// and with f in the place of v̇, and an inertial measurement unit measures all that they need.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "laboratory/identify/channel_noise.hpp"
#include "laboratory/identify/log_layout.hpp"

namespace flatdyn {

// The numbers that turn a log's readings into the base's motion.
struct BaseSensors {
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();       // g_0 in the world's axes, m/s²
  Eigen::Matrix3d imu_axes = Eigen::Matrix3d::Identity();  // x, y and z of the measurement unit, in base axes
  Eigen::Vector3d imu_place = Eigen::Vector3d::Zero();     // in the base frame, m
};

// The sensors of a robot; `imu` names the link whose frame is that of the measurement unit, empty for the base's.
// Throws Failure(usage) unless the link is fixed to the base link. Both are at rest for a robot with a fixed base.
BaseSensors base_sensors(const Mechanism& mechanism, const std::string& imu);

// `count` channels from `first` on, smoothed, or their derivative of this order, 0 to 2.
using ChannelFilter = std::function<Eigen::VectorXd(int first, int count, int order)>;

// Writes (0, ω) to the first six entries of q̇, and (f, ω̇) to those of q̈: rad/s, m/s², rad/s², in base axes.
void set_base_motion(const LogLayout& layout, const BaseSensors& sensors, const ChannelFilter& channels,
                     Eigen::VectorXd& qd, Eigen::VectorXd& qdd);

// How often the readings are differentiated that the six entries (f, ω̇) of q̈ are made of.
std::vector<int> base_orders(const LogLayout& layout);
// By these entries: the noise of the readings, as it enters them before it is differentiated. Zero where readings are
// estimates already, such as twists. `noise` is by channel.
std::vector<ChannelNoise> base_noise(const LogLayout& layout, const BaseSensors& sensors,
                                     const std::vector<ChannelNoise>& noise);

}  // namespace flatdyn
