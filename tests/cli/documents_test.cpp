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

const fs::path kPythonOfPeers =
    fs::path(FLATDYN_SOURCE_DIR) / "build" / "peers" / "bin";  // Python with numpy and CasADi

// A user's folder: robots/, docs/ and runtime/ are in it, outputs go beside them, and flatdyn is on the PATH.
class UsersFolder {
 public:
  UsersFolder() {
    for (const char* name : {"robots", "docs", "runtime"}) {
      fs::create_directory_symlink(fs::path(FLATDYN_SOURCE_DIR) / name, folder_.path(name));
    }
  }

  // Runs a command as it stands on the page.
  Outcome run(const std::string& command) const {
    const std::string path = fs::path(FLATDYN_PROGRAM).parent_path().string();
    const int status = std::system(fmt::format("cd '{}' && PATH='{}':'{}':\"$PATH\" && {{ {}\n}} > log 2> err",
                                               folder_.path(), path, kPythonOfPeers.string(), command)
                                       .c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder_.read("log"), folder_.read("err")};
  }

  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
  std::string read(const std::string& name) const { return folder_.read(name); }

 private:
  Scratch folder_;
};

// The prefixes of commands in a code block.
constexpr const char* kPrompts[] = {"    flatdyn ", "    make -C out", "    cd out && cc ", "    cc ",     "    g++ ",
                                    "    ./",       "    node ",       "    cargo ",        "    python3 "};
const std::string kPrints = "    → ";  // prefix of the expected output of the command before it

bool is_command(const std::string& line) {
  return std::any_of(std::begin(kPrompts), std::end(kPrompts),
                     [&line](const char* prompt) { return line.starts_with(prompt); });
}

// "…, `arm.toml`:" names the file whose text follows.
std::string file_that_follows(const std::string& line) {
  if (!line.ends_with("`:")) return "";
  const std::size_t begin = line.rfind('`', line.size() - 3);
  return line.substr(begin + 1, line.size() - begin - 3);
}

// "lines of `out/arm.hpp`" names the file that has the text that follows.
std::string file_that_is_quoted(const std::string& line) {
  const std::string words = "lines of `";
  const std::size_t begin = line.find(words);
  if (begin == std::string::npos) return "";
  return line.substr(begin + words.size(), line.find('`', begin + words.size()) - begin - words.size());
}

// A page as it is read from top to bottom, with everything done that it says.
class Reading {
 public:
  explicit Reading(const std::string& page) : page_(page) {}

  void read(const std::string& line) {
    if (line.starts_with("```")) {
      if (in_code_) end_code();
      in_code_ = !in_code_;
    } else if (in_code_) {
      code_ += line + "\n";
    } else if (is_command(line)) {
      run(line);
    } else if (line.starts_with(kPrints)) {
      EXPECT_THAT(printed_, HasSubstr(line.substr(kPrints.size()))) << page_;
    } else if (!line.empty()) {
      file_ = file_that_follows(line);
      quoted_ = file_that_is_quoted(line);
    }
  }
  int commands() const { return commands_; }

 private:
  void run(const std::string& line) {
    const Outcome outcome = folder_.run(line);
    EXPECT_EQ(outcome.code, 0) << line << "\n" << outcome.out << outcome.err;
    printed_ = outcome.out;
    ++commands_;
  }

  void end_code() {
    if (!file_.empty()) folder_.write(file_, code_);
    if (!quoted_.empty()) {
      EXPECT_THAT(folder_.read(quoted_), HasSubstr(code_)) << page_;
    }
    file_ = quoted_ = code_ = "";
  }

  std::string page_;
  UsersFolder folder_;
  std::string printed_, code_, file_, quoted_;
  bool in_code_ = false;
  int commands_ = 0;
};

class Page : public ::testing::TestWithParam<const char*> {};

TEST_P(Page, HasCommandsThatRunAndPrintWhatItSays) {
  const bool needs_cargo = std::string(GetParam()) == "rust.md";
  if (needs_cargo && std::system("cargo --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "cargo is not installed";
  const bool needs_peers = std::string(GetParam()) == "control.md";
  if (needs_peers && !fs::exists(kPythonOfPeers)) GTEST_SKIP() << "build/peers is not there: scripts/setup makes it";
  Reading reading(GetParam());
  for (const std::string& line : lines_of(kDocs / GetParam())) reading.read(line);
  EXPECT_GT(reading.commands(), 0);
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
                         ::testing::Values("../README.md", "casadi.md", "control.md", "derivatives.md",
                                           "example-7-2.md", "figure-7-15.md", "firmware.md", "generated-code.md",
                                           "javascript.md", "loops.md", "python.md", "rust.md", "tutorial.md",
                                           "problems/7-01.md", "problems/7-02.md", "problems/7-03.md",
                                           "problems/7-04.md", "problems/7-05.md", "problems/7-07.md",
                                           "problems/7-08.md", "problems/7-09.md", "problems/7-10.md",
                                           "problems/7-11.md", "problems/7-12.md"),
                         [](const auto& test) {
                           std::string name = fs::path(test.param).stem().string();
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace flatdyn::testing
