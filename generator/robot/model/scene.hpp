// SPDX-License-Identifier: GPL-2.0-or-later
// A scene: a user's choices for one use of a robot, such as joints held still, gravity, payload, limits and the results
// needed. They come from a scene file (docs/scene-format.md) and from --gravity, --fix and --frame, which take
// precedence. Where each is applied: gravity, locked, payload, frames, friction, springs and limits when the robot is
// read (robot/input/scene_application.hpp); at_rest and outputs to each function (functions/scene/specialise.hpp); the
// error budget to the mechanism that functions are derived from (functions/scene/abbreviate.hpp).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "graph/task.hpp"
#include "robot/model/parts.hpp"

namespace flatdyn {

// The position of a joint, or the position where it is held.
struct JointPosition {
  std::string joint;
  Number position = 0;        // rad or m, as written
  std::string written = "0";  // the text as written
  bool is_decimal = true;     // then an angle near a multiple of pi/12 is snapped to it
  Place place{};
  bool in_degrees = false;  // whether the text says so: "45 deg"
};

struct ScenePayload {
  std::optional<Reference> link;  // the tip's link if it is not given
  Inertial inertial;
};

// Limits that replace those of the robot, in the unit of the scene's angles.
struct SceneLimits {
  Reference joint;
  Limits limits;
};

// The gain of a joint's drive, N m/A or N/A; it replaces the robot's.
struct SceneGain {
  Reference joint;
  Value current_to_torque;
};

// Limits of a floating base: the largest size of each component, in base axes, of its velocity (m/s, rad/s), of the
// derivatives of these (m/s^2, rad/s^2), and of the force and moment on it (N, N m); and how far a planned motion may
// bring it from where it begins, along each axis and by roll, pitch and yaw (m, rad).
struct BaseLimits {
  Limits linear, angular;
  Place place;
};

// A point of a link, or its frame's axes with it, that touches something which does not move.
struct SceneContact {
  std::string name;  // the link's, if it is not given
  Reference link;
  Vec3 position = zero_vector();     // in the link's frame, m
  bool is_surface = false;           // whether the link cannot turn, either
  std::optional<Number> friction{};  // μ; nullopt: its forces have no limit
  std::array<Number, 2> size{0, 0};  // of a surface with friction: length along x and width along y of the link, m
  bool is_against_gravity = false;   // the normal: against gravity, or the link's z
  Place place;
  int index = -1;  // of the link, once the robot is read
};

// A frame that is fixed to a link, such as a tool's, and has a name of its own, like a link.
struct SceneFrame {
  std::string name;
  Reference link;
  Vec3 xyz = zero_vector();               // its origin in the link's frame, m
  Vec3 rpy = zero_vector();               // its roll, pitch and yaw there, R = R_z R_y R_x, rad
  std::array<std::string, 3> decimals{};  // of angles that are not snapped yet: the texts that they were read from
  Place place{};
};

// The entries of a function that are needed: "tau[0..2]", "B[shoulder][elbow]".
struct SceneOutputs {
  Reference function;
  std::vector<Reference> entries;
};

// The torque error allowed at each joint in exchange for fewer operations: a fraction of its effort limit, or N m (N
// for prismatic joints).
struct ErrorBudget {
  double value = 0;
  bool relative = false;  // whether it is a fraction of the joint's effort limit
  std::string written;    // "0.1%", "0.05"
};

inline constexpr const char* kErrorBudgetHint =
    "write it as \"0.1%\" of each joint's effort limit, or as \"0.05\" N m (N for prismatic joints)";

// The budget that the text gives; nothing if it is neither a percentage from 0 to 100 nor a number from 0.
std::optional<ErrorBudget> error_budget(const std::string& text);

struct Scene {
  std::string file;  // empty if there is none
  std::optional<Vec3> gravity;
  bool degrees = false;               // whether angles of the file, in `locked` and `limits`, are in degrees
  std::vector<JointPosition> locked;  // of two entries for one joint the first counts
  std::optional<ScenePayload> payload;
  std::vector<SceneLimits> limits;
  std::vector<SceneGain> gains;
  bool at_rest = false;  // joint velocities are 0
  bool friction = true;  // false: no joint has friction
  std::optional<ErrorBudget> error_budget;
  Task task;                         // the tip's task; no rows: all that are independent
  std::vector<Reference> functions;  // empty: those of `outputs`; without outputs: the usual ones
  std::vector<SceneOutputs> outputs;
  bool springs = true;  // false: no joint has a spring
  std::optional<BaseLimits> base_limits;
  std::vector<SceneFrame> frames;
  std::vector<SceneContact> contacts;
  Rational contact_damping = 0;  // λ, as Mechanism::contact_damping
};

}  // namespace flatdyn
