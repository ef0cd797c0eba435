// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/progress.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace flatdyn {
namespace {

constexpr const char* kEraseLine = "\r\033[K";

rusage usage_so_far() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage;
}

double processor_seconds(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

bool is_line_shown = false;  // shown by any Progress: there is one terminal

}  // namespace

void erase_progress() {
  if (!is_line_shown) return;
  fmt::print(stderr, "{}", kEraseLine);
  std::fflush(stderr);
  is_line_shown = false;
}

Progress::Progress(bool quiet)
    : shown_(!quiet && ::isatty(STDERR_FILENO) == 1), start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() { erase_progress(); }

void Progress::step(const std::string& what) {
  account(finished_);
  current_ = what;
  current_start_ = std::chrono::steady_clock::now();
  current_processor_start_ = processor_seconds(usage_so_far());
  if (!shown_ || std::chrono::steady_clock::now() - start_ < std::chrono::seconds(1)) return;
  fmt::print(stderr, "{}{} …", kEraseLine, what);
  std::fflush(stderr);
  is_line_shown = true;
}

std::vector<Progress::Step> Progress::steps() const {
  std::vector<Step> steps = finished_;
  account(steps);
  return steps;
}

void Progress::account(std::vector<Step>& steps) const {
  if (current_.empty()) return;
  const auto known = std::find_if(steps.begin(), steps.end(), [&](const Step& each) { return each.what == current_; });
  Step& step = known == steps.end() ? steps.emplace_back(Step{current_}) : *known;
  const rusage usage = usage_so_far();
  step.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - current_start_).count();
  step.processor_seconds += processor_seconds(usage) - current_processor_start_;
  step.peak_kilobytes = usage.ru_maxrss;
}

}  // namespace flatdyn
