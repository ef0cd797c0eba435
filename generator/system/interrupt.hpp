// SPDX-License-Identifier: GPL-2.0-or-later
// What becomes of a run that Ctrl-C, or another signal, ends.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string_view>

namespace flatdyn {

// While one lives, Ctrl-C does not end the program but is kept in mind: for work of which the part that is done is
// worth writing.
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

// Otherwise signals that end the program first remove these folders, at most 64 at a time, and end these processes.
void remove_when_interrupted(const std::filesystem::path& folder);
void keep_when_interrupted(const std::filesystem::path& folder);  // again
void end_when_interrupted(pid_t child);
void forget_when_interrupted(pid_t child);  // it has ended

// The last words on standard output of a program that a signal ends; "": none. At most 1000 characters.
void say_when_interrupted(std::string_view text);

}  // namespace flatdyn
