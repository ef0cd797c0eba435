// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/motion_stream.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "laboratory/identify/base_check.hpp"
#include "laboratory/identify/log_reader.hpp"
#include "laboratory/identify/position_check.hpp"
#include "laboratory/identify/rate_check.hpp"
#include "laboratory/identify/signal_check.hpp"
#include "laboratory/identify/spike_repair.hpp"

namespace flatdyn {
namespace {

constexpr int kMostMissing = 3;

// Checks the rates of samples on their way.
class RateChecked : public SampleReceiver {
 public:
  RateChecked(std::string file, RateCheck& rates, SampleReceiver& receiver, Diagnostics& diagnostics)
      : file_(std::move(file)), rates_(rates), receiver_(receiver), diagnostics_(diagnostics) {}
  void restart() override { receiver_.restart(); }
  void sample(const RawSample& sample) override {
    rates_.add(
        sample.channels,
        [&] {
          return Place{file_, sample.file_line};
        },
        diagnostics_);
    receiver_.sample(sample);
  }

 private:
  std::string file_;
  RateCheck& rates_;
  SampleReceiver& receiver_;
  Diagnostics& diagnostics_;
};

// One log on its way through reader and checks.
class Stream {
 public:
  Stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan, BlockPartition& shares,
         SampleReceiver& receiver, Diagnostics& diagnostics)
      : reader_(log, plan.heading, diagnostics),
        diagnostics_(diagnostics),
        positions_(mechanism, plan.heading),
        rates_(mechanism, plan.heading, plan.filter.dt, plan.moves),
        signals_(plan),
        base_(plan.heading, plan.filter.dt),
        plan_(plan),
        half_window_(std::min(plan.filter.half_window() + SpikeRepair::kReach + plan.filter.standing_samples(),
                              static_cast<int>(kBlock / 2))),
        shares_(shares),
        rate_checked_(log.string(), rates_, receiver, diagnostics),
        spikes_(plan, rate_checked_),
        receiver_(plan.filter.band > 0 ? static_cast<SampleReceiver&>(spikes_) : rate_checked_),
        sample_(static_cast<std::size_t>(plan.layout().channels())) {}

  StreamCount run() {
    receiver_.restart();
    for (long line = 0;; ++line) {
      if (!skip_to_needed(line) || !reader_.next(sample_.data())) {
        // The last samples still belong to this log.
        if (!diagnostics_.has_errors()) finish();
        shares_.end_log(line);
        return count_;
      }
      if (first_.line == 0) first_ = reader_.place();
      if (positions_.is_odd(sample_.data()) && !positions_.accepts(sample_.data(), reader_.place(), diagnostics_)) {
        return count_;
      }
      if (shares_.owns(line)) ++count_.lines;
      base_.add(sample_.data());
      pass_on(line);
    }
  }

 private:
  // Whether the line belongs to the part, or to the filter's window about a line of the part, or to the time before it
  // that shows whether a joint stands still.
  bool is_needed(long line) {
    return shares_.is_whole() || shares_.owns(line - half_window_) || shares_.owns(line + half_window_);
  }

  void finish() {
    spikes_.flush();
    rates_.finish(first_, diagnostics_);
    spikes_.finish(first_.file, diagnostics_);
    signals_.finish(first_.file, diagnostics_);
    base_.finish(first_, diagnostics_);
    count_.lost = signals_.lost_blocks();
  }

  // Skips blocks of other parts. Returns false at the end of the log.
  bool skip_to_needed(long& line) {
    while (!is_needed(line)) {
      const long half = half_window_, next = ((line + half) / kBlock + 1) * kBlock - half;
      line += reader_.skip(next - line);
      restart();
      rates_.restart();
      if (line < next) return false;
    }
    return true;
  }

  void restart() {
    receiver_.restart();
    signals_.restart();
    base_.restart();
    contiguous_ = 0;
  }

  bool jitters() const {
    constexpr double kFew = 0.05;  // share of dt
    return plan_.jitter > kFew;
  }

