// SPDX-License-Identifier: GPL-2.0-or-later
// All documents have these properties: links lead somewhere, lines of prose are short, the pages of commands have the
// words of the program, and figures that are said twice, or that the program prints, are the same.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const fs::path kSource = FLATDYN_SOURCE_DIR;

std::vector<fs::path> pages() {
  std::vector<fs::path> result = {kSource / "generator/README.md", kSource / "tests/README.md"};
  for (const auto& entry : fs::directory_iterator(kSource)) result.push_back(entry.path());
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "docs")) result.push_back(entry.path());
  std::erase_if(result, [](const fs::path& path) { return path.extension() != ".md"; });
  return result;
}

std::string text_of(const fs::path& page) {
  std::ostringstream text;
  text << std::ifstream(page).rdbuf();
  return text.str();
}

struct Line {
  int number;
  std::string text;
};

// The lines of a page that are not in a fenced block.
std::vector<Line> lines_outside_code(const fs::path& page) {
  std::ifstream file(page);
  std::vector<Line> result;
  bool in_code = false;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    const bool is_fence = line.find("```") == line.find_first_not_of(' ') && !line.empty();
    if (is_fence) in_code = !in_code;
    if (!is_fence && !in_code) result.push_back({number, line});
  }
  return result;
}

std::string place(const fs::path& page, const Line& line) {
  return fmt::format("{}:{}: ", fs::relative(page, kSource).string(), line.number);
}

