// SPDX-License-Identifier: GPL-2.0-or-later
// The names of velocities, accelerations, forces and quaternions in formulas of robots with a floating base or
// spherical joints, and what they mean.
#pragma once

#include <string>
#include <vector>

#include "derivation/notation/sum_formatter.hpp"

namespace flatdyn {

// The names of one entry of q̇ (or v), q̈ (or a) and τ: "omega_x", "domega_x", "n_x" of a floating base, "omega_2x",
// "domega_2x", "tau_2x" of a spherical joint, "qd_1", "qdd_1", "tau_1" of another one.
struct EntryNames {
  std::string velocity, acceleration, torque;
};

// Those of all entries, in the notation of the formatter.
std::vector<EntryNames> entry_names(const Mechanism& mechanism, const SumFormatter& formatter);

// "g_x", "g_y", "g_z": gravity in the axes of a floating base. A letter is doubled, "gg_x", where the robot has a free
// symbol of such a name; so are those of all other names here.
std::vector<std::string> base_gravity_names(const Mechanism& mechanism);

// "w_2", "x_2", "y_2", "z_2" of each spherical joint, in order.
std::vector<std::string> quaternion_names(const Mechanism& mechanism);

// Lines that say frames, order and units of all names, in text notation. Only with quasi-velocities.
std::vector<std::string> motion_conventions(const Mechanism& mechanism, const std::vector<EntryNames>& names);

}  // namespace flatdyn
