// SPDX-License-Identifier: GPL-2.0-or-later
// Sources of one folder may be compiled as one file (cmake/UnityByFolder.cmake), which joins their anonymous
// namespaces. So no two files of a folder may use one name for a local function, type or constant, and none of these
// may have the name of a type or constant of a header, which another file of the folder may include.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "unit/layout/source_files.hpp"

namespace flatdyn::testing {
namespace {

std::string without_text(std::string line) {
  static const std::regex kQuoted(R"("(\\.|[^"\\])*"|'(\\.|[^'\\])')"), kComment("//.*");
  line = std::regex_replace(line, kQuoted, "0");
  return std::regex_replace(line, kComment, "");
}

// The name declared by an unindented line, or an empty string.
std::string declared_name(const std::string& line) {
  static const std::regex kType(R"(^(struct|class|enum class|union) (\w+).*)");
  static const std::regex kFunction(R"(^[\w:]+(<.*>)?[\w:&* ]*?[ &*](\w+)\(.*)");
  static const std::regex kConstant(R"(^(inline )?(constexpr|const|static)\b.*?[ &*](\w+)(\[[^\]]*\])? *[={].*)");
  std::smatch match;
  if (std::regex_match(line, match, kType)) return match[2];
  if (std::regex_match(line, match, kFunction)) return match[2];
  if (std::regex_match(line, match, kConstant)) return match[3];
  return "";
}

// The name of a type or constant that an unindented line declares, or an empty string.
std::string declared_type(const std::string& line) {
  static const std::regex kFunction(R"(^(constexpr |const |static |inline )?[\w:]+(<.*>)?[\w:&* ]*?[ &*]\w+\(.*)");
  static const std::regex kAlias(R"(^using (\w+) = .*)");
  std::smatch match;
  if (std::regex_match(line, match, kAlias)) return match[1];
  return std::regex_match(line, kFunction) ? "" : declared_name(line);
}

// The names that lines declare, by `declared`, in the anonymous namespaces of a file, or in the others. The file is
// formatted by clang-format, which does not indent in namespaces.
std::set<std::string> names_in(const std::vector<std::string>& lines, bool anonymous,
                               std::string (*declared)(const std::string&)) {
  std::set<std::string> names;
  std::vector<bool> is_anonymous;  // one per open namespace
  long depth = 0;
  bool in_raw_text = false;
  for (const std::string& each : lines) {
    if (in_raw_text) {
      in_raw_text = each.find(")\"") == std::string::npos;
      continue;
    }
    in_raw_text = each.find("R\"(") != std::string::npos && each.find(")\"") == std::string::npos;
    const std::string line = without_text(each);
    if (line.starts_with("namespace ")) {
      is_anonymous.push_back(line.starts_with("namespace {"));
    } else if (line.starts_with("}") && depth == 0 && !is_anonymous.empty()) {
      is_anonymous.pop_back();
    } else {
      if (depth == 0 && !is_anonymous.empty() && is_anonymous.back() == anonymous) names.insert(declared(line));
      depth += std::count(line.begin(), line.end(), '{') - std::count(line.begin(), line.end(), '}');
    }
  }
  names.erase("");
  return names;
}

std::vector<std::string> names_twice(const std::vector<SourceFile>& files) {
  std::map<std::pair<std::string, std::string>, std::string> first;  // file by folder and name
  std::vector<std::string> twice;
  for (const SourceFile& file : files) {
    if (file.path.extension() != ".cpp") continue;
    for (const std::string& name : names_in(file.lines, true, declared_name)) {
      const auto [known, is_new] = first.emplace(std::pair(file.folder, name), file.name);
      if (!is_new)
        twice.push_back(fmt::format("{}: {} is a name of {}, too: rename one", file.name, name, known->second));
    }
  }
  return twice;
}

// Whether the names of a header stand in a namespace of their own, so that others are written beside them.
bool is_qualified(const SourceFile& header) {
  return std::any_of(header.lines.begin(), header.lines.end(),
                     [](const std::string& line) { return line.starts_with("namespace flatdyn::"); });
}

std::vector<std::string> names_that_hide_a_header(const std::vector<SourceFile>& files) {
  std::map<std::string, std::string> headers;  // by name
  for (const SourceFile& file : files) {
    if (file.path.extension() != ".hpp" || is_qualified(file)) continue;
    for (const std::string& name : names_in(file.lines, false, declared_type)) headers.emplace(name, file.name);
  }
  std::vector<std::string> hidden;
  for (const SourceFile& file : files) {
    if (file.path.extension() != ".cpp") continue;
    for (const std::string& name : names_in(file.lines, true, declared_type)) {
      const auto header = headers.find(name);
      if (header != headers.end())
        hidden.push_back(fmt::format("{}: {} is a name of {}, too: rename it", file.name, name, header->second));
    }
  }
  return hidden;
}

TEST(Layout, FilesOfAFolderHaveNoAnonymousNameInCommon) {
  for (const std::string& each : names_twice(source_files("generator"))) ADD_FAILURE() << "generator/" << each;
}

TEST(Layout, NoAnonymousNameIsThatOfAHeader) {
  for (const std::string& each : names_that_hide_a_header(source_files("generator")))
    ADD_FAILURE() << "generator/" << each;
}

TEST(Layout, AnAnonymousNameOfAHeaderIsFound) {
  const std::vector<std::string> header = {
      "namespace flatdyn {",    "struct Place;", "using Form = int;",          "constexpr int kMost = 3;",
      "int sum(const int&);",   "class Line {",  "  struct Inner {};",         "};",
      "namespace detail {",     "struct Bit {",  "};  // \"struct Word {};\"", "}",
      "}  // namespace flatdyn"};
  const std::vector<std::string> source = {"namespace flatdyn {",
                                           "namespace {",
                                           "class Place {",
                                           "};",
                                           "constexpr double kMost = 2;",
                                           "struct Form {};",
                                           "int sum(const int& a) { return a; }",
                                           "struct Inner {};",
                                           "}  // namespace",
                                           "struct Line {};",
                                           "}  // namespace flatdyn"};
  const std::vector<SourceFile> files = {{"a.hpp", "a.hpp", "", header}, {"b.cpp", "b.cpp", "", source}};
  EXPECT_EQ(names_that_hide_a_header(files),
            (std::vector<std::string>{"b.cpp: Form is a name of a.hpp, too: rename it",
                                      "b.cpp: Place is a name of a.hpp, too: rename it",
                                      "b.cpp: kMost is a name of a.hpp, too: rename it"}));
}

TEST(Layout, AnAnonymousNameInTwoFilesIsFound) {
  const std::vector<std::string> first = {"namespace flatdyn {",
                                          "namespace {",
                                          "double sum(const Robot& robot) {",
                                          "  return 0;",
                                          "}",
                                          "constexpr int kMost = 3;",
                                          "struct Row {};",
                                          "}  // namespace",
                                          "int open() { return 1; }",
                                          "}  // namespace flatdyn"};
  const std::vector<std::string> second = {"namespace {", "std::vector<int> sum(int x);",
                                           "class Row;",  "constexpr const char* kMost = \"}\";",
                                           "int open();", "}"};
  const std::vector<SourceFile> files = {{"a.cpp", "a.cpp", "", first}, {"b.cpp", "b.cpp", "", second}};
  EXPECT_EQ(names_twice(files), (std::vector<std::string>{"b.cpp: Row is a name of a.cpp, too: rename one",
                                                          "b.cpp: kMost is a name of a.cpp, too: rename one",
                                                          "b.cpp: sum is a name of a.cpp, too: rename one"}));
}

}  // namespace
}  // namespace flatdyn::testing
