// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/equation_filter.hpp"

#include <cmath>
#include <utility>

#include "laboratory/identify/zero_phase.hpp"

namespace flatdyn {
namespace {

using Eigen::VectorXd;

VectorXd as_weights(const std::vector<double>& weights) {
  return Eigen::Map<const VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size()));
}

// The weights of the narrow filter at samples that are dt apart.
VectorXd narrow_weights(double band, double dt) {
  return band == 0 ? VectorXd::Ones(1) : as_weights(zero_phase_kernel(band, dt).weights[0]);
}

// The weights of the rate of what is measured; without a filter there is no rate.
VectorXd rate_weights(const StreamPlan& plan) {
  const auto& [dt, band, decimate] = plan.filter;
  return band == 0 ? VectorXd::Zero(1) : as_weights(rate_weights_ahead(band, dt, plan.delay));
}

// The weights of the slow motion where the narrow filter has `length` weights: a Gaussian, whose standard deviation is
// 1 / band. The filter's ends are 4.5 of these away.
VectorXd gaussian_weights(const SampleFilter& filter, Eigen::Index length) {
  VectorXd weights(length);
  const Eigen::Index middle = length / 2;
  for (Eigen::Index k = 0; k < length; ++k) {
    const double t = static_cast<double>(k - middle) * filter.dt * filter.stride();
    weights[k] = std::exp(-std::pow(filter.band * t, 2) / 2);
  }
  return weights / weights.sum();
}

int half_of(const VectorXd& weights) { return static_cast<int>(weights.size()) / 2; }

// Cubic between two samples `step` apart that have slopes, at a part 0 … 1 of the way.
double between(double from, double slope_from, double to, double slope_to, double step, double part) {
  const double u = part, v = 1 - part;
  return v * v * (from * (1 + 2 * u) + step * slope_from * u) + u * u * (to * (1 + 2 * v) - step * slope_to * v);
}

}  // namespace

EquationFilter::EquationFilter(const StreamPlan& plan, const EquationModel& model, EquationSink sink)
    : plan_(plan),
      model_(model),
      sink_(std::move(sink)),
      layout_(plan.layout()),
      n_(layout_.rates()),
      stride_(plan.filter.stride()),
      lookahead_(plan.filter.rest_strides()),
      motion_half_(plan.filter.motion_half_window()),
      row_half_(plan.filter.row_half_window()),
      row_weights_(narrow_weights(plan.filter.band, plan.filter.dt * stride_)),
      slow_weights_(gaussian_weights(plan.filter, row_weights_.size())),
      sample_weights_(narrow_weights(plan.filter.band, plan.filter.dt)),
      measured_weights_(plan.delay == 0 ? sample_weights_
                                        : as_weights(weights_ahead(plan.filter.band, plan.filter.dt, plan.delay))),
      rate_weights_(rate_weights(plan)),
      row_kernel_half_(half_of(row_weights_)),
      sample_kernel_half_(half_of(sample_weights_)),
      motion_filter_(plan),
      raw_(layout_.channels() + 1, motion_half_ + 1 + std::max(motion_half_, (lookahead_ + 1) * stride_)),
      rows_(motion_at() + motions(), row_half_ + row_kernel_half_ + 1),
      samples_window_(unsure_at() + n_, row_half_ * stride_ + sample_kernel_half_ + 1),
      slow_(static_cast<std::size_t>(n_), 0),
      near_(static_cast<std::size_t>(n_), 0),
      anchors_(n_),
      entries_(model.entries()),
      right_(model.equations()),
      fast_(model.equations()),
      rates_(model.equations()),
      motion_(motions()),
      speeds_(n_),
      slow_motion_(motions()),
      instruments_(model.entries()),
      known_of_slow_(model.equations()),
      used_(static_cast<std::size_t>(model.equations()), 1) {}

void EquationFilter::restart() {
  raw_.clear();
  rows_.clear();
  samples_window_.clear();
  pending_.clear();
  before_.reset();
  slow_.assign(slow_.size(), 0);
  samples_ = motions_ = 0;
}

