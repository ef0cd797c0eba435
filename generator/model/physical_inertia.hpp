// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <optional>

#include "model/mechanism.hpp"
#include "model/robot.hpp"

namespace flatdyn {

enum class InertiaFault {
  not_positive_semidefinite,  // a principal moment is negative
  triangle_inequality,        // a principal moment is larger than the other two together
};

// Whether a body can have this inertia tensor about its centre of mass, decided exactly. Nothing is found where an
// entry is no rational number (a symbol, a root).
std::optional<InertiaFault> fault_of_inertia(const Mat3& tensor);

// The tensor about the centre of mass, along the axes of the inertial frame.
Mat3 central_tensor(const Inertial& inertial);
// Of a body about its frame's origin; one without mass has its centre there.
Mat3 central_tensor(const InertialParameters& body);
Vec3 centre_of_mass(const InertialParameters& body);

// Principal moments, largest first, for messages only.
std::array<double, 3> principal_moments(const Mat3& tensor);

}  // namespace flatdyn
