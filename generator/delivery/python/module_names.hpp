// SPDX-License-Identifier: GPL-2.0-or-later
// Names that a Python module cannot have.
#pragma once

#include <string_view>

namespace flatdyn {

bool is_keyword_of_python(std::string_view name);

// Whether the name belongs to the standard library, which is searched after the folder of a program, or is numpy. A
// generated module of that name would be imported in its place.
bool is_module_of_python(std::string_view name);

}  // namespace flatdyn
