// SPDX-License-Identifier: GPL-2.0-or-later
// Steps in time, and their derivatives, by their formulas with the accelerations of Lagrange's equations.
#pragma once

#include "truth/definition/definition.hpp"

namespace flatdyn::definitions {

extern const Definition semi_implicit_step, semi_implicit_step_derivatives, runge_kutta_step,
    runge_kutta_step_derivatives, midpoint_step, midpoint_step_derivatives;

}  // namespace flatdyn::definitions
