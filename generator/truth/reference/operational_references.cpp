// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/operational_references.hpp"

#include "truth/reference/operational_values.hpp"
#include "truth/reference/reference_point.hpp"

namespace flatdyn::references {
namespace {

using At = ReferencePoint<double>;

OperationalMagnitude magnitude_at(const At& at) { return {at.robot, at.q, at.task}; }

template <class S>
std::vector<S> null_space_entries(const ReferencePoint<S>& at) {
  return row_by_row(reference::null_space_torque(at.robot, at.q, at.tau, reference_task<S>(at.task)));
}

}  // namespace

constinit const NumericReference operational_inertia =
    computed_by([](const auto& at) { return operational_inertia_entries(at.robot, at.q, at.task); },
                [](const At& at) { return magnitude_at(at).inertia(); });

constinit const NumericReference operational_bias =
    computed_by([](const auto& at) { return operational_bias_entries(at.robot, at.q, at.qd, at.task); },
                [](const At& at) { return magnitude_at(at).bias(at.qd); });

constinit const NumericReference null_space_torque =
    computed_by([](const auto& at) { return null_space_entries(at); },
                [](const At& at) { return magnitude_at(at).null_space(at.tau); });

}  // namespace flatdyn::references
