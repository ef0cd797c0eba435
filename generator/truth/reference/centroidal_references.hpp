// SPDX-License-Identifier: GPL-2.0-or-later
// Momentum and centre of mass of a robot with a floating base, by the recursive reference.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn::references {

extern const NumericReference centroidal_momentum_matrix, centroidal_bias, centre_of_mass;

}  // namespace flatdyn::references
