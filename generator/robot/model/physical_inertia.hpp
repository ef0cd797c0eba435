// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <optional>

#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

enum class InertiaFault {
  not_positive_semidefinite,  // a principal moment is negative
  triangle_inequality,        // a principal moment is larger than the sum of the other two
};

// Why no body can have this inertia tensor about its centre of mass, decided exactly; nothing if one can. Nothing is
// found, either, where an entry has a symbol.
std::optional<InertiaFault> fault_of_inertia(const Mat3& tensor);

// The tensor about the centre of mass, along the axes of the inertial frame.
Mat3 central_tensor(const Inertial& inertial);
// The central tensor of a body that is given about its frame's origin. A body without mass has its centre there.
Mat3 central_tensor(const InertialParameters& body);
Vec3 centre_of_mass(const InertialParameters& body);

// The principal moments, largest first, for messages only.
std::array<double, 3> principal_moments(const Mat3& tensor);

}  // namespace flatdyn
