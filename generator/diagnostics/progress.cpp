// SPDX-License-Identifier: GPL-2.0-or-later
#include "diagnostics/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace flatdyn {
namespace {

constexpr const char* kEraseLine = "\r\033[K";

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
  starts_.push_back({what, std::chrono::steady_clock::now()});
  if (!shown_ || std::chrono::steady_clock::now() - start_ < std::chrono::seconds(1)) return;
  fmt::print(stderr, "{}{} …", kEraseLine, what);
  std::fflush(stderr);
  is_line_shown = true;
}

std::vector<Progress::Step> Progress::steps() const {
  std::vector<Step> steps;
  for (std::size_t k = 0; k < starts_.size(); ++k) {
    const auto end = k + 1 < starts_.size() ? starts_[k + 1].at : std::chrono::steady_clock::now();
    steps.push_back({starts_[k].what, std::chrono::duration<double>(end - starts_[k].at).count()});
  }
  return steps;
}

}  // namespace flatdyn
