// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/pose_product.hpp"

#include <algorithm>

namespace flatdyn {

namespace {

using DisplacementKind = Displacement::Kind;

bool moves_nothing(const Displacement& a) {
  if (a.kind != DisplacementKind::translation) return vanishes(a.angle);
  return std::all_of(a.translation.begin(), a.translation.end(), [](const Number& x) { return vanishes(x); });
}

void append(const Displacement& next, Displacements& all) {
  if (moves_nothing(next)) return;
  if (all.empty() || all.back().kind != next.kind) {
    all.push_back(next);
    return;
  }
  Displacement& last = all.back();
  last.translation = expanded(last.translation + next.translation);
  last.angle = Number(last.angle + next.angle).expand();
  if (moves_nothing(last)) all.pop_back();
}

}  // namespace

Displacements product(const Displacements& a, const Displacements& b) {
  Displacements all;
  for (const Displacements* part : {&a, &b}) {
    for (const Displacement& next : *part) append(next, all);
  }
  return all;
}

Displacements inverse(const Displacements& a) {
  Displacements reversed(a.rbegin(), a.rend());
  for (Displacement& each : reversed) {
    each.translation = expanded(Number(-1) * each.translation);
    each.angle = -each.angle;
  }
  return reversed;
}

Displacements rotations_in(const Displacements& a) {
  Displacements rotations;
  for (const Displacement& each : a) {
    if (each.kind != DisplacementKind::translation) append(each, rotations);
  }
  return rotations;
}

}  // namespace flatdyn
