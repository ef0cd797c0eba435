// SPDX-License-Identifier: GPL-2.0-or-later
// q, q̇, q̈, the tip force and temperatures at the middle of a window of samples: smoothed, and differentiated where the
// log lacks them. The first six entries of q̇ and q̈ of a floating base are (0, ω) and (f, ω̇), base_motion.hpp.
#pragma once

#include <Eigen/Core>

#include "laboratory/identify/motion_stream.hpp"
#include "laboratory/identify/sample_window.hpp"

namespace flatdyn {

// h_e and temperatures are empty where the log lacks them.
struct SmoothedMotion {
  Eigen::VectorXd q, qd, qdd, h_e, temperatures;
};

class MotionFilter {
 public:
  explicit MotionFilter(const StreamPlan& plan);

  // Uses the newest samples of the window, an odd number.
  int length() const { return static_cast<int>(weights_[0].size()); }
  void filter(const SampleWindow& window, SmoothedMotion& motion) const;

 private:
  // Sets the entries of the k-th spherical joint.
  void set_spherical(std::size_t k, const ChannelFilter& channels, Eigen::VectorXd& q, Eigen::VectorXd& qd,
                     Eigen::VectorXd& qdd) const;

  LogLayout layout_;
  BaseSensors sensors_;
  Eigen::VectorXd weights_[3];
};

}  // namespace flatdyn
