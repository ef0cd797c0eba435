// SPDX-License-Identifier: GPL-2.0-or-later
// A picture of the regressor's structural zeros.
#pragma once

#include <string>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// SVG with a row per torque and thirteen columns per joint, grouped by joint and numbered from 1 like its rows ("3–5" a
// spherical joint), in the colours of the page around it. With a floating base, six rows, and ten columns with the
// number 0, come before them. `label` is escaped.
std::string regressor_map(const Function& function, const Output& Y, const Mechanism& mechanism,
                          const std::string& label);

}  // namespace flatdyn
