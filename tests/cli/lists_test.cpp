// SPDX-License-Identifier: GPL-2.0-or-later
// Formats of robot files and languages of generated code are named in many places. All name those that the program has.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "base/system/process.hpp"
#include "cli/program.hpp"
#include "robot/input/formats.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path kSources = FLATDYN_SOURCE_DIR;

std::vector<std::string> formats() { return {kRobotFormats.begin(), kRobotFormats.end()}; }

// The languages of the program's own description: "Flat, dependency-free C++, C or Python for the dynamics".
std::vector<std::string> languages() {
  const std::string help = run_flatdyn("--help").out;
  std::smatch found;
  if (!std::regex_search(help, found, std::regex("dependency-free ([^.]*?)\\s+for\\s+the"))) return {};
  const std::string list = found[1];
  const std::regex name("[A-Z][A-Za-z+]*");
  return {std::sregex_token_iterator(list.begin(), list.end(), name), {}};
}

// Whether a text has the name by itself: "C" is not in "C++".
bool has_name(const std::string& text, const std::string& name) {
  const auto is_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+'; };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const bool begins = at == 0 || !is_of_name(text[at - 1]);
    const bool ends = at + name.size() == text.size() || !is_of_name(text[at + name.size()]);
    if (begins && ends) return true;
  }
  return false;
}

// The first part of a page, which says what the program is.
std::string opening_of(const char* file, std::size_t length) {
  return content_of_file(kSources / file).substr(0, length);
}

void expect_all(const std::string& text, const std::vector<std::string>& names, const char* place) {
  for (const std::string& name : names) EXPECT_TRUE(has_name(text, name)) << place << " does not name " << name;
}

// The text between two others.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  if (from == std::string::npos) return "";
  return text.substr(from, text.find(end, from) - from);
}

TEST(Formats, AreTheSameWhereverTheyAreListed) {
  ASSERT_GE(formats().size(), 5U);
  EXPECT_THAT(run_flatdyn("inspect --help").out, HasSubstr("robot file: " + robot_formats_text()));
  expect_all(opening_of("README.md", 400), formats(), "README.md");
  expect_all(opening_of("SECURITY.md", 500), formats(), "SECURITY.md");
  expect_all(between(content_of_file(kSources / "docs/commands/README.md"), "Every command", "It prints"), formats(),
             "docs/commands/README.md");
  const std::string cmake = content_of_file(kSources / "cmake/FlatdynGenerate.cmake");
  expect_all(between(cmake, "#   ROBOT file", "\n"), formats(), "cmake/FlatdynGenerate.cmake");
  expect_all(between(cmake, "ROBOT is missing", "\n"), formats(), "the message of cmake/FlatdynGenerate.cmake");
  expect_all(between(content_of_file(kSources / "cmake/DebianPackage.cmake"), "PACKAGE_DESCRIPTION \"", "\")"),
             formats(), "the Debian package");
}

TEST(Languages, AreTheSameWhereverTheyAreListed) {
  const std::vector<std::string> names = languages();
  ASSERT_GE(names.size(), 5U);
  const std::string help = run_flatdyn("generate --help").out;
  std::string options = between(help, "--language TEXT:{", "}");
  for (const std::string& name : names) {
    std::string option = name;
    for (char& c : option) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    EXPECT_TRUE(has_name(options, option)) << options << " has no " << option;
  }
  EXPECT_EQ(std::count(options.begin(), options.end(), ',') + 1, static_cast<std::ptrdiff_t>(names.size()));
  expect_all(opening_of("README.md", 200), names, "README.md");
  expect_all(opening_of("SECURITY.md", 500), names, "SECURITY.md");
  expect_all(between(content_of_file(kSources / "cmake/DebianPackage.cmake"), "PACKAGE_DESCRIPTION \"", "\")"), names,
             "the Debian package");
}

// CMake makes libraries to link with, in every language that can be linked.
TEST(Languages, OfCMakeAreThoseThatLink) {
  const std::string cmake = content_of_file(kSources / "cmake/FlatdynGenerate.cmake");
  const std::string listed = between(cmake, "[LANGUAGE ", "]");
  for (const char* name : {"c++", "c", "cuda"}) EXPECT_TRUE(has_name(listed, name)) << listed;
  EXPECT_THAT(cmake, HasSubstr("LANGUAGE is c, c++ or cuda"));
}

}  // namespace
}  // namespace flatdyn::testing
