// SPDX-License-Identifier: GPL-2.0-or-later
// One HTML page about a robot that needs no other file; the emitted functions themselves move the robot on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "derivation/parameters/parameter_frames.hpp"
#include "derivation/parameters/parameters.hpp"
#include "functions/load/loaded_robot.hpp"
#include "functions/planning/optimised_function.hpp"
#include "proof/certify/certificate.hpp"
#include "proof/verify/snap_effect.hpp"
#include "report/html/drawing.hpp"
#include "report/html/worst_states.hpp"

namespace flatdyn {

// The functions that the page runs for the robot; for all others it shows operation counts only. With a floating base
// there is no ellipsoid of manipulability, so no Jacobian; the robot moves by inverse dynamics and B.
const std::vector<std::string>& functions_of_page(const Mechanism& mechanism);

struct PageContent {
  const LoadedRobot& model;
  std::vector<OptimisedFunction> functions;  // includes the functions of the page
  Drawing drawing;
  Diagnostics findings;  // in addition to those of the model
  SnapEffects snap_effects;
  ParameterSet parameters = ParameterSet::given;   // the set from which base parameters are made
  ParameterFrames frames = ParameterFrames::file;  // the frames to which their names refer
  std::string options;                             // the options that shaped the page
  std::string proof;                               // a sentence on what was proven of the functions
  std::optional<Certificate> certificate{};        // certificate of the torques
  std::optional<WorstStates> worst_states{};       // worst states found by a search
};

// The page's functions as JavaScript, the body of a function that returns them, with the functions in their order.
struct PageCode {
  std::string text;
  std::vector<OptimisedFunction> functions;
};
PageCode page_code(const PageContent& content);

// The page as text. Deterministic. Every name of the robot file is escaped.
std::string report_page(const PageContent& content, const PageCode& code);

}  // namespace flatdyn
