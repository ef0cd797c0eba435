// SPDX-License-Identifier: GPL-2.0-or-later
// A measurement as a file, so that a batch system can spread logs over processes or machines: each part k of N is
// folded by itself, and the parts are joined.
#pragma once

#include <string>

#include "laboratory/identify/measurement.hpp"
#include "laboratory/identify/torque_equations.hpp"

namespace flatdyn {

// The largest number of parts; a file that names more is a mistake.
inline constexpr int kMostParts = 65536;

// The JSON text of a part. Numbers are exact: the shortest text that reads back as the same double.
std::string part_text(const Measurement& measurement, const TorqueEquations& equations, const StreamOptions& options);

// Joins all parts 1 … N of one N, given in any order. A part that is missing, given twice, of another robot or of other
// logs, made with other options or by another version of this file is an error in `diagnostics`. Throws Failure(io) for
// a file that cannot be read.
Measurement merge_parts(const std::vector<std::filesystem::path>& files, const TorqueEquations& equations,
                        Diagnostics& diagnostics);

}  // namespace flatdyn
