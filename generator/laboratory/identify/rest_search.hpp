// SPDX-License-Identifier: GPL-2.0-or-later
// Speeds below which joints of a real robot do not follow the law of friction: there they creep, stick and slip.
#pragma once

#include <vector>

#include "laboratory/identify/measurement.hpp"
#include "laboratory/identify/torque_equations.hpp"

namespace flatdyn {

// By joint, rad/s or m/s: the rest speed with which the logs are better read again. It is a few hundredths of the
// joint's largest speed where residuals of slow rows are clearly larger than those of fast ones, else the
// measurement's. `values`: the estimate. Empty if nothing changes.
std::vector<double> better_rest_speeds(const TorqueEquations& equations, const Measurement& measurement,
                                       const Eigen::VectorXd& values);

}  // namespace flatdyn
