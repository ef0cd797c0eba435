// SPDX-License-Identifier: GPL-2.0-or-later
// A trajectory file, of samples (CSV) or as a plan (TOML) → Trajectory.
#pragma once

#include <filesystem>

#include "model/mechanism.hpp"
#include "model/robot.hpp"
#include "trajectory/trajectory.hpp"

namespace flatdyn {

// By its extension. CSV: the columns of a log (docs/identification.md): t, q, and here also q̇ and q̈, which a trajectory
// has; h_e where the tip pushes. TOML: docs/trajectory-format.md. What is wrong goes into `diagnostics`; after an error
// the result means nothing. Throws Failure(io) for a missing file.
Trajectory read_trajectory(const std::filesystem::path& path, const Robot& robot, const Mechanism& mechanism,
                           Diagnostics& diagnostics);

}  // namespace flatdyn