// As GitHub makes it from a heading: "## Sines of your own" has #sines-of-your-own.
std::string anchor_of(const std::string& heading) {
  std::string result;
  for (const char c : heading.substr(heading.find_first_not_of("# "))) {
    if (c == ' ') result += '-';
    const bool is_kept = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || (c & 0x80) != 0;
    if (is_kept) result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

bool has_anchor(const fs::path& page, const std::string& anchor) {
  const std::vector<Line> lines = lines_outside_code(page);
  return std::any_of(lines.begin(), lines.end(), [&anchor](const Line& line) {
    return line.text.starts_with("#") && anchor_of(line.text) == anchor;
  });
}

// Empty if the link of this page leads somewhere, else what is wrong with it.
std::string fault_of(const fs::path& page, const std::string& link) {
  if (link.find("://") != std::string::npos) return "";
  const std::size_t hash = link.find('#');
  const std::string file = link.substr(0, hash);
  const fs::path target = file.empty() ? page : page.parent_path() / file;
  if (!fs::exists(target)) return "there is no file " + link;
  if (hash == std::string::npos || has_anchor(target, link.substr(hash + 1))) return "";
  return "there is no heading " + link;
}

TEST(Pages, TheCitationHasTheVersion) {
  const std::string version = run_flatdyn("--version").out.substr(std::string("flatdyn ").size());
  EXPECT_THAT(text_of(kSource / "CITATION.cff"), HasSubstr("\nversion: " + version));
}

TEST(Pages, HaveLinksThatLeadSomewhere) {
  const std::regex link_in_text(R"(\]\(([^)\s]+)\))");
  std::vector<std::string> faults;
  for (const fs::path& page : pages()) {
    for (const Line& line : lines_outside_code(page)) {
      for (std::sregex_iterator link(line.text.begin(), line.text.end(), link_in_text), end; link != end; ++link) {
        const std::string fault = fault_of(page, (*link)[1]);
        if (!fault.empty()) faults.push_back(place(page, line) + fault);
      }
    }
  }
  EXPECT_THAT(faults, IsEmpty());
}

// Tables, code, headings and pictures may be as long as they have to be. `scripts/docs` breaks other long lines.
bool is_prose(const std::string& line) {
  const char* const others[] = {"|", "    ", "#", "![", "<!--"};
  return std::none_of(std::begin(others), std::end(others),
                      [&line](const char* other) { return line.starts_with(other); });
}

std::size_t characters(const std::string& line) {
  return static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

// Lines of prose that `is_wrong`, with their places.
template <class Predicate>
std::vector<std::string> faulty_prose(Predicate is_wrong) {
  std::vector<std::string> faults;
  for (const fs::path& page : pages()) {
    for (const Line& line : lines_outside_code(page)) {
      if (is_prose(line.text) && is_wrong(line.text)) faults.push_back(place(page, line) + line.text);
    }
  }
  return faults;
}

TEST(Pages, HaveNoLineOfProseOver120Characters) {
  EXPECT_THAT(faulty_prose([](const std::string& line) { return characters(line) > 120; }), IsEmpty());
}

// "Of each joint the torque" is a riddle at first reading; the subject comes first.
TEST(Pages, HaveNoSentenceThatOpensWithOfOrWhat) {
  const std::regex opening(R"((^|[.:;] |[-*] )(Of|What) )");
  EXPECT_THAT(faulty_prose([&](const std::string& line) { return std::regex_search(line, opening); }), IsEmpty());
}

TEST(Readme, IsShort) {
  const std::string text = text_of(kSource / "README.md");
  EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 120);
}

// The commands that the program has, from its list of them: "| [`generate`](generate.md) | …".
std::vector<std::string> commands() {
  const std::regex row(R"(\| \[`(\w+)`\])");
  const std::string list = run_flatdyn("man --markdown").out;
  std::vector<std::string> result;
  for (std::sregex_iterator name(list.begin(), list.end(), row), end; name != end; ++name) result.push_back((*name)[1]);
  return result;
}

TEST(CommandPages, HaveTheWordsOfTheProgram) {
  const fs::path folder = kSource / "docs/commands";
  EXPECT_THAT(text_of(folder / "README.md"), HasSubstr(run_flatdyn("man --markdown").out)) << "run scripts/docs";
  const std::vector<std::string> names = commands();
  EXPECT_GE(names.size(), 18U);
  for (const std::string& name : names) {
    const std::string reference = run_flatdyn("man " + name + " --markdown").out;
    EXPECT_FALSE(reference.empty()) << name;
    EXPECT_THAT(text_of(folder / (name + ".md")), HasSubstr(reference)) << "run scripts/docs";
    EXPECT_THAT(text_of(kSource / "README.md"), HasSubstr(fmt::format("[`{0}`](docs/commands/{0}.md)", name)));
  }
}

// "| gravity | 82 | 40 |" → "gravity", "82", "40"
std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream stream(row.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const std::size_t begin = cell.find_first_not_of(' '), end = cell.find_last_not_of(' ');
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
  }
  return cells;
}

// The rows of a page's table that has this heading in its first cell.
std::vector<std::vector<std::string>> table_under(const fs::path& page, const std::string& heading) {
  std::vector<std::vector<std::string>> rows;
  for (const Line& line : lines_outside_code(page)) {
    const bool is_row = line.text.starts_with("| ");
    if (!rows.empty() && !is_row && !line.text.starts_with("|--")) break;
    if (is_row && (!rows.empty() || cells_of(line.text).front() == heading)) rows.push_back(cells_of(line.text));
  }
  return rows;
}

TEST(Readme, HasTheTimesOfTheBenchmark) {
  // flatdyn, fused, with libm, with given sines, in batches of doubles; KDL, MuJoCo
  const std::vector<std::size_t> columns = {0, 1, 5, 2, 4, 7, 9, 10};
  const auto measured = table_under(kSource / "docs/benchmark.md", "Panda");
  const auto shown = table_under(kSource / "README.md", "Panda");
  ASSERT_GE(shown.size(), 4U);
  for (std::size_t row = 1; row < shown.size(); ++row) {
    const auto same = std::find_if(measured.begin(), measured.end(),
                                   [&](const auto& cells) { return cells.front() == shown[row].front(); });
    ASSERT_NE(same, measured.end()) << shown[row].front();
    for (std::size_t column = 0; column < columns.size(); ++column) {
      EXPECT_EQ(shown[row].at(column), same->at(columns[column])) << shown[row].front();
    }
  }
}

// The bounds are the same whatever the number of states, and whether Gappa is asked.
TEST(CertificatesPage, OpensWithTheBoundsOfTheProgram) {
  const std::string page = text_of(kSource / "docs/certificates.md");
  const Outcome outcome =
      run_flatdyn("certify -q robots/panda.urdf --functions inverse_dynamics --states 1000 --time-limit 0 --enough 1");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::regex bound(R"(tau\[([01])\]  N m   (\S+))");
  std::vector<std::string> bounds;
  for (std::sregex_iterator row(outcome.out.begin(), outcome.out.end(), bound), end; row != end; ++row) {
    bounds.push_back((*row)[2]);
    EXPECT_THAT(page, HasSubstr(fmt::format("    tau[{}]  N m   {}", (*row)[1].str(), bounds.back())));
  }
  ASSERT_EQ(bounds.size(), 2U) << outcome.out;
  EXPECT_THAT(page, HasSubstr(fmt::format("| Panda | inverse dynamics | double | `tau[0]` | {} N m |", bounds[0])));
  EXPECT_THAT(text_of(kSource / "README.md"), HasSubstr(bounds[0] + " N m for the Panda's first joint"));
}

// Function, exactly, 50 digits: these do not depend on the machine's sines.
std::vector<std::string> proven_columns(const std::string& text) {
  const std::regex row(R"((?:^|\n) *(\w+ +equal +\S+e-\d+) )");
  std::vector<std::string> result;
  for (std::sregex_iterator found(text.begin(), text.end(), row), end; found != end; ++found) {
    result.push_back(std::regex_replace((*found)[1].str(), std::regex(" +"), " "));
  }
  return result;
}

TEST(AccuracyPage, HasTheRowsOfVerify) {
  const std::vector<std::string> shown = proven_columns(text_of(kSource / "docs/accuracy.md"));
  EXPECT_EQ(shown.size(), 5U);
  const Outcome outcome = run_flatdyn(
      "verify -q robots/panda.urdf --functions inverse_dynamics,inertia_matrix,christoffel,gravity,forward_dynamics");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(proven_columns(outcome.out), shown);
}

// Multiplications and additions per function, as the checked-in output states them, which `ctest -R Golden` holds.
std::map<std::string, std::pair<int, int>> operations_of(const std::string& robot) {
  const std::regex operations(R"(Operations:\s+(\d+) mul, (\d+) add)"),
      function(R"(^(?:\[\[nodiscard\]\] )?static inline \w+ (\w+)\()");
  std::ifstream header(kSource / "generated" / (robot + ".hpp"));
  std::map<std::string, std::pair<int, int>> result;
  std::pair<int, int> counts = {-1, -1};  // of the comment above
  for (std::string line; std::getline(header, line);) {
    std::smatch match;
    if (std::regex_search(line, match, operations)) {
      counts = {std::stoi(match[1]), std::stoi(match[2])};
    } else if (counts.first >= 0 && std::regex_search(line, match, function)) {
      result[match[1]] = counts;
      counts.first = -1;
    }
  }
  return result;
}

// "Coriolis matrix" → "coriolis_matrix"
std::string function_called(const std::string& words) {
  if (words == "all Christoffel symbols") return "christoffel";
  std::string name;
  for (const char c : words) name += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

// docs/robots.md has multiplications and additions, docs/operation-counts.md their sums for `generate` without
// --search.
class OperationTables : public ::testing::TestWithParam<std::string> {};

TEST_P(OperationTables, AreThoseOfTheCheckedInOutput) {
  const auto operations = operations_of(GetParam());
  ASSERT_GE(operations.size(), 10U);
  // Where the robot's column is; the Puma 560 of the second page has links alone.
  const std::map<std::string, std::pair<std::size_t, std::size_t>> columns = {
      {"panda", {1, 2}}, {"ur5", {2, 5}}, {"puma560", {3, 0}}, {"rx90", {4, 3}}};
  const auto [in_robots, in_counts] = columns.at(GetParam());
  const auto robots = table_under(kSource / "docs/robots.md", "function");
  ASSERT_EQ(robots.size(), 5U);
  for (std::size_t row = 1; row < robots.size(); ++row) {
    const auto [mul, add] = operations.at(function_called(robots[row].front()));
    EXPECT_EQ(robots[row].at(in_robots), fmt::format("{} / {}", mul, add)) << robots[row].front();
  }
  if (in_counts == 0) return;
  int rows = 0;
  for (const auto& cells : table_under(kSource / "docs/operation-counts.md", "function")) {
    if (cells.at(1) != "usual choices") continue;
    const auto [mul, add] = operations.at(function_called(cells.front()));
    EXPECT_EQ(cells.at(in_counts), std::to_string(mul + add)) << cells.front();
    ++rows;
  }
  EXPECT_EQ(rows, 6);
}

INSTANTIATE_TEST_SUITE_P(Documents, OperationTables, ::testing::Values("panda", "ur5", "puma560", "rx90"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace flatdyn::testing
