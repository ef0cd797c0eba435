// SPDX-License-Identifier: GPL-2.0-or-later
#include "languages/language_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace flatdyn {

const std::vector<LanguageRow>& language_rows() {
  static const std::vector<LanguageRow> all = {
      {.option = "c++",
       .name = "C++",
       .language = Language::cpp,
       .has_pair = true,
       .has_stages = true,
       .has_scalar = true,
       .has_namespace = true,
       .has_fma = true,
       .has_lanes = true,
       .has_conventions = true,
       .is_compiled_by_host = true},
      {.option = "c",
       .name = "C",
       .language = Language::c,
       .has_source = true,
       .has_scalar = true,
       .has_namespace = true,
       .has_fma = true,
       .has_given_variants = true,
       .is_compiled_by_host = true},
      {.option = "cuda",
       .name = "CUDA",
       .language = Language::cuda,
       .has_scalar = true,
       .has_namespace = true,
       .has_fma = true,
       .has_parts = false,
       .has_kernels = true},
      {.option = "javascript", .name = "JavaScript", .language = Language::javascript, .has_types_apart = true},
      {.option = kPython,
       .name = "Python",
       .language = Language::c,
       .has_source = true,
       .has_scalar = true,
       .has_namespace = true,
       .has_given_variants = true}};
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
