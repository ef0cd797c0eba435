// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/wrap.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

TEST(Wrap, BreaksAtBlanksUnderTheLineOrItsLastColumn) {
  EXPECT_EQ(wrapped("one two three four", 9), "one two\nthree\nfour");
  EXPECT_EQ(wrapped("  one two three\n", 9), "  one two\n  three\n");
  EXPECT_EQ(wrapped("  -a  one two three", 13), "  -a  one two\n      three");
}

TEST(Wrap, LeavesShortLinesAndLongWordsAndCountsCharacters) {
  EXPECT_EQ(wrapped("a  b\n\nc", 4), "a  b\n\nc");
  EXPECT_EQ(wrapped("abcdefgh i", 4), "abcdefgh\ni");
  EXPECT_EQ(wrapped("äöü äöü", 7), "äöü äöü");
}

}  // namespace
}  // namespace flatdyn
