// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/inertial_torque_reference.hpp"

#include "truth/reference/magnitude.hpp"
#include "truth/reference/reference_point.hpp"

namespace flatdyn::references {
namespace {

template <class S>
std::vector<S> inertial_torques(const ReferencePoint<S>& at) {
  return row_by_row(reference::VectorX<S>(reference::inertia_matrix(at.robot, at.q) * at.qdd));
}

std::vector<double> sizes_of_terms(const ReferencePoint<double>& at) {
  return row_by_row(reference::VectorX<double>(reference::inertia_magnitude(at.robot, at.q) * at.qdd.cwiseAbs()));
}

}  // namespace

constinit const NumericReference inertial_torque =
    computed_by([](const auto& at) { return inertial_torques(at); }, [](const auto& at) { return sizes_of_terms(at); });

}  // namespace flatdyn::references
