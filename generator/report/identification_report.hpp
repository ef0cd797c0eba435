// SPDX-License-Identifier: GPL-2.0-or-later
// What was identified, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "identify/least_squares.hpp"
#include "identify/measurement.hpp"
#include "identify/physical_parameters.hpp"

namespace flatdyn {

// All that one run found.
struct Identification {
  Measurement measurement;
  Estimate estimate;
  std::optional<Eigen::VectorXd> joint_by_joint;  // the textbook's sequential procedure, for comparison
  PhysicalParameters physical;
  std::vector<std::string> doubts;  // doubts_about() all the others
};

// What can hardly be right, and what may be the reason; a sentence each.
std::vector<std::string> doubts_about(const TorqueModel& model, const Identification& found);

std::string describe_identification(const TorqueModel& model, const Identification& found);
nlohmann::ordered_json identification_json(const TorqueModel& model, const Identification& found);

}  // namespace flatdyn
