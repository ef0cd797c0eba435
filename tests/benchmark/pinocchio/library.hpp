// SPDX-License-Identifier: GPL-2.0-or-later
// A function of Pinocchio for the mechanism of a file.
#pragma once

namespace pinocchio_peer {

struct Called;

// It lives until the program ends.
Called* called(const char* mechanism, const char* function);

// Computes it at the inputs x, with outputs y (algorithms.hpp).
void call(Called& of, const double* x, double* y);

}  // namespace pinocchio_peer
