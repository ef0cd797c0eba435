// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/spike_repair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "laboratory/identify/stamp_weights.hpp"

namespace flatdyn {
namespace {

constexpr double kFarFromNoise = 12;  // standard deviations

}  // namespace

SpikeRepair::SpikeRepair(const StreamPlan& plan, SampleReceiver& receiver)
    : receiver_(receiver),
      channels_(static_cast<std::size_t>(plan.layout().channels())),
      is_stamped_(plan.clock.is_interpolated()) {
  const std::vector<std::string> names = plan.heading.channel_names();
  for (const int channel : plan.layout().positions_of_all()) {
    const auto at = static_cast<std::size_t>(channel);
    found_.push_back({at, names[at], plan.noise[at].deviation});
  }
}

void SpikeRepair::restart() {
  flush();
  receiver_.restart();
}

void SpikeRepair::sample(const RawSample& sample) {
  spare_.channels.assign(sample.channels, sample.channels + channels_);
  spare_.sample = sample;
  held_.push_back(std::move(spare_));
  if (static_cast<int>(held_.size()) < kHeld) return;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    // Nearly all readings go on as the two before them do.
    const double change = reading(2, i) - 2 * reading(1, i) + reading(0, i);
    if (!(std::abs(change) > kFarFromNoise / 2 * found_[i].noise)) continue;
    for (int wrong = 1; wrong <= kMost && !repair(i, wrong); ++wrong) {
    }
  }
  pass_on();
}

void SpikeRepair::flush() {
  while (!held_.empty()) pass_on();
}

void SpikeRepair::pass_on() {
  RawSample& oldest = held_.front().sample;
  oldest.channels = held_.front().channels.data();
  receiver_.sample(oldest);
  spare_ = std::move(held_.front());
  held_.pop_front();
}

double& SpikeRepair::reading(int at, std::size_t position) {
  return held_[static_cast<std::size_t>(at)].channels[found_[position].channel];
}

// The reading of a sample that is held by the cubic through its neighbours. Where stamps are not those of samples,
// these are counted.
double SpikeRepair::curve_at(int at, const double (&neighbours)[4], int wrong) const {
  const auto time = [this](int place) {
    return is_stamped_ ? held_[static_cast<std::size_t>(place)].channels[LogLayout::time()] : place;
  };
  const double times[4] = {time(0), time(1), time(wrong + 2), time(wrong + 3)};
  const std::vector<double> weights = interpolation_weights(times, time(at));
  return std::inner_product(weights.begin(), weights.end(), neighbours, 0.0);
}

// Spikes are far from the curve through the two neighbours on either side, which agree with each other: behind a jump
// they do not.
bool SpikeRepair::repair(std::size_t position, int wrong) {
  constexpr double kMotion = 2;       // changes from sample to sample, of q and of these changes
  constexpr double kAgreeing = 0.25;  // share of a spike
  Spikes& found = found_[position];
  const double neighbours[4] = {reading(0, position), reading(1, position), reading(wrong + 2, position),
                                reading(wrong + 3, position)};
  const double gap = wrong + 1, slope = (neighbours[1] - neighbours[0] + neighbours[3] - neighbours[2]) / 2;
  const double disagreement = std::abs(neighbours[2] - neighbours[1] - gap * slope);
  const double bend = (neighbours[3] - neighbours[2] - neighbours[1] + neighbours[0]) / gap;
  const double least =
      std::max(kFarFromNoise * found.noise + kMotion * (std::abs(slope) + std::abs(bend)), disagreement / kAgreeing);
  double curve[kMost] = {};
  for (int k = 0; k < wrong; ++k) {
    curve[k] = curve_at(k + 2, neighbours, wrong);
    if (!(std::abs(reading(k + 2, position) - curve[k]) > least)) return false;
  }
  if (found.count == 0) {
    const Held& first = held_[2];
    found.size = reading(2, position) - curve[0];
    found.time = first.channels[LogLayout::time()];
    found.file_line = first.sample.file_line;
  }
  found.count += wrong;
  for (int k = 0; k < wrong; ++k) reading(k + 2, position) = curve[k];
  return true;
}

void SpikeRepair::finish(const std::string& file, Diagnostics& diagnostics) const {
  for (const Spikes& each : found_) {
    if (each.count == 0) continue;
    diagnostics.warning(
        {file, each.file_line},
        fmt::format("{}: a reading is far from those beside it, by {:.2g} at {:.6g} s{}", each.name, each.size,
                    each.time, each.count > 1 ? fmt::format("; {} such readings in all", each.count) : ""),
        "interpolated positions are taken instead; is the encoder or its cable loose, or does motion capture lose the "
        "base?");
  }
}

}  // namespace flatdyn
