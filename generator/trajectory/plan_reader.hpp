// SPDX-License-Identifier: GPL-2.0-or-later
// Trajectory files (docs/trajectory-format.md) → TrajectoryPlan.
#pragma once

#include <filesystem>

#include "model/mechanism.hpp"
#include "trajectory/plan.hpp"

namespace flatdyn {

// What is wrong goes into `diagnostics`; after an error the plan means nothing. Throws Failure(io) for a missing file.
TrajectoryPlan read_plan(const std::filesystem::path& path, const Mechanism& mechanism, Diagnostics& diagnostics);

}  // namespace flatdyn
