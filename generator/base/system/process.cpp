// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/system/process.hpp"

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "base/diagnostics/diagnostics.hpp"
#include "base/system/interrupt.hpp"
#include "base/system/temporary_folder.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

// Pins the process to the last core; the first one has most of the system's own work.
void pin_to_last_core() {
  cpu_set_t allowed, one;
  CPU_ZERO(&allowed);
  CPU_ZERO(&one);
  if (::sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
  for (int core = CPU_SETSIZE - 1; core >= 0; --core) {
    if (!CPU_ISSET(core, &allowed)) continue;
    CPU_SET(core, &one);
    ::sched_setaffinity(0, sizeof one, &one);
    return;
  }
}

}  // namespace

int run_command(const std::string& command, const fs::path& folder, bool pinned) {
  const pid_t child = ::fork();
  if (child < 0) throw Failure(FailureKind::io, "no process can be started");
  if (child == 0) {
    if (pinned) pin_to_last_core();
    if (::chdir(folder.c_str()) == 0) ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  end_when_interrupted(child);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw Failure(FailureKind::io, "a process was lost");
  }
  forget_when_interrupted(child);
  // Ctrl-C goes to this program, too, which may get it a moment later than its child.
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) throw Failure(FailureKind::interrupted, "interrupted");
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string machine_compiler() {
  const char* chosen = std::getenv("CXX");
  const std::string compiler = chosen != nullptr && *chosen != '\0' ? chosen : "c++";
  if (run_command(compiler + " --version > /dev/null 2>&1", temporary_root()) != 0) {
    throw Failure(FailureKind::io, "no C++ compiler: " + compiler + " cannot be run", "install g++ or set CXX");
  }
  return compiler;
}

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string content_of_file(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void write_file(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file)
    throw Failure(FailureKind::io, path.string() + ": cannot be written",
                  "check the permissions, and that the disk is not full");
}

}  // namespace flatdyn
