// SPDX-License-Identifier: GPL-2.0-or-later
// Statistics of measurements.
#pragma once

#include <vector>

namespace flatdyn {

struct Quartiles {
  double low = 0, median = 0, high = 0;
};

// The quartiles of at least one number.
Quartiles quartiles(std::vector<double> numbers);

// Two quantities of a row, both better if smaller.
struct Cost {
  double time = 0, error = 0;
};

// The Pareto front: true for costs that no other one beats in one quantity without being worse in the other.
std::vector<bool> pareto_front(const std::vector<Cost>& costs);

// The slope of log y over log x by least squares, from at least two different x > 0, with y > 0.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace flatdyn
