// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "robot/model/number.hpp"

namespace flatdyn {

// An expression as robot files have it, "l_2 - a_2", "2*pi*a^2": terms and factors by their texts, those with a minus
// last. GiNaC prints them by the addresses of its symbols.
std::string ordered_text(const Number& expression);

}  // namespace flatdyn
