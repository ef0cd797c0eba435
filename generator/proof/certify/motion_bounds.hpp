// SPDX-License-Identifier: GPL-2.0-or-later
// Bounds of combinations of a link's motion within the limits of rates and accelerations.
//
// With u_j the unit vector of joint j's axis and r_j the displacement from it to the link's origin, the motion of the
// link is a sum over joints up to its own, and over pairs a < b of them:
//     ω = Σ q̇_j u_j,   ω̇ = Σ q̈_j u_j + Σ q̇_a q̇_b u_a × u_b,
//     p̈ = -g_0 + Σ q̈_j u_j × r_j + Σ q̇_j² u_j × (u_j × r_j) + 2 Σ q̇_a q̇_b u_a × (u_b × r_b).
// Each summand is bounded for all positions by spectral norms, as |u_j| = 1 and |u_j × r_j| is no larger than the sum
// of the distances between axes on the path. A floating base counts as the first joint: its ω_b and ω̇_b take the places
// of q̇_j u_j and q̈_j u_j, and v̇ + ω × v - g_b that of -g_0; each is at most as long as its largest components together.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "proof/certify/input_limits.hpp"
#include "truth/definition/field_motion.hpp"

namespace flatdyn {

// The places of the entries of a link's motion in the rows that combine them.
struct MotionBasis {
  static constexpr int kOne = 0, kOmega = 1, kRate = 4, kAngular = 5, kOwn = 8, kLinear = 9;
  static constexpr int kProducts = 12;  // of ω_x, ω_y, ω_z, q̇_i, by pairs: (0, 0), (0, 1), ... (3, 3)
  static constexpr int kSize = 22;
  // The entries caused by one joint's acceleration alone: ω̇ and p̈.
  static constexpr int kAxis = 0, kLever = 3, kSizeOfAxis = 6;
};

// The entries of a link's motion, MotionBasis::kSize of them, in the order of the places above.
template <class F>
std::vector<F> entries_of(const FieldMotion<F>& motion) {
  std::vector<F> result = {F(1)};
  result.insert(result.end(), motion.omega.begin(), motion.omega.end());
  result.push_back(motion.qd);
  result.insert(result.end(), motion.domega.begin(), motion.domega.end());
  result.push_back(motion.qdd);
  result.insert(result.end(), motion.ddp.begin(), motion.ddp.end());
  const F factors[] = {motion.omega[0], motion.omega[1], motion.omega[2], motion.qd};
  for (int i = 0; i < 4; ++i) {
    for (int j = i; j < 4; ++j) result.push_back(factors[i] * factors[j]);
  }
  return result;
}

class MotionBounds {
 public:
  // The mechanism must not have closed loops, or coupled, prismatic or spherical joints.
  MotionBounds(const Mechanism& mechanism, const InputLimits& limits);

  // The largest length of rows · entries_of(the link's motion); rows has kSize columns.
  double of_motion(int link, const Eigen::MatrixXd& rows) const;
  // The largest length of rows · (u_joint, u_joint × r_joint) in the link's frame, of rows · (0, u_joint) if a floating
  // base slides along the axis; rows has kSizeOfAxis columns.
  double of_axis(int joint, int link, const Eigen::MatrixXd& rows) const;

 private:
  struct Link {
    std::vector<int> before;    // joints on the path to the link, without its own; 5 for a floating base
    std::vector<double> lever;  // by joint of `before`: bound of |u_j × r_j|
  };

  void add_base(const InputLimits& limits);
  Link after(int link, const Body& body) const;
  double lever_of(int joint, int link) const;
  double of_axis_of_base(int joint, int link, const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) const;

  std::vector<Link> links_;
  std::vector<double> rates_, accelerations_;  // largest, by joint; |ω_b| and |ω̇_b| at 5 of a floating base
  double of_base_ = 0;                         // |p̈| of the base: |g_0|, or |v̇ + ω × v - g_b|
  int base_ = -1;                              // the link that is a floating base
};

}  // namespace flatdyn
