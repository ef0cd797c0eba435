// SPDX-License-Identifier: GPL-2.0-or-later
// What a straight line of operations computes at a state: each result rounded, as compiled code rounds it without
// contraction.
#pragma once

#include <vector>

#include "model/states.hpp"
#include "readback/straight_line.hpp"

namespace flatdyn {

// Of the positions, by joint. Of other angles, those of <cmath> in double are taken.
struct SinesAndCosines {
  std::vector<double> sine, cosine;
};

// Those of <cmath>, in double.
SinesAndCosines library_sines(const State& state);

// By operation, in double, with the sines of <cmath>.
std::vector<double> values_of(const StraightLine& lines, const State& state);

// Entries of all outputs, in order; not-a-number where one is not written, or a condition does not hold.
std::vector<double> outputs_of(const StraightLine& lines, const State& state);

// The same as T rounds, float or double, with given sines.
template <class T>
std::vector<double> outputs_of(const StraightLine& lines, const State& state, const SinesAndCosines& given);

extern template std::vector<double> outputs_of<float>(const StraightLine&, const State&, const SinesAndCosines&);
extern template std::vector<double> outputs_of<double>(const StraightLine&, const State&, const SinesAndCosines&);

}  // namespace flatdyn
