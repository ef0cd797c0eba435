// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/system/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "base/diagnostics/diagnostics.hpp"
#include "base/system/interrupt.hpp"
#include "base/system/process.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Sets $TMPDIR, and restores it at the end.
class TemporaryRoot {
 public:
  explicit TemporaryRoot(const fs::path& root) {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    ::setenv("TMPDIR", root.c_str(), 1);
  }
  ~TemporaryRoot() {
    if (before_.empty()) {
      ::unsetenv("TMPDIR");
    } else {
      ::setenv("TMPDIR", before_.c_str(), 1);
    }
  }
  TemporaryRoot(const TemporaryRoot&) = delete;
  TemporaryRoot& operator=(const TemporaryRoot&) = delete;

 private:
  std::string before_;
};

TEST(TemporaryFolder, SaysThatTmpdirIsNoFolder) {
  const TemporaryRoot root("/nowhere/at/all");
  try {
    const TemporaryFolder folder;
    FAIL() << folder.path();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::io);
    EXPECT_THAT(failure.what(), HasSubstr("TMPDIR is \"/nowhere/at/all\""));
  }
}

// Checks how a child process ended by `signal` has ended, and that it leaves nothing behind.
void expect_nothing_left(int signal) {
  const TemporaryFolder cross;
  const TemporaryRoot root(cross.path());
  const pid_t child = ::fork();
  if (child == 0) {
    keep_when_interrupted(cross.path());  // the parent's folder
    std::signal(signal, SIG_DFL);         // ignored if the tests run in the background
    const TemporaryFolder one, two;
    write_file(one.path() / "file", "text");
    ::raise(signal);
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), signal);
  EXPECT_TRUE(fs::is_empty(cross.path())) << signal;
}

TEST(TemporaryFolder, GoesWithAProgramThatASignalEnds) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) expect_nothing_left(signal);
}

TEST(Interruption, KeepsTheSignalInMind) {
  const pid_t child = ::fork();
  if (child == 0) {
    const Interruption interruption;
    const bool before = Interruption::happened();
    ::raise(SIGINT);
    ::_exit(!before && Interruption::happened() ? 3 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3);
}

}  // namespace
}  // namespace flatdyn::testing
