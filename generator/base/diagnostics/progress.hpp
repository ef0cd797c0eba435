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
    double seconds = 0;            // until the next step, or until now; steps of one name together
    double processor_seconds = 0;  // of the whole program
    long peak_kilobytes = 0;       // of the program so far, at the end of the step
  };
  // Each step by its name once, in the order in which they were first taken.
  std::vector<Step> steps() const;

 private:
  // Adds what has been used since the last step to that step.
  void account(std::vector<Step>& steps) const;

  bool shown_;
  std::vector<Step> finished_;
  std::string current_;
  std::chrono::steady_clock::time_point current_start_;
  double current_processor_start_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace flatdyn
