// SPDX-License-Identifier: GPL-2.0-or-later
// A planned motion for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "identify/excitation.hpp"
#include "identify/excitation_log.hpp"

namespace flatdyn {

// logged: the information of the logs that the motion completes, if there are any.
std::string describe_excitation(const TorqueModel& model, const Excitation& excitation,
                                const std::optional<LoggedInformation>& logged);
nlohmann::ordered_json excitation_json(const TorqueModel& model, const Excitation& excitation,
                                       const std::optional<LoggedInformation>& logged);

// CSV with columns t, q1, …, qd1, …, qdd1, …, tau1, …, SI. Every number is the shortest text that reads back exactly.
std::string excitation_csv(const PlannedMotion& motion);
// Positions, speeds and torques against time as SVG.
std::string excitation_plot(const Mechanism& mechanism, const PlannedMotion& motion);

}  // namespace flatdyn
