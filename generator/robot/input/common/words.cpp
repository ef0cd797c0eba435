// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/words.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

#include "robot/model/number.hpp"

namespace flatdyn {
namespace {

std::optional<Number> number_of(const std::string& word) {
  try {
    return exact_decimal(word);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string joined_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string single_word(const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  return words.size() == 1 ? words[0] : text;
}

bool are_equivalent_texts(const std::string& a, const std::string& b) {
  const std::vector<std::string> first = words_of(a), second = words_of(b);
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const std::string& x, const std::string& y) {
                      const std::optional<Number> p = number_of(x), q = number_of(y);
                      return x == y || (p && q && p->is_equal(*q));
                    });
}

bool is_zero_text(const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  return std::all_of(words.begin(), words.end(), [](const std::string& word) {
    const std::optional<Number> number = number_of(word);
    return number && vanishes(*number);
  });
}

}  // namespace flatdyn
