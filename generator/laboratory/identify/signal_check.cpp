// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/signal_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flatdyn {
namespace {

constexpr long kLeastSamples = 20;
constexpr double kLeastTime = 0.05;         // s
constexpr double kOfNoise = 8;              // standard deviations; a smaller jump counts as noise
constexpr double kSpike = 12, kLarge = 36;  // standard deviations
constexpr double kStepsOfMotion = 20;       // steps or standard deviations of a position that changes

}  // namespace

SignalCheck::SignalCheck(const StreamPlan& plan) {
  const LogLayout& layout = plan.layout();
  const std::vector<std::string> names = plan.heading.channel_names();
  const auto add = [&](int channel, bool is_torque, const ChannelNoise& noise, int position) {
    Signal signal;
    const ChannelNoise& of_position = plan.noise[static_cast<std::size_t>(position)];
    signal.position = position;
    signal.position_step = kStepsOfMotion * std::max(of_position.step, of_position.deviation);
    signal.channel = channel;
    signal.is_torque = signal.may_spike = is_torque;
    signal.noise = noise.deviation;
    signal.step = noise.step;
    signal.name = names[static_cast<std::size_t>(channel)];
    signals_.push_back(std::move(signal));
  };
  const auto add_position = [&](int channel) {
    add(channel, false, plan.noise[static_cast<std::size_t>(channel)], channel);
  };
  for (int i = 0; i < layout.positions; ++i) add_position(LogLayout::q() + i);
  for (int i = layout.base; i < layout.rates() && layout.has_torques; ++i) {
    add(layout.tau() + i, true, plan.tau_noise[static_cast<std::size_t>(i)],
        LogLayout::q() + layout.position_of[static_cast<std::size_t>(i)]);
  }
  // The base's own force and motion are looked at as positions are: no joint shows when they must change.
  const auto add_of_base = [&](int channel) {
    add_position(channel);
    signals_.back().may_spike = true;
  };
  for (int i = 0; i < layout.base && layout.has_base_force; ++i) add_of_base(layout.tau() + i);
  const bool is_pose = layout.base_motion == BaseMotion::pose;
  for (int i = is_pose && !layout.has_place ? LogLayout::kQuaternionInPose : 0; i < layout.base_readings(); ++i) {
    is_pose ? add_position(layout.base_reading() + i) : add_of_base(layout.base_reading() + i);
  }
  for (int i = 0; i < LogLayout::kTwist && layout.has_twist; ++i) add_of_base(layout.twist() + i);
}

void SignalCheck::add(const double* channels, int file_line) {
  const double time = channels[LogLayout::time()];
  if (samples_++ == 0) first_time_ = time;
  last_time_ = time;
  for (Signal& signal : signals_) signal.add(time, channels[signal.channel], channels[signal.position], file_line);
}

void SignalCheck::restart() {
  for (Signal& signal : signals_) signal.count = signal.held = 0;
}

void SignalCheck::Signal::add(double time, double reading, double joint, int file_line) {
  if (may_spike && count > 1) follow_spikes(reading);
  if (count > 0) follow_block(time, reading, joint, file_line);
  if (count == 0) {
    since = time;
    since_line = file_line;
    position_since = joint;
  }
  second_before = before;
  before = last;
  last = reading;
  last_time = time;
  last_line = file_line;
  ++count;
}

// A spike is a reading far from both of its neighbours, which are near each other. It bends the signal to the other
// side one reading before, as the top of a smooth signal does not.
void SignalCheck::Signal::follow_spikes(double reading) {
  const double middle = last - (before + reading) / 2, bend_before = before - (second_before + last) / 2;
  if (count > 2 && bend_before * middle >= 0) return;
  if (noise == 0 || std::abs(middle) < kSpike * noise || std::abs(reading - before) > std::abs(middle) / 2) return;
  (std::abs(middle) < kLarge * noise ? small : large).add(last_time, last_line);
}

void SignalCheck::Spikes::add(double at, int file_line) {
  if (count++ > 0) return;
  time = at;
  line = file_line;
}

bool SignalCheck::Signal::has_tails() const {
  constexpr long kSeveral = 5;
  return small.count >= kSeveral;
}

SignalCheck::Spikes SignalCheck::Signal::spikes() const {
  if (has_tails() || small.count == 0) return large;
  Spikes all = large.count == 0 || small.line < large.line ? small : large;
  all.count = small.count + large.count;
  return all;
}

