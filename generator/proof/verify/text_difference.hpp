// SPDX-License-Identifier: GPL-2.0-or-later
// Where two texts in the same language differ, statement by statement. Comments and blanks do not count.
#pragma once

#include <string>
#include <vector>

#include "code/readback/tokens.hpp"

namespace flatdyn {

// A statement of the held text that is another one in the own text. `held` is empty where one is missing, `own` where
// one is too many; `held_word` and `own_word` are the first words in which two statements differ.
struct TextDifference {
  int line = 0;          // in the held text: of the word, or of the statement behind the missing one
  int own_line = 0;      // in the own text
  std::string function;  // its name, or that of its part; empty: around the functions
  std::string held, own, held_word, own_word;
};

// The differences, in order. If there are more than can be found in reasonable time, only the first one, and
// `is_only_first` becomes true.
std::vector<TextDifference> differences_of(const std::vector<Token>& held, const std::vector<Token>& own,
                                           bool& is_only_first);

}  // namespace flatdyn
