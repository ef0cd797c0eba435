// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// Replaces s² by 1 - c², or c² by 1 - s², where both squares of an angle occur in one sum, with the same cofactor or
// not: a·c² + b·s² = b + (a - b)·c². The squares kept are those that leave more to share.
Function trigonometric(const Function& function);

}  // namespace flatdyn
