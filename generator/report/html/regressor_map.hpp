// SPDX-License-Identifier: GPL-2.0-or-later
// Which entries of the regressor are always zero, as a picture.
#pragma once

#include <string>

#include "graph/function.hpp"

namespace flatdyn {

// SVG with a row per torque and thirteen columns per joint, those of a joint together and the joints numbered from 1;
// in the colours of the page that it stands in. `label` is escaped.
std::string regressor_map(const Function& function, const Output& Y, const std::string& label);

}  // namespace flatdyn
