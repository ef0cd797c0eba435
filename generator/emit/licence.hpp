// SPDX-License-Identifier: GPL-2.0-or-later
// The licence of emitted files in full.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// The lines of the BSD-3-Clause licence, whose copyright holder is the user of flatdyn.
std::vector<std::string> licence_lines();

}  // namespace flatdyn
