// SPDX-License-Identifier: GPL-2.0-or-later
// The tables of a report, as what its template is filled with.
#pragma once

#include <kainjow/mustache.hpp>
#include <optional>
#include <vector>

#include "certify/certificate.hpp"
#include "load/loaded_robot.hpp"
#include "planning/optimised_function.hpp"
#include "report/html/worst_states.hpp"
#include "symbolic/parameters/parameters.hpp"

namespace flatdyn {

// Operation counts per function, and what each pass saved of them.
void write_operations(kainjow::mustache::data& page, const std::vector<OptimisedFunction>& functions);

// Base parameters with their values, and what cannot be identified.
void write_base(kainjow::mustache::data& page, const Mechanism& mechanism, ParameterSet set);

// How large the rounding errors of the torques can be, if that was asked for.
void write_certificate(kainjow::mustache::data& page, const std::optional<Certificate>& certificate);

// Where rounding errors were largest, if a search for such states was given.
void write_worst_states(kainjow::mustache::data& page, const std::optional<WorstStates>& states);

// Joints with their limits, what a scene fixed, snapped numbers.
void write_model(kainjow::mustache::data& page, const LoadedRobot& model, const std::vector<double>& snap_effects);

// What was found while reading and deriving. Of files their names only, so that the page is the same from any folder.
void write_notes(kainjow::mustache::data& page, const LoadedRobot& model, const Diagnostics& findings);

}  // namespace flatdyn
