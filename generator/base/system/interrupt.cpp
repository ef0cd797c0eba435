// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/system/interrupt.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <csignal>
#include <mutex>

namespace flatdyn {
namespace {

volatile std::sig_atomic_t has_happened = 0;

// A folder's name in memory that a signal handler may read; a handler may neither allocate nor lock.
struct Folder {
  volatile std::sig_atomic_t is_used = 0;
  char path[PATH_MAX] = {};
};
std::array<Folder, 64> folders;
std::array<volatile std::sig_atomic_t, 64> children;  // 0: none
std::array<char, 1000> last_words;
volatile std::sig_atomic_t length_of_last_words = 0;
std::mutex changing;

// Removes a folder. All calls here are safe in a handler (signal-safety(7)); another program removes what is in the
// folder. glibc's fork() is not safe: it waits for the lock of malloc, which the interrupted thread may hold.
void remove(const char* folder) {
  const pid_t child = ::_Fork();
  if (child == 0) {
    ::execl("/bin/rm", "rm", "-rf", "--", folder, nullptr);
    ::_exit(127);
  }
  if (child > 0) ::waitpid(child, nullptr, 0);
}

void clean_up(int signal) {
  for (const std::sig_atomic_t child : children) {
    if (child > 0 && ::kill(child, signal) == 0) ::waitpid(child, nullptr, 0);
  }
  for (const Folder& folder : folders) {
    if (folder.is_used != 0) remove(folder.path);
  }
  if (length_of_last_words > 0) {
    [[maybe_unused]] const ssize_t written =
        ::write(STDOUT_FILENO, last_words.data(), static_cast<std::size_t>(length_of_last_words));
  }
  std::signal(signal, SIG_DFL);
  ::raise(signal);
}

// Installs the handlers. Signals that are ignored, as under nohup, or handled by someone else, stay so.
void take_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now = {};
    if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::signal(signal, clean_up);
  }
}

}  // namespace

Interruption::Interruption() : before_(std::signal(SIGINT, [](int) { has_happened = 1; })) {}

Interruption::~Interruption() { std::signal(SIGINT, before_); }

bool Interruption::happened() { return has_happened != 0; }

void remove_when_interrupted(const std::filesystem::path& folder) {
  const std::lock_guard lock(changing);
  take_signals();
  for (Folder& each : folders) {
    if (each.is_used != 0 || folder.native().size() >= sizeof each.path) continue;
    each.path[folder.native().copy(each.path, sizeof each.path - 1)] = 0;
    each.is_used = 1;
    return;
  }
}

void keep_when_interrupted(const std::filesystem::path& folder) {
  const std::lock_guard lock(changing);
  for (Folder& each : folders) {
    if (each.is_used != 0 && folder.native() == each.path) each.is_used = 0;
  }
}

void end_when_interrupted(pid_t child) {
  const std::lock_guard lock(changing);
  for (volatile std::sig_atomic_t& each : children) {
    if (each != 0) continue;
    each = child;
    return;
  }
}

void forget_when_interrupted(pid_t child) {
  const std::lock_guard lock(changing);
  for (volatile std::sig_atomic_t& each : children) {
    if (each == child) each = 0;
  }
}

pid_t fork_without_registrations() {
  const std::lock_guard lock(changing);
  take_signals();
  sigset_t signals, before;
  ::sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&signals, signal);
  ::pthread_sigmask(SIG_BLOCK, &signals, &before);
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      struct sigaction now = {};
      if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == clean_up) std::signal(signal, SIG_DFL);
    }
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return child;
}

void print_when_interrupted(std::string_view text) {
  const std::lock_guard lock(changing);
  length_of_last_words = 0;
  length_of_last_words = static_cast<std::sig_atomic_t>(text.copy(last_words.data(), last_words.size()));
  if (!text.empty()) take_signals();
}

}  // namespace flatdyn
