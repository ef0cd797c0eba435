// SPDX-License-Identifier: GPL-2.0-or-later
// The readers of emitted text.
#pragma once

#include "code/emit/emit_options.hpp"
#include "code/readback/language_reader.hpp"

namespace flatdyn {

// The reader of text that is written with these options.
AnyLanguageReader reader_of(const EmitOptions& options);

// The readers of what emit_header() writes, and of the first file's text with emit_batch()'s behind it
// (code/languages/emit.hpp).
AnyLanguageReader header_reader();
AnyLanguageReader batch_reader(const EmitOptions& options);

}  // namespace flatdyn
