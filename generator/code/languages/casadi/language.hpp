// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "code/languages/common/language_row.hpp"

namespace flatdyn {

LanguageRow casadi_language();

}  // namespace flatdyn
