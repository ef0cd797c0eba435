// SPDX-License-Identifier: GPL-2.0-or-later
// From the samples of a log to filtered equations (SampleFilter).
#pragma once

#include <Eigen/Core>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "laboratory/identify/equation_model.hpp"
#include "laboratory/identify/motion_filter.hpp"
#include "laboratory/identify/sample_window.hpp"

namespace flatdyn {

// The equations at one instant, valid during the call. An equation that is not used speaks of a joint that rests near
// this instant, whose friction may be anything up to F_s, or that turns around so slowly that its noise hides when.
struct FilteredEquations {
  MeasuredMotion motion;
  std::size_t positions = 0, rates = 0;  // lengths of q, and of q̇ and q̈
  long line = 0;                         // of the log, counted from 0
  long index = 0;                   // counts the instants: 1 more than that of the one before it, unless time has a gap
  const double* entries = nullptr;  // of Y, filtered
  const double* right = nullptr;    // what is measured less what is known, filtered
  const double* measured_rates = nullptr;  // of what is measured, by time; zeros without a filter
  // The part of what is measured that is faster than the band; null without a filter or with a delay.
  const double* fast = nullptr;
  const std::uint8_t* used = nullptr;  // by equation
  // The entries of Y along the same motion, smoothed by a Gaussian whose standard deviation is 1 / band: almost none of
  // the noise in q is left. Null unless the equations want them.
  const double* instruments = nullptr;
};
using EquationSink = std::function<void(const FilteredEquations&)>;

class EquationFilter : public SampleReceiver {
 public:
  EquationFilter(const StreamPlan& plan, const EquationModel& model, EquationSink sink);

  void restart() override;
  void sample(const RawSample& sample) override;

 private:
  // The motion at a stride, which joints rest, and which have done so for long.
  struct GridMotion : SmoothedMotion {
    double time = 0;
    long index = 0;
    Eigen::VectorXd factors{};  // by friction entry: what its value is multiplied by
    std::vector<std::uint8_t> rests, stands;
  };

  void mark_rest();
  void mark_standing();
  void push_row(GridMotion motion);
  void push_sample(const GridMotion& from, const GridMotion& to, int part);
  // The entries of Y that are friction.
  Eigen::VectorXd friction_of(const Eigen::VectorXd& entries) const;
  bool sticks(int joint, int back, double speed) const;
  void pass_on(long index);
  void set_instruments(int rows_back, double time);

  // Places in the channels of `rows_`: the entries of Y, then
  int known() const { return model_.entries(); }
  int motion_at() const { return known() + model_.equations(); }
  int motions() const { return layout_.positions + 2 * n_; }
  // and in those of `samples_window_`.
  static constexpr int time_at() { return 0; }
  static constexpr int line_at() { return 1; }
  static constexpr int measured_at() { return 2; }
  int friction_at() const { return measured_at() + model_.equations(); }
  int unsure_at() const { return friction_at() + static_cast<int>(model_.friction().size()); }

  const StreamPlan& plan_;
  const EquationModel& model_;
  EquationSink sink_;
  LogLayout layout_;
  int n_, stride_, lookahead_;
  int motion_half_, row_half_;                                        // SampleFilter's: in samples, in strides
  Eigen::VectorXd row_weights_;                                       // of Y, at its strides
  Eigen::VectorXd slow_weights_;                                      // of the slow motion, at the same strides
  Eigen::VectorXd sample_weights_, measured_weights_, rate_weights_;  // of friction, τ and dτ/dt, at every sample
  int row_kernel_half_, sample_kernel_half_;                          // their half lengths
  MotionFilter motion_filter_;
  SampleWindow raw_, rows_, samples_window_;
  std::deque<GridMotion> pending_;    // motions for which it is not known yet which joints rest
  std::optional<GridMotion> before_;  // the last motion that left `pending_`
  std::vector<int> slow_;             // by joint: for how many strides it has been slow
  std::vector<int> near_;             // by joint: for how many strides it has been near
  Eigen::VectorXd anchors_;           // this position
  long samples_ = 0, motions_ = 0;    // since the restart
  long first_index_ = 0;              // RawSample::index of the first sample since the restart
  Eigen::VectorXd entries_, right_, fast_, rates_, motion_, speeds_, slow_motion_, instruments_, known_of_slow_;
  std::vector<std::uint8_t> used_;
};

}  // namespace flatdyn
