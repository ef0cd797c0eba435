// SPDX-License-Identifier: GPL-2.0-or-later
// Momentum and centre of mass of a robot with a floating base, from the poses of its bodies and Lagrange's equations.
#pragma once

#include "truth/definition/definition.hpp"

namespace flatdyn::definitions {

extern const Definition centroidal_momentum_matrix, centroidal_bias, centre_of_mass;

}  // namespace flatdyn::definitions
