// SPDX-License-Identifier: GPL-2.0-or-later
// Comments are sentences, or name what they describe: none opens with the fragments "Of ..." and "What ...". Prose of
// the documents fits into 120 columns.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>

#include "diagnostics/table.hpp"
#include "unit/layout/source_files.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;

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

TEST(Prose, OfDocumentsFitsInto120Columns) {
  constexpr std::size_t kColumns = 120;
  const fs::path root = FLATDYN_SOURCE_DIR;
  std::vector<fs::path> pages = {root / "README.md", root / "generator/README.md"};
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  for (const fs::path& page : pages) {
    bool is_code = false;
    const std::vector<std::string> lines = lines_of(page);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const std::string& line = lines[k];
      if (line.starts_with("```")) is_code = !is_code;
      const bool is_prose = !is_code && !line.starts_with("|") && !line.starts_with("    ");
      if (is_prose && text_width(line) > kColumns) {
        ADD_FAILURE() << fmt::format("{}:{}: {} columns", fs::relative(page, root).string(), k + 1, text_width(line));
      }
    }
  }
}

}  // namespace
}  // namespace flatdyn::testing
