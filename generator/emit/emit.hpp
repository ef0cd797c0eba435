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

// The form of C++: all in one header, or declarations in a header and definitions in a source that is compiled once.
enum class Form { header, pair };

struct EmitOptions {
  std::string name_space;         // empty: from the robot's name
  std::string scalar = "double";  // default of the template parameter: "double" or "float"
  std::string options_stamp;      // the options that affect the output, for the stamp
  std::string input_hash;         // hash of the robot file's content (and of files that it includes)
  std::string scene_stamp;        // the content of the scene file
  std::string scene_facts;        // sentences about what a scene has fixed
  int most_lines = 0;             // limit of lines per function; 0: only that of compilers
  Language language = Language::cpp;
  std::string file_name{};  // name of header and source without extension; empty: the robot's name
  Form form = Form::header;
  std::vector<std::string> more_scalars{};  // scalars beside `scalar` that the source of a pair is compiled for
};

// The file name for this mechanism: the header's, "panda.hpp", in C "panda.h", or the JavaScript module's, "panda.js".
std::string header_name(const Mechanism& mechanism, const EmitOptions& options);
std::string source_name(const Mechanism& mechanism, const EmitOptions& options);  // "panda.cpp", in C "panda.c"

struct HeaderAndSource {
  std::string header, source;
};

// The text of the whole header: documentation, constants, one function template per Function, and the stages.
// Deterministic.
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
// for the hash of all texts of the library is marked by kHash (emit/text_hash.hpp).
std::string emit_c_batch(const Mechanism& mechanism, const std::vector<Function>& functions,
                         const EmitOptions& options);

// The same functions in JavaScript, in double: an ES module, or the body of a function that returns them in an object,
// for a web page. They have the same operations in the same order.
enum class JavascriptForm { module, function_body };
std::string emit_javascript(const Mechanism& mechanism, const std::vector<Function>& functions,
                            const EmitOptions& options, JavascriptForm form = JavascriptForm::module);

// The dialect of a robot's code: its language, its scalar and the prefix of its names.
Dialect dialect_of(const Mechanism& mechanism, const EmitOptions& options);

}  // namespace flatdyn
