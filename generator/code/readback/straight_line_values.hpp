// SPDX-License-Identifier: GPL-2.0-or-later
// Values of a straight line at a state, with each result rounded as compiled code rounds it without contraction.
#pragma once

#include <vector>

#include "code/readback/straight_line.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

// The sines and cosines of the positions, by joint. For other angles, those of <cmath> in double are used.
struct SinesAndCosines {
  std::vector<double> sine, cosine;
};

// The values of <cmath>, in double.
SinesAndCosines library_sines(const State& state);

// The values by operation, in double, with the sines of <cmath>.
std::vector<double> values_of(const StraightLine& lines, const State& state);

// The entries of all outputs, in order; NaN for an entry that is not written, and for all if a condition does not hold.
std::vector<double> outputs_of(const StraightLine& lines, const State& state);

// The same with the rounding of T, float or double, and with given sines.
template <class T>
std::vector<double> outputs_of(const StraightLine& lines, const State& state, const SinesAndCosines& given);

extern template std::vector<double> outputs_of<float>(const StraightLine&, const State&, const SinesAndCosines&);
extern template std::vector<double> outputs_of<double>(const StraightLine&, const State&, const SinesAndCosines&);

}  // namespace flatdyn
