// SPDX-License-Identifier: GPL-2.0-or-later
// The unit of an entry of a function's output, from the output's quantity and the joints' types: a torque of a revolute
// joint is in N m, one of a prismatic joint in N.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The unit, such as "N m" or "kg m^2"; "1" for a number without one, "" if the output's quantity is not said.
std::string unit_of(const Mechanism& mechanism, const Function& function, const Output& output, std::size_t entry);

// The unit of a dynamic parameter by its index in pi, and those of the base parameters, which are those of the
// parameters that they keep.
std::string unit_of_parameter(const Mechanism& mechanism, int index);
std::vector<std::string> units_of_base_parameters(const Mechanism& mechanism);

// All units of a function's entries in their order, each once: "N m, N".
std::string units_of(const Mechanism& mechanism, const Function& function);

}  // namespace flatdyn
