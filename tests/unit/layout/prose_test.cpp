// SPDX-License-Identifier: GPL-2.0-or-later
// Comments are sentences, or name what they describe: none opens with the fragments "Of ..." and "What ...".
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>

#include "unit/layout/source_files.hpp"

namespace flatdyn::testing {
namespace {

// The numbers of lines that open a block of comments with a fragment.
std::vector<std::size_t> fragments(const std::vector<std::string>& lines) {
  static const std::regex kComment(R"(^\s*(//|\*).*)"), kFragment(R"(^\s*// (Of|What)\b.*)");
  std::vector<std::size_t> found;
  bool is_inside = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (!is_inside && std::regex_match(lines[k], kFragment)) found.push_back(k + 1);
    is_inside = std::regex_match(lines[k], kComment);
  }
  return found;
}

TEST(Prose, NoCommentOpensWithAFragment) {
  for (const char* top : {"generator", "runtime", "tests"}) {
    for (const SourceFile& file : source_files(top)) {
      for (const std::size_t line : fragments(file.lines)) {
        ADD_FAILURE() << fmt::format("{}/{}:{}: a comment opens with \"Of\" or \"What\": write a sentence", top,
                                     file.name, line);
      }
    }
  }
}

TEST(Prose, AFragmentIsFound) {
  const std::vector<std::string> lines = {"// The mass of body i, kg.",
                                          "// Of all bodies.",
                                          "int x;",
                                          "  // What it is.",
                                          "int y;  // of z",
                                          "// Officially so.",
                                          "",
                                          "// Of body i."};
  EXPECT_EQ(fragments(lines), (std::vector<std::size_t>{4, 8}));
}

}  // namespace
}  // namespace flatdyn::testing
