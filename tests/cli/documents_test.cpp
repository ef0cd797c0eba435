// SPDX-License-Identifier: GPL-2.0-or-later
// Every command that these pages give is run as it stands, but that out/ is a folder of the test's own.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kDocs = fs::path(FLATDYN_SOURCE_DIR) / "docs";

std::vector<std::string> lines_of(const fs::path& page) {
  std::ifstream file(page);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

// Without "flatdyn", with the test's folder for out/.
std::vector<std::string> commands_of(const fs::path& page, const Scratch& scratch) {
  const std::string prefix = "    flatdyn ", output = " out/";
  std::vector<std::string> commands;
  for (const std::string& line : lines_of(page)) {
    if (!line.starts_with(prefix)) continue;
    std::string command = line.substr(prefix.size());
    for (std::size_t at = command.find(output); at != std::string::npos; at = command.find(output, at + 1)) {
      command.replace(at, output.size(), " " + scratch.path());
    }
    commands.push_back(command);
  }
  return commands;
}

class Page : public ::testing::TestWithParam<const char*> {};

TEST_P(Page, HasCommandsThatRunAndPicturesThatAreThere) {
  const Scratch scratch;
  const fs::path page = kDocs / GetParam();
  const std::vector<std::string> commands = commands_of(page, scratch);
  EXPECT_FALSE(commands.empty());
  for (const std::string& command : commands) {
    const Outcome outcome = run_flatdyn(command);
    EXPECT_EQ(outcome.code, 0) << command << "\n" << outcome.err;
  }
  const std::string picture = "](";
  for (const std::string& line : lines_of(page)) {
    if (!line.starts_with("![")) continue;
    const std::size_t begin = line.find(picture) + picture.size();
    EXPECT_TRUE(fs::exists(page.parent_path() / line.substr(begin, line.find(')', begin) - begin))) << line;
  }
}

// The page of the format opens with a plan.
TEST(TrajectoryFormat, HasAnExampleThatRuns) {
  const Scratch scratch;
  std::string plan;
  bool inside = false;
  for (const std::string& line : lines_of(kDocs / "trajectory-format.md")) {
    if (line.starts_with("```")) {
      inside = line == "```toml";
    } else if (inside) {
      plan += line + "\n";
    }
  }
  scratch.write("plan.toml", plan);
  const Outcome outcome = run_flatdyn("torques robots/planar_2r_example_7_2.toml --trajectory " +
                                      scratch.path("plan.toml") + " -o " + scratch.path("out.csv"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(scratch.path("out.csv")));
}

INSTANTIATE_TEST_SUITE_P(Documents, Page, ::testing::Values("example-7-2.md", "problems/7-07.md", "problems/7-09.md"),
                         [](const auto& test) {
                           std::string name = fs::path(test.param).stem().string();
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace flatdyn::testing
