// SPDX-License-Identifier: GPL-2.0-or-later
// Parameter directions that closed loops hide. Adding a point mass at one of the points where a loop is closed, and
// subtracting it at the other, which moves with it, changes neither energy: δ with Y δ = 0 wherever the loop is closed.
// In a loop whose joints all turn about one direction, the same holds for masses anywhere on the line through the
// points in that direction: their sum, and their first and second moments along the line, are three δ. If all joints
// are revolute, products of inertia with that direction that are perpendicular to the links' lengths add up to zero,
// too: a fourth δ. In a loop that is closed along an axis in space, the same holds for masses anywhere on that axis:
// three δ, without that of the first moments where it is not known whether the axes of the two ends point the same way.
#pragma once

#include <functional>
#include <vector>

#include "derivation/parameters/base_parameters.hpp"

namespace flatdyn {

// Removes one parameter for each δ that affects those of the model, the last possible one. `forms`: the parameters of
// the tree, including those that the model does not have, which are not `present`.
BaseParameters without_shifts(const Mechanism& mechanism, BaseParameters base, const std::vector<ParameterForm>& forms,
                              const std::vector<bool>& present, const std::function<bool(const Number&)>& is_zero);

}  // namespace flatdyn
