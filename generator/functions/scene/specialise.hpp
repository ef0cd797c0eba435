// SPDX-License-Identifier: GPL-2.0-or-later
// Functions as a scene needs them: parts that it does not need are removed before the passes.
#pragma once

#include "base/diagnostics/diagnostics.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/scene.hpp"

namespace flatdyn {

// The function for q̇ = 0: terms with a velocity as a factor are gone. Its arguments stay the same. A function without
// velocities among its arguments is returned unchanged.
Function at_rest(const Function& function);

// The function without the entries that the scene does not ask for. Errors in `wanted` are reported to `diagnostics`.
Function with_outputs(const Function& function, const Mechanism& mechanism, const SceneOutputs& wanted,
                      Diagnostics& diagnostics);

// Applies both, as far as the scene asks for it.
Function specialised(const Function& function, const Mechanism& mechanism, const Scene& scene,
                     Diagnostics& diagnostics);

}  // namespace flatdyn
