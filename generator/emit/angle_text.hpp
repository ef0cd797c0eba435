// SPDX-License-Identifier: GPL-2.0-or-later
// The text about the angles whose sines and cosines emitted functions need (lower/angles.hpp).
#pragma once

#include <string>
#include <vector>

#include "emit/header_scope.hpp"

namespace flatdyn {

// The name of the number of angles.
std::string angle_count_name(const HeaderScope& scope);

// The call "detail::angles(q, angle);", and the definition of the function, which fills the array. Needed only if there
// are angles beside the entries of q.
std::string angles_call(const HeaderScope& scope);
std::string angles_definition(const HeaderScope& scope);

// Lines of comment that list these angles.
std::vector<std::string> angles_comment(const HeaderScope& scope);

}  // namespace flatdyn
