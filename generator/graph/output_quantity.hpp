// SPDX-License-Identifier: GPL-2.0-or-later
// The physical quantity of a function's output, from which the unit of each entry follows (functions/units.hpp).
#pragma once

namespace flatdyn {

enum class OutputQuantity {
  none,                       // not said: outputs that only flatdyn itself uses
  number,                     // without a unit
  position,                   // of a point
  joint_position,             // an angle, or a distance for prismatic joints
  joint_rate,                 // its derivative by time
  joint_acceleration,         // and the second one
  joint_torque,               // a force for prismatic joints
  joint_momentum,             // a torque times seconds
  joint_momentum_rate,        // a torque that is none: what changes momenta, or is left of an equation
  joint_inertia,              // entries of B
  christoffel_symbol,         // c_ijk
  energy,                     // of the whole robot
  torque_per_position,        // a joint torque by a joint position
  torque_per_rate,            // a joint torque by a joint rate
  acceleration_per_position,  // a joint acceleration by a joint position
  acceleration_per_rate,      // a joint acceleration by a joint rate
  acceleration_per_torque,    // a joint acceleration by a joint torque
  tip_jacobian,               // rows of the tip's twist, linear ones first, by joint rates
  frame_velocity,             // linear components first
  frame_acceleration,         // linear components first
  tip_acceleration,           // while joints do not accelerate, linear components first
  task_inertia,               // of the task's directions
  task_force,                 // along the task's directions, a moment where they turn
  joint_rate_per_task,        // a joint rate by a velocity along the task's directions
  loop_gap,                   // between points that meet where a loop is closed; cosines where axes do
  loop_gap_per_position,      // its derivative by a joint position
  parameter,                  // an inertial or friction parameter, or a sum of them
  torque_per_parameter,       // a column per parameter
  momentum_per_rate,          // a momentum, then a moment of momentum, by joint rates
  force_and_moment,           // three entries of each
  contact_jacobian,           // rows of the contacts' velocities and rotations, by joint rates
  contact_acceleration,       // of the contacts: linear, and angular where they are surfaces
  contact_force,              // on the robot: forces, and moments where contacts are surfaces
  contact_impulse,            // these, times seconds
  derivative,                 // of entries of an output by those of arguments, perhaps weighted
};

}  // namespace flatdyn
