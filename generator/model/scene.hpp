// SPDX-License-Identifier: GPL-2.0-or-later
// What a user wants of a robot in one place of use: which joints are held, gravity, payload, limits, and which results
// are needed. From a scene file (docs/scene-format.md) and from --gravity and --fix, which go before it. Where each
// part is applied: gravity, locked, payload, friction and limits when the robot is read (input/scene_application.hpp);
// at_rest and outputs to each function (scene/specialise.hpp); the error budget to the
// mechanism that functions are derived from (scene/abbreviate.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/task.hpp"
#include "model/parts.hpp"

namespace flatdyn {

// Where a joint is, or is held.
struct JointPosition {
  std::string joint;
  Number position = 0;        // rad or m, as written
  std::string written = "0";  // the text of it
  bool is_decimal = true;     // an angle near to a multiple of pi/12 is then taken for it
  Place place{};
};

struct ScenePayload {
  std::optional<Reference> link;  // the tip's if it is not given
  Inertial inertial;
};

// Limits that replace those of the robot.
struct SceneLimits {
  Reference joint;
  Limits limits;
};

// The entries that are needed of a function: "tau[0..2]", "B[shoulder][elbow]".
struct SceneOutputs {
  Reference function;
  std::vector<Reference> entries;
};

// What may be given up at each joint for fewer operations: a part of its effort limit, or N m (N for prismatic joints).
struct ErrorBudget {
  double value = 0;
  bool relative = false;  // to the joint's effort limit
  std::string written;    // "0.1%", "0.05"
};

inline constexpr const char* kErrorBudgetHint =
    "write it as \"0.1%\" of each joint's effort limit, or as \"0.05\" N m (N for prismatic joints)";

// Nothing if the text is neither a percentage from 0 to 100 nor a number from 0.
std::optional<ErrorBudget> error_budget(const std::string& text);

struct Scene {
  std::string file;  // empty if there is none
  std::optional<Vec3> gravity;
  std::vector<JointPosition> locked;  // of two for one joint the first counts
  std::optional<ScenePayload> payload;
  std::vector<SceneLimits> limits;
  bool at_rest = false;  // joint velocities are 0
  bool friction = true;  // false: none at all
  std::optional<ErrorBudget> error_budget;
  Task task;                         // of the tip; no rows: all that are independent
  std::vector<Reference> functions;  // empty: those of `outputs`; if these are none: the usual ones
  std::vector<SceneOutputs> outputs;
};

}  // namespace flatdyn
