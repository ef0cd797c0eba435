// SPDX-License-Identifier: GPL-2.0-or-later
// Differences of two texts, statement by statement.
#include "proof/verify/text_difference.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace flatdyn {
namespace {

constexpr const char* kOwn =
    "void f(double* x) {\n"
    "  const double a = 1.5, b = 2.5;  // two\n"
    "  x[0] = a * b;\n"
    "  x[1] = b;\n"
    "}\n"
    "constexpr double y[2] = {1.0, 2.0};\n"
    "#endif\n";

std::vector<TextDifference> differences(const std::string& held, const std::string& own = kOwn) {
  bool is_only_first = false;
  std::vector<TextDifference> found = differences_of(tokens_of(held), tokens_of(own), is_only_first);
  EXPECT_FALSE(is_only_first);
  return found;
}

std::string with(std::string from, const std::string& to) {
  std::string text = kOwn;
  return text.replace(text.find(from), from.size(), to);
}

TEST(TextDifference, IsNoneWithOtherCommentsAndBlanks) {
  EXPECT_TRUE(differences(kOwn).empty());
  EXPECT_TRUE(differences(with("  // two\n", " /* 2 */\n\n")).empty());
}

TEST(TextDifference, IsTheWordInAStatementAndItsLine) {
  const std::vector<TextDifference> found = differences(with("2.5", "2.25"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].line, 2);
  EXPECT_EQ(found[0].held_word, "2.25");
  EXPECT_EQ(found[0].own_word, "2.5");
  EXPECT_EQ(found[0].held, "const double a = 1.5, b = 2.25;");
  EXPECT_EQ(found[0].own, "const double a = 1.5, b = 2.5;");
}

TEST(TextDifference, IsAStatementThatIsMissingOrTooMany) {
  const std::vector<TextDifference> missing = differences(with("  x[0] = a * b;\n", ""));
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].line, 3);
  EXPECT_EQ(missing[0].held, "");
  EXPECT_EQ(missing[0].own, "x[0] = a * b;");
  const std::vector<TextDifference> more = differences(with("#endif", "int z;\n#endif"));
  ASSERT_EQ(more.size(), 1u);
  EXPECT_EQ(more[0].line, 7);
  EXPECT_EQ(more[0].held, "int z;");
  EXPECT_EQ(more[0].own, "");
}

TEST(TextDifference, KeepsATableInOneStatement) {
  const std::vector<TextDifference> found = differences(with("1.0, 2.0", "1.0, 3.0"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].held, "constexpr double y[2] = { 1.0, 3.0 };");
}

TEST(TextDifference, FindsSeveralFarFromEachOther) {
  std::string text = with("1.5", "1.25");
  text.replace(text.find("x[1] = b"), 8, "x[1] = a");
  const std::vector<TextDifference> found = differences(text);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].line, 2);
  EXPECT_EQ(found[1].line, 4);
}

TEST(TextDifference, IsTheFirstOneWhereTheyAreTooMany) {
  std::string held, own;
  for (int k = 0; k < 1000; ++k) {
    held += fmt::format("a{} = 1;\n", k);
    own += fmt::format("b{} = 1;\n", k);
  }
  bool is_only_first = false;
  const std::vector<TextDifference> found =
      differences_of(tokens_of("same;\n" + held), tokens_of("same;\n" + own), is_only_first);
  EXPECT_TRUE(is_only_first);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].line, 2);
  EXPECT_EQ(found[0].held, "a0 = 1;");
}

TEST(TextDifference, HoldsForTextsWithoutStatements) {
  EXPECT_TRUE(differences("", "").empty());
  EXPECT_EQ(differences("", "x;").size(), 1u);
  EXPECT_EQ(differences("x;", "").size(), 1u);
}

}  // namespace
}  // namespace flatdyn
