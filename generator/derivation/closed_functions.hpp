// SPDX-License-Identifier: GPL-2.0-or-later
// Functions of small robots derived directly from the closed form (7.32), (7.39), (7.45), with sines of sums of
// parallel joints' angles. They are often shorter than the recursion; the cheaper of the two is emitted.
#pragma once

#include <optional>
#include <vector>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

class ClosedModel;

// The entries of the function's only output, computed from the closed form.
using ClosedEntries = std::vector<Number> (*)(ClosedModel&);

std::vector<Number> closed_inertia_matrix(ClosedModel& model);
std::vector<Number> closed_christoffel(ClosedModel& model);
std::vector<Number> closed_coriolis_matrix(ClosedModel& model);
std::vector<Number> closed_gravity(ClosedModel& model);
std::vector<Number> closed_bias(ClosedModel& model);
std::vector<Number> closed_inverse_dynamics(ClosedModel& model);
std::vector<Number> closed_kinetic_energy(ClosedModel& model);

// The same function as `recursive`, with the same name and one output with these entries. nullopt if `entries` is null,
// or if the closed form is too long to be tried: more than three joints, or more terms than a person would read.
std::optional<Function> closed_variant(const Mechanism& mechanism, const Function& recursive, ClosedEntries entries);

}  // namespace flatdyn
