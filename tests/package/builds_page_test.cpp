// SPDX-License-Identifier: GPL-2.0-or-later
// docs/builds.md is executed from its text: the files that it shows are written, and its commands run as they stand, in
// a folder of the test's own, and print what it shows.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// A built checkout, with a home folder of its own to install to.
class Checkout {
 public:
  Checkout() {
    const fs::path source = FLATDYN_SOURCE_DIR;
    for (const char* name : {"robots", "docs"}) fs::create_directory_symlink(source / name, folder_.path(name));
    fs::create_directory(folder_.path("build"));
    fs::create_directory_symlink(FLATDYN_BUILD_DIR, folder_.path("build/release"));
    fs::create_directory(folder_.path("home"));
  }

  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }

  bool run(const std::string& command) const {
    const std::string home = folder_.path("home");
    return std::system(fmt::format("cd '{}' && export HOME='{}' PATH='{}/.local/bin':\"$PATH\" && {{ {}\n}} > log 2>&1",
                                   folder_.path(), home, home, command)
                           .c_str()) == 0;
  }
  std::string log() const { return folder_.read("log"); }

 private:
  Scratch folder_;
};

// "`CMakeLists.txt`:" is the name of the file that follows.
std::string file_name(const std::string& line) {
  const bool is_name = line.size() > 3 && line.front() == '`' && line.ends_with("`:");
  return is_name ? line.substr(1, line.size() - 3) : "";
}

// A step of the page, in its order.
struct Step {
  enum class Kind { command, prints, file } kind;
  std::string text;
  std::string name = {};  // name of the file
};

std::vector<Step> steps_of(std::ifstream page) {
  const std::string command = "    ", prints = "    → ";
  std::vector<Step> steps;
  std::string name;
  bool inside = false;  // inside a fence
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside && !name.empty()) steps.push_back({Step::Kind::file, "", name});
      if (!inside) name.clear();
    } else if (inside) {
      if (!name.empty()) steps.back().text += line + "\n";
    } else if (line.starts_with(prints)) {
      steps.push_back({Step::Kind::prints, line.substr(prints.size())});
    } else if (line.starts_with(command)) {
      steps.push_back({Step::Kind::command, line.substr(command.size())});
    } else if (!line.empty()) {
      name = file_name(line);
    }
  }
  return steps;
}

// Whether another test covers the command: the build is done, IsADebianPackage makes the package, and scripts/package
// installs what a release has.
bool is_done_elsewhere(const std::string& command) {
  return command.starts_with("cmake --preset") || command.starts_with("pip install ./flatdyn-") ||
         command.find("sudo apt") != std::string::npos;
}

TEST(BuildsPage, HasFilesAndCommandsThatRunAndPrintWhatItSays) {
  const Checkout checkout;
  int commands = 0, files = 0, lines = 0;
  for (const Step& step : steps_of(std::ifstream(FLATDYN_SOURCE_DIR "/docs/builds.md"))) {
    switch (step.kind) {
      case Step::Kind::file:
        checkout.write(step.name, step.text);
        ++files;
        break;
      case Step::Kind::command:
        if (is_done_elsewhere(step.text)) break;
        ASSERT_TRUE(checkout.run(step.text)) << step.text << "\n" << checkout.log();
        ++commands;
        break;
      case Step::Kind::prints:
        EXPECT_THAT(checkout.log(), HasSubstr(step.text));
        ++lines;
        break;
    }
  }
  EXPECT_GE(files, 3);
  EXPECT_GE(commands, 9);
  EXPECT_GE(lines, 2);
}

}  // namespace
}  // namespace flatdyn::testing
