// SPDX-License-Identifier: GPL-2.0-or-later
// The header with a robot's functions in another convention, over its C++ header.
#pragma once

#include <vector>

#include "code/conventions/convention.hpp"
#include "code/emit/emit_options.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// For a robot with a floating base or spherical joints. `functions`: those of the C++ code that was emitted with these
// options. Throws what check_conventions_apply() throws, and Failure(unsupported) if gravity is not a number.
ConventionHeader convention_header(const Mechanism& mechanism, const std::vector<Function>& functions,
                                   const EmitOptions& options, const Convention& convention);

}  // namespace flatdyn
