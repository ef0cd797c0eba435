// SPDX-License-Identifier: GPL-2.0-or-later
// A planned motion for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "derivation/parameters/parameter_frames.hpp"
#include "laboratory/identify/excitation.hpp"
#include "laboratory/identify/excitation_log.hpp"

namespace flatdyn {

// logged: the information of the logs that the motion completes, if there are any. Names of parameters refer to
// `frames`.
std::string describe_excitation(const MotionEquations& equations, const Excitation& excitation,
                                const std::optional<LoggedInformation>& logged, ParameterFrames frames);
nlohmann::ordered_json excitation_json(const MotionEquations& equations, const Excitation& excitation,
                                       const std::optional<LoggedInformation>& logged, ParameterFrames frames);

// CSV with columns t, q1, …, qd1, …, qdd1, …, tau1, …, SI. Every number is the shortest text that reads back exactly.
// The pose of a floating base comes before q; its twist, the derivative of that and the force on it come before those
// of the joints, as in docs/csv.md.
std::string excitation_csv(const MotionEquations& equations, const PlannedMotion& motion);
// Positions, speeds and torques against time as SVG, and those of a floating base.
std::string excitation_plot(const MotionEquations& equations, const PlannedMotion& motion);

}  // namespace flatdyn
