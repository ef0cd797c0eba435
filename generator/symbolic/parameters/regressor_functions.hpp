// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of the table that are linear in the dynamic parameters. Columns of Y_b and entries of π_b are those of
// base_parameters(mechanism).
#pragma once

#include "graph/function.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

Function regressor_function(const Mechanism& mechanism);
Function base_regressor_function(const Mechanism& mechanism);
Function base_parameters_function(const Mechanism& mechanism);  // π_b, from the free symbols
Function inverse_dynamics_base_function(const Mechanism& mechanism);
Function adaptive_regressor_function(const Mechanism& mechanism);

}  // namespace flatdyn
