// SPDX-License-Identifier: GPL-2.0-or-later
// A row says of a language all that code outside of its folder asks for: what it has, its dialect and its reader.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "code/conventions/convention.hpp"
#include "code/emit/page_dialect.hpp"
#include "code/readback/language_reader.hpp"

namespace flatdyn {

using DialectOf = std::unique_ptr<const PageDialect>(const Mechanism& mechanism, const EmitOptions& options);

using ReaderOf = AnyLanguageReader(const EmitOptions& options);

// A language may need more functions of a robot than are asked for: by name, sets of which each is computed as one, and
// a sentence that says what is left out.
struct FunctionsNeeded {
  std::vector<std::string> functions;
  std::vector<std::vector<std::string>> fused;
  std::string note;  // empty: nothing
};

struct LanguageRow {
  const char *option = "", *name = "";  // the value of --language, "c++", and for people, "C++"
  const char* description = "";         // "a C++17 header"
  // The endings of its files after their name, ".h" and ".c"; and of files that some options add.
  std::vector<std::string> endings{}, more_endings{};
  DialectOf* dialect = nullptr;  // writes its files
  ReaderOf* reader = nullptr;    // reads them
  // Only some languages have these; in others they are nullptr. They write a file of types for editors, a source with
  // functions over arrays of states, a script for pages of the web, and a header in another program's convention.
  DialectOf *types = nullptr, *batch = nullptr, *page_script = nullptr;
  ReaderOf* batch_reader = nullptr;  // reads that source behind the first of the files
  // Likewise: the functions that it needs for those that are asked for, the form in which its text has them, and files
  // around that text.
  FunctionsNeeded (*functions_needed)(const Mechanism& mechanism, const std::vector<std::string>& asked) = nullptr;
  std::vector<Function> (*as_written)(const Mechanism& mechanism, const std::vector<Function>& functions) = nullptr;
  std::vector<GeneratedFile> (*more_files)(const Mechanism& mechanism, const std::vector<Function>& functions,
                                           const EmitOptions& options) = nullptr;
  ConventionHeader (*convention_header)(const Mechanism& mechanism, const std::vector<Function>& functions,
                                        const EmitOptions& options, const Convention& convention) = nullptr;
  bool has_pair = false;             // header and source on request
  bool has_stages = false;           // structures that keep what functions have in common
  bool has_scalar = false;           // float in addition to double
  bool has_namespace = false;        // or a prefix of names
  bool has_fma = false;              // fused multiply-adds
  bool has_lanes = false;            // limbs in the lanes of vectors
  bool has_parts = true;             // long functions in parts
  bool has_kernels = false;          // functions divided among kernels
  bool has_given_variants = false;   // functions of their own that take sines and cosines
  bool is_compiled_by_host = false;  // by the C or C++ compiler of the machine
  bool is_called_by_python = false;  // by a module that is written beside it
  bool is_for_firmware = false;      // with a folder that a microcontroller builds and tests it with

  bool is_one_file() const { return endings.size() == 1; }
  bool has_conventions() const { return convention_header != nullptr; }
};

}  // namespace flatdyn
