// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "graph/function.hpp"

namespace flatdyn::testing {

// The function that graph/text.hpp has printed. Throws std::runtime_error with the line where the text is no such text.
Function function_from_text(const std::string& text);

}  // namespace flatdyn::testing
