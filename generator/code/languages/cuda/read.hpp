// SPDX-License-Identifier: GPL-2.0-or-later
// Reading CUDA back.
#pragma once

#include "code/readback/language_reader.hpp"

namespace flatdyn {

AnyLanguageReader cuda_reader();

}  // namespace flatdyn
