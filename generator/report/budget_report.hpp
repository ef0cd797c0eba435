// SPDX-License-Identifier: GPL-2.0-or-later
// What an error budget bought, and what was given up for it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "pipeline.hpp"

namespace flatdyn {

// A sentence for the header: "Left out for an error budget: I3xy, m7lx. Within the limits this changes …".
std::string abbreviation_fact(const Abbreviation& abbreviation);

// Largest change of each joint's torque that was seen at random states within the limits, half of them at the largest
// speeds and accelerations; and a table of it beside the proven bound.
struct GivenUp {
  int states = 0;
  std::vector<double> largest;  // by joint, N m or N
};
GivenUp sampled(const Model& model);

std::string describe_abbreviation(const Model& model, const GivenUp& seen);
nlohmann::ordered_json abbreviation_json(const Model& model, const GivenUp& seen);

}  // namespace flatdyn
