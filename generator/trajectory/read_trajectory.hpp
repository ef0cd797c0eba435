// SPDX-License-Identifier: GPL-2.0-or-later
// A trajectory file, of samples (CSV) or as a plan (TOML) → Trajectory.
#pragma once

#include <filesystem>
#include <optional>

#include "model/mechanism.hpp"
#include "model/robot.hpp"
#include "trajectory/trajectory.hpp"

namespace flatdyn {

// By its extension. CSV: the columns of a log (docs/csv.md): t, q, and here also q̇ and q̈, which a trajectory
// has; h_e where the tip pushes. TOML: docs/trajectory-format.md. What is wrong goes into `diagnostics`; after an error
// the result means nothing. A plan is sampled at its rate, or with so many intervals (plan_motion.hpp). Throws
// Failure(io) for a missing file.
Trajectory read_trajectory(const std::filesystem::path& path, const Robot& robot, const Mechanism& mechanism,
                           Diagnostics& diagnostics, std::optional<int> intervals = std::nullopt);

// Whether the file is a plan, which can be sampled at will.
bool is_plan(const std::filesystem::path& path);

}  // namespace flatdyn
