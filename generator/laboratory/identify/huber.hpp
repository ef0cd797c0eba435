// SPDX-License-Identifier: GPL-2.0-or-later
// Robust weights (Huber, Annals of Mathematical Statistics 35, 1964): a residual counts in full up to 1.345 standard
// deviations, and beyond that by its size instead of its square. Of normal noise 5 % of the efficiency are lost.
#pragma once

#include <Eigen/Core>

#include "laboratory/identify/measurement.hpp"

namespace flatdyn {

// The weights of rows for parameters that a fit with the present ones has found. The standard deviation of each
// equation is that of normal noise with the residuals' median, which outliers hardly change.
RowWeight huber_weights(const EquationModel& equations, const Measurement& measurement, const Eigen::VectorXd& values);

}  // namespace flatdyn
