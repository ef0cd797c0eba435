// SPDX-License-Identifier: GPL-2.0-or-later
// What closed loops hide of the parameters. A point mass at one of the points where a loop is closed, and as much less
// at the other, which moves with it, change neither energy: δ with Y δ = 0 wherever the loop is closed. In a loop whose
// joints all turn about one direction, masses anywhere on the line through the points in that direction do so: their
// sum, and their first and second moments along the line, three δ. If they all turn, products of inertia with that
// direction that are perpendicular to the links' lengths add up to nothing, too: a fourth δ. In a loop that is closed
// along an axis in space, masses anywhere on that axis do so: three δ, of which the first moments' is left out where it
// is not known whether the two ends' axes point the same way.
#pragma once

#include <functional>
#include <vector>

#include "symbolic/base_parameters.hpp"

namespace flatdyn {

// With one parameter less for each δ that has a part in those of the model, the last that it may be.
// `forms`: the parameters of the tree, those that the model does not have included, which are those that are not
// `present`.
BaseParameters without_shifts(const Mechanism& mechanism, BaseParameters base, const std::vector<ParameterForm>& forms,
                              const std::vector<bool>& present, const std::function<bool(const Number&)>& is_zero);

}  // namespace flatdyn