  // Whether no sample is missing within a step, s.
  bool is_next(double step) const {
    constexpr double kMost = 0.5, kMostWithJitter = 0.9;  // shares of dt
    const double dt = plan_.filter.dt;
    return std::abs(step - dt) <= (jitters() ? kMostWithJitter : kMost) * dt;
  }

  // The time since the last sample, s. Where the clock jitters, it is that since the time at which the last sample was
  // due; steps that are too long and too short by turns are no gaps.
  double step_to_new() {
    constexpr double kFollows = 0.1;  // of the difference, at every sample
    const double dt = plan_.filter.dt;
    if (contiguous_ == 0) due_ = sample_[0] - dt;
    const double step = sample_[0] - (contiguous_ > 0 && !jitters() ? last_[0] : due_);
    due_ += is_next(step) ? dt : dt * std::max(1.0, std::round(step / dt));
    due_ += kFollows * (sample_[0] - due_);
    return step;
  }

  // Passes the new sample on, after those that are missing before it. Without a filter times may be any.
  void pass_on(long line) {
    const double dt = plan_.filter.dt, step = step_to_new();
    if (plan_.filter.band > 0 && !is_next(step)) {
      const auto missing = static_cast<int>(std::lround(step / dt)) - 1;
      const bool is_late = missing >= 1 && missing <= kMostMissing && std::abs(step - (missing + 1) * dt) < dt / 2;
      const bool owned = shares_.owns(line);
      if (is_late) {
        for (int k = 1; k <= missing; ++k) put_in(static_cast<double>(k) / (missing + 1), line);
        if (owned) count_.interpolated += missing;
      } else {
        restart();
        if (owned) ++count_.gaps;
      }
    }
    if (plan_.filter.band > 0) signals_.add(sample_.data(), reader_.line());
    before_last_.swap(last_);
    last_ = sample_;
    ++contiguous_;
    receiver_.sample({sample_.data(), line, index_of(sample_[0]), reader_.line()});
  }

  // Passes a sample on that lies at `part` of the way from the last one to the new one, on the parabola through these
  // and the one before them.
  void put_in(double part, long line) {
    between_ = sample_;
    const double r = contiguous_ > 1 ? (last_[0] - before_last_[0]) / (sample_[0] - last_[0]) : 0;
    for (std::size_t c = 0; c < between_.size(); ++c) {
      const double slope = sample_[c] - last_[c];
      const double bend = r > 0 ? (slope - (last_[c] - before_last_[c]) / r) / (1 + r) : 0;
      between_[c] = last_[c] + part * slope + part * (part - 1) * bend;
    }
    receiver_.sample({between_.data(), line, index_of(between_[0]), reader_.line()});
  }

  long index_of(double time) const { return std::lround((time - plan_.start) / plan_.filter.dt); }

  LogReader reader_;
  Diagnostics& diagnostics_;
  PositionCheck positions_;
  RateCheck rates_;
  SignalCheck signals_;
  BaseCheck base_;
  const StreamPlan& plan_;
  int half_window_;
  BlockPartition& shares_;
  RateChecked rate_checked_;
  SpikeRepair spikes_;
  SampleReceiver& receiver_;  // of all samples: the spikes' with a filter
  std::vector<double> sample_, last_, before_last_, between_;
  StreamCount count_;
  Place first_;          // place of the first sample that is read
  long contiguous_ = 0;  // samples since the restart, without those that were put in
  double due_ = 0;       // the time at which the last sample was due, s
};

class ChannelReceiver : public SampleReceiver {
 public:
  explicit ChannelReceiver(const std::function<void(const double*)>& sink) : sink_(sink) {}
  void restart() override {}
  void sample(const RawSample& sample) override { sink_(sample.channels); }

 private:
  const std::function<void(const double*)>& sink_;
};

}  // namespace

StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   BlockPartition& shares, SampleReceiver& receiver, Diagnostics& diagnostics) {
  return Stream(log, mechanism, plan, shares, receiver, diagnostics).run();
}

StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   const std::function<void(const double* channels)>& sink, Diagnostics& diagnostics) {
  BlockPartition whole;
  ChannelReceiver receiver(sink);
  return stream(log, mechanism, plan, whole, receiver, diagnostics);
}

}  // namespace flatdyn
