// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/base_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace flatdyn {
namespace {

using ThreeNumbers = Eigen::Map<const Eigen::Vector3d>;

constexpr int kAxes = 3;

}  // namespace

void BaseCheck::Agreement::add(const Eigen::Vector3d& in_base, const Eigen::Vector3d& in_world,
                               const Eigen::Vector3d& expected) {
  of_base += (in_base - expected).squaredNorm();
  of_world += (in_world - expected).squaredNorm();
  all += expected.squaredNorm();
  ++count;
}

// Noise of the pose is in both, and cancels in the difference but for a few times what it has in one sample.
bool BaseCheck::Agreement::is_in_world() const {
  constexpr double kClearly = 3e-3, kOfNoise = 400;  // share of the squares; of the noise in one sample
  const double difference = of_base - of_world;
  return difference > kClearly * all && difference * static_cast<double>(count) > kOfNoise * of_world;
}

void BaseCheck::add(const double* channels) {
  const LogLayout& layout = heading_.layout;
  const bool is_unit = layout.base_motion == BaseMotion::imu;
  if (!is_unit && !layout.has_twist) return;
  const ThreeNumbers turns(channels + kAxes + (is_unit ? layout.base_reading() : layout.twist()));
  fastest_ = std::max(fastest_, turns.norm());
  if (layout.base_motion != BaseMotion::pose) return;
  const double* const pose = channels + layout.base_reading();
  const double* const wxyz = pose + LogLayout::kQuaternionInPose;
  const Sample now{channels[LogLayout::time()], ThreeNumbers(pose), ThreeNumbers(channels + layout.twist()), turns,
                   Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3])};
  const double step = last_ ? now.time - last_->time : 0;
  if (last_ && step < 2 * dt_) {
    const Eigen::Vector3d moved = now.place - last_->place;
    const Eigen::Vector3d along = step / 2 * (last_->turn * last_->v + now.turn * now.v);
    if (layout.has_place) linear_.add(along, step / 2 * (last_->v + now.v), moved);
    const Eigen::Vector3d turned = step / 2 * (last_->turns + now.turns);
    angular_.add(2 * (last_->turn.conjugate() * now.turn).vec(), 2 * (now.turn * last_->turn.conjugate()).vec(),
                 turned);
  }
  last_ = now;
}

void BaseCheck::finish(const Place& place, Diagnostics& diagnostics) const {
  constexpr double kFastest = 100;  // rad/s
  if (fastest_ > kFastest) {
    diagnostics.warning(place, fmt::format("the base turns by up to {:.3g} rad/s", fastest_),
                        "are these degrees? Then write the unit into the heading: imu_wx [deg/s], or base_wx [deg/s]");
  }
  const auto ask_about = [&](const char* columns, const char* what) {
    diagnostics.warning(place, fmt::format("{} look like {} in the world's axes", columns, what),
                        "a twist is in base axes: v = R' dp/dt with R of the quaternion, and omega turned likewise; "
                        "MuJoCo has dp/dt, and others both, in the world's axes");
  };
  if (linear_.is_in_world()) ask_about("base_vx to base_vz", "the velocity");
  if (angular_.is_in_world()) ask_about("base_wx to base_wz", "the angular velocity");
}

}  // namespace flatdyn
