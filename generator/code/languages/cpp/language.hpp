// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "code/languages/common/language_row.hpp"

namespace flatdyn {

LanguageRow cpp_language();

}  // namespace flatdyn
