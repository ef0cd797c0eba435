// SPDX-License-Identifier: GPL-2.0-or-later
// Conversion of names of the robot file to names of the generated code.
#pragma once

#include <string>
#include <string_view>

namespace flatdyn {

// A valid C++ identifier for a name as written: "arm-1/joint 2" → "arm_1_joint_2", "class" → "class_", "2dof" →
// "x2dof", "größe" → "grosse", "关节" → "u5173_u8282". It contains nothing that C++ reserves: no two underscores in a
// row, none in front. Two names may become the same identifier; the reader reports that for symbols.
std::string cpp_identifier(std::string_view name);

// Whether a C++17 or C++20 compiler gives this word a meaning of its own (a keyword, or a macro of <cmath>).
bool is_reserved_in_cpp(std::string_view word);

}  // namespace flatdyn
