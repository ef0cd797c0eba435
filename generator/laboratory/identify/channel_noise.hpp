// SPDX-License-Identifier: GPL-2.0-or-later
// The step and the noise of a sampled signal, estimated from the signal itself.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <vector>

namespace flatdyn {

struct ChannelNoise {
  double step = 0;       // smallest change from one sample to the next; of an encoder, its resolution
  double deviation = 0;  // standard deviation of white noise, the encoder's rounding included

  // Whether it is mostly the rounding to steps, which is not white: a slow signal has more of it in a low band.
  bool is_of_steps() const { return deviation < 1.5 * step / std::sqrt(12.0); }

  auto operator<=>(const ChannelNoise&) const = default;
};

// The middle one of some values, at least one.
double median(std::vector<double> values);

// The weights of the last samples in their differences of each order, for samples that are not evenly apart.
class StampDifferences {
 public:
  static constexpr int kOrders = 6;

  void add(double time);
  void restart() { times_.clear(); }
  // The highest order that is known.
  int known() const { return static_cast<int>(times_.size()) - 1; }
  // The oldest of order + 1 samples first; of unit norm.
  const std::vector<double>& weights(int order) const { return weights_[static_cast<std::size_t>(order)]; }

 private:
  std::vector<double> times_;
  std::array<std::vector<double>, kOrders + 1> weights_;
};

// Differences of order m let a slow signal vanish, and white noise grows by √(2m over m) in them. The order that leaves
// least is the one that holds least of the signal. Blocks of 32 samples that have far more of it than most, such as one
// with a wrong reading, do not count, nor do those in which nothing changes unless all are so.
class ChannelNoiseMeter {
 public:
  // The next of samples that are evenly apart.
  void add(double value);
  // The next of samples that are not, to whose stamps its own was added. A meter takes either of the two.
  void add(double value, const StampDifferences& stamps);
  // Tells that the next sample does not follow the last one.
  void restart() {
    held_ = 0;
    end_block();
  }
  ChannelNoise noise() const;

 private:
  static constexpr int kOrders = StampDifferences::kOrders, kLowest = 3;

  void count(int order, double difference);
  void end_sample(double value, int known);

  // Squares of the differences of each order in some samples.
  struct Block {
    std::array<double, kOrders + 1> squares{};
    std::array<long, kOrders + 1> counts{};
    int samples = 0;
    double mean_square(int order) const;
  };

  void end_block();
  // The mean square of the differences of an order in the blocks that count.
  double mean_square(int order) const;

  // The last difference of each order, of which order 0 is the value; of samples that are not evenly apart, the last
  // values, the newest first.
  std::array<double, kOrders + 1> last_{};
  Block block_;
  std::vector<Block> blocks_;  // whole ones
  int held_ = 0;               // differences known, 0 … kOrders + 1
  double step_ = 0;
};

// The noise of a run of samples by the medians of such differences, which steps now and then hardly change: dry
// friction in a torque, or a rate with kinks.
ChannelNoise typical_noise(std::vector<double> run);
// The same of samples at these times, which are not evenly apart.
ChannelNoise typical_noise(const std::vector<double>& run, const std::vector<double>& times);

}  // namespace flatdyn
