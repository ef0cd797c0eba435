// SPDX-License-Identifier: GPL-2.0-or-later
// Where a robot meets what is around it: its tip, and the points and surfaces that touch something.
#pragma once

#include <string>
#include <vector>

#include "robot/model/body.hpp"
#include "robot/model/friction_cone.hpp"
#include "robot/model/scene.hpp"

namespace flatdyn {

// A point of a body, or a frame, that touches something which does not move. `frame` has the axes of the link.
struct Contact {
  std::string name;
  LinkFrame frame;
  bool is_surface = false;  // whether the body cannot turn, either
  // The conditions of friction, if the scene says any, in axes whose z is the normal: those of the link or, against
  // gravity, with x and y of the base frame mirrored to it (derivation/dynamics/friction_cones.hpp).
  std::vector<ConeRow> cone{};
  bool is_against_gravity = false;

  // The directions that it holds: velocities along x, y, z of the base frame, and for a surface rotations about them.
  int rows() const { return is_surface ? 6 : 3; }
};

// The tip and its task, and the contacts that a scene has.
struct MechanismScene {
  LinkFrame tip;  // the frame of the tip
  Task task;      // no rows: the independent rows of the tip's Jacobian
  // The contacts, and λ of the matrix J B^-1 J^T + λ² 1 that their forces are found with.
  std::vector<Contact> contacts;
  Rational contact_damping = 0;

  // The rows of all contacts' Jacobian, and those of their friction cones.
  int contact_rows() const;
  int cone_rows() const;
};

}  // namespace flatdyn
