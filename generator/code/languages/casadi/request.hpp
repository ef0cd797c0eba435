// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that CasADi's form of a set of functions is made from.
#pragma once

#include <string>
#include <vector>

#include "code/languages/common/language_row.hpp"

namespace flatdyn {

// A function that is asked for without any of its derivatives has all that CasADi uses for exact first and second
// derivatives: jac:f, vjp:f, and hessian:f with jac:f. If derivatives of it are named, it has these. If no function is
// asked for, they are inverse and forward dynamics and forward kinematics. Derivatives by the entries of q are not
// there with closed loops or spherical joints: they are left out, which the note says, or refused if they are named.
FunctionsNeeded functions_for_casadi(const Mechanism& mechanism, const std::vector<std::string>& asked);

}  // namespace flatdyn
