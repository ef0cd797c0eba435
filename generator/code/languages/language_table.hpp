// SPDX-License-Identifier: GPL-2.0-or-later
// The languages of emitted code, a row for each. The options of `generate` and their refusals, its help, and everything
// that depends on a language outside of its folder ask this table; tests compare documents, CMake and packages with it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "code/languages/common/language_row.hpp"

namespace flatdyn {

// The value of --language for a module over the C form, which has neither dialect nor reader.
inline constexpr const char* kPython = "python";

const std::vector<LanguageRow>& language_rows();
const LanguageRow& language_row(const std::string& option);
std::vector<std::string> language_options();  // "c++", "c", ...

// The names of all languages, "C++, C, CUDA, JavaScript, Rust or Python", or of those that are meant: the question may
// be a member of LanguageRow.
using LanguageQuestion = std::function<bool(const LanguageRow&)>;
std::string languages_text();
std::string languages_text(const LanguageQuestion& is_meant);

// The first of these languages.
const LanguageRow& language_with(const LanguageQuestion& is_meant);

// "a C++17 header, a C99 header and source in one scalar, …"
std::string descriptions_of_languages();

}  // namespace flatdyn
