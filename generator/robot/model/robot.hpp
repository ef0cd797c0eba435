// SPDX-License-Identifier: GPL-2.0-or-later
// The robot as its file describes it: links, joints, motors, in exact numbers, each with its place in the file. Nothing
// is merged, moved or simplified here; the `Mechanism` is derived from it.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/model/parts.hpp"
#include "robot/model/scene.hpp"

namespace flatdyn {

struct Link {
  std::string name;
  std::vector<Inertial> inertials;  // bodies fixed to it: none or one in URDF; payloads are added here
  Place place;
};

// The rotor of the motor that drives a joint, (7.21)-(7.30). It turns at k_r q̇ about z_m, on the link that carries it.
struct Motor {
  Value mass;                     // kg
  Value inertia_axial;            // I_m about the rotor axis, kg m^2
  Value inertia_transverse;       // about any axis perpendicular to it through the centre of mass, kg m^2
  Value gear_ratio;               // k_r = dϑ_m/dq, (7.22); rad/m for a prismatic joint
  int carrier = -1;               // index of the link that carries it; -1: the joint's parent link
  Vec3 axis = {0, 0, 1};          // z_m, in the frame of the carrier; need not be normalised
  Vec3 position = zero_vector();  // the rotor's centre of mass, in the frame of the carrier, m
  Place place;
};

// spherical: turns in all directions (robot/model/spherical_joint.hpp).
enum class JointType { fixed, revolute, continuous, prismatic, spherical };

// The type of motion of a joint that is held still, and the position where it is held.
struct Held {
  JointType type = JointType::revolute;
  Number position = 0;  // rad or m
};

// A joint whose position is offset + Σ factor · (coordinate of a joint). If it names itself, it has a coordinate of its
// own, which then differs from its position. If it does not, it has no coordinate, and where other joints name it, its
// position is meant.
struct Coupled {
  struct Term {
    Reference joint;
    Number factor;  // per rad or m of the coordinate
  };
  std::vector<Term> terms;
  Number offset = 0;  // rad or m
  Place place;
};

// How the dry friction of a joint depends on its speed, as written; what is not given is a constant F_s against the
// motion. Friction is F_s s, where s is sgn(q̇), or smooth with a speed v_0: tanh((q̇ + φ)/v_0) - tanh(φ/v_0).
struct DryFrictionLaw {
  std::optional<Value> speed;            // v_0, rad/s or m/s
  std::optional<Value> offset;           // φ, rad/s or m/s
  std::optional<Value> static_friction;  // F_st at rest, which falls to F_s: F_s + (F_st - F_s)/(1 + (q̇/v_s)²)
  std::optional<Value> stribeck_speed;   // v_s, rad/s or m/s
  std::optional<Value> backward;         // F_m for q̇ < 0; F_s is that for q̇ > 0
  std::optional<Value> load;             // c, the share of its torque that the drive loses: c |τ| s

