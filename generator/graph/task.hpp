// SPDX-License-Identifier: GPL-2.0-or-later
// The task of the operational-space functions: the directions of the tip, the coordinates that describe them, and the
// damping near singularities.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/rational.hpp"

namespace flatdyn {

// The quantity in the last three rows of the tip's Jacobian: the angular velocity, or the rates of Euler angles φ, θ, ψ
// with R = R_z(φ) R_y(θ) R_z(ψ) or, for roll, pitch and yaw, R = R_z(φ) R_y(θ) R_x(ψ).
enum class Orientation : std::uint8_t { angular_velocity, zyz, rpy };

struct Task {
  std::vector<int> rows;  // ascending: 0 to 2 for x, y, z, 3 to 5 for the rotation
  Orientation orientation = Orientation::angular_velocity;
  Rational damping = 0;  // λ: the matrix that is inverted is J B^-1 J^T + λ² 1

  bool empty() const { return rows.empty(); }
  bool has_angles() const { return orientation != Orientation::angular_velocity; }
  bool rates_are_of_angles() const { return has_angles() && !empty() && rows.back() >= 3; }
  bool is_damped() const { return damping != 0; }
};

}  // namespace flatdyn
