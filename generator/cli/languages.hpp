// SPDX-License-Identifier: GPL-2.0-or-later
// The languages of --language, and which options each has. Help is made of this list, and tests compare documents,
// CMake and packages with it.
#pragma once

#include <string>
#include <vector>

#include "emit/emit_options.hpp"

namespace flatdyn {

struct LanguageChoice {
  const char *option, *name;  // "c++", "C++"
  Language language;
  bool has_form, has_stages, has_scalar, has_namespace, has_fma;
  bool is_one_file;  // unless its form is a pair
};

// The value of --language for a module over the C form.
inline constexpr const char* kPython = "python";

const std::vector<LanguageChoice>& language_choices();
const LanguageChoice& language_choice(const std::string& option);
std::vector<std::string> language_options();  // "c++", "c", ...

// "C++, C, CUDA, JavaScript or Python"
std::string languages_text();

}  // namespace flatdyn