void EquationFilter::sample(const RawSample& sample) {
  if (samples_ == 0) first_index_ = sample.index;
  auto row = raw_.push();
  row.head(layout_.channels()) = Eigen::Map<const VectorXd>(sample.channels, layout_.channels()).transpose();
  row[layout_.channels()] = static_cast<double>(sample.line);
  const long newest = first_index_ + samples_++;
  const long middle = newest - motion_half_;
  if (samples_ < 2 * motion_half_ + 1 || middle % stride_ != 0) return;
  GridMotion motion;
  motion.index = middle;
  motion.time = raw_.sample(motion_half_)[LogLayout::time()];
  motion_filter_.filter(raw_, motion);
  motion.rests.assign(static_cast<std::size_t>(n_), 0);
  motion.stands.assign(static_cast<std::size_t>(n_), 0);
  pending_.push_back(std::move(motion));
  mark_rest();
  mark_standing();
  if (static_cast<int>(pending_.size()) <= lookahead_) return;
  GridMotion oldest = std::move(pending_.front());
  pending_.pop_front();
  // Whether a joint rests at the first motions depends on samples before the restart.
  if (motions_++ >= lookahead_) push_row(std::move(oldest));
}

// A joint rests where it stays slow for longer than the lookahead, from the beginning of that time to its end.
void EquationFilter::mark_rest() {
  for (int j = 0; j < n_; ++j) {
    const auto at = static_cast<std::size_t>(j);
    const bool is_slow = std::abs(pending_.back().qd[j]) < plan_.rest_speed[at];
    slow_[at] = is_slow ? slow_[at] + 1 : 0;
    if (slow_[at] <= lookahead_) continue;
    pending_.back().rests[at] = 1;
    if (slow_[at] > lookahead_ + 1) continue;
    for (auto motion = pending_.rbegin(); motion != pending_.rbegin() + lookahead_ + 1; ++motion) motion->rests[at] = 1;
  }
}

// A joint stands still where its position stays the same for five periods of the band, but for the encoder's step and
// noise. One that turns around slowly, or creeps, is slow for a while, too, but its accelerations count in the
// equations of the others. At the beginning of a log a joint counts as standing until it moves.
void EquationFilter::mark_standing() {
  constexpr double kSteps = 1.5, kDeviations = 5;  // of the encoder, of its noise
  if (plan_.filter.band == 0) return;
  const int long_time = plan_.filter.standing_strides();
  GridMotion& newest = pending_.back();
  for (int j = layout_.base; j < n_; ++j) {
    if (layout_.spherical_of(j)) continue;  // its rates are of all entries of its quaternion
    const auto at = static_cast<std::size_t>(j);
    const int position = layout_.position_of[at];
    const auto [step, deviation] = plan_.q_noise(position);
    const bool is_first = motions_ == 0 && pending_.size() == 1;
    if (is_first) near_[at] = long_time;
    if (is_first) anchors_[j] = newest.q[position];
    ++near_[at];
    if (std::abs(newest.q[position] - anchors_[j]) > std::max(kSteps * step, kDeviations * deviation)) {
      near_[at] = 0;
      anchors_[j] = newest.q[position];
      for (GridMotion& each : pending_) each.stands[at] = 0;
    }
    newest.stands[at] = near_[at] > long_time && plan_.rest_speed[at] > 0 ? 1 : 0;
  }
}

// A joint that stands still has no speed and no acceleration: those that the filter finds are noise. Without a filter,
// one slow sample counts as rest, and its acceleration is the log's.
void EquationFilter::push_row(GridMotion motion) {
  for (int j = 0; j < n_ && plan_.filter.band > 0; ++j) {
    if (motion.stands[static_cast<std::size_t>(j)] != 0) motion.qd[j] = motion.qdd[j] = 0;
  }
  const MeasuredMotion measured{motion.time,
                                motion.q.data(),
                                motion.qd.data(),
                                motion.qdd.data(),
                                layout_.has_tip_force ? motion.h_e.data() : nullptr,
                                layout_.has_temperatures ? motion.temperatures.data() : nullptr};
  model_.evaluate(measured, entries_.data(), right_.data());
  motion.factors = friction_of(entries_);
  auto row = rows_.push();
  row.head(known()) = entries_.transpose();
  row.segment(known(), model_.equations()) = right_.transpose();
  row.segment(motion_at(), layout_.positions) = motion.q.transpose();
  row.segment(motion_at() + layout_.positions, n_) = motion.qd.transpose();
  row.segment(motion_at() + layout_.positions + n_, n_) = motion.qdd.transpose();
  if (before_) {
    for (int part = 1; part < stride_; ++part) push_sample(*before_, motion, part);
  }
  push_sample(before_ ? *before_ : motion, motion, stride_);
  const long index = motion.index - static_cast<long>(row_half_) * stride_;
  before_ = std::move(motion);
  if (rows_.full() && samples_window_.full() && index % plan_.filter.decimate == 0) pass_on(index);
}

