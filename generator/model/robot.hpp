// SPDX-License-Identifier: GPL-2.0-or-later
// The robot as its file says it: links, joints, motors, in exact numbers, each with its place in the file.
// Nothing is merged, moved or simplified here; `Mechanism` is what is derived from it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "model/number.hpp"

namespace flatdyn {

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

// Product of displacements, in order: URDF's origin is {translation xyz, rotation_z yaw, rotation_y pitch,
// rotation_x roll}. Empty: identity.
struct Pose {
  std::vector<Displacement> displacements;
  Place place;
};

// Inertia of a rigid body, (7.11): tensor = [ixx, ixy, ixz; ixy, iyy, iyz; ixz, iyz, izz] with the products of
// inertia as matrix entries, as URDF writes them (ixy = -∫ x y dm).
struct Inertial {
  enum class About { centre_of_mass, frame_origin };
  Value mass;                           // kg
  Pose frame;                           // of the inertial frame in the link frame; axes of `tensor`
  Vec3 centre_of_mass = zero_vector();  // in the inertial frame, m (URDF: zero)
  Mat3 tensor = zero_matrix();          // kg m^2, along the axes of the inertial frame
  About about = About::centre_of_mass;  // the point it is about; frame_origin: the inertial frame's origin
  Place place;
};

struct Link {
  std::string name;
  std::vector<Inertial> inertials;  // bodies fixed to it: none or one in URDF; payloads are added here
  Place place;
};

// The rotor of the motor that drives a joint, (7.21)-(7.30). It turns at k_r q̇ about z_m, on the link that carries it.
struct Motor {
  Value mass;                     // kg
  Value inertia_axial;            // I_m about the rotor axis, kg m^2
  Value inertia_transverse;       // about any axis across it through the centre of mass, kg m^2
  Value gear_ratio;               // k_r = dϑ_m/dq, (7.22); rad/m for a prismatic joint
  int carrier = -1;               // index of the link that carries it; -1: the joint's parent link
  Vec3 axis = {0, 0, 1};          // z_m, in the frame of the carrier; need not be normalised
  Vec3 position = zero_vector();  // of the rotor's centre of mass, in the frame of the carrier, m
  Place place;
};

struct Limits {
  std::optional<Value> lower, upper;  // rad or m
  std::optional<Value> velocity;      // rad/s or m/s
  std::optional<Value> acceleration;  // rad/s^2 or m/s^2
  std::optional<Value> effort;        // N·m or N
};

enum class JointType { fixed, revolute, continuous, prismatic };

// Child link frame = parent link frame · origin · motion(axis, q) · link_offset.
// URDF and modified DH: link_offset is the identity. Standard DH: origin is the identity.
struct Joint {
  std::string name;
  JointType type = JointType::fixed;
  int parent = -1, child = -1;  // indices of links
  Pose origin;
  Vec3 axis = {0, 0, 1};  // in the joint frame; need not be normalised
  Pose link_offset;
  Value viscous;   // F_v, N·m·s/rad or N·s/m
  Value coulomb;   // F_s, N·m or N
  Value armature;  // reflected inertia added to b_ii only, kg m^2 or kg
  std::optional<Motor> motor;
  Limits limits;
  Place place;
};

struct FreeSymbol {
  GiNaC::symbol symbol;
  std::string name;
  Place place;  // where it first appears
};

// An angle of the file that was taken for a multiple of pi/12.
struct Snap {
  Place place;
  std::string what;     // e.g. "joint \"shoulder\", origin rpy"
  std::string written;  // the decimal as written
  Number exact;         // the multiple of Pi it became
  Number difference;    // exact - written, rad (as a rational, to 50 digits)
};

struct Robot {
  std::string name;
  std::string file;
  std::vector<std::string> files;             // all that were read: this one, and a URDF that it names
  std::vector<Link> links;                    // in file order
  std::vector<Joint> joints;                  // in file order
  int root = -1;                              // index of the root link; it is the fixed base
  int tip = -1;                               // index of the link whose frame is the tip
  Pose tip_offset;                            // of the tip frame in the tip link's frame
  bool has_payload = false;                   // one of the links' inertials is a payload of the file
  Vec3 gravity = {0, 0, Number(-981) / 100};  // g_0 in the base frame, m/s^2
  std::vector<FreeSymbol> symbols;            // in order of first appearance
  std::vector<Snap> snaps;
};

// Indices of all joints, fixed ones too, in depth-first file order. Defined for a valid tree.
std::vector<int> depth_first_joints(const Robot& robot);

// Indices of the moving joints in depth-first file order: the order of q. Defined for a valid tree.
std::vector<int> moving_joints(const Robot& robot);

}  // namespace flatdyn
