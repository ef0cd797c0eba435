// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters of robots with coupled joints: parameters that are independent for the tree's joints may be dependent
// at the coordinates.
#pragma once

#include "derivation/parameters/base_parameters.hpp"

namespace flatdyn {

// Reduces `base`, the base parameters of the tree, to those that are independent at the coordinates, by exact
// elimination of Aᵀ Y_b at random rational states with the robot's symbols kept. The row space, and so its reduced
// echelon form, does not depend on the states.
BaseParameters reduced_at_coordinates(const Mechanism& mechanism, const BaseParameters& base);

}  // namespace flatdyn
