// SPDX-License-Identifier: GPL-2.0-or-later
// The output folder after a run that was killed, had no room, lacked permissions, or was not alone: the complete files
// of one run, or nothing new.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/diagnostics/diagnostics.hpp"
#include "cli/program.hpp"
#include "cli/replace_files.hpp"
#include "robot/input/common/content_hash.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

// The options alternate between two kinds, so that a mixture of runs would be noticed.
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

// Starts the program without a shell in between, so that a signal reaches it. `before` runs first in the child.
pid_t started(
    const std::string& arguments, void (*before)() = [] {}) {
  const std::string command =
      fmt::format("cd '{}' && exec '{}' {} > /dev/null 2>&1", FLATDYN_SOURCE_DIR, FLATDYN_PROGRAM, arguments);
  const pid_t child = ::fork();
  if (child == 0) {
    before();
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  return child;
}

// Headers and manifests of a run in double and one in float, in the same folder.
class KilledRuns : public ::testing::Test {
 protected:
  KilledRuns() {
    for (const bool is_float : {false, true}) {
      EXPECT_EQ(run_flatdyn(options(is_float, scratch.path())).code, 0);
      headers.push_back(scratch.read("planar_2r.hpp"));
      manifests.push_back(scratch.read("planar_2r.json"));
    }
    EXPECT_NE(headers[0], headers[1]);
    EXPECT_NE(manifests[0], manifests[1]);
  }

  bool has_manifest() const { return std::filesystem::exists(scratch.path("planar_2r.json")); }

  // The header is complete; the manifest, if it exists, is that of the same run.
  void expect_files_of_one_run() const {
    const auto run = std::find(headers.begin(), headers.end(), scratch.read("planar_2r.hpp")) - headers.begin();
    ASSERT_LT(run, 2);
    if (!has_manifest()) return;
    EXPECT_EQ(scratch.read("planar_2r.json"), manifests[static_cast<std::size_t>(run)]);
    EXPECT_TRUE(belong_together(scratch));
  }

  Scratch scratch;
  std::vector<std::string> headers, manifests;
};

TEST_F(KilledRuns, LeaveFilesOfOneRunAtAnyMoment) {
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run_flatdyn(options(true, scratch.path())).code, 0);
  const auto whole = std::chrono::steady_clock::now() - start;
  constexpr int kKills = 24;
  for (int k = 0; k < kKills; ++k) {
    const pid_t child = started(options(k % 2 == 0, scratch.path()));
    // The kills are spread over the whole run, with more of them towards its end, where it writes.
    std::this_thread::sleep_for(k % 3 == 0 ? whole * k / kKills : whole * 3 / 4 + whole * k / (2 * kKills));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    expect_files_of_one_run();
  }
}

bool changes_a_folder(std::uint64_t call) {
  const std::uint64_t calls[] = {
#ifdef SYS_rename
      SYS_rename, SYS_unlink,
#endif
      SYS_renameat, SYS_renameat2, SYS_unlinkat};
  return std::find(std::begin(calls), std::end(calls), call) != std::end(calls);
}

enum class End { killed, finished };

// Runs the program under ptrace and kills it before the k-th of its calls that rename or remove a file.
End killed_before(int k, const std::string& arguments) {
  const pid_t child = started(arguments, [] { ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr); });
  constexpr int kCall = SIGTRAP | 0x80;  // distinguishes a stop at a system call from others
  int status = 0;
  while (::waitpid(child, &status, 0) == child && WIFSTOPPED(status)) {
    ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
    __ptrace_syscall_info call = {};
    if (WSTOPSIG(status) == kCall) ::ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof call, &call);
    if (call.op == PTRACE_SYSCALL_INFO_ENTRY && changes_a_folder(call.entry.nr) && k-- == 0) {
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
      return End::killed;
    }
    const bool is_of_tracing = WSTOPSIG(status) == kCall || WSTOPSIG(status) == SIGTRAP;
    ::ptrace(PTRACE_SYSCALL, child, nullptr, is_of_tracing ? 0 : WSTOPSIG(status));
  }
  return End::finished;
}

TEST_F(KilledRuns, LeaveFilesOfOneRunBetweenAnyTwoStepsOfReplacingThem) {
  int kills = 0, without_manifest = 0;
  while (killed_before(kills, options(kills % 2 == 0, scratch.path())) == End::killed) {
    expect_files_of_one_run();
    without_manifest += has_manifest() ? 0 : 1;
    ASSERT_LT(++kills, 100);
  }
  if (kills == 0) GTEST_SKIP() << "nobody may be traced here";
  EXPECT_GE(kills, 3);  // a removal, two renamings
  EXPECT_GT(without_manifest, 0);
  EXPECT_EQ(files_in(scratch), 2u);  // the last run finished and removed the remains of the others
  EXPECT_TRUE(belong_together(scratch));
}

