// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles of meshes in exact numbers, as they are read.
#pragma once

#include <gmpxx.h>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "robot/model/number.hpp"

namespace flatdyn {

using MeshInteger = mpz_class;
using IntegerPoint = std::array<MeshInteger, 3>;

// A surface of triangles, counterclockwise seen from outside. Corners are multiples of a unit.
struct TriangleMesh {
  Number unit = 1;                   // of the corners' coordinates
  std::vector<IntegerPoint> points;  // no two are the same
  std::vector<std::array<std::size_t, 3>> triangles;
};

// mantissa · base^exponent, with the base of all of a mesh's numbers.
struct Scientific {
  MeshInteger mantissa;
  int exponent = 0;
};

// A float, exactly: of the base 2. nullopt if it is not finite.
std::optional<Scientific> exact_float(float value);

// A decimal as text: of the base 10. nullopt if it is not a decimal, is beyond 1e30, or has digits below 1e-60.
std::optional<Scientific> exact_scientific(std::string_view text);

class MeshBuilder {
 public:
  explicit MeshBuilder(int base) : base_(base) {}

  void add_point(const std::array<Scientific, 3>& point) { points_.push_back(point); }
  std::size_t point_count() const { return points_.size(); }
  // Indices of points that have been added.
  void add_triangle(std::size_t a, std::size_t b, std::size_t c) { triangles_.push_back({a, b, c}); }

  TriangleMesh mesh() const;

 private:
  int base_;
  std::vector<std::array<Scientific, 3>> points_;
  std::vector<std::array<std::size_t, 3>> triangles_;
};

}  // namespace flatdyn
