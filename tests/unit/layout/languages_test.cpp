// SPDX-License-Identifier: GPL-2.0-or-later
// Files of generator/emit/ are the same for all languages: they ask a dialect for what they need, and never which
// language it is. The languages themselves are in generator/emit/languages/, and one switch there chooses among them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "unit/layout/source_files.hpp"

namespace flatdyn::testing {
namespace {

// The lines that ask for the language. Naming it in a comment is allowed.
std::vector<std::string> questions(const std::vector<SourceFile>& files) {
  static const std::regex kQuestion(
      R"(\b(Language::|options_?\.language|dynamic_cast|typeid|(is|in)_(c|cpp|cuda|lanes|javascript)\b))");
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

// The files of a folder, without those of folders in it.
std::vector<SourceFile> files_of(const std::string& folder) {
  std::vector<SourceFile> files;
  for (SourceFile& file : source_files("generator")) {
    if (file.folder == folder) files.push_back(std::move(file));
  }
  return files;
}

TEST(Layout, OnlyLanguagesKnowWhichTheyAre) {
  std::vector<SourceFile> files = files_of("emit");
  for (const char* folder : {"code", "lower"}) {
    for (SourceFile& file : files_of(folder)) files.push_back(std::move(file));
  }
  std::erase_if(files,
                [](const SourceFile& file) { return file.name == "emit/emit_options.hpp"; });  // the option itself
  EXPECT_GT(files.size(), 30U);
  for (const std::string& each : questions(files)) ADD_FAILURE() << each;
}

TEST(Layout, OneSwitchChoosesTheLanguage) {
  std::set<std::string> asking;
  for (const SourceFile& file : source_files("generator")) {
    if (!questions({file}).empty() && file.folder.starts_with("emit")) asking.insert(file.name);
  }
  EXPECT_EQ(asking, (std::set<std::string>{"emit/emit_options.hpp", "emit/languages/emit.cpp"}));
}

TEST(Layout, AQuestionForTheLanguageIsFound) {
  const std::vector<SourceFile> files = {
      {"", "emit/a.cpp", "emit", {"// is_c() is gone", "int x;", "if (options.language == other) return;"}},
      {"", "emit/b.cpp", "emit", {"return dialect.is_javascript() ? 1 : 2;", "Language::c", "basis_c = 1;"}}};
  const std::string asks = "asks for the language: ask the dialect for what is needed";
  EXPECT_EQ(questions(files),
            (std::vector<std::string>{"generator/emit/a.cpp:3: " + asks, "generator/emit/b.cpp:1: " + asks,
                                      "generator/emit/b.cpp:2: " + asks}));
}

}  // namespace
}  // namespace flatdyn::testing
