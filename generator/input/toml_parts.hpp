// SPDX-License-Identifier: GPL-2.0-or-later
// Parts of TOML robot files that stand in several tables.
#pragma once

#include <optional>

#include "input/toml_table.hpp"
#include "model/robot.hpp"

namespace flatdyn {

// mass, com, inertia, inertia_about of a [[link]] or of [payload]; nothing if none of them is there.
std::optional<Inertial> read_inertial(TomlTable& table, Diagnostics& diagnostics);

// viscous, coulomb, armature, limits, motor of a [[link]] or [[joint]]; what is not there stays as it is.
// Returns the motor's carrier, to be looked up when all links are known, if it is given.
std::optional<Reference> read_joint_properties(TomlTable& table, Joint& joint);

}  // namespace flatdyn
