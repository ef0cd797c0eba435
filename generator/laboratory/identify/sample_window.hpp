// SPDX-License-Identifier: GPL-2.0-or-later
// The last samples of a stream, channel by channel, each contiguous in memory, so that a kernel can be applied to it.
#pragma once

#include <Eigen/Core>

namespace flatdyn {

class SampleWindow {
 public:
  SampleWindow(int channels, int length) : length_(length), samples_(2 * length + kSlack, channels) {}

  // The place of the next sample, for the caller to fill in.
  auto push() {
    if (end_ == samples_.rows()) restart_buffer();
    if (held_ < length_) ++held_;
    return samples_.row(end_++);
  }
  void clear() { held_ = 0; }
  bool full() const { return held_ == length_; }
  int held() const { return held_; }
  // `count` samples of some channels, of which the newest has `back` samples behind it.
  auto block(int back, int count, int first, int channels) const {
    return samples_.block(end_ - back - count, first, count, channels);
  }
  // One sample, which has `back` samples behind it.
  auto sample(int back) const { return samples_.row(end_ - 1 - back); }

 private:
  static constexpr int kSlack = 1024;

  void restart_buffer() {
    samples_.topRows(length_) = samples_.bottomRows(length_).eval();
    end_ = length_;
  }

  int length_;
  int held_ = 0;
  Eigen::Index end_ = 0;
  Eigen::MatrixXd samples_;
};

}  // namespace flatdyn
