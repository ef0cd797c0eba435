// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of a function, and their products with vectors, from its graph: what every operation does to a rate of
// change, or to a weight, is written beside it (Griewank and Walther, Evaluating Derivatives, 2nd edition, chapters 2
// and 3).
//
// Derivatives of signs are zero: Coulomb friction counts as constant.
#pragma once

#include <string>
#include <vector>

#include "derivation/differentiation/tangents.hpp"

namespace flatdyn {

// J d, the rate of change of every entry of the outputs while the arguments change at the rates d, in forward mode. Its
// outputs have the shapes of the function's own; its last argument is the direction d.
Function jacobian_times_vector(const Function& function, const Tangents& tangents);

// wᵀ J, the derivatives of Σ w_k y_k over all entries y of the outputs, in reverse mode: an output for each argument.
// Its last argument, the weights w, has the entries of one output after the other.
Function vector_times_jacobian(const Function& function, const Tangents& tangents);

// J as matrices, one for each output and each argument: a row for each entry of the output, a column for each direction
// of the argument; of a scalar output its gradient. In forward or in reverse mode, whichever costs less.
Function jacobian_matrices(const Function& function, const Tangents& tangents);

// The derivatives of wᵀ J, as matrices, one for each pair of arguments, those that are zero left out: in row k and
// column l the rate of the derivative by direction k of the one along direction l of the other. Those of an argument by
// itself are symmetric unless directions are turns.
Function contracted_hessian(const Function& function, const Tangents& tangents);

}  // namespace flatdyn
