// SPDX-License-Identifier: GPL-2.0-or-later
// Functions → text of a self-contained C++17 header, of a header and source in C++17 or C99, or of a JavaScript module.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/dialect.hpp"
#include "emit/stages.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// C++: all in one header, or declarations there and definitions in a source that is compiled once.
enum class Form { header, pair };

struct EmitOptions {
  std::string name_space;         // empty: from the robot's name
  std::string scalar = "double";  // default of the template parameter: "double" or "float"
  std::string options_stamp;      // the options that shaped the output, for the stamp
  std::string input_hash;         // of the robot file's content (and what it includes)
  std::string scene_stamp;        // the content of the scene file
  std::string scene_facts;        // sentences that say what a scene fixed
  int most_lines = 0;             // of any function in the header; 0: no limit but that of compilers
  Language language = Language::cpp;
  std::string file_name{};  // of header and source, without what follows the dot; empty: the robot's name
  Form form = Form::header;
  std::vector<std::string> more_scalars{};  // that the source of a pair is compiled for, beside `scalar`
};

// The header's file name for this mechanism: "panda.hpp", in C "panda.h"; in JavaScript the module's, "panda.js".
std::string header_name(const Mechanism& mechanism, const EmitOptions& options);
std::string source_name(const Mechanism& mechanism, const EmitOptions& options);  // "panda.cpp", in C "panda.c"

struct HeaderAndSource {
  std::string header, source;
};

// The whole header: documentation, constants, one function template per Function, and the stages. Deterministic.
std::string emit_cpp(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options,
                     const std::optional<Stages>& stages = std::nullopt);

// The same text in two files: templates that are declared in the header, defined in the source, and instantiated there
// for options.scalar and options.more_scalars. The same bits.
HeaderAndSource emit_cpp_pair(const Mechanism& mechanism, const std::vector<Function>& functions,
                              const EmitOptions& options, const std::optional<Stages>& stages = std::nullopt);

// The same functions in C99, for options.scalar: no templates, plain arrays, names with a prefix. The same bits.
HeaderAndSource emit_c(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options);

// How C calls what computes without sines and cosines of its own: the function that is given them, or the function
// itself where it needs none.
struct StraightCall {
  std::string function;                // "panda_gravity_given"
  std::vector<std::string> arguments;  // names: "parameters", "sine", "cosine", inputs, outputs
};
std::vector<StraightCall> straight_calls(const Mechanism& mechanism, const std::vector<Function>& functions,
                                         const EmitOptions& options);

// The same functions over arrays of states, several states at a time in the lanes of SIMD registers: a source of GNU C
// that goes with the C form's header. The same statements, and the same bits but for sines and cosines. Where it says
// the hash of all texts of the library there is kHash (emit/text_hash.hpp).
std::string emit_c_batch(const Mechanism& mechanism, const std::vector<Function>& functions,
                         const EmitOptions& options);

// The same functions in JavaScript, in double: an ES module, or the body of a function that returns them in an object,
// for a page. The same operations in the same order.
enum class JavascriptForm { module, function_body };
std::string emit_javascript(const Mechanism& mechanism, const std::vector<Function>& functions,
                            const EmitOptions& options, JavascriptForm form = JavascriptForm::module);

// In which a robot's code is written: its scalar, and how its names begin.
Dialect dialect_of(const Mechanism& mechanism, const EmitOptions& options);

}  // namespace flatdyn
