// SPDX-License-Identifier: GPL-2.0-or-later
// Functions as kernels may compute them that read what earlier kernels of the same function have written.
#pragma once

#include <optional>

#include "functions/load/loaded_robot.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// The function with some of its outputs left out, whose entries it reads: those stored in entry k of all outputs, in
// order, are inputs of kind `stored` and index k. nullopt: there is no such form. So far there is one of
// forward_dynamics_derivatives, which reads B⁻¹.
std::optional<Function> reading_own_outputs(const LoadedRobot& model, const Function& function);

}  // namespace flatdyn
