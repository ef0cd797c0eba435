// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/findings_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace flatdyn {
namespace {

TEST(FindingsText, NotesOfOneKindShareALine) {
  Diagnostics found;
  for (const int line : {12, 25, 40, 41, 57}) found.note({"arm.urdf", line}, "each", "h", "limits of 0 left out");
  found.note({"arm.urdf", 3}, "of no kind", "do this");
  EXPECT_EQ(findings_text(found, {}),
            "note: 5 limits of 0 left out (arm.urdf:12, 25, 40, 41, …)\n    hint: h\n"
            "arm.urdf:3: note: of no kind\n    hint: do this\n"
            "note: -v lists each by itself\n");
}

TEST(FindingsText, ASingleOneOfAKindIsToldAsItIs) {
  Diagnostics found;
  found.note({"arm.urdf", 12}, "each", "h", "limits of 0 left out");
  EXPECT_EQ(findings_text(found, {}), "arm.urdf:12: note: each\n    hint: h\n");
}

TEST(FindingsText, PlacesNameTheirFilesAndStandOnce) {
  Diagnostics found;
  for (const char* file : {"a.urdf", "b.toml", "b.toml"}) found.note({file, 7}, "each", "", "things");
  found.note({}, "each", "", "things");
  EXPECT_EQ(findings_text(found, {}), "note: 4 things (a.urdf:7, b.toml:7)\nnote: -v lists each by itself\n");
}

TEST(FindingsText, NotesTakeTenLinesAtMostAndErrorsAsManyAsTheyNeed) {
  Diagnostics found;
  for (int line = 1; line <= 30; ++line) {
    found.error({"arm.urdf", line}, "wrong", "mend it");
    found.note({"arm.urdf", line}, "odd", "look at it");
  }
  const std::string text = findings_text(found, {});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10 + 60);
  EXPECT_NE(text.find("note: 21 more; -v lists each by itself"), std::string::npos);
  EXPECT_LT(text.find("21 more"), text.find("error"));
}

TEST(FindingsText, VerboseTellsEachAndQuietNoNotes) {
  Diagnostics found;
  for (const int line : {1, 2}) found.note({"a", line}, "odd", "h", "odd things");
  for (const int line : {3, 4}) found.warning({"a", line}, "doubtful", "", "doubts");
  EXPECT_EQ(
      findings_text(found, {.verbose = true}),
      "a:1: note: odd\n    hint: h\na:2: note: odd\n    hint: h\na:3: warning: doubtful\na:4: warning: doubtful\n");
  EXPECT_EQ(findings_text(found, {.quiet = true}), "warning: 2 doubts (a:3, 4)\n");
}

}  // namespace
}  // namespace flatdyn
