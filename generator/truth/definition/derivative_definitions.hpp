// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of inverse and forward dynamics by their definitions, over dual numbers.
#pragma once

#include "truth/definition/definition.hpp"

namespace flatdyn::definitions {

extern const Definition inverse_dynamics_derivatives, forward_dynamics_derivatives;

}  // namespace flatdyn::definitions
