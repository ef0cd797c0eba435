// SPDX-License-Identifier: GPL-2.0-or-later
// The readers of all languages.
#pragma once

#include "emit/emit_options.hpp"
#include "languages/c/read.hpp"
#include "languages/cpp/read.hpp"
#include "languages/cuda/read.hpp"
#include "languages/javascript/read.hpp"

namespace flatdyn {

// The reader of text that is written with these options.
AnyLanguageReader reader_of(const EmitOptions& options);

}  // namespace flatdyn
