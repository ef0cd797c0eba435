// SPDX-License-Identifier: GPL-2.0-or-later
// Which functions of the table have derivatives. This header is light, for those who need no more of the table.
#pragma once

#include <string>

namespace flatdyn {

// Whether vjp:FUNCTION and its siblings are functions. A name that is none at all counts as one that has them, so that
// its derivatives are asked for, and refused with their names.
bool has_derivatives(const std::string& function);

}  // namespace flatdyn
