// SPDX-License-Identifier: GPL-2.0-or-later
#include "languages/language_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace flatdyn {

namespace {

LanguageRow cpp_row() {
  LanguageRow row{.option = "c++", .name = "C++", .language = Language::cpp};
  row.has_pair = row.has_stages = row.has_lanes = row.has_conventions = true;
  row.has_scalar = row.has_namespace = row.has_fma = true;
  row.is_compiled_by_host = true;
  return row;
}

LanguageRow c_row() {
  LanguageRow row{.option = "c", .name = "C", .language = Language::c};
  row.has_source = row.has_given_variants = true;
  row.has_scalar = row.has_namespace = row.has_fma = true;
  row.is_compiled_by_host = true;
  return row;
}

LanguageRow cuda_row() {
  LanguageRow row{.option = "cuda", .name = "CUDA", .language = Language::cuda};
  row.has_scalar = row.has_namespace = row.has_fma = true;
  row.has_kernels = true;
  row.has_parts = false;
  return row;
}

LanguageRow javascript_row() {
  LanguageRow row{.option = "javascript", .name = "JavaScript", .language = Language::javascript};
  row.has_types_apart = true;
  return row;
}

// A module over C, whose row says what it has.
LanguageRow python_row() { return {.option = kPython, .name = "Python", .language = Language::c}; }

}  // namespace

const std::vector<LanguageRow>& language_rows() {
  static const std::vector<LanguageRow> all = {cpp_row(), c_row(), cuda_row(), javascript_row(), python_row()};
  return all;
}

const LanguageRow& language_row(const std::string& option) {
  const std::vector<LanguageRow>& all = language_rows();
  const auto found =
      std::find_if(all.begin(), all.end(), [&option](const LanguageRow& each) { return option == each.option; });
  if (found == all.end()) throw std::invalid_argument("no language " + option);
  return *found;
}

const LanguageRow& language_row(Language language) {
  const std::vector<LanguageRow>& all = language_rows();
  return *std::find_if(all.begin(), all.end(),
                       [language](const LanguageRow& each) { return each.language == language; });
}

std::vector<std::string> language_options() {
  std::vector<std::string> options;
  for (const LanguageRow& each : language_rows()) options.emplace_back(each.option);
  return options;
}

std::string languages_text() {
  const std::vector<LanguageRow>& all = language_rows();
  std::string text;
  for (std::size_t k = 0; k < all.size(); ++k) {
    text += std::string(k == 0 ? "" : k + 1 < all.size() ? ", " : " or ") + all[k].name;
  }
  return text;
}

}  // namespace flatdyn
