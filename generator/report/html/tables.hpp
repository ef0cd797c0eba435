// SPDX-License-Identifier: GPL-2.0-or-later
// The tables of a report as data for its template.
#pragma once

#include <kainjow/mustache.hpp>
#include <optional>
#include <vector>

#include "derivation/parameters/parameter_frames.hpp"
#include "derivation/parameters/parameters.hpp"
#include "functions/load/loaded_robot.hpp"
#include "functions/planning/optimised_function.hpp"
#include "proof/certify/certificate.hpp"
#include "proof/verify/snap_effect.hpp"
#include "report/html/worst_states.hpp"

namespace flatdyn {

// Operation counts per function, with the savings of each pass.
void write_operations(kainjow::mustache::data& page, const std::vector<OptimisedFunction>& functions);

// Base parameters with their values, and the parameters that cannot be identified; names of parameters refer to
// `frames`.
void write_base(kainjow::mustache::data& page, const Mechanism& mechanism, ParameterSet set, ParameterFrames frames);

// Bounds of the torques' rounding errors, if a certificate was asked for.
void write_certificate(kainjow::mustache::data& page, const std::optional<Certificate>& certificate);

// The states with the largest rounding errors, if a search for them was given.
void write_worst_states(kainjow::mustache::data& page, const std::optional<WorstStates>& states);

// Joints with their limits, the settings of a scene, and snapped numbers.
void write_model(kainjow::mustache::data& page, const LoadedRobot& model, const SnapEffects& snap_effects);

// The findings of reading and deriving. Files are named without folders, so the page does not depend on the folder.
void write_notes(kainjow::mustache::data& page, const LoadedRobot& model, const Diagnostics& findings);

}  // namespace flatdyn
