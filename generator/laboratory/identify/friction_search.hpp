// SPDX-License-Identifier: GPL-2.0-or-later
// The speeds v of friction laws that are not linear in them.
#pragma once

#include "laboratory/identify/fit_quality.hpp"
#include "laboratory/identify/torque_equations.hpp"

namespace flatdyn {

// Columns for many speeds of each joint, from where it hardly moves to its largest speed in a measurement: the values
// of FurtherParameters::dictionary.
std::vector<std::vector<double>> friction_dictionary(const TorqueEquations& equations, const Measurement& measurement);

struct FrictionSpeeds {
  std::vector<double> speeds;  // v by joint, rad/s or m/s
  // By joint: whether the log determines F_v, F_s and the law's term. It does if the speeds that fit about as well (up
  // to 9 in the cost, three standard deviations) are alike, or give about the same parameters, and if the largest of
  // the dictionary, beyond which friction may be anything, fits clearly worse (25, five of them). The term must
  // not be negative.
  std::vector<bool> are_told;
};

// The speeds with which the law fits best, together with all other parameters. `measurement` is that of equations with
// a dictionary; columns between those of the dictionary are interpolated. A joint whose friction shows no such speed
// keeps the best of the dictionary.
FrictionSpeeds friction_speeds(const TorqueEquations& equations, const Measurement& measurement);

}  // namespace flatdyn
