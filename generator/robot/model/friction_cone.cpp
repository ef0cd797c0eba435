// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/friction_cone.hpp"

namespace flatdyn {
namespace {

constexpr int kSigns[] = {1, -1};
constexpr const char* kInside = "0.7071067811865475";  // just below 1/√2

// |entry k| <= bound f_z.
void add_between(std::size_t k, const Number& bound, std::vector<ConeRow>& rows) {
  for (const int sign : kSigns) {
    ConeRow row{0, 0, -bound, 0, 0, 0};
    row[k] = sign;
    rows.push_back(row);
  }
}

}  // namespace

std::vector<ConeRow> point_cone(const Number& friction) {
  std::vector<ConeRow> rows;
  for (const int x : kSigns) {
    for (const int y : kSigns) rows.push_back({x, y, -friction, 0, 0, 0});
  }
  return rows;
}

std::vector<ConeRow> surface_cone(const Number& friction, const Number& half_length, const Number& half_width) {
  const Number mu = friction * exact_decimal(kInside), X = half_length, Y = half_width;
  std::vector<ConeRow> rows;
  add_between(0, mu, rows);
  add_between(1, mu, rows);
  add_between(3, Y, rows);
  add_between(4, X, rows);
  // m_z <= μ (X + Y) f_z - |Y f_x + μ m_x| - |X f_y + μ m_y|, and the mirror image for -m_z.
  for (const int turn : kSigns) {
    for (const int x : kSigns) {
      for (const int y : kSigns) rows.push_back({x * Y, y * X, -mu * (X + Y), turn * x * mu, turn * y * mu, turn});
    }
  }
  return rows;
}

std::vector<ConeRow> cone_of(const SceneContact& contact) {
  if (!contact.friction) return {};
  return contact.is_surface ? surface_cone(*contact.friction, contact.size[0] / 2, contact.size[1] / 2)
                            : point_cone(*contact.friction);
}

}  // namespace flatdyn
