// SPDX-License-Identifier: GPL-2.0-or-later
// The division of a function among several kernels. A thread of a graphics processor has 255 registers of 32 bits;
// values beyond them go through memory that all threads share, which soon costs more than computing values twice. Parts
// are called in their order, so that later ones may read what earlier ones have written.
#pragma once

#include <optional>
#include <vector>

#include "code/lower/schedule.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// The entry that a part reads as the stored value of this index.
Target entry_read(const Function& part, int index);

struct KernelParts {
  std::vector<Function> functions;  // "forward_dynamics_derivatives_part_1", …; each writes some entries of the whole
  std::vector<int> counts;          // by whole function: how many of these are its parts, in order; 0: it stays whole
};

// The number of values that the registers of a thread hold; a double takes two.
int values_in_registers(bool is_double);

// By function: the same with some of its outputs left out, whose entries, in order over all outputs, it reads as inputs
// of kind `stored`; or nullopt.
using ReadingParts = std::vector<std::optional<Function>>;

// Divides functions of which more values are live at once, column by column of their outputs, as far as it pays. The
// first part has the conditions of validity. Where it costs less, the outputs that `reading` leaves out come first, and
// later parts read them.
KernelParts kernel_parts(const std::vector<Function>& functions, int registers, const ReadingParts& reading = {});

// The function that the parts compute if they are called in their order: what a part reads is what an earlier one has
// written. `whole`: the function that they are parts of. Throws Failure(bug) if a part reads what none has written yet,
// or if an entry of the whole is not written.
Function composed(const Function& whole, const std::vector<Function>& parts);

}  // namespace flatdyn
