// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/base_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "laboratory/identify/quaternion_rates.hpp"

namespace flatdyn {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kDirections = 3;

Vector3d numbers_of(const Vec3& v) { return {nearest_double(v[0]), nearest_double(v[1]), nearest_double(v[2])}; }

Eigen::Quaterniond quaternion_of(const VectorXd& wxyz) { return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]}; }

// (ω, f, ω̇).
struct ImuMotion {
  Vector3d turns, force, turns_faster;
};

ImuMotion of_measurement_unit(const LogLayout& layout, const BaseSensors& sensors, const ChannelFilter& channels) {
  const int accelerometer = layout.base_reading(), gyroscope = accelerometer + kDirections;
  const Vector3d turns = sensors.imu_axes * channels(gyroscope, kDirections, 0);
  const Vector3d turns_faster = sensors.imu_axes * channels(gyroscope, kDirections, 1);
  const Vector3d there = sensors.imu_axes * channels(accelerometer, kDirections, 0);
  const Vector3d &r = sensors.imu_place, moved = turns_faster.cross(r) + turns.cross(turns.cross(r));
  return {turns, there - moved, turns_faster};
}

ImuMotion of_pose(const LogLayout& layout, const BaseSensors& sensors, const ChannelFilter& channels) {
  const int place = layout.base_reading(), quaternion = place + LogLayout::kQuaternionInPose;
  const auto turned = [&](int order) -> Eigen::Vector4d { return channels(quaternion, LogLayout::kQuaternion, order); };
  const QuaternionRates found = quaternion_rates(turned(0), turned(1), turned(2));
  const Vector3d force = found.turn.conjugate() * (channels(place, kDirections, 2) - sensors.gravity);
  return {found.velocity, force, found.acceleration};
}

Vector3d base_gravity(const LogLayout& layout, const BaseSensors& sensors, const ChannelFilter& channels) {
  if (layout.base_motion == BaseMotion::gravity) return channels(layout.base_reading(), kDirections, 0);
  const VectorXd q = channels(layout.base_reading() + LogLayout::kQuaternionInPose, 4, 0);
  return quaternion_of(q).normalized().conjugate() * sensors.gravity;
}

ImuMotion of_twist(const LogLayout& layout, const BaseSensors& sensors, const ChannelFilter& channels) {
  const VectorXd twist = channels(layout.twist(), LogLayout::kTwist, 0);
  const VectorXd rates = layout.has_twist_rates ? channels(layout.twist_rates(), LogLayout::kTwist, 0)
                                                : channels(layout.twist(), LogLayout::kTwist, 1);
  const Vector3d v = twist.head(kDirections), turns = twist.tail(kDirections), faster = rates.head(kDirections);
  return {turns, faster + turns.cross(v) - base_gravity(layout, sensors, channels), rates.tail(kDirections)};
}

}  // namespace

BaseSensors base_sensors(const Mechanism& mechanism, const std::string& imu) {
  BaseSensors sensors;
  if (!mechanism.floating_base) return sensors;
  sensors.gravity = numbers_of(mechanism.gravity);
  if (imu.empty()) return sensors;
  const int base = mechanism.base_bodies() - 1;
  const auto link = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                 [&](const LinkFrame& each) { return each.link == imu; });
  if (link == mechanism.links.end() || link->body != base) {
    throw Failure(FailureKind::usage,
                  link == mechanism.links.end() ? fmt::format("--imu: the robot has no link \"{}\"", imu)
                                                : fmt::format("--imu: link \"{}\" moves against the base link", imu),
                  "name a link that fixed joints hold to the base link; flatdyn inspect lists links");
  }
  for (int k = 0; k < kDirections; ++k) {
    sensors.imu_axes.row(k) = numbers_of(link->R[static_cast<std::size_t>(k)]).transpose();
  }
  sensors.imu_place = numbers_of(link->p);
  return sensors;
}

void set_base_motion(const LogLayout& layout, const BaseSensors& sensors, const ChannelFilter& channels, VectorXd& qd,
                     VectorXd& qdd) {
  const ImuMotion motion = layout.base_motion == BaseMotion::imu ? of_measurement_unit(layout, sensors, channels)
                           : layout.has_twist                    ? of_twist(layout, sensors, channels)
                                                                 : of_pose(layout, sensors, channels);
  qd.head(LogLayout::kTwist) << Vector3d::Zero(), motion.turns;
  qdd.head(LogLayout::kTwist) << motion.force, motion.turns_faster;
}

std::vector<int> base_orders(const LogLayout& layout) {
  if (layout.base_motion == BaseMotion::imu) return {0, 0, 0, 1, 1, 1};
  const int order = layout.has_twist_rates ? 0 : layout.has_twist ? 1 : 2;
  return std::vector<int>(LogLayout::kTwist, order);
}

// Noise of a pose is taken for the same along all directions, so that the base's turning does not change it. Half a
// turn's sine is in the quaternion: ω̇ has twice its noise.
std::vector<ChannelNoise> base_noise(const LogLayout& layout, const BaseSensors& sensors,
                                     const std::vector<ChannelNoise>& noise) {
  std::vector<ChannelNoise> result(static_cast<std::size_t>(layout.base));
  const auto deviations = [&](int first, int count) {
    VectorXd squares(count);
    for (int k = 0; k < count; ++k) squares[k] = std::pow(noise[static_cast<std::size_t>(first + k)].deviation, 2);
    return squares;
  };
  const auto set = [&](std::size_t first, const Vector3d& squares) {
    for (std::size_t k = 0; k < kDirections; ++k) {
      result[first + k].deviation = std::sqrt(squares[static_cast<Eigen::Index>(k)]);
    }
  };
  const int at = layout.base_reading();
  if (layout.base_motion == BaseMotion::imu) {
    const Matrix3d shares = sensors.imu_axes.cwiseAbs2();
    set(0, shares * deviations(at, kDirections));
    set(kDirections, shares * deviations(at + kDirections, kDirections));
  } else if (layout.base_motion == BaseMotion::pose && !layout.has_twist) {
    set(0, Vector3d::Constant(deviations(at, kDirections).mean()));
    set(kDirections, Vector3d::Constant(4 * deviations(at + LogLayout::kQuaternionInPose, 4).mean()));
  }
  return result;
}

}  // namespace flatdyn
