// SPDX-License-Identifier: GPL-2.0-or-later
// The languages of emitted code and what each has, a row for each. The options of `generate` and their refusals, its
// help, and everything that depends on a language outside of its folder ask this table; tests compare documents, CMake
// and packages with it.
#pragma once

#include <string>
#include <vector>

#include "emit/emit_options.hpp"

namespace flatdyn {

struct LanguageRow {
  const char *option, *name;  // the value of --language, "c++", and for people, "C++"
  Language language = Language::cpp;
  bool has_pair = false;             // header and source on request
  bool has_source = false;           // header and source always
  bool has_stages = false;           // structures that keep what functions have in common
  bool has_scalar = false;           // float beside double
  bool has_namespace = false;        // or a prefix of names
  bool has_fma = false;              // fused multiply-adds
  bool has_lanes = false;            // limbs in the lanes of vectors
  bool has_conventions = false;      // headers in other programs' conventions
  bool has_parts = true;             // long functions in parts
  bool has_kernels = false;          // functions divided among kernels
  bool has_types_apart = false;      // a file of types for editors
  bool has_given_variants = false;   // functions of their own that take sines and cosines
  bool is_compiled_by_host = false;  // by the C or C++ compiler of the machine
};

// The value of --language for a module over the C form.
inline constexpr const char* kPython = "python";

const std::vector<LanguageRow>& language_rows();
const LanguageRow& language_row(const std::string& option);
const LanguageRow& language_row(Language language);
std::vector<std::string> language_options();  // "c++", "c", ...

// "C++, C, CUDA, JavaScript or Python"
std::string languages_text();

}  // namespace flatdyn
