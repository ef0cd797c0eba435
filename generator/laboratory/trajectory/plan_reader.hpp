// SPDX-License-Identifier: GPL-2.0-or-later
// From trajectory files (docs/trajectory-format.md) to TrajectoryPlan.
#pragma once

#include <filesystem>

#include "laboratory/trajectory/plan.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Errors go into `diagnostics`; after one the plan is meaningless. Throws Failure(io) for a missing file.
TrajectoryPlan read_plan(const std::filesystem::path& path, const Mechanism& mechanism, Diagnostics& diagnostics);

}  // namespace flatdyn