void SignalCheck::report_tails(const std::string& file, Diagnostics& diagnostics) const {
  std::vector<std::string> names;
  long count = 0;
  for (const Signal& signal : signals_) {
    if (!signal.has_tails()) continue;
    names.push_back(signal.name);
    count += signal.small.count;
  }
  if (names.empty()) return;
  diagnostics.note({file, 1},
                   fmt::format("{}: {} readings in all lie {} to {} standard deviations of the noise from their "
                               "neighbours; that many count as noise",
                               fmt::join(names, ", "), count, kSpike, kLarge),
                   {}, "logs whose noise has readings that are far off");
}

// A block ends with a jump, and goes on from there: what changes step by step, or slowly, only rests. A torque whose
// noise is larger than its step does not stay the same by itself while its joint moves.
void SignalCheck::Signal::follow_block(double time, double reading, double joint, int file_line) {
  const double change = reading - last;
  if (jump != 0) {
    if (std::abs(change) < std::abs(jump) / 4 && blocks++ == 0) {
      first_from = from;
      first_to = to;
      block_line = from_line;
      first_is_zero = was_zero;
    }
    jump = 0;
  }
  if (change == 0) {
    ++held;
    return;
  }
  ++changes[std::min<std::size_t>(static_cast<std::size_t>(held) + 1, kMostHeld)];
  const bool is_long = held >= kLeastSamples && time - since >= kLeastTime;
  const bool is_noisy = is_torque && noise > step && std::abs(joint - position_since) > position_step;
  if (is_long && is_noisy) {
    if (blocks++ == 0) {
      first_from = since;
      first_to = last_time;
      block_line = since_line;
      first_is_zero = last == 0;
    }
  } else if (is_long && std::abs(change) > kOfNoise * std::max(noise, step)) {
    jump = change;
    from = since;
    from_line = since_line;
    to = last_time;
    was_zero = last == 0;
  }
  held = 0;
  since = time;
  since_line = file_line;
  position_since = joint;
}

// The largest number that most of the times between changes are multiples of.
int SignalCheck::Signal::held_over() const {
  constexpr double kMost = 0.8;
  constexpr long kLeastChanges = 100;
  long all = 0;
  for (const long each : changes) all += each;
  for (std::size_t over = kMostHeld / 2; over > 1 && all >= kLeastChanges; --over) {
    long multiples = 0;
    for (std::size_t after = over; after < kMostHeld; after += over) multiples += changes[after];
    if (static_cast<double>(multiples) > kMost * static_cast<double>(all)) return static_cast<int>(over);
  }
  return 1;
}

void SignalCheck::report_held(const std::string& file, Diagnostics& diagnostics) const {
  std::map<int, std::vector<std::string>> held;
  for (const Signal& signal : signals_) {
    if (const int over = signal.held_over(); over > 1) held[over].push_back(signal.name);
  }
  const double dt = samples_ > 1 ? (last_time_ - first_time_) / static_cast<double>(samples_ - 1) : 0;
  for (const auto& [over, names] : held) {
    diagnostics.warning(
        {file, 1},
        fmt::format("{}: the readings change at every {}th line only, and are {:.2g} ms late on average",
                    fmt::join(names, ", "), over, 1000 * dt * (over - 1) / 2.0),
        "log at the rate of the readings, or keep the lines at which they change");
  }
}

long SignalCheck::lost_blocks() const {
  long blocks = 0;
  for (const Signal& signal : signals_) blocks += signal.blocks;
  return blocks;
}

void SignalCheck::finish(const std::string& file, Diagnostics& diagnostics) const {
  report_held(file, diagnostics);
  report_tails(file, diagnostics);
  for (const Signal& signal : signals_) {
    if (const Spikes spikes = signal.spikes(); spikes.count > 0) {
      diagnostics.warning({file, spikes.line},
                          fmt::format("{}: {} {}, the first at {:.6g} s", signal.name, spikes.count,
                                      spikes.count == 1 ? "spike" : "spikes", spikes.time),
                          "single readings far from their neighbours: repair them, or give --robust");
    }
    if (signal.blocks > 0) {
      diagnostics.warning(
          {file, signal.block_line},
          fmt::format("{}: {} from {:.6g} to {:.6g} s, and then jumps{}", signal.name,
                      signal.first_is_zero ? "is 0" : "does not change", signal.first_from, signal.first_to,
                      signal.blocks > 1 ? fmt::format("; {} such blocks in all", signal.blocks) : ""),
          signal.is_torque ? "readings that were lost: cut these times out of the log"
                           : "is the reading frozen there? Cut these times out of the log");
    }
  }
}

}  // namespace flatdyn
