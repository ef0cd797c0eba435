// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/progress.hpp"

#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

namespace flatdyn {
namespace {

// The output of a program whose stderr is a terminal.
std::string on_terminal(void (*program)()) {
  int terminal = 0;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    program();
    ::_exit(0);
  }
  std::string text;
  char buffer[256];
  for (ssize_t size = 0; (size = ::read(terminal, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(size));
  }
  ::close(terminal);
  ::waitpid(child, nullptr, 0);
  return text;
}

TEST(Progress, LeavesNothingBeforeAResult) {
  const std::string text = on_terminal([] {
    Progress progress;
    std::this_thread::sleep_for(std::chrono::milliseconds(1050));
    progress.step("searching");
    erase_progress();
    std::fputs("result", stderr);
    std::fflush(stderr);
  });
  EXPECT_EQ(text, "\r\033[Ksearching …\r\033[Kresult");
}

}  // namespace
}  // namespace flatdyn
