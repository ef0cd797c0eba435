// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The length of q̇, q̈ and τ, and the length of q, which is longer if loops are closed or joints are spherical.
struct JointCounts {
  int joints, positions;
  int base = 0;            // entries of q̇ that are a floating base's; then v and a have a name for their length
  bool spherical = false;  // whether there are spherical joints

  JointCounts(int n) : joints(n), positions(n) {}  // NOLINT(google-explicit-constructor): most robots have one number
  explicit JointCounts(const Mechanism& mechanism)
      : joints(mechanism.size()),
        positions(mechanism.position_count()),
        base(mechanism.base_bodies()),
        spherical(mechanism.has_spherical_joints()) {}

  bool has_base() const { return base > 0; }
};

}  // namespace flatdyn
