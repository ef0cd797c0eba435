// SPDX-License-Identifier: GPL-2.0-or-later
// What is left in the output folder when a run is killed, has no room, may not write, or is not alone: the files of one
// run, whole, or nothing new.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/program.hpp"
#include "input/content_hash.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

// Of two kinds, so that a mixture would be seen.
std::string options(bool is_float, const std::string& folder) {
  return fmt::format("generate robots/planar_2r.toml -q --functions gravity,bias -o {}{}", folder,
                     is_float ? " --scalar float" : "");
}

bool belong_together(const Scratch& scratch) {
  const std::string header = scratch.read("planar_2r.hpp");
  const auto manifest = nlohmann::json::parse(scratch.read("planar_2r.json"), nullptr, false);
  return !manifest.is_discarded() && manifest["header_hash"] == content_hash({header});
}

std::size_t files_in(const Scratch& scratch) {
  const std::filesystem::directory_iterator folder(scratch.path());
  return static_cast<std::size_t>(std::distance(begin(folder), end(folder)));
}

// Started without a shell between, so that a signal reaches it.
pid_t started(const std::string& arguments) {
  const std::string command =
      fmt::format("cd '{}' && exec '{}' {} > /dev/null 2>&1", FLATDYN_SOURCE_DIR, FLATDYN_PROGRAM, arguments);
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  return child;
}

// The two files are renamed one after the other: a kill between leaves a new header beside an old manifest, and the
// manifest's hash says so.
TEST(Output, IsWholeWhenTheRunIsKilledAtAnyMoment) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn(options(false, scratch.path())).code, 0);
  const std::string header = scratch.read("planar_2r.hpp"), manifest = scratch.read("planar_2r.json");
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run_flatdyn(options(true, scratch.path())).code, 0);
  const auto whole = std::chrono::steady_clock::now() - start;
  const std::string other_header = scratch.read("planar_2r.hpp"), other_manifest = scratch.read("planar_2r.json");
  ASSERT_NE(header, other_header);
  ASSERT_NE(manifest, other_manifest);
  constexpr int kKills = 24;
  for (int k = 0; k < kKills; ++k) {
    const pid_t child = started(options(k % 2 == 0, scratch.path()));
    // Over all of a run, and more often about its end, where it writes.
    std::this_thread::sleep_for(k % 3 == 0 ? whole * k / kKills : whole * 3 / 4 + whole * k / (2 * kKills));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const bool is_first_header = scratch.read("planar_2r.hpp") == header;
    const bool is_first_manifest = scratch.read("planar_2r.json") == manifest;
    ASSERT_TRUE(is_first_header || scratch.read("planar_2r.hpp") == other_header) << k;
    ASSERT_TRUE(is_first_manifest || scratch.read("planar_2r.json") == other_manifest) << k;
    ASSERT_EQ(belong_together(scratch), is_first_header == is_first_manifest) << k;
  }
}

TEST(Output, StaysAsItWasWhenThereIsNoRoom) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn(options(false, scratch.path())).code, 0);
  const std::string header = scratch.read("planar_2r.hpp");
  // No file may have more than two kilobytes. Once as an error, once as a signal.
  const std::string limited = fmt::format("ulimit -f 2; cd '{}'; '{}' {} 2>&1", FLATDYN_SOURCE_DIR, FLATDYN_PROGRAM,
                                          options(true, scratch.path()));
  const int error = std::system(fmt::format("bash -c \"trap '' XFSZ; {}\" > /dev/null", limited).c_str());
  EXPECT_EQ(WEXITSTATUS(error), 6);
  EXPECT_EQ(files_in(scratch), 2u);
  EXPECT_NE(std::system(fmt::format("bash -c \"{}\" > /dev/null 2>&1", limited).c_str()), 0);
  EXPECT_EQ(scratch.read("planar_2r.hpp"), header);
  EXPECT_TRUE(belong_together(scratch));
}

TEST(Output, IsRefusedWhereNothingCanBeWritten) {
  const Outcome outcome = run_flatdyn(options(false, "/proc/flatdyn"));
  EXPECT_EQ(outcome.code, 6);
  EXPECT_THAT(outcome.err, HasSubstr("/proc/flatdyn"));
  EXPECT_THAT(outcome.err, HasSubstr("cannot be written"));
}

TEST(Output, SaysSoWhenStandardOutputIsFull) {
  const Scratch scratch;
  const std::string command = fmt::format("cd '{}' && '{}' {} > /dev/full 2> '{}'", FLATDYN_SOURCE_DIR, FLATDYN_PROGRAM,
                                          options(false, scratch.path("out")), scratch.path("err"));
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 6);
  EXPECT_THAT(scratch.read("err"), HasSubstr("No space left on device"));
}

TEST(Output, IsOfOneRunWhenSeveralWriteToOneFolder) {
  const Scratch scratch;
  for (int round = 0; round < 6; ++round) {
    std::vector<pid_t> children;
    for (int k = 0; k < 4; ++k) children.push_back(started(options(k % 2 == 0, scratch.path())));
    for (const pid_t child : children) {
      int status = -1;
      ::waitpid(child, &status, 0);
      EXPECT_EQ(status, 0);
    }
    ASSERT_TRUE(belong_together(scratch)) << round;
    EXPECT_EQ(files_in(scratch), 2u);
  }
}

}  // namespace
}  // namespace flatdyn::testing
