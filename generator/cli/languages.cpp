// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/languages.hpp"

#include <algorithm>
#include <stdexcept>

namespace flatdyn {

const std::vector<LanguageChoice>& language_choices() {
  static const std::vector<LanguageChoice> all = {
      {"c++", "C++", Language::cpp, true, true, true, true, true, true},
      {"c", "C", Language::c, false, false, true, true, true, false},
      {"cuda", "CUDA", Language::cuda, false, false, true, true, true, true},
      {"javascript", "JavaScript", Language::javascript, false, false, false, false, false, true},
      {kPython, "Python", Language::c, false, false, true, true, false, false}};
  return all;
}

const LanguageChoice& language_choice(const std::string& option) {
  const std::vector<LanguageChoice>& all = language_choices();
  const auto found =
      std::find_if(all.begin(), all.end(), [&option](const LanguageChoice& each) { return option == each.option; });
  if (found == all.end()) throw std::invalid_argument("no language " + option);
  return *found;
}

std::vector<std::string> language_options() {
  std::vector<std::string> options;
  for (const LanguageChoice& each : language_choices()) options.emplace_back(each.option);
  return options;
}

std::string languages_text() {
  const std::vector<LanguageChoice>& all = language_choices();
  std::string text;
  for (std::size_t k = 0; k < all.size(); ++k) {
    text += std::string(k == 0 ? "" : k + 1 < all.size() ? ", " : " or ") + all[k].name;
  }
  return text;
}

}  // namespace flatdyn
