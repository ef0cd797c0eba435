// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/schema.hpp"

namespace flatdyn {

const char* const kUrdfRotorNames =
    "rotor_inertia motorInertia gear_ratio mechanicalReduction mechanical_reduction reduction drake:rotor_inertia "
    "drake:gear_ratio";

const Schema& urdf_schema() {
  static const SchemaNames kAnything = {"", "*"};
  static const std::string kRotor = kUrdfRotorNames;
  // A torque constant maps current to torque.
  static const char* const kIrrelevantInActuator =
      "hardwareInterface role offset state_interface command_interface motorTorqueConstant motor_torque_constant "
      "torque_constant";
  static const Schema kSchema = {
      {"robot",
       kAnything,
       {"link joint transmission gazebo mujoco ros2_control loop loop_joint coupling plugin constraint loop_constraint "
        "joint_constraint",
        "material sensor frame drake:collision_filter_group self_collision_checking"}},
      {"link",
       kAnything,
       {"inertial", "visual collision contact self_filter sensor material self_collision_checking collision_checking"}},
      {"inertial", kAnything, {"origin mass inertia"}},
      {"joint",
       kAnything,
       {"origin axis parent child limit dynamics joint_properties mimic drake:mimic actuator " + kRotor,
        "safety_controller calibration hardwareInterface sensor"}},
      {"fixed/joint", kAnything, {"origin parent child"}},
      {"transmission", kAnything, {"type joint actuator plugin " + kRotor, kIrrelevantInActuator}},
      {"actuator", kAnything, {kRotor, kIrrelevantInActuator}},
      {"transmission/joint", kAnything, {kRotor, kIrrelevantInActuator}, true},  // may be named by its text
  };
  return kSchema;
}

}  // namespace flatdyn
