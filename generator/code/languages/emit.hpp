// SPDX-License-Identifier: GPL-2.0-or-later
// Functions → text in the language of the options, and what languages have in addition.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "code/emit/emit_options.hpp"
#include "code/emit/generated_file.hpp"
#include "code/emit/page_dialect.hpp"
#include "code/lower/stages.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The dialect of a robot's code: its language, its scalar and the prefix of its names.
std::unique_ptr<const PageDialect> dialect_of(const Mechanism& mechanism, const EmitOptions& options);

// The code in the language and the form of the options: the header, and the source if there is one. `stages`: only for
// languages that have them. Deterministic.
std::vector<GeneratedFile> emit_code(const Mechanism& mechanism, const std::vector<Function>& functions,
                                     const EmitOptions& options, const std::optional<Stages>& stages = std::nullopt);

// The name of the first of these files: "panda.hpp".
std::string header_name(const Mechanism& mechanism, const EmitOptions& options);

// The code as one header in the language that flatdyn itself compiles, executes and certifies, the default of the
// options, whatever language and form these options name. header_reader() reads it.
std::string emit_header(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options,
                        const std::optional<Stages>& stages = std::nullopt);

// The types of a module for editors, in the language of the options, which has them (LanguageRow::types).
std::string emit_types(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options);

// The same functions over arrays of states, several states at a time in the lanes of SIMD registers, in the language of
// the options, which has them (LanguageRow::batch). They have the same statements, and compute the same bits up to
// sines and cosines. The place for the hash of all texts of the library is marked by kHashPlaceholder
// (code/emit/text_hash.hpp).
std::string emit_batch(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options);

// The body of a function that returns the same functions, for a page of the web, in the first language that has such
// scripts; and options that name that language.
std::string emit_page_script(const Mechanism& mechanism, const std::vector<Function>& functions);
EmitOptions page_script_options();

// A call of a computation without library sines: the variant that takes sines and cosines as arguments, or the
// function itself if it needs none.
struct StraightCall {
  std::string function;                // "panda_gravity_given"
  std::vector<std::string> arguments;  // "parameters", "sine", "cosine", and the names of inputs and outputs
};
// One call per function, in order.
std::vector<StraightCall> straight_calls(const Mechanism& mechanism, const std::vector<Function>& functions,
                                         const EmitOptions& options);

}  // namespace flatdyn