// Whether the reading of a joint's position stays the same for far longer than its step explains at a speed: the joint
// sticks, and the filter smears the speeds before and after. `back`: the sample's place in `raw_`.
bool EquationFilter::sticks(int joint, int back, double speed) const {
  constexpr int kLeast = 4, kMost = 64;  // samples
  constexpr double kTimes = 3, kRounding = 1e-12;
  const int position = layout_.position_of[static_cast<std::size_t>(joint)];
  const double step = plan_.q_noise(position).step;
  const double expected = kTimes * step / (std::abs(speed) * plan_.filter.dt);
  if (!(expected < kMost)) return false;
  const int channel = LogLayout::q() + position;
  const double reading = raw_.sample(back)[channel];
  const auto is_same = [&](int at) {
    return std::abs(raw_.sample(at)[channel] - reading) <= kRounding * std::max(1.0, std::abs(reading));
  };
  const int before = std::min(kMost, raw_.held() - 1 - back), behind = std::min(kMost, back);
  int run = 1;
  for (int k = 1; k <= before && is_same(back + k); ++k) ++run;
  for (int k = 1; k <= behind && is_same(back - k); ++k) ++run;
  return run > kLeast + expected;
}

// Pushes what is measured, and speeds and their signs, at a sample between two motions.
void EquationFilter::push_sample(const GridMotion& from, const GridMotion& to, int part) {
  constexpr double kUnsure = 0.4;  // share of the rest speed, which has five standard deviations of noise
  const long newest = first_index_ + samples_ - 1, index = to.index - stride_ + part;
  const auto raw = raw_.sample(static_cast<int>(newest - index));
  auto sample = samples_window_.push();
  sample[time_at()] = raw[LogLayout::time()];
  sample[line_at()] = raw[layout_.channels()];
  sample.segment(measured_at(), model_.equations()) = raw.segment(model_.measured(layout_), model_.equations());
  const double step = plan_.filter.dt * stride_, share = static_cast<double>(part) / stride_;
  for (int j = 0; j < n_; ++j) {
    const auto at = static_cast<std::size_t>(j);
    const bool rests = from.rests[at] != 0 || to.rests[at] != 0;
    double speed = rests ? 0 : between(from.qd[j], from.qdd[j], to.qd[j], to.qdd[j], step, share);
    const bool has_reading = j >= layout_.base && !layout_.spherical_of(j);
    if (has_reading && !rests && plan_.filter.band > 0 && sticks(j, static_cast<int>(newest - index), speed)) speed = 0;
    speeds_[j] = speed;
    sample[unsure_at() + j] = std::abs(speed) < kUnsure * plan_.rest_speed[at] ? 1 : 0;
  }
  for (std::size_t k = 0; k < model_.friction().size(); ++k) {
    const FrictionEntry& each = model_.friction()[k];
    const auto at = static_cast<Eigen::Index>(k);
    const double factor = from.factors[at] + share * (to.factors[at] - from.factors[at]);
    sample[friction_at() + static_cast<int>(k)] = factor * each.value(speeds_[each.joint]);
  }
}

VectorXd EquationFilter::friction_of(const VectorXd& entries) const {
  VectorXd result(static_cast<Eigen::Index>(model_.friction().size()));
  for (Eigen::Index k = 0; k < result.size(); ++k) {
    result[k] = entries[model_.friction()[static_cast<std::size_t>(k)].entry];
  }
  return result;
}

