// SPDX-License-Identifier: GPL-2.0-or-later
// The one comparison of exact numbers, rational or not: every check of a number against another one goes through it.
#pragma once

#include <optional>

#include "robot/model/number.hpp"

namespace flatdyn {

// -1, 0 or 1: the sign of a rational, or of an expression in pi and square roots, exactly. Nothing if there is a symbol
// in it, or a function other than a root. Throws Failure(unsupported) if so many roots are in each other that it is not
// decided whether they cancel.
std::optional<int> sign_of(const Number& a);

// All false where the sign is not known, because of a symbol.
bool is_negative(const Number& a);
bool is_positive(const Number& a);
bool is_below(const Number& a, const Number& b);

// |a|, exactly; a itself where the sign is not known.
Number absolute(const Number& a);

}  // namespace flatdyn
