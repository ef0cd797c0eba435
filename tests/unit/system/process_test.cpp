// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/system/process.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "base/diagnostics/diagnostics.hpp"
#include "base/system/temporary_folder.hpp"

namespace flatdyn::testing {
namespace {

TEST(RunCommand, SaysHowItEnded) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_command("exit 3", folder.path()), 3);
  EXPECT_EQ(run_command("kill -TERM $$", folder.path()), 128 + 15);
}

TEST(RunCommand, EndsTheRunWhereCtrlCHasEndedIt) {
  const auto before = std::signal(SIGINT, SIG_DFL);  // a background process may ignore it
  const TemporaryFolder folder;
  try {
    run_command("kill -INT $$", folder.path());
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::interrupted);
  }
  std::signal(SIGINT, before);
}

TEST(RunCommand, RunsInTheFolder) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_command("echo here > note", folder.path()), 0);
  EXPECT_EQ(content_of_file(folder.path() / "note"), "here\n");
}

TEST(RunCommand, PinsToOneCore) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_command("nproc > cores", folder.path(), true), 0);
  EXPECT_EQ(content_of_file(folder.path() / "cores"), "1\n");
}

}  // namespace
}  // namespace flatdyn::testing
