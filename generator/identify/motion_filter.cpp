// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/motion_filter.hpp"

#include "identify/zero_phase.hpp"

namespace flatdyn {
namespace {

using Eigen::VectorXd;

void weigh(const SampleWindow& window, int first, const VectorXd& weights, VectorXd& out) {
  const auto length = static_cast<int>(weights.size());
  out.noalias() = window.block(0, length, first, static_cast<int>(out.size())).transpose() * weights;
}

// Rates of those positions that have one.
void weigh_positions(const SampleWindow& window, const LogLayout& layout, const VectorXd& weights, VectorXd& out) {
  if (layout.positions == layout.joints) return weigh(window, LogLayout::q(), weights, out);
  VectorXd all(layout.positions);
  weigh(window, LogLayout::q(), weights, all);
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = all[layout.position_of[static_cast<std::size_t>(i)]];
}

}  // namespace

MotionFilter::MotionFilter(const StreamPlan& plan) : layout_(plan.layout()) {
  if (plan.filter.band == 0) {
    weights_[0] = VectorXd::Ones(1);
    return;
  }
  const ZeroPhaseKernel kernel = zero_phase_kernel(plan.filter.motion_band(), plan.filter.dt);
  for (int order = 0; order < 3; ++order) {
    weights_[order] = Eigen::Map<const VectorXd>(kernel.weights[order].data(), kernel.length());
  }
}

void MotionFilter::filter(const SampleWindow& window, VectorXd& q, VectorXd& qd, VectorXd& qdd, VectorXd& h_e) const {
  q.resize(layout_.positions);
  qd.resize(layout_.joints);
  qdd.resize(layout_.joints);
  weigh(window, LogLayout::q(), weights_[0], q);
  if (layout_.has_rates) {
    weigh(window, layout_.qd(), weights_[0], qd);
  } else {
    weigh_positions(window, layout_, weights_[1], qd);
  }
  if (layout_.has_accelerations) {
    weigh(window, layout_.qdd(), weights_[0], qdd);
  } else if (layout_.has_rates) {
    weigh(window, layout_.qd(), weights_[1], qdd);
  } else {
    weigh_positions(window, layout_, weights_[2], qdd);
  }
  if (!layout_.has_tip_force) return;
  h_e.resize(LogLayout::kWrench);
  weigh(window, layout_.h_e(), weights_[0], h_e);
}

}  // namespace flatdyn
