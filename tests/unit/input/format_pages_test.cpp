// SPDX-License-Identifier: GPL-2.0-or-later
// The pages on formats of robots say what the schemas of their readers have: every name that is read stands in its
// page, and every element of the page's tables stands in its reader.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "base/system/process.hpp"
#include "robot/input/mjcf/schema.hpp"
#include "robot/input/sdf/schema.hpp"
#include "robot/input/urdf/schema.hpp"

namespace flatdyn {
namespace {

using Names = std::set<std::string>;

std::string page_of(const std::string& format) {
  return content_of_file(std::string(FLATDYN_SOURCE_DIR) + "/docs/robot-format/" + format + ".md");
}

Names matches(const std::string& text, const std::regex& pattern) {
  Names found;
  for (std::sregex_iterator k(text.begin(), text.end(), pattern), end; k != end; ++k) found.insert((*k)[1]);
  return found;
}

// The words between backticks: joint, type and revolute of `<joint type="revolute">`.
Names words_in_code(const std::string& page) {
  Names words;
  for (const std::string& code : matches(page, std::regex("`([^`\n]+)`"))) {
    words.merge(matches(code, std::regex("([A-Za-z_][A-Za-z0-9_:]*)")));
  }
  return words;
}

// The elements in the first column of tables.
Names elements_in_tables(const std::string& page) {
  Names elements;
  for (const std::string& cell : matches(page, std::regex("\n\\| ([^|\n]*)"))) {
    elements.merge(matches(cell, std::regex("<([A-Za-z_][A-Za-z0-9_:]*)")));
  }
  return elements;
}

// The words in the texts that stand in a reader.
Names words_of_reader(const std::string& format) {
  Names words;
  const std::filesystem::path folder = std::filesystem::path(FLATDYN_SOURCE_DIR) / "generator/robot/input" / format;
  for (const std::filesystem::directory_entry& file : std::filesystem::directory_iterator(folder)) {
    for (const std::string& text : matches(content_of_file(file.path()), std::regex("\"([^\"\n]*)\""))) {
      words.merge(matches(text, std::regex("([A-Za-z_][A-Za-z0-9_:]*)")));
    }
  }
  return words;
}

Names names_read_by(const Schema& schema) {
  Names names;
  for (const SchemaRow& row : schema.rows()) {
    for (const SchemaNames* each : {&row.attributes, &row.children}) {
      names.insert(each->read().begin(), each->read().end());
    }
  }
  return names;
}

// Some names are put together: "parent" and "_axis".
bool is_known(const std::string& element, const Names& words) {
  const std::size_t end = std::min(element.rfind('_'), element.size());
  return words.contains(element) || (words.contains(element.substr(0, end)) && words.contains(element.substr(end)));
}

struct FormatPage {
  std::string name;
  const Schema& schema;
};

void PrintTo(const FormatPage& page, std::ostream* stream) { *stream << page.name; }

class FormatPages : public ::testing::TestWithParam<FormatPage> {};

TEST_P(FormatPages, NameAllThatIsRead) {
  const Names words = words_in_code(page_of(GetParam().name));
  for (const std::string& name : names_read_by(GetParam().schema)) {
    EXPECT_TRUE(words.contains(name)) << "docs/robot-format/" << GetParam().name << ".md does not say `" << name << "`";
  }
}

TEST_P(FormatPages, HaveNoElementInTheirTablesThatNoReaderKnows) {
  const Names words = words_of_reader(GetParam().name);
  for (const std::string& element : elements_in_tables(page_of(GetParam().name))) {
    EXPECT_TRUE(is_known(element, words)) << "docs/robot-format/" << GetParam().name << ".md: <" << element << ">";
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, FormatPages,
                         ::testing::Values(FormatPage{"sdf", sdf_schema()}, FormatPage{"mjcf", mjcf_schema()},
                                           FormatPage{"urdf", urdf_schema()}),
                         [](const auto& format) { return format.param.name; });

}  // namespace
}  // namespace flatdyn
