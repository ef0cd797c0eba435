// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/motion_filter.hpp"

#include "laboratory/identify/quaternion_rates.hpp"
#include "laboratory/identify/zero_phase.hpp"

namespace flatdyn {
namespace {

using Eigen::VectorXd;

void weigh(const SampleWindow& window, int first, const VectorXd& weights, VectorXd& out) {
  const auto length = static_cast<int>(weights.size());
  out.noalias() = window.block(0, length, first, static_cast<int>(out.size())).transpose() * weights;
}

// Rates of those positions that have one.
VectorXd weighed_positions(const SampleWindow& window, const LogLayout& layout, const VectorXd& weights) {
  VectorXd all(layout.positions), result(layout.joints);
  weigh(window, LogLayout::q(), weights, all);
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    result[i] = all[layout.position_of[static_cast<std::size_t>(i + layout.base)]];
  }
  return result;
}

}  // namespace

MotionFilter::MotionFilter(const StreamPlan& plan) : layout_(plan.layout()), sensors_(plan.sensors) {
  if (plan.filter.band == 0) {
    weights_[0] = VectorXd::Ones(1);
    return;
  }
  const ZeroPhaseKernel kernel = zero_phase_kernel(plan.filter.motion_band(), plan.filter.dt);
  for (int order = 0; order < 3; ++order) {
    weights_[order] = Eigen::Map<const VectorXd>(kernel.weights[order].data(), kernel.length());
  }
}

void MotionFilter::filter(const SampleWindow& window, SmoothedMotion& motion) const {
  auto& [q, qd, qdd, h_e, temperatures] = motion;
  const auto channels = [this, &window](int first, int count, int order) {
    VectorXd result(count);
    weigh(window, first, weights_[order], result);
    return result;
  };
  const int n = layout_.joints;
  q = channels(LogLayout::q(), layout_.positions, 0);
  qd.resize(layout_.rates());
  qdd.resize(layout_.rates());
  if (layout_.base > 0) set_base_motion(layout_, sensors_, channels, qd, qdd);
  qd.tail(n) = layout_.has_rates ? channels(layout_.qd(), n, 0) : weighed_positions(window, layout_, weights_[1]);
  qdd.tail(n) = layout_.has_accelerations ? channels(layout_.qdd(), n, 0)
                : layout_.has_rates       ? channels(layout_.qd(), n, 1)
                                          : weighed_positions(window, layout_, weights_[2]);
  for (std::size_t k = 0; k < layout_.spherical.size(); ++k) set_spherical(k, channels, q, qd, qdd);
  if (layout_.has_tip_force) h_e = channels(layout_.h_e(), LogLayout::kWrench, 0);
  if (layout_.has_temperatures) temperatures = channels(layout_.temperatures(), n, 0);
}

// The rates of a spherical joint are no derivatives of entries of its quaternion, which is of unit length again here.
void MotionFilter::set_spherical(std::size_t k, const ChannelFilter& channels, VectorXd& q, VectorXd& qd,
                                 VectorXd& qdd) const {
  const int position = layout_.spherical_positions[k], first = LogLayout::q() + position;
  q.segment(position, LogLayout::kQuaternion).normalize();
  if (layout_.has_rates) return;
  const auto turned = [&](int order) -> Eigen::Vector4d { return channels(first, LogLayout::kQuaternion, order); };
  const QuaternionRates found = quaternion_rates(turned(0), turned(1), turned(2));
  qd.segment(layout_.spherical[k], LogLayout::kTurns) = found.velocity;
  if (!layout_.has_accelerations) qdd.segment(layout_.spherical[k], LogLayout::kTurns) = found.acceleration;
}

}  // namespace flatdyn
