// SPDX-License-Identifier: GPL-2.0-or-later
// From a trajectory file, of samples (CSV) or with a plan (TOML), to Trajectory.
#pragma once

#include <filesystem>
#include <optional>

#include "laboratory/trajectory/trajectory.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Reads the file by its extension. CSV: the columns of a log (docs/csv.md), with t, q, q̇ and q̈, and h_e if the tip
// pushes. TOML: docs/trajectory-format.md; a plan is sampled at its rate, or with `intervals` intervals
// (plan_motion.hpp). Errors go into `diagnostics`; after one the result is meaningless. Throws Failure(io) for a
// missing file.
Trajectory read_trajectory(const std::filesystem::path& path, const Robot& robot, const Mechanism& mechanism,
                           Diagnostics& diagnostics, std::optional<int> intervals = std::nullopt);

// Whether the file is a plan, which can be sampled at any rate.
bool is_plan(const std::filesystem::path& path);

}  // namespace flatdyn
