// SPDX-License-Identifier: GPL-2.0-or-later
// The results of an identification, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "identify/least_squares.hpp"
#include "identify/measurement.hpp"
#include "identify/physical_parameters.hpp"
#include "symbolic/parameters/parameter_frames.hpp"

namespace flatdyn {

// The results of one run.
struct Identification {
  Measurement measurement;
  Estimate estimate;
  std::optional<Eigen::VectorXd> joint_by_joint;  // the textbook's sequential procedure, for comparison
  PhysicalParameters physical;
  ParameterFrames frames = ParameterFrames::file;  // those to which the names of parameters refer
  std::vector<std::string> warning_texts;          // plausibility_warnings() the other members
};

// Sentences on results that are hardly right, each with a possible reason.
std::vector<std::string> plausibility_warnings(const TorqueModel& model, const Identification& found);

std::string describe_identification(const TorqueModel& model, const Identification& found);
nlohmann::ordered_json identification_json(const TorqueModel& model, const Identification& found);

}  // namespace flatdyn
