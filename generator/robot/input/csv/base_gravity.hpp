// SPDX-License-Identifier: GPL-2.0-or-later
// Gravity in the axes of a floating base, where a CSV file has the base's orientation instead.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robot/input/csv/table.hpp"

namespace flatdyn {

inline constexpr const char* kBaseGravityHint =
    "gravity is that in base axes: 0, 0, -9.81 where z of the base points up; or give base_qw to base_qz, the base's "
    "unit quaternion";

// The columns of a floating base's quaternion, w, x, y and z, if all four are there; else none.
std::vector<CsvSource> base_orientation(CsvHeading& heading);

// g_b = Rᵀ g_0, with the quaternion (w, x, y, z) as it is: (w² - u·u) g_0 + 2 (u·g_0) u - 2 w u × g_0, where u is
// (x, y, z). It is |q|² times the gravity of a unit quaternion.
template <class S>
std::array<S, 3> gravity_in_base_axes(const std::array<S, 4>& quaternion, const std::array<S, 3>& g_0) {
  const S& w = quaternion[0];
  const S* u = quaternion.data() + 1;
  const S along = S(2) * (u[0] * g_0[0] + u[1] * g_0[1] + u[2] * g_0[2]);
  const S scale = w * w - u[0] * u[0] - u[1] * u[1] - u[2] * u[2];
  std::array<S, 3> g_b;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
    g_b[k] = scale * g_0[k] + along * u[k] - S(2) * w * (u[next] * g_0[last] - u[last] * g_0[next]);
  }
  return g_b;
}

// Gravity in base axes of each row of a table, m/s². Reads its columns, or else the quaternion's if the robot's gravity
// is without symbols.
class BaseGravity {
 public:
  // Columns that are missing are errors; `why` says what needs them: "it moves the ellipsoids".
  BaseGravity(CsvHeading& heading, const Mechanism& mechanism, const Place& place, const std::string& why,
              Diagnostics& diagnostics);

  std::vector<CsvSource> sources() const;
  // Warns of quaternions whose norm is not 1.
  void check(const CsvTable& table, const std::string& file, Diagnostics& diagnostics) const;
  std::array<double, 3> at(const CsvTable& table, std::size_t row) const;

 private:
  std::vector<CsvSource> gravity_, orientation_;
  std::array<Number, 3> g_0_;
};

}  // namespace flatdyn
