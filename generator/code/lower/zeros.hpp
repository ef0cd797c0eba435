// SPDX-License-Identifier: GPL-2.0-or-later
// Zeros in entries that follow one another, such as those of two limbs in the inertia matrix.
#pragma once

#include "code/statement.hpp"

namespace flatdyn {

// The statements that store zeros in the places of `store`: those in entries that follow one another together, if there
// are enough of them, the others as before.
code::Statements zeros_together(code::Store store);

}  // namespace flatdyn
