// SPDX-License-Identifier: GPL-2.0-or-later
// Every command on these pages is run as it stands, in a folder of the test's own, and prints what the page shows.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const fs::path kDocs = fs::path(FLATDYN_SOURCE_DIR) / "docs";

std::vector<std::string> lines_of(const fs::path& page) {
  std::ifstream file(page);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

// A user's folder: robots/ and docs/ are in it, outputs go beside them, and flatdyn is on the PATH.
class UsersFolder {
 public:
  UsersFolder() {
    for (const char* name : {"robots", "docs"}) {
      fs::create_directory_symlink(fs::path(FLATDYN_SOURCE_DIR) / name, folder_.path(name));
    }
  }

  // Runs a command as it stands on the page.
  Outcome run(const std::string& command) const {
    const std::string path = fs::path(FLATDYN_PROGRAM).parent_path().string();
    const int status = std::system(
        fmt::format("cd '{}' && PATH='{}':\"$PATH\" && {{ {}\n}} > log 2> err", folder_.path(), path, command).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder_.read("log"), folder_.read("err")};
  }

 private:
  Scratch folder_;
};

// The prefixes of commands in a code block.
constexpr const char* kPrompts[] = {"    flatdyn ", "    make -C out", "    cd out && cc "};
const std::string kPrints = "    → ";  // prefix of the expected output of the command before it

bool is_command(const std::string& line) {
  return std::any_of(std::begin(kPrompts), std::end(kPrompts),
                     [&line](const char* prompt) { return line.starts_with(prompt); });
}

class Page : public ::testing::TestWithParam<const char*> {};

TEST_P(Page, HasCommandsThatRunAndPrintWhatItSays) {
  const UsersFolder folder;
  std::string printed;
  int commands = 0;
  for (const std::string& line : lines_of(kDocs / GetParam())) {
    if (is_command(line)) {
      const Outcome outcome = folder.run(line);
      EXPECT_EQ(outcome.code, 0) << line << "\n" << outcome.out << outcome.err;
      printed = outcome.out;
      ++commands;
    } else if (line.starts_with(kPrints)) {
      EXPECT_THAT(printed, HasSubstr(line.substr(kPrints.size()))) << GetParam();
    }
  }
  EXPECT_GT(commands, 0);
}

TEST_P(Page, HasPicturesThatAreThere) {
  const fs::path page = kDocs / GetParam();
  const std::string picture = "](";
  for (const std::string& line : lines_of(page)) {
    if (!line.starts_with("![")) continue;
    const std::size_t begin = line.find(picture) + picture.size();
    EXPECT_TRUE(fs::exists(page.parent_path() / line.substr(begin, line.find(')', begin) - begin))) << line;
  }
}

// The page on the format begins with a plan.
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

INSTANTIATE_TEST_SUITE_P(Documents, Page,
                         ::testing::Values("../README.md", "example-7-2.md", "figure-7-15.md", "firmware.md",
                                           "loops.md", "python.md", "problems/7-01.md", "problems/7-02.md",
                                           "problems/7-03.md", "problems/7-04.md", "problems/7-05.md",
                                           "problems/7-07.md", "problems/7-08.md", "problems/7-09.md",
                                           "problems/7-10.md", "problems/7-11.md", "problems/7-12.md"),
                         [](const auto& test) {
                           std::string name = fs::path(test.param).stem().string();
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace flatdyn::testing
