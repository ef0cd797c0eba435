// SPDX-License-Identifier: GPL-2.0-or-later
// The generator asks the table of languages, a dialect or a reader for what it needs, and never which language it is.
// The languages themselves are in the folders of generator/code/languages/, and one list there has them all.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "unit/layout/source_files.hpp"

namespace flatdyn::testing {
namespace {

// The lines that ask for the language, or call what only one of them has. Naming it in a comment is allowed.
std::vector<std::string> questions(const std::vector<SourceFile>& files) {
  static const std::regex kQuestion(
      R"q(anguage[^"]*"(c\+\+|c|casadi|cuda|javascript|rust)"|dynamic_cast<[^>]*Dialect|\b(is|in)_(cuda|lanes|javascript|rust)\b|)q"
      R"q("code/languages/(c|casadi|cpp|cuda|javascript|rust)/|\b(Cpp|C|Cuda|Javascript|Rust|Lanes)Dialect\b|)q"
      R"q(\b(emit_(c|cpp|cuda|javascript|rust)|(c|casadi|cpp|cuda|javascript|rust|lanes)_(reader|language))\()q");
  static const std::regex kComment("//.*");
  std::vector<std::string> found;
  for (const SourceFile& file : files) {
    for (std::size_t k = 0; k < file.lines.size(); ++k) {
      if (!std::regex_search(std::regex_replace(file.lines[k], kComment, ""), kQuestion)) continue;
      found.push_back(
          fmt::format("generator/{}:{}: asks for the language: ask the dialect for what is needed", file.name, k + 1));
    }
  }
  return found;
}

// Everything else asks the table of languages, the dialect or the reader.
TEST(Layout, OnlyLanguagesKnowWhichTheyAre) {
  std::set<std::string> asking;
  for (const SourceFile& file : source_files("generator")) {
    if (!file.folder.starts_with("code/languages/") && !questions({file}).empty()) asking.insert(file.name);
  }
  EXPECT_EQ(asking, (std::set<std::string>{"code/emit/emit_options.hpp",            // the default
                                           "code/languages/language_table.cpp"}));  // the list
}

TEST(Layout, AQuestionForTheLanguageIsFound) {
  const std::vector<SourceFile> files = {
      {"", "emit/a.cpp", "emit", {"// language == \"c\" is gone", "int x;", "if (language == \"c++\") return;"}},
      {"", "emit/b.cpp", "emit", {"return dialect.is_javascript() ? 1 : 2;", "dynamic_cast<const CDialect*>(x);"}},
      {"", "proof/c.cpp", "proof", {"#include \"code/languages/emit.hpp\"", "#include \"code/languages/c/read.hpp\""}},
      {"", "proof/d.cpp", "proof", {"EmittedText text(emit_header(m), header_reader());", "cpp_reader();"}}};
  const std::string asks = "asks for the language: ask the dialect for what is needed";
  EXPECT_EQ(questions(files),
            (std::vector<std::string>{"generator/emit/a.cpp:3: " + asks, "generator/emit/b.cpp:1: " + asks,
                                      "generator/emit/b.cpp:2: " + asks, "generator/proof/c.cpp:2: " + asks,
                                      "generator/proof/d.cpp:2: " + asks}));
}

}  // namespace
}  // namespace flatdyn::testing
