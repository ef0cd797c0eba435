// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/model/number.hpp"

namespace flatdyn {

// sqrt(a) of a number that is not negative. Of a rational: r sqrt(2)^x sqrt(3)^y ..., a rational times roots of
// different primes. GiNaC keeps sqrt(8) and 2 sqrt(2) apart; in this form equal roots look equal, so that a
// difference of them is zero exactly. (Primes above 10^4 are not looked for; what is left goes under one root.)
Number exact_root(const Number& a);

}  // namespace flatdyn
