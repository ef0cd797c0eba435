// SPDX-License-Identifier: GPL-2.0-or-later
// Functions as a scene needs them: what it does not need is taken out before the passes.
#pragma once

#include "diagnostics/diagnostics.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/scene.hpp"

namespace flatdyn {

// The function where q̇ = 0: what is multiplied by a velocity is gone. Its arguments stay as they are.
// A function that has no velocities among them stays as it is.
Function at_rest(const Function& function);

// The function without entries that nobody asks for. What is wrong with `wanted` goes to `diagnostics`.
Function with_outputs(const Function& function, const Mechanism& mechanism, const SceneOutputs& wanted,
                      Diagnostics& diagnostics);

// Both, as far as the scene says so.
Function specialised(const Function& function, const Mechanism& mechanism, const Scene& scene,
                     Diagnostics& diagnostics);

}  // namespace flatdyn
