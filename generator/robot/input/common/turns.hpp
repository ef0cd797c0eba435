// SPDX-License-Identifier: GPL-2.0-or-later
// Turns that a robot file gives by axes, quaternions and directions, as displacements. Where such a turn is a multiple
// of pi/12 about an axis of coordinates it is exact, else its angles have 80 digits.
#pragma once

#include "robot/input/common/context.hpp"

namespace flatdyn {

// Orthogonal vectors along the turned axes x and y, of any length.
struct TurnedAxes {
  Vec3 x, y;
};

// By a quaternion with the real part w, of any length but 0.
TurnedAxes turned_axes(const Number& w, const Vec3& v);

// Rz(yaw) Ry(pitch) Rx(roll). spot, written: where the file gives it.
std::vector<Displacement> displacements_of(const TurnedAxes& axes, const Spot& spot, const std::string& written,
                                           ReadContext& context);

Displacement translation(const Vec3& by);

// The turn by an angle, rad, about an axis that is not zero.
std::vector<Displacement> turn_about(const Vec3& axis, const Number& angle, const Spot& spot,
                                     const std::string& written, ReadContext& context);

// The turn by the smallest angle that takes z to a direction that is not zero.
std::vector<Displacement> turn_from_z(const Vec3& direction, const Spot& spot, const std::string& written,
                                      ReadContext& context);

}  // namespace flatdyn
