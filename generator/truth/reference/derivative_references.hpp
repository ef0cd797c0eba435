// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of inverse and forward dynamics by the reference.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn::references {

extern const NumericReference inverse_dynamics_derivatives, forward_dynamics_derivatives;

}  // namespace flatdyn::references