void EquationFilter::pass_on(long index) {
  constexpr double kMostUnsure = 0.02;  // share of the filter's weights that may lie on unsure friction
  const int rows = 2 * row_kernel_half_ + 1, rows_back = row_half_ - row_kernel_half_;
  const int samples = 2 * sample_kernel_half_ + 1, samples_back = row_half_ * stride_ - sample_kernel_half_;
  entries_.noalias() = rows_.block(rows_back, rows, 0, model_.entries()).transpose() * row_weights_;
  right_.noalias() =
      samples_window_.block(samples_back, samples, measured_at(), model_.equations()).transpose() * measured_weights_;
  const auto middle = samples_window_.sample(row_half_ * stride_);
  fast_ = middle.segment(measured_at(), model_.equations()).transpose() - right_;
  right_.noalias() -= rows_.block(rows_back, rows, known(), model_.equations()).transpose() * row_weights_;
  const auto laws = static_cast<int>(model_.friction().size());
  const VectorXd friction =
      samples_window_.block(samples_back, samples, friction_at(), laws).transpose() * sample_weights_;
  for (int k = 0; k < laws; ++k) entries_[model_.friction()[static_cast<std::size_t>(k)].entry] = friction[k];
  const VectorXd unsure =
      samples_window_.block(samples_back, samples, unsure_at(), n_).transpose() * sample_weights_.cwiseAbs();
  for (int i = 0; i < model_.equations(); ++i) {
    const bool is_sure = !model_.has_friction(i) || unsure[i] <= kMostUnsure;
    used_[static_cast<std::size_t>(i)] = is_sure && model_.is_measured(layout_, i) ? 1 : 0;
  }
  motion_.noalias() = rows_.block(rows_back, rows, motion_at(), motions()).transpose() * row_weights_;
  rates_.noalias() =
      samples_window_.block(samples_back, samples, measured_at(), model_.equations()).transpose() * rate_weights_;
  for (std::size_t i = 0; i < model_.rate_entries().size(); ++i) {
    entries_[model_.rate_entries()[i]] = -rates_[static_cast<Eigen::Index>(i)];
  }
  FilteredEquations equations;
  equations.motion = {middle[time_at()], motion_.data(), motion_.data() + layout_.positions,
                      motion_.data() + layout_.positions + n_, nullptr};
  equations.positions = static_cast<std::size_t>(layout_.positions);
  equations.rates = static_cast<std::size_t>(n_);
  equations.line = std::lround(middle[line_at()]);
  equations.index = index / plan_.filter.decimate;
  equations.entries = entries_.data();
  equations.right = right_.data();
  equations.measured_rates = rates_.data();
  if (plan_.filter.band > 0 && plan_.delay == 0) equations.fast = fast_.data();
  equations.used = used_.data();
  if (model_.has_instruments()) {
    set_instruments(rows_back, middle[time_at()]);
    equations.instruments = instruments_.data();
  }
  sink_(equations);
}

// Friction jumps, and is filtered as that of Y is, with the speed that the slow motion has about this instant. Drives
// warm up slowly, so that the newest temperatures serve.
void EquationFilter::set_instruments(int rows_back, double time) {
  const auto rows = static_cast<int>(slow_weights_.size());
  const int middle = rows / 2;
  slow_motion_.noalias() = rows_.block(rows_back, rows, motion_at(), motions()).transpose() * slow_weights_;
  const double *qd = slow_motion_.data() + layout_.positions, *qdd = qd + n_;
  const double* temperatures = layout_.has_temperatures ? before_->temperatures.data() : nullptr;
  model_.evaluate({time, slow_motion_.data(), qd, qdd, nullptr, temperatures}, instruments_.data(),
                  known_of_slow_.data());
  const double step = plan_.filter.dt * stride_;
  for (const FrictionEntry& each : model_.friction()) {
    double value = 0;
    for (int k = 0; k < rows; ++k) {
      value += row_weights_[k] * each.value(qd[each.joint] + qdd[each.joint] * step * (k - middle));
    }
    instruments_[each.entry] *= value;
  }
}

}  // namespace flatdyn
