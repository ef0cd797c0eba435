// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/language_table.hpp"

#include <algorithm>
#include <stdexcept>

#include "code/languages/c/language.hpp"
#include "code/languages/casadi/language.hpp"
#include "code/languages/cpp/language.hpp"
#include "code/languages/cuda/language.hpp"
#include "code/languages/javascript/language.hpp"
#include "code/languages/rust/language.hpp"

namespace flatdyn {

namespace {

// A module over C, whose row says what it has.
LanguageRow python_row() {
  LanguageRow row{.option = kPython, .name = "Python"};
  row.description = "a module for Python over the C form (--python)";
  row.endings = c_language().endings;
  return row;
}

// "a, b or c"
std::string alternatives(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t k = 0; k < items.size(); ++k) {
    text += std::string(k == 0 ? "" : k + 1 < items.size() ? ", " : " or ") + items[k];
  }
  return text;
}

}  // namespace

const std::vector<LanguageRow>& language_rows() {
  static const std::vector<LanguageRow> all = {cpp_language(),  c_language(), cuda_language(),  javascript_language(),
                                               rust_language(), python_row(), casadi_language()};
  return all;
}

const LanguageRow& language_row(const std::string& option) {
  const std::vector<LanguageRow>& all = language_rows();
  const auto found =
      std::find_if(all.begin(), all.end(), [&option](const LanguageRow& each) { return option == each.option; });
  if (found == all.end()) throw std::invalid_argument("no language " + option);
  return *found;
}

std::vector<std::string> language_options() {
  std::vector<std::string> options;
  for (const LanguageRow& each : language_rows()) options.emplace_back(each.option);
  return options;
}

const LanguageRow& language_with(const LanguageQuestion& is_meant) {
  const std::vector<LanguageRow>& all = language_rows();
  return *std::find_if(all.begin(), all.end(), is_meant);
}

std::string languages_text(const LanguageQuestion& is_meant) {
  std::vector<std::string> names;
  for (const LanguageRow& each : language_rows()) {
    if (is_meant(each)) names.emplace_back(each.name);
  }
  return alternatives(names);
}

std::string languages_text() {
  return languages_text([](const LanguageRow&) { return true; });
}

std::string descriptions_of_languages() {
  std::vector<std::string> descriptions;
  for (const LanguageRow& each : language_rows()) descriptions.emplace_back(each.description);
  return alternatives(descriptions);
}

}  // namespace flatdyn
