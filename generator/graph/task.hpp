// SPDX-License-Identifier: GPL-2.0-or-later
// What the functions of the operational space are about: directions of the tip, in which coordinates, and how much they
// give way near singularities.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/rational.hpp"

namespace flatdyn {

// What the last three rows of the tip's Jacobian are: the angular velocity, or the rates of Euler angles φ, θ, ψ with
// R = R_z(φ) R_y(θ) R_z(ψ) or, roll, pitch and yaw, R = R_z(φ) R_y(θ) R_x(ψ).
enum class Orientation : std::uint8_t { angular_velocity, zyz, rpy };

struct Task {
  std::vector<int> rows;  // rising: 0 to 2 for x, y, z, 3 to 5 for the rotation
  Orientation orientation = Orientation::angular_velocity;
  Rational damping = 0;  // λ: J B^-1 J^T + λ² 1 is inverted

  bool empty() const { return rows.empty(); }
  bool has_angles() const { return orientation != Orientation::angular_velocity; }
  bool is_damped() const { return damping != 0; }
};

}  // namespace flatdyn
