// SPDX-License-Identifier: GPL-2.0-or-later
// Finds positions far from their neighbours, up to three in a row, and puts interpolated ones in their place: a single
// wrong reading becomes an acceleration that no robot has, for all of the filter's window.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "laboratory/identify/motion_stream.hpp"

namespace flatdyn {

class SpikeRepair : public SampleReceiver {
 public:
  // A sample's repair depends on no more samples than these before and behind it.
  static constexpr int kReach = 6;

  SpikeRepair(const StreamPlan& plan, SampleReceiver& receiver);

  void restart() override;
  // Passes samples on late.
  void sample(const RawSample& sample) override;
  // Passes on what is held back.
  void flush();
  // One warning for each position that has spikes.
  void finish(const std::string& file, Diagnostics& diagnostics) const;

 private:
  static constexpr int kMost = 3;              // wrong readings in a row
  static constexpr int kHeld = 2 + kMost + 2;  // with two neighbours on either side

  struct Held {
    std::vector<double> channels;
    RawSample sample;
  };
  struct Spikes {
    std::size_t channel = 0;
    std::string name;
    double noise = 0;  // standard deviation
    long count = 0;
    double size = 0, time = 0;  // of the first
    int file_line = 0;
  };

  double& reading(int at, std::size_t position);
  double curve_at(int at, const double (&neighbours)[4], int wrong) const;
  // Interpolates so many readings from the third sample that is held on, if they are spikes.
  bool repair(std::size_t position, int wrong);
  void pass_on();

  SampleReceiver& receiver_;
  std::size_t channels_;
  bool is_stamped_;            // whether stamps are not even, and right
  std::vector<Spikes> found_;  // by position, those of a floating base's pose among them
  std::deque<Held> held_;
  Held spare_;  // memory for the next one
};

}  // namespace flatdyn
