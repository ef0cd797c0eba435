// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/centres.hpp"

#include <algorithm>
#include <optional>

namespace flatdyn {
namespace {

const Body& body_of(const Mechanism& mechanism, int i) { return mechanism.bodies[static_cast<std::size_t>(i)]; }

// A point of the parent's frame, expressed in the frame of a body at q = 0.
Vec3 seen_from(const Body& body, const Vec3& point) {
  return expanded(transpose(constant_rotation(body)) * (point - body.p));
}

constexpr int kWorthwhile = 3;  // least number of axes through one point

bool is_on_axis(const Vec3& point) { return vanishes(point[0]) && vanishes(point[1]); }

// The point where the axis of `body` crosses that of its parent, as z in the parent's frame; nothing if they do not
// cross.
std::optional<Number> crossing(const Body& body) {
  if (body.spherical == 1) return is_on_axis(body.p) ? std::optional<Number>(body.p[2]) : std::nullopt;
  const Vec3 origin = seen_from(body, zero_vector()), along = seen_from(body, {0, 0, 1}) - origin;
  for (const std::size_t k : {0U, 1U}) {
    if (vanishes(along[k])) continue;
    const Number height = (-origin[k] / along[k]).expand();
    if (is_on_axis(seen_from(body, {0, 0, height}))) return height;
  }
  return std::nullopt;
}

}  // namespace

Centres::Centres(Frames& frames)
    : frames_(frames),
      centre_(frames.mechanism().bodies.size(), -1),
      height_(frames.mechanism().bodies.size(), Number(0)) {
  for (int i = 0; i < frames.mechanism().body_count(); ++i) place(i);
  for (int& centre : centre_) {
    if (std::count(centre_.begin(), centre_.end(), centre) < kWorthwhile) centre = -1;
  }
}

void Centres::place(int i) {
  const Mechanism& mechanism = frames_.mechanism();
  const Body& body = body_of(mechanism, i);
  const auto k = static_cast<std::size_t>(i);
  if (body.prismatic) return;
  centre_[k] = i;
  if (body.parent >= 0 && centre_[static_cast<std::size_t>(body.parent)] >= 0) {
    const auto parent = static_cast<std::size_t>(body.parent);
    const Vec3 point = seen_from(body, {0, 0, height_[parent]});
    const bool is_fixed = body.spherical != 1 || vanishes(point[2]);  // a spherical joint turns about its point
    if (is_on_axis(point) && is_fixed) {
      centre_[k] = centre_[parent];
      height_[k] = point[2];
      return;
    }
  }
  for (int child = i + 1; child < mechanism.body_count(); ++child) {
    if (body_of(mechanism, child).parent != i || body_of(mechanism, child).prismatic) continue;
    height_[k] = crossing(body_of(mechanism, child)).value_or(0);
    return;
  }
}

Vec3 Centres::lever(int centre, int j) {
  const auto known = levers_.find({centre, j});
  if (known != levers_.end()) return known->second;
  const std::string name = "r_" + frames_.label(centre) + "_" + frames_.label(j);
  Vec3 lever;
  if (centre_of(j) == centre) {
    lever = frames_.derivation().named(Vec3{0, 0, -height_[static_cast<std::size_t>(j)]}, name);
  } else {
    const Vec3 before = this->lever(centre, body_of(frames_.mechanism(), j).parent);
    const Vec3 turned = frames_.to_child(j, frames_.derivation().named(before + frames_.p(j), name + "_o"), name);
    lever = frames_.derivation().named(turned + Vec3{0, 0, frames_.slide(j)}, name + "_s");
  }
  levers_[{centre, j}] = lever;
  return lever;
}

}  // namespace flatdyn
