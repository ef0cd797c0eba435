// SPDX-License-Identifier: GPL-2.0-or-later
// Interpolation and differences of samples that are not evenly apart.
#pragma once

#include <span>
#include <vector>

namespace flatdyn {

// The weights of values at these times, s, in the polynomial through them at time `at` (Lagrange). Times grow.
std::vector<double> interpolation_weights(std::span<const double> times, double at);

// The largest error of the cubic through four samples of a sine that are evenly apart, as a share of its amplitude:
// 3/128 (2π f h)⁴ in the middle. step: h, s; frequency: f, Hz.
double error_of_cubic(double step, double frequency);
// The step at which the error is that large.
double step_of_cubic(double error, double frequency);

// The weights of values at these times in a divided difference, whose order is one less than their number: zero for
// polynomials of a lower degree, and of unit norm, so that white noise keeps its standard deviation.
std::vector<double> difference_weights(std::span<const double> times);

}  // namespace flatdyn