  bool is_given() const { return speed || offset || static_friction || stribeck_speed || backward || load; }
};

// Child link frame = parent link frame · origin · motion(axis, q) · link_offset. A joint that is held keeps its motion.
// URDF and modified DH: link_offset is the identity. Standard DH: origin is the identity.
struct Joint {
  std::string name;
  JointType type = JointType::fixed;  // fixed also if the joint is held
  std::optional<Held> held;
  int parent = -1, child = -1;  // indices of links
  Pose origin;
  Vec3 axis = {0, 0, 1};  // in the joint frame; need not be normalised
  Pose link_offset;
  Value viscous;   // F_v, N·m·s/rad or N·s/m
  Value coulomb;   // F_s, N·m or N
  Value armature;  // reflected inertia added to b_ii only, kg m^2 or kg
  std::optional<Motor> motor;
  std::optional<Coupled> coupled;   // for moving joints only
  std::optional<bool> independent;  // whether URDF+ marks the joint as having a coordinate of its own
  bool driven = false;              // whether an actuator of MJCF moves it: in loops it keeps its coordinate if it can
  Limits limits;
  Place place;
  Value stiffness;                           // k of a spring at the joint, N m/rad or N/m
  Value spring_reference;                    // q_0, the joint's position where the spring exerts nothing, rad or m
  bool is_tendon = false;                    // a tendon's length (robot/model/tendon.hpp)
  std::optional<Value> current_to_torque{};  // the drive's gain, N m/A or N/A; logs may have its current
  DryFrictionLaw law{};
};

// A closed chain, cut at the joint that closes it: a point of one link coincides with a point of another, and if there
// are axes, the line through the point along the first axis coincides with the line along the second.
struct Loop {
  std::string name;  // the name of the joint that closes it; may be empty
  std::array<Reference, 2> links;
  std::array<Vec3, 2> points = {zero_vector(), zero_vector()};  // in the links' frames, m
  bool meets_at_zero = false;               // the second point is at the first one when all joints are at 0
  std::optional<std::array<Vec3, 2>> axes;  // in the links' frames, of any length
  std::vector<Reference> dependent;         // joints whose positions follow from those of the others
  bool is_marked = false;                   // the dependent joints are found from marks, Joint::independent and driven
  Place place;
};

// The loop in messages: "loop \"C\" between \"coupler\" and \"rocker\"".
std::string name_of(const Loop& loop);

struct FreeSymbol {
  GiNaC::symbol symbol;
  std::string name;
  Place place;         // the place where it first appears
  std::string unit{};  // "kg"; empty where the file does not show it (symbols in products) and for pure numbers
};

// The armature and friction at the six velocities of a floating base themselves, as MJCF gives them to a free joint.
// The armature is added to the six diagonal entries of B that belong to the velocity of the base frame's origin for an
// observer at rest, kg, and to the angular velocity in base axes, kg m^2; gravity does not act on it. Friction opposes
// the motion: viscous friction the velocity and the angular velocity, N s/m and N m s/rad, and Coulomb friction the
// turns about the base's axes alone, N m.
struct BaseJoint {
  Value armature, viscous, coulomb;
};

struct Robot;

// A number that was snapped to an exact one: an angle to a multiple of pi/12 (robot/input/common/context.hpp), or a
// value tiny compared with its neighbours to zero (robot/model/snap_dust.hpp).
struct Snap {
  enum class Kind { angle, axis, length, product_of_inertia, first_moment, gravity };
  Place place;
  std::string what;     // e.g. "joint \"shoulder\", origin, rpy"
  std::string written;  // the decimal as written
  Number exact;         // the exact value; components of axes are those of the unit vector
  Number difference;    // exact - written, in the unit of its kind (a rational, to 50 digits)
  Kind kind = Kind::angle;
  std::function<void(Robot&)> undo{};  // restores the number as it was written; none for an angle
};

const char* name_of(Snap::Kind kind);  // "product of inertia"
const char* unit_of(Snap::Kind kind);  // "kg m^2"; "1" for an axis

struct Robot {
  std::string name;
  std::string file;
  std::vector<std::string> files;  // all files that were read: this one, and a URDF that it names
  std::vector<Link> links;         // in file order
  std::vector<Joint> joints;       // in file order
  std::vector<Loop> loops;         // closed loops; those of coupled joints are part of `joints`
  // Positions of some joints near which the loops are closed; other joints are near 0.
  std::vector<JointPosition> assembly;
  int root = -1;                              // index of the root link: the base
  int tip = -1;                               // index of the link whose frame is the tip
  Pose tip_offset;                            // the tip frame in the tip link's frame
  bool has_payload = false;                   // one of the links' inertials is a payload of the file
  Vec3 gravity = {0, 0, Number(-981) / 100};  // g_0 in the base frame, m/s^2
  std::vector<FreeSymbol> symbols;            // in order of first appearance
  std::vector<Snap> snaps;
  // Angles kept as written that are multiples of pi/12 rounded to two to four digits: 1.57.
  std::vector<Snap> rounded_angles;
  Scene scene;                 // the user's choices for this robot, applied as far as they concern the robot
  bool floating_base = false;  // whether the root link moves freely
  BaseJoint base_joint;        // of a floating base
  bool in_degrees = false;     // whether angles of the file are in degrees
};

// The indices of all joints, fixed ones too, in depth-first file order. The tree must be valid.
std::vector<int> depth_first_joints(const Robot& robot);

// By link: whether a joint between the base and it moves. The tree must be valid.
std::vector<bool> moving_links(const Robot& robot);

// The indices of the moving joints in depth-first file order: the order of q. The tree must be valid.
std::vector<int> moving_joints(const Robot& robot);

// The number of bodies of a mechanism that a moving joint is, and of its entries of q̇.
inline std::size_t bodies_of(const Joint& joint) { return joint.type == JointType::spherical ? 3 : 1; }

}  // namespace flatdyn
