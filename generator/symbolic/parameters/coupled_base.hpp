// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters where joints are coupled: what the tree's joints could tell apart, their coordinates may not.
#pragma once

#include "symbolic/parameters/base_parameters.hpp"

namespace flatdyn {

// Of `base`, the base parameters of the tree, those that are independent at the coordinates: exact elimination of
// Aᵀ Y_b at random rational states, the robot's symbols kept. What does not depend on the states is the row space, and
// so its reduced echelon form.
BaseParameters reduced_at_coordinates(const Mechanism& mechanism, const BaseParameters& base);

}  // namespace flatdyn
