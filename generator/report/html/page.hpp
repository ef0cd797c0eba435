// SPDX-License-Identifier: GPL-2.0-or-later
// All of a robot on one page of HTML that needs nothing else: it moves, by the emitted functions themselves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/certificate.hpp"
#include "load/loaded_robot.hpp"
#include "planning/optimised_function.hpp"
#include "report/html/drawing.hpp"
#include "report/html/worst_states.hpp"
#include "symbolic/parameters/parameters.hpp"

namespace flatdyn {

// The functions that the page runs. The others are only counted.
const std::vector<std::string>& functions_of_page();

struct PageContent {
  const LoadedRobot& model;
  std::vector<OptimisedFunction> functions;  // those of the page among them
  Drawing drawing;
  Diagnostics findings;  // beside those of the model
  std::vector<double> snap_effects;
  ParameterSet parameters = ParameterSet::given;  // that base parameters are made of
  std::string options;                            // that shaped the page
  std::string proof;                              // a sentence: what was proven of the functions
  std::optional<Certificate> certificate{};       // of the torques
  std::optional<WorstStates> worst_states{};      // that a search has found
};

// The page's functions as JavaScript: the body of a function that returns them. With what it prints, in its order.
struct PageCode {
  std::string text;
  std::vector<OptimisedFunction> functions;
};
PageCode page_code(const PageContent& content);

// Deterministic. Every name of the robot file is escaped.
std::string report_page(const PageContent& content, const PageCode& code);

}  // namespace flatdyn
