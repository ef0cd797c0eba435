// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// Replaces (1 / a) · b by b / a where nothing else needs 1 / a: one multiplication and one rounding less.
Function quotients(const Function& function);

}  // namespace flatdyn
