// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/equivalents.hpp"

#include <algorithm>

namespace flatdyn {
namespace {

void scale(InertialParameters& body, const Number& unit) {
  body.mass = (body.mass * unit * unit).expand();
  body.first_moment = expanded(unit * body.first_moment);
}

}  // namespace

Mechanism with_frame_shifted(const Mechanism& mechanism, int i, const Number& axial_shift) {
  Mechanism result = mechanism;
  Body& body = result.bodies[static_cast<std::size_t>(i)];
  if (body.prismatic) throw Failure(FailureKind::bug, "the frame of a prismatic joint cannot be raised");
  const Vec3 up = {0, 0, axial_shift};
  body.p = expanded(body.p + constant_rotation(body) * up);
  const auto lower = [&up](Vec3& point) { point = expanded(point - up); };
  body.inertia = transformed(body.inertia, identity_matrix(), Number(-1) * up);
  for (Body& other : result.bodies) {
    if (other.parent == i) lower(other.p);
  }
  for (LinkFrame& link : result.links) {
    if (link.body == i) lower(link.p);
  }
  if (result.tip.body == i) lower(result.tip.p);
  for (Contact& contact : result.contacts) {
    if (contact.frame.body == i) lower(contact.frame.p);
  }
  for (LoopClosure& loop : result.loops) {
    for (LoopClosure::End& end : loop.ends) {
      if (end.body == i) lower(end.p);
    }
  }
  return result;
}

Mechanism in_length_unit(const Mechanism& mechanism, const Number& unit) {
  Mechanism result = mechanism;
  result.gravity = expanded(1 / unit * mechanism.gravity);
  scale(result.base, unit);
  for (Body& body : result.bodies) {
    body.p = expanded(1 / unit * body.p);
    scale(body.inertia, unit);
  }
  for (LoopClosure& loop : result.loops) {
    for (LoopClosure::End& end : loop.ends) end.p = expanded(1 / unit * end.p);
  }
  return result;
}

}  // namespace flatdyn
