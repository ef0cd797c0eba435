// SPDX-License-Identifier: GPL-2.0-or-later
// How well a motion tells parameters, in words.
#pragma once

#include <string>

#include "laboratory/identify/least_squares.hpp"
#include "laboratory/identify/torque_equations.hpp"

namespace flatdyn {

// Directions that the motion does not tell, and those that noise hides; empty if there are none. lacks_base_force:
// whether no log has the force on a floating base.
std::string untold_text(const TorqueEquations& equations, const Estimate& estimate, bool lacks_base_force);

// The condition number, and the singular values of the weighted rows.
std::string conditioning_text(const Estimate& estimate);

}  // namespace flatdyn
