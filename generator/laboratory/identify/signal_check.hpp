// SPDX-License-Identifier: GPL-2.0-or-later
// Detects torques and positions that no sensor in order gives: spikes of torques, blocks in which a reading is frozen
// or zero, and readings that are held over several samples. Spikes of positions are repaired (SpikeRepair).
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "laboratory/identify/motion_stream.hpp"

namespace flatdyn {

class SignalCheck {
 public:
  explicit SignalCheck(const StreamPlan& plan);

  // Adds the next sample, which is in this line of the file.
  void add(const double* channels, int file_line);
  // Tells that the next sample does not follow the last one.
  void restart();
  // One warning for each kind and channel, but for readings that are held: one for all channels that are so alike.
  void finish(const std::string& file, Diagnostics& diagnostics) const;
  // The number of blocks in which a reading is frozen or zero.
  long lost_blocks() const;

 private:
  struct Spikes {
    long count = 0;
    double time = 0;  // of the first
    int line = 0;

    void add(double at, int file_line);
  };

  // One channel. `noise`: the standard deviation of its noise; `step`: the least change of its reading.
  struct Signal {
    int channel = 0;
    bool is_torque = false;
    bool may_spike = false;    // spikes of positions are repaired elsewhere
    int position = 0;          // the channel of the joint's position
    double position_step = 0;  // how far it must move to count as moving
    double noise = 0, step = 0;
    std::string name;

    // The last three readings, and since when the last one has not changed.
    double second_before = 0, before = 0, last = 0, since = 0, last_time = 0;
    double position_since = 0;  // the joint's position then
    int since_line = 0, last_line = 0;
    long held = 0, count = 0;
    // A block that has ended with a jump; it counts once the next reading is near the one behind the jump.
    double jump = 0, from = 0, to = 0;
    int from_line = 0;
    bool was_zero = false;

    // Readings far from both neighbours, by how far.
    Spikes small, large;
    long blocks = 0;
    double first_from = 0, first_to = 0;
    int block_line = 0;  // of the first
    bool first_is_zero = false;
    // How often a reading changed after 1, 2, … samples.
    static constexpr std::size_t kMostHeld = 64;
    std::array<long, kMostHeld + 1> changes{};

    void add(double time, double reading, double joint, int file_line);
    void follow_block(double time, double reading, double joint, int file_line);
    void follow_spikes(double reading);
    // Small spikes are noise if there are several: noise often has some readings that are far off.
    bool has_tails() const;
    Spikes spikes() const;
    // The number of samples over which readings are held; 1 if they are not.
    int held_over() const;
  };

  void report_held(const std::string& file, Diagnostics& diagnostics) const;
  // One note for all channels.
  void report_tails(const std::string& file, Diagnostics& diagnostics) const;

  std::vector<Signal> signals_;
  double first_time_ = 0, last_time_ = 0;
  long samples_ = 0;
};

}  // namespace flatdyn
