// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/even_samples.hpp"

#include <algorithm>
#include <cmath>

#include "laboratory/identify/stamp_weights.hpp"

namespace flatdyn {
namespace {

constexpr int kMostMissing = 3;
constexpr std::size_t kNodes = 4;

}  // namespace

double longest_bridge(const SampleFilter& filter) {
  constexpr double kOff = 5e-3;
  const double bridged = filter.band > 0 ? step_of_cubic(kOff, filter.band) : 0;
  return std::max((kMostMissing + 1.5) * filter.dt, bridged);
}

StepCheck::StepCheck(const StreamPlan& plan)
    : plan_(plan), dt_(plan.filter.dt), longest_(longest_bridge(plan.filter)) {}

bool StepCheck::is_next(double step) const {
  constexpr double kMost = 0.5, kMostWithJitter = 0.9;  // shares of dt
  const bool is_counted = plan_.clock.kind == SampleClock::Kind::counted;
  return std::abs(step - dt_) <= (is_counted ? kMostWithJitter : kMost) * dt_;
}

// Where stamps are not those of samples, the step is that from the time at which the last sample was due: steps that
// are too long and too short by turns are no gaps.
StepCheck::Step StepCheck::step_to(double time) {
  constexpr double kFollows = 0.1;  // of the difference, at every sample
  const bool is_counted = plan_.clock.kind == SampleClock::Kind::counted;
  if (!has_last_) due_ = time - dt_;
  const double step = time - (has_last_ && !is_counted ? last_ : due_);
  const bool had_last = has_last_;
  due_ += is_next(step) ? dt_ : dt_ * std::max(1.0, std::round(step / dt_));
  due_ += kFollows * (time - due_);
  last_ = time;
  has_last_ = true;
  if (plan_.filter.band == 0 || !had_last) return {};
  const int missing = std::max(0, static_cast<int>(std::lround(step / dt_)) - 1);
  if (plan_.clock.is_interpolated()) return {step > longest_, missing};
  // Stamps of arrival are early where samples that were held up come all at once.
  if (is_next(step) || (is_counted && step < dt_)) return {};
  return {missing < 1 || step > longest_, missing};
}

EvenSamples::EvenSamples(const StreamPlan& plan, SampleReceiver& receiver)
    : plan_(plan), receiver_(receiver), dt_(plan.filter.dt), quaternions_(plan.layout().quaternions()) {}

bool EvenSamples::join(const RawSample& raw) {
  constexpr double kClose = 0.3;  // times dt
  if (!plan_.clock.is_interpolated() || held_.empty()) return false;
  std::vector<double>& last = held_.back().channels;
  if (raw.channels[0] - last[0] > kClose * dt_) return false;
  for (std::size_t c = 0; c < last.size(); ++c) last[c] = (last[c] + raw.channels[c]) / 2;
  return true;
}

void EvenSamples::sample(const RawSample& raw) {
  if (join(raw)) return;
  const auto channels = static_cast<std::size_t>(plan_.layout().channels());
  if (held_.size() == kNodes) {
    held_.push_back(std::move(held_.front()));  // its memory
    held_.pop_front();
  } else {
    held_.emplace_back();
  }
  Held& newest = held_.back();
  newest.channels.assign(raw.channels, raw.channels + channels);
  newest.sample = raw;
  if (held_.size() >= 2) pass_on(held_.size() - 2);
}

void EvenSamples::restart() {
  if (!held_.empty()) pass_on(held_.size() - 1);
  held_.clear();
  receiver_.restart();
}

void EvenSamples::pass_on(std::size_t at) {
  if (plan_.clock.is_interpolated()) return pass_on_grid(at);
  Held& next = held_[at];
  for (int k = 1; k <= next.sample.missing && at > 0; ++k) {
    const double before = held_[at - 1].channels[0];
    const double t = before + (next.channels[0] - before) * k / (next.sample.missing + 1);
    interpolate(t, plan_.index_of(t), next);
  }
  next.sample.channels = next.channels.data();
  receiver_.sample(next.sample);
}

// The points of the grid behind the sample before, up to this one.
void EvenSamples::pass_on_grid(std::size_t at) {
  if (at == 0) return;
  const auto place = [this](double time) { return (time - plan_.start) / dt_; };
  const double first = std::floor(place(held_[at - 1].channels[0])) + 1,
               last = std::floor(place(held_[at].channels[0]));
  for (double point = first; point <= last; ++point) {
    interpolate(plan_.start + point * dt_, static_cast<long>(point), held_[at]);
  }
}

void EvenSamples::interpolate(double t, long index, const Held& next) {
  double times[kNodes];
  for (std::size_t k = 0; k < held_.size(); ++k) times[k] = held_[k].channels[0];
  const std::vector<double> weights = interpolation_weights({times, held_.size()}, t);
  between_.assign(next.channels.size(), 0);
  for (std::size_t k = 0; k < held_.size(); ++k) {
    for (std::size_t c = 0; c < between_.size(); ++c) between_[c] += weights[k] * held_[k].channels[c];
  }
  between_[0] = t;
  for (const int first : quaternions_) {
    const auto begin = between_.begin() + first;
    double squares = 0;
    for (auto entry = begin; entry != begin + LogLayout::kQuaternion; ++entry) squares += *entry * *entry;
    for (auto entry = begin; entry != begin + LogLayout::kQuaternion; ++entry) *entry /= std::sqrt(squares);
  }
  receiver_.sample({between_.data(), next.sample.line, index, next.sample.file_line});
}

}  // namespace flatdyn
