// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// s² = 1 - c² or c² = 1 - s² where both squares of an angle stand in one sum, with the same cofactor or not:
// a·c² + b·s² = b + (a - b)·c². What that opens for sharing decides which squares stay.
Function trigonometric(const Function& function);

}  // namespace flatdyn
