// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/motion_stream.hpp"

#include <Eigen/Core>
#include <cmath>

#include "identify/log_reader.hpp"
#include "identify/position_check.hpp"
#include "identify/rate_check.hpp"
#include "identify/zero_phase.hpp"

namespace flatdyn {
namespace {

// The last samples, channel by channel, each contiguous, so that a kernel can be applied.
class Window {
 public:
  Window(int channels, int length) : length_(length), samples_(2 * length + kSlack, channels) {}

  void push(const Eigen::VectorXd& sample) {
    if (end_ == samples_.rows()) restart_buffer();
    samples_.row(end_++) = sample.transpose();
    if (held_ < length_) ++held_;
  }
  void clear() { held_ = 0; }
  bool full() const { return held_ == length_; }
  auto channels(int first, int count) const { return samples_.block(end_ - length_, first, length_, count); }

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

// A sample of a log that has all signals.
MeasuredMotion as_measured(const LogLayout& layout, const double* channels) {
  return {channels[LogLayout::time()],
          channels + LogLayout::q(),
          channels + layout.qd(),
          channels + layout.qdd(),
          layout.has_torques ? channels + layout.tau() : nullptr,
          layout.has_tip_force ? channels + layout.h_e() : nullptr};
}

// Computes the motion at the middle of a window.
class MotionFilter {
 public:
  explicit MotionFilter(const StreamPlan& plan)
      : layout_(plan.layout()),
        n_(plan.layout().joints),
        q_(plan.layout().positions),
        qd_(n_),
        qdd_(n_),
        tau_(n_),
        h_e_(LogLayout::kWrench) {
    const ZeroPhaseKernel kernel = zero_phase_kernel(plan.filter.band, plan.filter.dt);
    for (int order = 0; order < 3; ++order) {
      weights_[order] = Eigen::Map<const Eigen::VectorXd>(kernel.weights[order].data(), kernel.length());
    }
  }

  MeasuredMotion motion(const Window& window) {
    const auto times = window.channels(LogLayout::time(), 1);
    smooth(window, LogLayout::q(), 0, q_);
    if (layout_.has_torques) smooth(window, layout_.tau(), 0, tau_);
    if (layout_.has_rates) {
      smooth(window, layout_.qd(), 0, qd_);
    } else {
      smooth_positions(window, 1, qd_);
    }
    if (layout_.has_accelerations) {
      smooth(window, layout_.qdd(), 0, qdd_);
    } else if (layout_.has_rates) {
      smooth(window, layout_.qd(), 1, qdd_);
    } else {
      smooth_positions(window, 2, qdd_);
    }
    if (layout_.has_tip_force) smooth(window, layout_.h_e(), 0, h_e_);
    return {times(times.rows() / 2, 0),
            q_.data(),
            qd_.data(),
            qdd_.data(),
            layout_.has_torques ? tau_.data() : nullptr,
            layout_.has_tip_force ? h_e_.data() : nullptr};
  }

 private:
  void smooth(const Window& window, int first, int order, Eigen::VectorXd& out) const {
    out.noalias() = window.channels(first, static_cast<int>(out.size())).transpose() * weights_[order];
  }

  // Smooths the positions that have a rate q̇.
  void smooth_positions(const Window& window, int order, Eigen::VectorXd& out) const {
    if (layout_.positions == layout_.joints) return smooth(window, LogLayout::q(), order, out);
    const Eigen::VectorXd all = window.channels(LogLayout::q(), layout_.positions).transpose() * weights_[order];
    for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = all[layout_.position_of[static_cast<std::size_t>(i)]];
  }

  LogLayout layout_;
  int n_;
  Eigen::VectorXd weights_[3];
  Eigen::VectorXd q_, qd_, qdd_, tau_, h_e_;
};

// One log on its way through reader, window and filter.
class Stream {
 public:
  Stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan, BlockPartition& shares,
         Diagnostics& diagnostics)
      : reader_(log, plan.heading, diagnostics),
        diagnostics_(diagnostics),
        positions_(mechanism, plan.heading),
        rates_(mechanism, plan.heading, plan.filter.dt),
        plan_(plan),
        half_window_(plan.filter.half_window()),
        shares_(shares),
        window_(plan.layout().channels(), 2 * half_window_ + 1),
        sample_(plan.layout().channels()) {
    if (plan.filter.band > 0) filter_.emplace(plan);
  }

  StreamCount run(const MotionSink& sink) {
    for (long line = 0;; ++line) {
      if (!skip_to_needed(line) || !reader_.next(sample_.data())) {
        shares_.end_log(line);
        if (!diagnostics_.has_errors()) rates_.finish(first_, diagnostics_);
        return count_;
      }
      if (first_.line == 0) first_ = reader_.place();
      if (positions_.is_odd(sample_.data()) && !positions_.accepts(sample_.data(), reader_.place(), diagnostics_)) {
        return count_;
      }
      rates_.add(
          sample_.data(), [this] { return reader_.place(); }, diagnostics_);
      if (shares_.owns(line)) ++count_.lines;
      const bool complete = !filter_ || window_is_full();
      const long centre = line - half_window_;
      if (!complete || !shares_.owns(centre) || centre % plan_.filter.decimate != 0) continue;
      sink(filter_ ? filter_->motion(window_) : as_measured(plan_.layout(), sample_.data()));
      ++count_.used;
    }
  }

 private:
  // Whether the line belongs to the part, or to the filter's window about a line of the part.
  bool is_needed(long line) {
    return shares_.is_whole() || shares_.owns(line - half_window_) || shares_.owns(line + half_window_);
  }

  // Skips blocks of other parts. Returns false at the end of the log.
  bool skip_to_needed(long& line) {
    while (!is_needed(line)) {
      const long half = half_window_, next = ((line + half) / kBlock + 1) * kBlock - half;
      line += reader_.skip(next - line);
      window_.clear();
      rates_.restart();
      contiguous_ = false;
      if (line < next) return false;
    }
    return true;
  }

  // Whether the window is full with the new sample; a gap in time before it empties the window.
  bool window_is_full() {
    const double time = sample_[LogLayout::time()];
    const double dt = plan_.filter.dt;
    if (contiguous_ && std::abs(time - last_time_ - dt) > dt / 2) {
      window_.clear();
      ++count_.gaps;
    }
    last_time_ = time;
    contiguous_ = true;
    window_.push(sample_);
    return window_.full();
  }

  LogReader reader_;
  Diagnostics& diagnostics_;
  PositionCheck positions_;
  RateCheck rates_;
  const StreamPlan& plan_;
  int half_window_;
  BlockPartition& shares_;
  Window window_;
  std::optional<MotionFilter> filter_;
  Eigen::VectorXd sample_;
  StreamCount count_;
  Place first_;  // place of the first sample that is read
  double last_time_ = 0;
  bool contiguous_ = false;
};

}  // namespace

StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   BlockPartition& shares, const MotionSink& sink, Diagnostics& diagnostics) {
  return Stream(log, mechanism, plan, shares, diagnostics).run(sink);
}

StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   const MotionSink& sink, Diagnostics& diagnostics) {
  BlockPartition whole;
  return stream(log, mechanism, plan, whole, sink, diagnostics);
}

}  // namespace flatdyn
