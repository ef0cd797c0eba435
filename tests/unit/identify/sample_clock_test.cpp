// SPDX-License-Identifier: GPL-2.0-or-later
// Uneven stamps, gaps and repeated readings: signals of known course, at stamps that are right or wrong.
#include "laboratory/identify/sample_clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "laboratory/identify/even_samples.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;

constexpr double kDt = 1e-3;

LogLayout one_joint() {
  LogLayout layout;
  layout.joints = layout.positions = 1;
  layout.position_of = {0};
  return layout;
}

double position(double t) { return std::sin(2 * t) + 0.2 * std::cos(9 * t); }
double torque(double t) { return 3 * std::cos(4 * t); }

// Times that are 0.7 to 1.3 ms apart.
std::vector<double> uneven_times(std::size_t count) {
  testing::Uniform draw(3);
  std::vector<double> times = {0};
  while (times.size() < count) times.push_back(times.back() + kDt * (1 + 0.3 * draw()));
  return times;
}

// Samples taken at `taken`, with other stamps.
std::vector<std::vector<double>> samples_at(const std::vector<double>& taken, const std::vector<double>& stamps) {
  std::vector<std::vector<double>> samples;
  for (std::size_t k = 0; k < taken.size(); ++k) {
    samples.push_back({stamps[k], position(taken[k]), torque(taken[k])});
  }
  return samples;
}

std::vector<double> even_times(std::size_t count) {
  std::vector<double> times;
  for (std::size_t k = 0; k < count; ++k) times.push_back(kDt * static_cast<double>(k));
  return times;
}

TEST(SampleClock, IsEven) {
  const std::vector<double> times = even_times(2000);
  const SampleClock clock = sample_clock(one_joint(), {samples_at(times, times)});
  EXPECT_EQ(clock.kind, SampleClock::Kind::even);
  EXPECT_NEAR(clock.dt, kDt, 1e-9);
  EXPECT_EQ(clock_text(clock, 0.005, 10), "");
}

TEST(SampleClock, TrustsStampsAtWhichTheMotionIsSmooth) {
  const std::vector<double> times = uneven_times(2000);
  const SampleClock clock = sample_clock(one_joint(), {samples_at(times, times)});
  EXPECT_EQ(clock.kind, SampleClock::Kind::stamped);
  EXPECT_NEAR(clock.dt, times.back() / 1999, 1e-12);
  EXPECT_THAT(clock_text(clock, 0.005, 10), HasSubstr("interpolated at their stamps"));
}

TEST(SampleClock, DoesNotTrustStampsOfArrival) {
  const SampleClock clock = sample_clock(one_joint(), {samples_at(even_times(2000), uneven_times(2000))});
  EXPECT_EQ(clock.kind, SampleClock::Kind::counted);
  EXPECT_THAT(clock_text(clock, 0.005, 10), HasSubstr("taken evenly, whatever their stamps"));
}

TEST(SampleClock, DoesAsItIsTold) {
  const std::vector<double> times = uneven_times(2000);
  const std::vector<std::vector<double>> samples = samples_at(times, times);
  EXPECT_EQ(sample_clock(one_joint(), {samples}, ClockChoice::counted).kind, SampleClock::Kind::counted);
  EXPECT_EQ(sample_clock(one_joint(), {samples}, ClockChoice::stamped).kind, SampleClock::Kind::stamped);
}

// A robot that rests first tells nothing then.
TEST(SampleClock, LooksWhereTheRobotMoves) {
  const std::vector<double> times = uneven_times(2000);
  SampleRun moving = samples_at(times, times), resting = moving;
  testing::Uniform draw(5);
  for (std::vector<double>& sample : resting) sample[1] = 0.3 + 1e-5 * draw();
  EXPECT_EQ(sample_clock(one_joint(), {resting, moving}).kind, SampleClock::Kind::stamped);
}

// Stamps in whole milliseconds of samples at 240 Hz: four, four, four, four, four, five.
TEST(SampleClock, TakesTheMeanStepOfStampsThatAreRounded) {
  std::vector<double> taken, stamps;
  for (int k = 0; k < 2400; ++k) {
    taken.push_back(k / 240.0);
    stamps.push_back(std::floor(taken.back() * 1000) / 1000);
  }
  EXPECT_NEAR(sample_clock(one_joint(), {samples_at(taken, stamps)}).dt, 1 / 240.0, 2e-6);
}

TEST(SampleClock, TakesTheMeanStepOfSamplesThatArriveInPairs) {
  const std::vector<double> taken = even_times(2000);
  std::vector<double> stamps;
  for (std::size_t k = 0; k < taken.size(); ++k) {
    stamps.push_back(kDt * static_cast<double>(k - k % 2) + (k % 2 == 0 ? 0 : 5e-5));
  }
  const SampleClock clock = sample_clock(one_joint(), {samples_at(taken, stamps)});
  EXPECT_EQ(clock.kind, SampleClock::Kind::counted);
  EXPECT_NEAR(clock.dt, kDt, 2e-6);
}

// A clock whose rate drifts by 5 % is no matter of arrival, though neighbours do not show it.
TEST(SampleClock, FollowsStampsThatDrift) {
  std::vector<double> times = {0};
  for (int k = 1; k < 8000; ++k) times.push_back(times.back() + kDt * (1 + 0.05 * std::sin(k / 1000.0)));
  EXPECT_EQ(sample_clock(one_joint(), {samples_at(times, times)}).kind, SampleClock::Kind::stamped);
}

