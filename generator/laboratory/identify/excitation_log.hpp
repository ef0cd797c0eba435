// SPDX-License-Identifier: GPL-2.0-or-later
// The information that logs have on the parameters already, to be completed by an exciting motion.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "laboratory/identify/measurement.hpp"
#include "laboratory/identify/torque_equations.hpp"

namespace flatdyn {

struct LoggedInformation {
  // b × b: |root x|² is the sum of |Y_b x|² over all joints and samples, as if the logs had been sampled at a rate of 1
  // Hz. A log counts by its length in seconds, whatever its rate and filter are, because it and the motion are logged
  // and filtered alike.
  Eigen::MatrixXd root;
  double seconds = 0;  // length of what was used of the logs
};

// Errors go into `diagnostics`; after an error the result is meaningless. imu: StreamOptions::imu.
LoggedInformation logged_information(const TorqueModel& model, const std::vector<std::filesystem::path>& logs,
                                     const std::string& imu, Progress& progress, Diagnostics& diagnostics);

// The information of observations whose samples are `seconds` apart.
LoggedInformation information_of(const Observations& observations, double seconds);

}  // namespace flatdyn
