// SPDX-License-Identifier: GPL-2.0-or-later
// Positions of joints in CSV files: those that may be in degrees, and quaternions that are not of norm 1.
#pragma once

#include "robot/input/csv/table.hpp"

namespace flatdyn {

// Warnings of them. Angles: a question (robot/model/unit_plausibility.hpp), once for each joint that turns and whose
// column has no unit. A joint without limits counts as one that turns without end: states are not always those of a
// robot that moves. `q`: the columns, by entries of q; what is not there is passed over. Entries have to be decimals.
// Quaternions: one warning for each spherical joint, of the row whose norm is farthest from 1, if that is by more than
// 1e-6.
void warn_of_positions(const CsvTable& table, const std::vector<std::optional<CsvSource>>& q,
                       const Mechanism& mechanism, const std::string& file, Diagnostics& diagnostics);

// The same of the quaternion in four columns, w, x, y and z; `of`: "spherical joint "ball"".
void warn_of_quaternion(const CsvTable& table, const std::vector<std::optional<CsvSource>>& q, const std::string& of,
                        const std::string& file, Diagnostics& diagnostics);

}  // namespace flatdyn
