// SPDX-License-Identifier: GPL-2.0-or-later
// The Graph's exact constants.
#pragma once

#include <boost/multiprecision/gmp.hpp>

namespace flatdyn {

using Rational = boost::multiprecision::mpq_rational;

}  // namespace flatdyn
