// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/schema.hpp"

namespace flatdyn {

namespace {

const std::string kPose = "pos quat axisangle xyaxes zaxis euler ";

const SchemaNames kInBody = {"inertial joint freejoint geom body frame replicate attach site",
                             "camera light composite flexcomp plugin"};

const SchemaNames kAnything = {"", "*"};

const std::string kOfEveryEquality = "name class active ", kUnreadOfEquality = "solref solimp";

const SchemaNames kOfTendon = {
    "name class limited actuatorfrclimited range actuatorfrcrange frictionloss springlength stiffness damping armature",
    "group margin solreflimit solimplimit solreffriction solimpfriction width material rgba user"};

const SchemaNames kOfActuator = {
    "name class ctrlrange ctrllimited forcelimited forcerange gear damping armature joint tendon slidersite cranksite "
    "jointinparent site refsite body dyntype gaintype biastype range",
    "group nsample interp delay user actlimited actrange lengthrange cranklength actdim input velrange ffrange "
    "posrange dynprm gainprm biasprm actearly kp kv dampratio timeconst ki imax slewmax inheritrange area diameter "
    "bias tausmooth force scale lmin lmax vmax fpmax fvmax gain motorconst resistance nominal saturation inductance "
    "cogging controller thermal lugre plugin instance"};

}  // namespace

const Schema& mjcf_schema() {
  static const Schema kSchema = {
      {"mujoco",
       {"model"},
       {"compiler option default asset worldbody deformable equality tendon actuator keyframe",
        "size visual statistic extension custom contact sensor"}},
      {"compiler",
       {"autolimits boundmass boundinertia settotalmass balanceinertia strippath coordinate angle eulerseq meshdir "
        "inertiafromgeom inertiagrouprange assetdir alignfree exactmeshinertia",
        "fitaabb texturedir discardvisual usethread fusestatic saveinertial conflict convexhull"},
       {"", "lengthrange"}},
      {"worldbody", {kPose + "name childclass"}, kInBody},
      {"body", {kPose + "name childclass mocap gravcomp", "sleep simple fuse user"}, kInBody},
      {"frame", {kPose + "name childclass"}, kInBody},
      {"replicate", {"count offset euler sep childclass"}, kInBody},
      {"attach", {"model body frame prefix"}},
      {"inertial", {kPose + "mass diaginertia fullinertia"}},
      {"joint",
       {"name class type pos axis springdamper limited actuatorfrclimited stiffness range ref springref "
        "actuatorfrcrange armature damping frictionloss",
        "group solreflimit solimplimit solreffriction solimpfriction margin actuatorgravcomp user"},
       kAnything},
      {"freejoint", {"name align", "group"}},
      {"geom",
       {kPose + "name class type group size mass density shellinertia fromto mesh",
        "contype conaffinity condim priority material friction solmix solref solimp margin gap surfacevel adhesion "
        "hfield fitscale rgba fluidshape fluidcoef user"},
       {"", "plugin"}},
      {"keyframe", {}, {"key"}},
      {"key", {"name qpos", "time qvel act mpos mquat ctrl"}},
      {"actuator",
       {},
       {"general motor position velocity intvelocity orientation pid damper cylinder muscle adhesion dcmotor plugin"}},
      {"actuator/*", kOfActuator, kAnything},
      {"equality", {}, {"connect weld joint tendon flex flexvert flexstrain distance"}},
      {"equality/connect", {kOfEveryEquality + "body1 body2 anchor site1 site2", kUnreadOfEquality}},
      {"equality/weld",
       {kOfEveryEquality + "body1 body2 relpose anchor site1 site2", kUnreadOfEquality + " torquescale"}},
      {"equality/joint", {kOfEveryEquality + "joint1 joint2 polycoef", kUnreadOfEquality}},
      {"equality/tendon", {kOfEveryEquality + "tendon1 tendon2 polycoef", kUnreadOfEquality}},
      {"equality/*", kAnything, kAnything},
      {"tendon", {}, {"spatial fixed"}},
      {"tendon/fixed", kOfTendon, {"joint"}},
      {"tendon/spatial", kOfTendon, {"site geom pulley"}},
      {"fixed/*", kAnything, kAnything},
      {"spatial/*", kAnything, kAnything},
      {"deformable", {}, {"flex", "skin"}},
  };
  return kSchema;
}

}  // namespace flatdyn
