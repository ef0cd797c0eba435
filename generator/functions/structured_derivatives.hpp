// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of inverse and forward dynamics that use their structure, and cost less than derivatives of their graphs.
// Those by free symbols are not among them.
#pragma once

#include <optional>

#include "derivation/kernel/choices.hpp"
#include "functions/formulation.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Whether the Jacobian is that of a step by its state, with a column by the step's length.
bool has_state_derivatives(const Mechanism& mechanism, const FunctionRow& row);
// It, from a formulation of A and B; nullopt: there is no such formulation.
std::optional<Function> jacobian_of_step(const Mechanism& mechanism, const FunctionRow& row, FormulationIndex way,
                                         const Choices& choices);

// Whether the Jacobian is there in parts (FunctionRow::jacobian_parts).
bool has_jacobian_parts(const Mechanism& mechanism, const FunctionRow& row);

// The matrices of jac:FUNCTION from their parts, the first of which is derived in formulation `way`; nullopt if it has
// none such.
std::optional<Function> jacobian_of_parts(const Mechanism& mechanism, const FunctionRow& row, FormulationIndex way,
                                          const Choices& choices);

// Whether the Jacobian is that of a motion while contacts hold (FunctionRow::held_motion).
bool is_held(const Mechanism& mechanism, const FunctionRow& row);

// Its matrices.
Function held_jacobian(const Mechanism& mechanism, const FunctionRow& row, const Choices& choices);

// Whether a weighted sum is differentiated as that of an implicit function (FunctionRow::implicit).
bool is_implicit(const Mechanism& mechanism, const FunctionRow& row, Derivative derivative);

// wᵀ J or the contracted Hessian, with the solution in formulation `way`; nullopt if it has none such.
std::optional<Function> implicit_derivative(const Mechanism& mechanism, const FunctionRow& row, Derivative derivative,
                                            FormulationIndex way, const Choices& choices);

}  // namespace flatdyn
