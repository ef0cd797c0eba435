// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/utf8.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

TEST(Utf8, TakesCharactersOfAllLengths) {
  for (const char* text : {"", "arm",
                           "gr\xC3\xB6\xC3\x9F"
                           "e",
                           "\xE2\x82\xAC", "\xED\x9F\xBF", "\xF0\x9F\xA4\x96", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_TRUE(is_utf8(text)) << text;
  }
}

TEST(Utf8, RefusesWhatIsNone) {
  for (const char* text : {"gr\xF6\xDF"
                           "e",                                             // Latin-1
                           "\x80", "\xC3", "\xE2\x82", "\xC3(",             // a byte too many or too few
                           "\xC0\xAF", "\xE0\x80\xAF", "\xF0\x80\x80\x80",  // overlong forms
                           "\xED\xA0\x80",                                  // a surrogate
                           "\xF4\x90\x80\x80", "\xFF"}) {                   // beyond Unicode
    EXPECT_FALSE(is_utf8(text)) << text;
  }
}

}  // namespace
}  // namespace flatdyn
