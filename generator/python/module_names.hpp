// SPDX-License-Identifier: GPL-2.0-or-later
// Names that a module of Python cannot have.
#pragma once

#include <string_view>

namespace flatdyn {

bool is_keyword_of_python(std::string_view name);

// Of the standard library, which is searched after the folder of a program; and numpy. A module of that name would be
// imported in its place, by itself or by the others.
bool is_module_of_python(std::string_view name);

}  // namespace flatdyn
