// SPDX-License-Identifier: GPL-2.0-or-later
// Functions → text of a self-contained C++17 header, of a header and source in C++17 or C99, or of a JavaScript module.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "code/emit/emit_options.hpp"
#include "code/emit/page_dialect.hpp"
#include "code/languages/javascript/dialect.hpp"
#include "code/lower/stages.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The dialect of a robot's code: its language, its scalar and the prefix of its names.
std::unique_ptr<const PageDialect> dialect_of(const Mechanism& mechanism, const EmitOptions& options);

// A file of the generated code.
struct GeneratedFile {
  std::string name;  // without a folder
  std::string text;
};

// The code in the language and the form of the options: the header, and the source if there is one. `stages`: only for
// languages that have them. Deterministic.
std::vector<GeneratedFile> emit_code(const Mechanism& mechanism, const std::vector<Function>& functions,
                                     const EmitOptions& options, const std::optional<Stages>& stages = std::nullopt);

// The file name for this mechanism: the header's, "panda.hpp", in C "panda.h", or the JavaScript module's, "panda.js".
std::string header_name(const Mechanism& mechanism, const EmitOptions& options);

struct HeaderAndSource {
  std::string header, source;
};

// The following functions write one language, whichever the options name.

// The text of the whole header: documentation, constants, one function template per Function, and the stages.
std::string emit_cpp(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options,
                     const std::optional<Stages>& stages = std::nullopt);

// The same text in two files: templates are declared in the header, defined in the source, and instantiated there for
// options.scalar and options.more_scalars. They compute the same bits.
HeaderAndSource emit_cpp_pair(const Mechanism& mechanism, const std::vector<Function>& functions,
                              const EmitOptions& options, const std::optional<Stages>& stages = std::nullopt);

// The same functions in C99, for options.scalar: no templates, plain arrays, names with a prefix. They compute the same
// bits.
HeaderAndSource emit_c(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options);

// A call from C of a computation without library sines: the variant that takes sines and cosines as arguments, or the
// function itself if it needs none.
struct StraightCall {
  std::string function;                // "panda_gravity_given"
  std::vector<std::string> arguments;  // "parameters", "sine", "cosine", and the names of inputs and outputs
};
// One call per function, in order.
std::vector<StraightCall> straight_calls(const Mechanism& mechanism, const std::vector<Function>& functions,
                                         const EmitOptions& options);

// The same functions over arrays of states, several states at a time in the lanes of SIMD registers: a source in GNU C
// for the C form's header. It has the same statements, and computes the same bits up to sines and cosines. The place
// for the hash of all texts of the library is marked by kHashPlaceholder (code/emit/text_hash.hpp).
std::string emit_c_batch(const Mechanism& mechanism, const std::vector<Function>& functions,
                         const EmitOptions& options);

// The types of a JavaScript module for TypeScript and editors.
std::string emit_javascript_types(const Mechanism& mechanism, const std::vector<Function>& functions,
                                  const EmitOptions& options = {});

// The same functions in JavaScript, in double. They have the same operations in the same order.
std::string emit_javascript(const Mechanism& mechanism, const std::vector<Function>& functions,
                            const EmitOptions& options, JavascriptForm form = JavascriptForm::module);

}  // namespace flatdyn
