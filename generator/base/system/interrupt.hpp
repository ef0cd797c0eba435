// SPDX-License-Identifier: GPL-2.0-or-later
// The end of a run by Ctrl-C or another signal.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string_view>

namespace flatdyn {

// While an object exists, Ctrl-C does not end the program but is remembered, for work whose finished part is worth
// writing.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static bool happened();

 private:
  void (*before_)(int);
};

// Registers folders, at most 64 at a time, that are removed, and processes that are ended, before a signal ends the
// program.
void remove_when_interrupted(const std::filesystem::path& folder);
void keep_when_interrupted(const std::filesystem::path& folder);  // reverses that
void end_when_interrupted(pid_t child);
void forget_when_interrupted(pid_t child);  // after it has ended

// Forks. A signal ends the child at once: what is registered is left to the parent. -1: there is no room for a process.
pid_t fork_without_registrations();

// The last words on standard output of a program that a signal ends; "": none. At most 1000 characters.
void print_when_interrupted(std::string_view text);

}  // namespace flatdyn
