// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/motion_stream.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "laboratory/identify/base_check.hpp"
#include "laboratory/identify/even_samples.hpp"
#include "laboratory/identify/log_reader.hpp"
#include "laboratory/identify/position_check.hpp"
#include "laboratory/identify/rate_check.hpp"
#include "laboratory/identify/signal_check.hpp"
#include "laboratory/identify/spike_repair.hpp"

namespace flatdyn {
namespace {

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
        half_window_(std::min(plan.lines_of(plan.filter.half_window() + SpikeRepair::kReach + EvenSamples::kReach +
                                            plan.filter.standing_samples()),
                              static_cast<int>(kBlock / 2))),
        shares_(shares),
        rate_checked_(log.string(), rates_, receiver, diagnostics),
        even_(plan, rate_checked_),
        spikes_(plan, even_),
        receiver_(plan.filter.band > 0 ? static_cast<SampleReceiver&>(spikes_) : rate_checked_),
        steps_(plan),
        repeats_(plan.clock, plan.layout().channels(), longest_bridge(plan.filter) - 1.5 * plan.filter.dt),
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
      if (plan_.filter.band > 0 && repeats_.is_repeat(sample_.data())) {
        if (shares_.owns(line)) ++count_.repeated;
        continue;
      }
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
    receiver_.restart();
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
    steps_.restart();
    signals_.restart();
    base_.restart();
  }

  void pass_on(long line) {
    const StepCheck::Step step = steps_.step_to(sample_[0]);
    const bool owned = shares_.owns(line);
    if (step.is_gap) {
      restart();
      steps_.step_to(sample_[0]);
      if (owned) ++count_.gaps;
    } else if (owned) {
      count_.interpolated += step.missing;
    }
    if (plan_.filter.band > 0) signals_.add(sample_.data(), reader_.line());
    receiver_.sample(
        {sample_.data(), line, plan_.index_of(sample_[0]), reader_.line(), step.is_gap ? 0 : step.missing});
  }

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
  EvenSamples even_;
  SpikeRepair spikes_;
  SampleReceiver& receiver_;  // of all samples: the spikes' with a filter
  StepCheck steps_;
  RepeatFilter repeats_;
  std::vector<double> sample_;
  StreamCount count_;
  Place first_;  // place of the first sample that is read
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
