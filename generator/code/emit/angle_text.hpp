// SPDX-License-Identifier: GPL-2.0-or-later
// The text about the angles whose sines and cosines emitted functions need (code/lower/angles.hpp).
#pragma once

#include <string>
#include <vector>

#include "code/emit/header_scope.hpp"

namespace flatdyn {

// The definition of the function that fills the array of angles. Needed only if there are angles other than those of q.
std::string angles_definition(const HeaderScope& scope);

// Lines of comment that list these angles.
std::vector<std::string> angles_comment(const HeaderScope& scope);

}  // namespace flatdyn
