// SPDX-License-Identifier: GPL-2.0-or-later
// The reader of the language that options name, and those of languages that some code writes whatever options say.
#pragma once

#include "code/emit/emit_options.hpp"
#include "code/languages/c/read.hpp"
#include "code/languages/cpp/read.hpp"
#include "code/languages/cuda/read.hpp"
#include "code/languages/javascript/read.hpp"

namespace flatdyn {

// The reader of text that is written with these options.
AnyLanguageReader reader_of(const EmitOptions& options);

}  // namespace flatdyn
