// SPDX-License-Identifier: GPL-2.0-or-later
// The current activity of the program on stderr, shown only on a terminal and after a second.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace flatdyn {

// Erases the line that is shown, if there is one, before anything else is written.
void erase_progress();

class Progress {
 public:
  explicit Progress(bool quiet = false);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step(const std::string& what);

  struct Step {
    std::string what;
    double seconds;  // until the next step, or until now
  };
  std::vector<Step> steps() const;

 private:
  struct Start {
    std::string what;
    std::chrono::steady_clock::time_point at;
  };

  bool shown_;
  std::vector<Start> starts_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace flatdyn
