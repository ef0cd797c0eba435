// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace flatdyn {

// Names go into JSON and C++ comments, which are UTF-8; XML files come in other encodings too.
bool is_utf8(std::string_view text);

}  // namespace flatdyn
