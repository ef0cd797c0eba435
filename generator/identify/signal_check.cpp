// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/signal_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flatdyn {
namespace {

constexpr long kLeastSamples = 20;
constexpr double kLeastTime = 0.05;  // s
constexpr double kOfNoise = 8;       // standard deviations of a jump that is none
constexpr double kSpike = 12;        // standard deviations

}  // namespace

SignalCheck::SignalCheck(const StreamPlan& plan) {
  const LogLayout& layout = plan.layout();
  const std::vector<std::string> names = plan.heading.channel_names();
  const auto add = [&](int channel, bool is_torque, const ChannelNoise& noise) {
    Signal signal;
    signal.channel = channel;
    signal.is_torque = is_torque;
    signal.noise = noise.deviation;
    signal.step = noise.step;
    signal.name = names[static_cast<std::size_t>(channel)];
    signals_.push_back(std::move(signal));
  };
  for (int i = 0; i < layout.positions; ++i) add(LogLayout::q() + i, false, plan.q_noise[static_cast<std::size_t>(i)]);
  for (int i = 0; i < layout.joints && layout.has_torques; ++i) {
    add(layout.tau() + i, true, plan.tau_noise[static_cast<std::size_t>(i)]);
  }
}

void SignalCheck::add(const double* channels, int file_line) {
  for (Signal& signal : signals_) signal.add(channels[LogLayout::time()], channels[signal.channel], file_line);
}

void SignalCheck::restart() {
  for (Signal& signal : signals_) signal.count = signal.held = 0;
}

void SignalCheck::Signal::add(double time, double reading, int file_line) {
  if (is_torque && count > 1) follow_spikes(reading);
  if (count > 0) follow_block(time, reading, file_line);
  if (count == 0) {
    since = time;
    since_line = file_line;
  }
  before = last;
  last = reading;
  last_time = time;
  last_line = file_line;
  ++count;
}

// A spike is a reading far from both of its neighbours, which are near each other.
void SignalCheck::Signal::follow_spikes(double reading) {
  const double middle = last - (before + reading) / 2;
  if (noise == 0 || std::abs(middle) < kSpike * noise || std::abs(reading - before) > std::abs(middle) / 2) return;
  if (spikes++ > 0) return;
  first_spike = last_time;
  spike_line = last_line;
}

// A block ends with a jump, and goes on from there: what changes step by step, or slowly, only rests.
void SignalCheck::Signal::follow_block(double time, double reading, int file_line) {
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
  const bool is_long = held >= kLeastSamples && time - since >= kLeastTime;
  if (is_long && std::abs(change) > kOfNoise * std::max(noise, step)) {
    jump = change;
    from = since;
    from_line = since_line;
    to = last_time;
    was_zero = last == 0;
  }
  held = 0;
  since = time;
  since_line = file_line;
}

void SignalCheck::finish(const std::string& file, Diagnostics& diagnostics) const {
  for (const Signal& signal : signals_) {
    if (signal.spikes > 0) {
      diagnostics.warning(
          {file, signal.spike_line},
          fmt::format("{}: {} spikes, the first at {:.6g} s", signal.name, signal.spikes, signal.first_spike),
          "single readings far from their neighbours: repair them, or give --robust");
    }
    if (signal.blocks > 0) {
      diagnostics.warning(
          {file, signal.block_line},
          fmt::format("{}: {} from {:.6g} to {:.6g} s, and then jumps{}", signal.name,
                      signal.first_is_zero ? "is 0" : "does not change", signal.first_from, signal.first_to,
                      signal.blocks > 1 ? fmt::format("; {} such blocks in all", signal.blocks) : ""),
          signal.is_torque ? "readings that were lost: cut these times out of the log"
                           : "is the encoder frozen there? Cut these times out of the log");
    }
  }
}

}  // namespace flatdyn
