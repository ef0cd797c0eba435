// SPDX-License-Identifier: GPL-2.0-or-later
// The division of a function among several kernels. A thread of a graphics processor has 255 registers of 32 bits;
// values beyond them go through memory that all threads share, which soon costs more than computing values twice.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

struct KernelParts {
  std::vector<Function> functions;  // "forward_dynamics_derivatives_part_1", …; each writes some entries of the whole
  std::vector<int> counts;          // by whole function: how many of these are its parts, in order; 0: it stays whole
};

// The number of values that the registers of a thread hold; a double takes two.
int values_in_registers(bool is_double);

// Divides functions of which more values are live at once, column by column of their outputs, as far as it pays. The
// first part has the conditions of validity.
KernelParts kernel_parts(const std::vector<Function>& functions, int registers);

}  // namespace flatdyn
