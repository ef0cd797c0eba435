// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/held_position.hpp"

#include "robot/input/common/units.hpp"

namespace flatdyn {

std::string held_at(const JointPosition& lock) { return "joint \"" + lock.joint + "\", held at " + lock.written; }

Units units_of(const HeldJoint& lock) {
  Units units = lock.units;
  units.degrees = units.degrees || lock.in_degrees;
  return units;
}

void check_degrees(const HeldJoint& lock, bool slides, const Spot& spot, Diagnostics& diagnostics) {
  if (!lock.in_degrees) return;
  if (slides) {
    diagnostics.error(spot.place, spot.what + ": it slides, and its positions are lengths", "write a length in m");
  } else if (has_symbols(lock.position)) {
    diagnostics.error(spot.place, spot.what + ": symbols are in rad", "leave the unit out");
  }
}

Number held_position(const HeldJoint& lock, JointType type, ReadContext& context) {
  const Spot spot{lock.place, held_at(lock)};
  const Units units = units_of(lock);
  const Quantity quantity = type == JointType::prismatic ? Quantity::length : Quantity::angle;
  context.symbols.check_quantity(lock.position, quantity, lock.place, context.diagnostics);
  check_degrees(lock, type == JointType::prismatic, spot, context.diagnostics);
  if (type == JointType::prismatic) return in_metres(lock.position, units, spot, context.diagnostics);
  if (lock.is_decimal) return decimal_angle(lock.position, lock.written, units, spot, context);
  return canonical_angle(in_radians(lock.position, units, spot, context.diagnostics), spot, context.diagnostics);
}

}  // namespace flatdyn
