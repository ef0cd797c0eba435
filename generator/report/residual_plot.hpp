// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "report/identification_report.hpp"
#include "report/plot/plot.hpp"

namespace flatdyn {

// Per joint over time: the measured torque, and its residual with the identified parameters where the joint's rows are
// used; where it rests, friction may be anything. The observations are those of the log that they come from, or of
// another one.
std::string residual_plot(const TorqueModel& model, const Observations& observations, const Eigen::VectorXd& values,
                          PictureFormat format);

}  // namespace flatdyn