// Readings at rest that change now and then are not those of a slower sensor.
TEST(SampleClock, TakesNoRestForARepetition) {
  const std::vector<double> times = even_times(6000);
  SampleRun samples = samples_at(times, times);
  testing::Uniform draw(7);
  double reading = 0.3;
  for (std::vector<double>& sample : samples) {
    if (std::abs(draw()) < 0.1) reading += draw() > 0 ? 1e-4 : -1e-4;
    sample[1] = sample[2] = reading;
  }
  EXPECT_EQ(sample_clock(one_joint(), {samples}).held, 1);
}

TEST(SampleClock, FindsReadingsThatAreRepeated) {
  std::vector<double> taken, stamps = even_times(4000);
  for (std::size_t k = 0; k < stamps.size(); ++k) taken.push_back(stamps[k - k % 4]);
  const std::vector<std::vector<double>> samples = samples_at(taken, stamps);
  const SampleClock clock = sample_clock(one_joint(), {samples});
  EXPECT_NEAR(clock.held, 4, 0.01);
  EXPECT_NEAR(clock.dt, 4 * kDt, 1e-9);
  RepeatFilter filter(clock, 3, 0.01);
  std::size_t kept = 0;
  for (const std::vector<double>& sample : samples) kept += filter.is_repeat(sample.data()) ? 0 : 1;
  EXPECT_EQ(kept, 1000U);
  EXPECT_THAT(clock_text(clock, 0.005, 10), HasSubstr("change at every 4 lines only"));
}

// Keeps what it is given, and how far positions are off.
class Kept : public SampleReceiver {
 public:
  void restart() override { ++restarts; }
  void sample(const RawSample& sample) override {
    times.push_back(sample.channels[0]);
    indices.push_back(sample.index);
    largest_error = std::max(largest_error, std::abs(sample.channels[1] - position(sample.channels[0])));
  }

  std::vector<double> times;
  std::vector<long> indices;
  double largest_error = 0;
  int restarts = 0;
};

StreamPlan plan_of(SampleClock::Kind kind) {
  StreamPlan plan;
  plan.heading.layout = one_joint();
  plan.clock.kind = kind;
  plan.filter.dt = plan.clock.dt = kDt;
  plan.filter.band = 10;
  return plan;
}

// Feeds samples at these times; returns how many gaps there were.
int feed(const StreamPlan& plan, const std::vector<double>& times, Kept& kept) {
  EvenSamples even(plan, kept);
  StepCheck steps(plan);
  int gaps = 0;
  for (const std::vector<double>& sample : samples_at(times, times)) {
    StepCheck::Step step = steps.step_to(sample[0]);
    if (step.is_gap) {
      ++gaps;
      even.restart();
      steps.restart();
      step = steps.step_to(sample[0]);
    }
    even.sample({sample.data(), 0, plan.index_of(sample[0]), 0, step.missing});
  }
  even.restart();
  return gaps;
}

void expect_consecutive(const Kept& kept) {
  for (std::size_t k = 1; k < kept.indices.size(); ++k) EXPECT_EQ(kept.indices[k], kept.indices[k - 1] + 1);
}

TEST(EvenSamples, PassOnWhatIsEvenAsItIs) {
  const StreamPlan plan = plan_of(SampleClock::Kind::even);
  Kept kept;
  const std::vector<double> times = even_times(500);
  EXPECT_EQ(feed(plan, times, kept), 0);
  EXPECT_EQ(kept.times, times);
  EXPECT_EQ(kept.largest_error, 0);
}

TEST(EvenSamples, InterpolateAtStamps) {
  const StreamPlan plan = plan_of(SampleClock::Kind::stamped);
  Kept kept;
  const std::vector<double> times = uneven_times(2000);
  EXPECT_EQ(feed(plan, times, kept), 0);
  expect_consecutive(kept);
  EXPECT_NEAR(static_cast<double>(kept.times.size()), times.back() / kDt, 2);
  EXPECT_LT(kept.largest_error, 1e-9);
}

// A cubic through stamps a microsecond apart would make a hundred times the noise.
TEST(EvenSamples, JoinSamplesWithNearlyTheSameStamp) {
  const StreamPlan plan = plan_of(SampleClock::Kind::stamped);
  Kept kept;
  std::vector<double> times = uneven_times(500);
  for (std::size_t k = 50; k < times.size(); k += 50) times[k] = times[k - 1] + 1e-6;
  EXPECT_EQ(feed(plan, times, kept), 0);
  expect_consecutive(kept);
  EXPECT_LT(kept.largest_error, 1e-6);
}

// Six samples in a row are missing: 7 ms, beside a band of 100 ms.
TEST(EvenSamples, BridgeGapsThatAreShortBesideTheBand) {
  for (const SampleClock::Kind kind : {SampleClock::Kind::even, SampleClock::Kind::stamped}) {
    const StreamPlan plan = plan_of(kind);
    Kept kept;
    std::vector<double> times = even_times(500);
    times.erase(times.begin() + 200, times.begin() + 206);
    EXPECT_EQ(feed(plan, times, kept), 0);
    expect_consecutive(kept);
    EXPECT_LT(kept.largest_error, 1e-5);
  }
}

TEST(EvenSamples, BeginAnewBehindALongGap) {
  const StreamPlan plan = plan_of(SampleClock::Kind::even);
  Kept kept;
  std::vector<double> times = even_times(500);
  times.erase(times.begin() + 200, times.begin() + 230);
  EXPECT_EQ(feed(plan, times, kept), 1);
  EXPECT_EQ(kept.times, times);
}

}  // namespace
}  // namespace flatdyn
