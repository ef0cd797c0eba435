// SPDX-License-Identifier: GPL-2.0-or-later
// Angles that are multiples of pi/12 to a few digits (1.57), too far from them to be taken for them without a word.
#pragma once

#include "planning/make_functions.hpp"

namespace flatdyn {

// A note that asks, if there are such angles: with --snap, which tolerance takes them for these multiples? `functions`:
// those made of the model. If inverse_dynamics is one of them, and the robot is no larger than what takes a few
// seconds, the note says how many operations that would save.
void ask_for_rounded_angles(const LoadedRobot& model, const PipelineOptions& options,
                            const std::vector<OptimisedFunction>& functions, Diagnostics& findings);

}  // namespace flatdyn
