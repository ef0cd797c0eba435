// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/motion_stream.hpp"

#include <Eigen/Core>
#include <cmath>

#include "identify/log_reader.hpp"
#include "identify/zero_phase.hpp"

namespace flatdyn {
namespace {

// The last samples, channel by channel, each contiguous: what a kernel is laid over.
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
  auto channel(int k) const { return samples_.col(k).segment(end_ - length_, length_); }
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

// The motion at the middle of a window.
class MotionFilter {
 public:
  explicit MotionFilter(const StreamPlan& plan)
      : layout_(plan.layout),
        n_(plan.layout.joints),
        filtered_(plan.band > 0),
        q_(n_),
        qd_(n_),
        qdd_(n_),
        tau_(n_),
        h_e_(LogLayout::kWrench) {
    if (!filtered_) return;
    const ZeroPhaseKernel kernel = zero_phase_kernel(plan.band, plan.dt);
    for (int order = 0; order < 3; ++order) {
      weights_[order] = Eigen::Map<const Eigen::VectorXd>(kernel.weights[order].data(), kernel.length());
    }
  }

  Motion motion(const Window& window) {
    const auto middle = window.channel(LogLayout::time()).size() / 2;
    smooth(window, LogLayout::q(), 0, q_);
    smooth(window, layout_.tau(), 0, tau_);
    if (layout_.has_rates) {
      smooth(window, layout_.qd(), 0, qd_);
    } else {
      smooth(window, LogLayout::q(), 1, qd_);
    }
    if (layout_.has_accelerations) {
      smooth(window, layout_.qdd(), 0, qdd_);
    } else if (layout_.has_rates) {
      smooth(window, layout_.qd(), 1, qdd_);
    } else {
      smooth(window, LogLayout::q(), 2, qdd_);
    }
    if (layout_.has_tip_force) smooth(window, layout_.h_e(), 0, h_e_);
    return {window.channel(LogLayout::time())[middle],    q_.data(), qd_.data(), qdd_.data(), tau_.data(),
            layout_.has_tip_force ? h_e_.data() : nullptr};
  }

 private:
  void smooth(const Window& window, int first, int order, Eigen::VectorXd& out) const {
    if (filtered_) {
      out.noalias() = window.channels(first, static_cast<int>(out.size())).transpose() * weights_[order];
    } else {
      out = window.channels(first, static_cast<int>(out.size())).row(0).transpose();
    }
  }

  LogLayout layout_;
  int n_;
  bool filtered_;
  Eigen::VectorXd weights_[3];
  Eigen::VectorXd q_, qd_, qdd_, tau_, h_e_;
};

// Which lines belong to a part: each N-th block, and around it what the filter's window needs.
class Blocks {
 public:
  Blocks(const StreamOptions& options, int half_window)
      : part_(options.part - 1), parts_(options.parts), half_(half_window) {}

  bool owns(long line) const { return line >= 0 && (line / kBlock) % parts_ == part_; }
  // The first line from `line` on that is needed.
  long next_needed(long line) const {
    if (parts_ == 1 || owns(line - half_) || owns(line + half_)) return line;
    const long block = (line + half_) / kBlock;
    const long ahead = ((part_ - block) % parts_ + parts_) % parts_;
    return (block + ahead) * kBlock - half_;
  }

 private:
  long part_, parts_, half_;
};

}  // namespace

StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   const StreamOptions& options, const MotionSink& sink, Diagnostics& diagnostics) {
  LogReader reader(log, mechanism, diagnostics);
  StreamCount count;
  const int half = plan.half_window;
  const Blocks blocks(options, half);
  Window window(plan.layout.channels(), 2 * half + 1);
  MotionFilter filter(plan);
  Eigen::VectorXd sample(plan.layout.channels());
  double last_time = 0;
  bool contiguous = false;
  for (long line = 0;; ++line) {
    if (const long needed = blocks.next_needed(line); needed > line) {
      line += reader.skip(needed - line);
      window.clear();
      contiguous = false;
    }
    if (!reader.next(sample.data())) break;
    const double step = sample[LogLayout::time()] - last_time;
    if (plan.band > 0 && contiguous && std::abs(step - plan.dt) > plan.dt / 2) {
      window.clear();
      ++count.gaps;
    }
    last_time = sample[LogLayout::time()];
    contiguous = true;
    window.push(sample);
    const long centre = line - half;
    if (blocks.owns(line)) ++count.lines;
    if (!window.full() || !blocks.owns(centre) || centre % plan.decimate != 0) continue;
    sink(filter.motion(window));
    ++count.used;
  }
  return count;
}

}  // namespace flatdyn
