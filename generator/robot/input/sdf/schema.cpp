// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/schema.hpp"

namespace flatdyn {

const Schema& sdf_schema() {
  static const Schema kSchema = {
      {"sdf", {"version"}, {"model world", "actor light"}},
      {"world",
       {"name"},
       {"model include gravity frame joint",
        "physics light scene gui plugin actor road state population audio wind magnetic_field atmosphere "
        "spherical_coordinates"}},
      {"model",
       {"name canonical_link placement_frame"},
       {"link joint frame model include pose static", "self_collide allow_auto_disable gripper enable_wind plugin"}},
      {"include", {"merge"}, {"uri name pose static placement_frame", "plugin"}},
      {"frame", {"name attached_to"}, {"pose"}},
      {"pose", {"relative_to rotation_format degrees frame"}, {}, true},
      {"link",
       {"name"},
       {"pose inertial gravity kinematic velocity_decay",
        "enable_wind self_collide must_be_base_link collision visual sensor projector audio_sink audio_source battery "
        "light particle_emitter frame plugin"}},
      {"inertial", {"auto"}, {"mass pose inertia fluid_added_mass", "density auto_inertia_params frame"}},
      {"inertia", {}, {"ixx iyy izz ixy ixz iyz"}},
      {"joint",
       {"name type"},
       {"parent child pose axis axis2 thread_pitch screw_thread_pitch drake:rotor_inertia drake:gear_ratio drake:mimic "
        "gearbox_ratio gearbox_reference_body",
        "sensor physics frame plugin"}},
      {"axis", {}, {"xyz dynamics limit mimic use_parent_model_frame", "initial_position"}},
      {"axis2", {}, {"xyz dynamics limit mimic use_parent_model_frame", "initial_position"}},
      {"xyz", {"expressed_in"}, {}, true},
      {"dynamics", {}, {"damping friction spring_reference spring_stiffness"}},
      {"limit", {}, {"lower upper velocity effort drake:acceleration", "stiffness dissipation"}},
      {"mimic", {"joint axis"}, {"multiplier offset reference"}},
  };
  return kSchema;
}

}  // namespace flatdyn
