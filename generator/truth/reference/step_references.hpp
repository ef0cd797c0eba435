// SPDX-License-Identifier: GPL-2.0-or-later
// Steps in time, and their derivatives, by the reference.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn::references {

extern const NumericReference semi_implicit_step, semi_implicit_step_derivatives, runge_kutta_step,
    runge_kutta_step_derivatives, midpoint_step, midpoint_step_derivatives;

}  // namespace flatdyn::references