TEST(Output, StaysAsItWasWhenThereIsNoRoom) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn(options(false, scratch.path())).code, 0);
  const std::string header = scratch.read("planar_2r.hpp");
  // No file may be larger than two kilobytes: once reported as an error, once as a signal.
  const std::string limited = fmt::format("ulimit -f 2; cd '{}'; '{}' {} 2>&1", FLATDYN_SOURCE_DIR, FLATDYN_PROGRAM,
                                          options(true, scratch.path()));
  const int error = std::system(fmt::format("bash -c \"trap '' XFSZ; {}\" > /dev/null", limited).c_str());
  EXPECT_EQ(WEXITSTATUS(error), 6);
  EXPECT_EQ(files_in(scratch), 2u);
  EXPECT_NE(std::system(fmt::format("bash -c \"{}\" > /dev/null 2>&1", limited).c_str()), 0);
  EXPECT_EQ(scratch.read("planar_2r.hpp"), header);
  EXPECT_TRUE(belong_together(scratch));
}

TEST(Output, LeavesNoFolderBehindWhenThereIsNoRoom) {
  const Scratch scratch;
  for (const char* command :
       {"generate robots/planar_2r.toml", "certify robots/panda.urdf --functions gravity --states 100"}) {
    const std::string limited = fmt::format("ulimit -f 2; cd '{}'; '{}' {} -q -o {} 2>&1", FLATDYN_SOURCE_DIR,
                                            FLATDYN_PROGRAM, command, scratch.path("new/folder"));
    const int error = std::system(fmt::format("bash -c \"trap '' XFSZ; {}\" > /dev/null", limited).c_str());
    EXPECT_EQ(WEXITSTATUS(error), 6) << command;
    EXPECT_EQ(files_in(scratch), 0u) << command;
  }
}

// `generate` and `certify` in one folder: a file about a header that no longer exists goes away with it.
TEST(Output, HasNothingBesideAHeaderThatSpeaksOfAnother) {
  const Scratch scratch;
  const std::string certify = "certify robots/panda.urdf -q --states 100 --time-limit 0 -o " + scratch.path();
  const auto exists = [&](const char* name) { return std::filesystem::exists(scratch.path(name)); };
  ASSERT_EQ(run_flatdyn(certify + " --functions gravity,inertia_matrix").code, 0);
  const auto scripts = [&] {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scratch.path("panda.gappa"))) {
      count += entry.path().filename().string().rfind("inertia_matrix", 0) == 0 ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(scripts(), 0u);
  ASSERT_EQ(run_flatdyn(certify + " --functions gravity").code, 0);
  EXPECT_EQ(scripts(), 0u);
  scratch.write("panda.txt", "somebody's");
  ASSERT_EQ(run_flatdyn("generate robots/panda.urdf -q --functions bias -o " + scratch.path()).code, 0);
  EXPECT_FALSE(exists("panda.certificate.md") || exists("panda.certificate.json") || exists("panda.gappa"));
  EXPECT_TRUE(exists("panda.json") && exists("panda.txt"));
  ASSERT_EQ(run_flatdyn(certify + " --functions gravity").code, 0);
  EXPECT_TRUE(exists("panda.certificate.md") && exists("panda.txt"));
  EXPECT_FALSE(exists("panda.json"));
  scratch.write("panda.json", "{\"mine\": 1}");
  ASSERT_EQ(run_flatdyn(certify + " --functions inertia_matrix").code, 0);
  EXPECT_TRUE(exists("panda.json"));
}

// The third file cannot be renamed: it is the second one again, which is absent then.
TEST(ReplacedFiles, ComeBackIfNotAllCanBe) {
  const Scratch scratch;
  const std::string first = scratch.path("first"), second = scratch.path("second"), third = scratch.path("third");
  scratch.write("first", "old");
  scratch.write("second", "old");
  EXPECT_THROW(replace_files({{first, "new"}, {third, "new"}, {second, "new"}, {second, "new"}}), Failure);
  EXPECT_EQ(scratch.read("first"), "old");
  EXPECT_EQ(scratch.read("second"), "old");
  EXPECT_EQ(files_in(scratch), 2u);
  EXPECT_THROW(replace_files({{third, "new"}, {second, "new"}, {second, "new"}}), Failure);
  EXPECT_EQ(scratch.read("second"), "old");
  EXPECT_EQ(files_in(scratch), 2u);
  replace_files({{first, "new"}, {third, "new"}, {second, "new"}});
  EXPECT_EQ(scratch.read("first") + scratch.read("second") + scratch.read("third"), "newnewnew");
  EXPECT_EQ(files_in(scratch), 3u);
}

TEST(Output, IsRefusedWhereNothingCanBeWritten) {
  const Outcome outcome = run_flatdyn(options(false, "/proc/flatdyn"));
  EXPECT_EQ(outcome.code, 6);
  EXPECT_THAT(outcome.err, HasSubstr("/proc/flatdyn"));
  EXPECT_THAT(outcome.err, HasSubstr("cannot be written"));
}

TEST(Output, SaysSoWhenStandardOutputIsFull) {
  const Scratch scratch;
  const std::string command = fmt::format("cd '{}' && '{}' {} --json > /dev/full 2> '{}'", FLATDYN_SOURCE_DIR,
                                          FLATDYN_PROGRAM, options(false, scratch.path("out")), scratch.path("err"));
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
