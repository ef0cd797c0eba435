// SPDX-License-Identifier: GPL-2.0-or-later
// Tests of the harness with a stand-in for the program: a script that copies the robot file.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A source folder with two robots, and a program that "generates" NAME.hpp from robots/NAME.urdf; it fails on "bad".
class GoldenHarness : public ::testing::Test {
 protected:
  GoldenHarness() {
    for (const char* name : {"robots", "generated", "output"}) fs::create_directories(folder_.path() / name);
    write("robots/a.urdf", "one\ntwo\n");
    write("robots/b.urdf", "three\n");
    write("robots/bad.urdf", "bad\n");
    write("generated/robots.txt", "# robot  options\n\nrobots/a.urdf\nrobots/b.urdf --functions gravity\n");
    write("program",
          "#!/bin/sh\n"
          "if grep -q bad \"$2\"; then echo refused; exit 3; fi\n"
          "mkdir -p \"$4\" && cat \"$2\" > \"$4/$(basename \"$2\" .urdf).hpp\"\n");
    fs::permissions(folder_.path() / "program", fs::perms::owner_all);
  }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder_.path() / name) << text; }
  std::string run(const GoldenCase& golden) {
    return generate((folder_.path() / "program").string(), folder_.path(), golden, folder_.path() / "output");
  }
  std::vector<std::string> compare() { return differences(folder_.path() / "generated", folder_.path() / "output"); }
  int regenerate() {
    const std::string command = fmt::format(
        "cmake -D PROGRAM='{0}/program' -D SOURCE_DIR='{0}' -P '{1}/cmake/Regenerate.cmake' > '{0}/log' 2>&1",
        folder_.path().string(), FLATDYN_SOURCE_DIR);
    return std::system(command.c_str());
  }

  TemporaryFolder folder_;
};

TEST_F(GoldenHarness, ReadsTheTable) {
  const std::vector<GoldenCase> cases = read_cases(folder_.path() / "generated/robots.txt");
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].robot, "robots/a.urdf");
  EXPECT_EQ(cases[0].options, "");
  EXPECT_EQ(cases[1].options, " --functions gravity");
}

TEST_F(GoldenHarness, SeesWhatDiffers) {
  EXPECT_THAT(compare(), ElementsAre("no header was written"));
  ASSERT_EQ(run({"robots/a.urdf", ""}), "");
  EXPECT_THAT(compare(), ElementsAre("a.hpp is not checked in"));
  write("generated/a.hpp", "one\n2\n");
  EXPECT_THAT(compare(), ElementsAre("a.hpp differs from line 2 on:\n  checked in: 2\n  now:        two"));
  write("generated/a.hpp", "one\ntwo");
  EXPECT_THAT(compare(), ElementsAre("a.hpp differs in how it ends"));
  write("generated/a.hpp", "one\ntwo\n");
  EXPECT_THAT(compare(), IsEmpty());
}

TEST_F(GoldenHarness, ReportsAProgramThatFails) { EXPECT_THAT(run({"robots/bad.urdf", ""}), HasSubstr("refused")); }

TEST_F(GoldenHarness, RegenerateWritesAllAndRemovesTheOld) {
  write("generated/gone.hpp", "");
  ASSERT_EQ(regenerate(), 0) << content_of(folder_.path() / "log");
  EXPECT_EQ(content_of(folder_.path() / "generated/a.hpp"), "one\ntwo\n");
  EXPECT_EQ(content_of(folder_.path() / "generated/b.hpp"), "three\n");
  EXPECT_FALSE(fs::exists(folder_.path() / "generated/gone.hpp"));
}

TEST_F(GoldenHarness, RegenerateLeavesAllAsItWasIfTheProgramFails) {
  write("generated/a.hpp", "as it was");
  write("generated/robots.txt", "robots/a.urdf\nrobots/bad.urdf\n");
  EXPECT_NE(regenerate(), 0);
  EXPECT_EQ(content_of(folder_.path() / "generated/a.hpp"), "as it was");
}

}  // namespace
}  // namespace flatdyn::testing
