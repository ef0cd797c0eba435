// SPDX-License-Identifier: GPL-2.0-or-later
// Angles that are multiples of pi/12 to a few digits (1.57), but too far from them to be snapped without asking.
#pragma once

#include "functions/planning/make_functions.hpp"

namespace flatdyn {

// If there are such angles, adds a note with the --snap tolerance that snaps them. `functions`: those made of the
// model. If inverse_dynamics is one of them, and the robot is small enough for a second derivation within seconds, the
// note says how many operations that would save.
void note_rounded_angles(const LoadedRobot& model, const PipelineOptions& options,
                         const std::vector<OptimisedFunction>& functions, Diagnostics& findings);

}  // namespace flatdyn
