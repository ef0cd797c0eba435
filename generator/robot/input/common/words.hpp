// SPDX-License-Identifier: GPL-2.0-or-later
// Texts of several words, most of them numbers.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

std::vector<std::string> words_of(const std::string& text);
// With a blank between two.
std::string joined_words(const std::vector<std::string>& words);

// The word without the blanks around it if the text is a single one, else the text as it is.
std::string single_word(const std::string& text);

// Whether two texts are the same words, or words for the same numbers: "0 0 1" and "0 0 1.0".
bool are_equivalent_texts(const std::string& a, const std::string& b);

// Whether the text is zeros only: "0 0.0 0".
bool is_zero_text(const std::string& text);

}  // namespace flatdyn
