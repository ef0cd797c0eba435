// SPDX-License-Identifier: GPL-2.0-or-later
// The speeds v of friction laws that are not linear in them.
#pragma once

#include "identify/fit_quality.hpp"
#include "identify/torque_equations.hpp"

namespace flatdyn {

// Columns for many speeds of each joint, from where it hardly moves to its largest speed in a measurement: the values
// of FurtherParameters::dictionary.
std::vector<std::vector<double>> friction_dictionary(const TorqueEquations& equations, const Measurement& measurement);

// By joint: the speed with which the law fits best, together with all other parameters. `measurement` is that of
// equations with a dictionary. Columns between those of the dictionary are interpolated; Ceres finds the speeds
// (Levenberg and Marquardt). A joint whose friction shows no such speed keeps the best of the dictionary.
std::vector<double> friction_speeds(const TorqueEquations& equations, const Measurement& measurement);

}  // namespace flatdyn
