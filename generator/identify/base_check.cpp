// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/base_check.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>

namespace flatdyn {
namespace {

using Three = Eigen::Map<const Eigen::Vector3d>;

constexpr int kAxes = 3;

}  // namespace

void BaseCheck::add(const double* channels) {
  const LogLayout& layout = heading_.layout;
  const bool has_unit = layout.base_motion == BaseMotion::imu;
  if (!has_unit && !layout.has_twist) return;
  if (has_unit) sum_of_forces_ += Three(channels + layout.base_reading()).norm();
  const int turns = kAxes + (has_unit ? layout.base_reading() : layout.twist());
  fastest_ = std::max(fastest_, Three(channels + turns).norm());
  ++samples_;
}

void BaseCheck::finish(const Place& place, Diagnostics& diagnostics) const {
  constexpr double kLittle = 0.3, kMuch = 3;  // shares of gravity, of a mean
  constexpr double kFastest = 100;            // rad/s
  if (samples_ == 0) return;
  if (fastest_ > kFastest) {
    diagnostics.warning(place, fmt::format("the base turns by up to {:.3g} rad/s", fastest_),
                        "are these degrees? Then write the unit into the heading: imu_wx [deg/s], or base_wx [deg/s]");
  }
  const double mean = sum_of_forces_ / static_cast<double>(samples_);
  const bool is_odd = mean < kLittle * gravity_ || mean > kMuch * gravity_;
  if (heading_.layout.base_motion != BaseMotion::imu || gravity_ == 0 || !is_odd) return;
  diagnostics.warning(
      place, fmt::format("imu_ax to imu_az have a size of {:.3g} m/s^2 on average", mean),
      "an accelerometer at rest shows 9.81 m/s^2 upwards: is the unit g (imu_ax [g]), or was gravity taken off?");
}

}  // namespace flatdyn
