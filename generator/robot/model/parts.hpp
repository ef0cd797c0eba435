// SPDX-License-Identifier: GPL-2.0-or-later
// The parts that robots and scenes consist of: numbers, names, poses, bodies and limits, each with its place in its
// file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/number.hpp"

namespace flatdyn {

// A name that refers to a link, joint or function, and the place where it is written.
struct Reference {
  std::string name;
  Place place;
};

struct Value {
  Number number = 0;
  Place place;
};

// One elementary displacement. A Pose is a product of them, leftmost first.
struct Displacement {
  enum class Kind { translation, rotation_x, rotation_y, rotation_z };
  Kind kind = Kind::translation;
  Vec3 translation = zero_vector();  // m; only for translation
  Number angle = 0;                  // rad; only for rotations: rational, multiple of Pi, or free symbol
};

// A product of displacements, in order: URDF's origin is {translation xyz, rotation_z yaw, rotation_y pitch, rotation_x
// roll}. Empty: identity.
struct Pose {
  std::vector<Displacement> displacements;
  Place place;
};

// The inertia of a rigid body, (7.11): tensor = [ixx, ixy, ixz; ixy, iyy, iyz; ixz, iyz, izz] with the products of
// inertia as matrix entries, as URDF writes them (ixy = -∫ x y dm).
struct Inertial {
  enum class About { centre_of_mass, frame_origin };
  Value mass;                           // kg
  Pose frame;                           // the inertial frame in the link frame; axes of `tensor`
  Vec3 centre_of_mass = zero_vector();  // in the inertial frame, m (URDF: zero)
  Mat3 tensor = zero_matrix();          // kg m^2, along the axes of the inertial frame
  About about = About::centre_of_mass;  // the reference point of `tensor`; frame_origin: the inertial frame's origin
  Place place;
};

struct Limits {
  std::optional<Value> lower, upper;  // rad or m
  std::optional<Value> velocity;      // rad/s or m/s
  std::optional<Value> acceleration;  // rad/s^2 or m/s^2
  std::optional<Value> effort;        // N·m or N
};

}  // namespace flatdyn
