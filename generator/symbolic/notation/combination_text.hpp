// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters as people write them: "I1zz + k_r1^2 Im1 + a_1^2 m2".
#pragma once

#include <string>

#include "symbolic/parameters/base_parameters.hpp"

namespace flatdyn {

// A coefficient in a fixed order that does not depend on GiNaC's: "a_1^2", "(2 a_1 + a_2)"; numbers exactly: "0.425",
// "1/3".
std::string coefficient_text(const Number& coefficient);

// Base parameter k as a sum: the kept parameter first, the others in the order of π, with numbers to `digits`
// significant digits.
std::string combination_text(const BaseParameters& base, int k, int digits = 6);

}  // namespace flatdyn
