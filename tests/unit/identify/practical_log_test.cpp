// SPDX-License-Identifier: GPL-2.0-or-later
// Logs as people have them: encoder steps, noise, joints that are held, idle time, dropped samples. The motion and its
// torques are those of the recursive reference.
#include "support/practical_bench.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "report/residual_plot.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using testing::kEncoderStep;
using testing::panda;
using testing::SimulatedSample;
using testing::ur5;
using Bench = testing::PracticalBench;

// Counts, by kind of parameter, how many 95 % intervals hold the truth.
struct Coverage {
  int inside = 0, all = 0;
  double share() const { return static_cast<double>(inside) / all; }
};
using Coverages = std::map<std::string, Coverage>;

void count(const Bench& bench, const Estimate& found, Coverages& coverages) {
  constexpr double kTwoSided95 = 1.959964;
  for (int k = 0; k < bench.model().parameters(); ++k) {
    const Parameter parameter = parameter_of(bench.model().base().columns[static_cast<std::size_t>(k)]);
    const bool is_friction = parameter == Parameter::Fv || parameter == Parameter::Fs;
    const double error = std::abs(found.values(k) - bench.truth(k));
    for (const char* kind : {"all", is_friction ? "friction" : "others"}) {
      ++coverages[kind].all;
      coverages[kind].inside += error <= kTwoSided95 * found.standard_deviations(k) ? 1 : 0;
    }
  }
}

Coverages coverages_of(Bench& bench, unsigned motions, unsigned logs_per_motion) {
  Coverages coverages;
  for (unsigned motion = 1; motion <= motions; ++motion) {
    const std::vector<SimulatedSample> samples = bench.motion({.motion = motion});
    for (unsigned log = 1; log <= logs_per_motion; ++log) {
      const unsigned seed = 1000 * motion + log;
      count(bench, bench.estimated(bench.measured(samples, kEncoderStep, 1, seed)), coverages);
    }
  }
  return coverages;
}

TEST(PracticalLog, WithoutNoiseEveryParameterComesBack) {
  Bench& bench = ur5();
  const Estimate found = bench.estimated(bench.measured(bench.motion({}), 0, 0));
  for (int k = 0; k < bench.model().parameters(); ++k) EXPECT_NEAR(found.values(k), bench.truth(k), 1e-4) << k;
}

TEST(PracticalLog, IntervalsHoldTheTruth) {
  const Coverages coverages = coverages_of(ur5(), 2, 5);
  EXPECT_GT(coverages.at("all").share(), 0.91);
  EXPECT_LT(coverages.at("all").share(), 0.985);
  EXPECT_GT(coverages.at("friction").share(), 0.88);
}

TEST(PracticalLog, IntervalsOfASixAxisArmHoldTheTruthIn200Logs) {
  for (const auto& [kind, coverage] : coverages_of(ur5(), 40, 5)) {
    EXPECT_GE(coverage.share(), 0.93) << kind;
    EXPECT_LE(coverage.share(), 0.97) << kind;
  }
}

TEST(PracticalLog, IntervalsOfASevenAxisArmHoldTheTruthIn50Logs) {
  for (const auto& [kind, coverage] : coverages_of(panda(), 25, 2)) {
    EXPECT_GE(coverage.share(), 0.93) << kind;
    EXPECT_LE(coverage.share(), 0.97) << kind;
  }
}

// The encoder of a joint that is held reads noise of one step, and a brake may hold it.
TEST(PracticalLog, AJointThatStandsStillTellsNothingOfItself) {
  constexpr int kHeld = 4;
  Bench& bench = ur5();
  std::vector<SimulatedSample> samples = bench.motion({.held = {kHeld}});
  testing::Uniform draw(3);
  for (SimulatedSample& sample : samples) {
    sample.tau(kHeld) = 50 * draw();  // the brake's
    if (draw() > 0.4) sample.q(kHeld) += kEncoderStep;
  }
  for (const double step : {kEncoderStep, 0.0}) {
    const Measurement measurement = bench.measured(samples, step, 1);
    EXPECT_EQ(measurement.observations.joints[kHeld].rows, 0);
    for (const double damping : {1e-8, 1e-15, 0.0}) {
      const Estimate found = bench.estimated(measurement, damping);
      for (const char* name : {"Fv5", "Fs5", "Im5"}) {
        const int k = bench.place_of(name);
        EXPECT_EQ(found.values(k), 0) << name;
        EXPECT_TRUE(std::isinf(found.standard_deviations(k))) << name;
      }
      for (int k = 0; k < bench.model().parameters(); ++k) {
        if (std::isinf(found.standard_deviations(k))) continue;
        EXPECT_NEAR(found.values(k), bench.truth(k), 5 * found.standard_deviations(k)) << k;
      }
    }
  }
}

TEST(PracticalLog, IdleTimeDoesNotSpeakOfFriction) {
  Bench& bench = ur5();
  const std::vector<SimulatedSample> samples = bench.motion({.seconds = 30, .idles = true});
  const Measurement measurement = bench.measured(samples, kEncoderStep, 1);
  const Estimate found = bench.estimated(measurement);
  Coverages coverages;
  count(bench, found, coverages);
  EXPECT_GT(coverages.at("friction").share(), 0.8);
  for (const JointObservations& joint : measurement.observations.joints) {
    EXPECT_LT(static_cast<double>(joint.rows), 0.7 * static_cast<double>(measurement.count.used));
  }
  for (const char* name : {"Fs1", "Fs3", "Fs5"}) {
    EXPECT_NEAR(found.values(bench.place_of(name)), bench.truth(name), 0.01 * bench.truth(name)) << name;
  }
  // As every row counts, Coulomb friction comes out far too small.
  const Estimate all = bench.estimated(bench.measured(samples, kEncoderStep, 1, 1, {.rest_speed = {0}}));
  EXPECT_LT(all.values(bench.place_of("Fs1")), 0.9 * bench.truth("Fs1"));
}

// The points of each curve of a picture, in the order of its panels; lines that are interrupted count as one.
std::vector<double> points_of_curves(const std::string& svg) {
  const std::string stroke = "stroke='rgb( 43, 131, 202)'";  // of a panel's first series
  std::vector<double> points;
  for (std::size_t at = svg.find(stroke); at != std::string::npos; at = svg.find(stroke, at + 1)) {
    points.push_back(static_cast<double>(std::count(svg.data() + at, svg.data() + svg.find("/>", at), ',')) - 2);
  }
  return points;
}

// The sixth joint counts as one that never moves.
TEST(PracticalLog, ResidualsAreDrawnWhereRowsAreUsed) {
  Bench& bench = ur5();
  const Measurement measurement = bench.measured(bench.motion({.seconds = 12, .idles = true}), kEncoderStep, 1);
  Observations observations = measurement.observations;
  for (EquationInstant& instant : observations.instants) instant.used[5] = 0;
  const std::string svg =
      residual_plot(bench.model(), observations, bench.estimated(measurement).values, PictureFormat::svg);
  EXPECT_THAT(svg, HasSubstr("nothing to plot: the joint rests"));
  const std::vector<double> points = points_of_curves(svg);
  ASSERT_EQ(points.size(), 11u);
  const auto all = static_cast<double>(observations.instants.size());
  for (std::size_t i = 0; i < 5; ++i) {
    const auto used =
        static_cast<double>(std::count_if(observations.instants.begin(), observations.instants.end(),
                                          [i](const EquationInstant& instant) { return instant.used[i] != 0; }));
    EXPECT_LT(used, 0.9 * all) << i;
    EXPECT_NEAR(points[2 * i], all, 0.05 * all) << i;
    EXPECT_NEAR(points[2 * i + 1], used, 0.05 * all) << i;
  }
}

TEST(PracticalLog, DroppedSamplesAreInterpolated) {
  Bench& bench = ur5();
  std::vector<SimulatedSample> samples = bench.motion({});
  const auto whole = samples.size();
  testing::Uniform draw(9);
  std::erase_if(samples, [&](const SimulatedSample& sample) { return sample.time > 0 && draw() > 0.98; });
  const Measurement measurement = bench.measured(samples, kEncoderStep, 1);
  const auto dropped = static_cast<long>(whole - samples.size());
  EXPECT_GT(dropped, 150);
  EXPECT_NEAR(static_cast<double>(measurement.count.interpolated), static_cast<double>(dropped), 4);
  EXPECT_EQ(measurement.count.gaps, 0);
  Coverages coverages;
  count(bench, bench.estimated(measurement), coverages);
  EXPECT_GT(coverages.at("all").share(), 0.85);
}

TEST(PracticalLog, AClockThatJittersHasNoGaps) {
  Bench& bench = ur5();
  std::vector<SimulatedSample> samples = bench.motion({.seconds = 12});
  testing::Uniform draw(7);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    samples[k].time = std::max(samples[k].time + 2e-4 * draw.normal(), samples[k - 1].time + 1e-4);
  }
  const Measurement measurement = bench.measured(samples, kEncoderStep, 1);
  EXPECT_LE(measurement.count.gaps, 2);
  EXPECT_LE(measurement.count.interpolated, 20);
  EXPECT_THAT(bench.warnings, ::testing::Contains(HasSubstr("time is not even")));
}

// The torques of drives have noise that is slower than the band: that of one sample is like that of the one before it.
TEST(PracticalLog, IntervalsHoldTheTruthWhereNoiseIsSlow) {
  constexpr double kAlike = 0.9, kTimes = 2;  // at 200 Hz, 3.4 Hz; standard deviations of the arm's noise
  Bench& bench = ur5();
  Coverages coverages;
  for (unsigned motion = 1; motion <= 5; ++motion) {
    std::vector<SimulatedSample> samples = bench.motion({.rate = 200, .motion = motion});
    testing::Uniform draw(motion);
    Eigen::VectorXd noise = Eigen::VectorXd::Zero(6);
    for (SimulatedSample& sample : samples) {
      for (int i = 0; i < 6; ++i) {
        noise[i] = kAlike * noise[i] + std::sqrt(1 - kAlike * kAlike) * draw.normal();
        sample.tau(i) += kTimes * bench.arm().noise[static_cast<std::size_t>(i)] * noise[i];
      }
    }
    count(bench, bench.estimated(bench.measured(samples, kEncoderStep, 0, motion)), coverages);
  }
  EXPECT_GT(coverages.at("all").share(), 0.9);
  EXPECT_LT(coverages.at("all").share(), 0.985);
}

// While a joint turns around it is slow, but not at rest: its acceleration counts in the equations of the others. The
// band is lower than that of finer encoders.
TEST(PracticalLog, IntervalsHoldTheTruthWhereStepsAreCoarse) {
  constexpr double kCoarse = 1e-3;  // rad
  Bench& bench = ur5();
  Coverages coverages;
  for (unsigned motion = 1; motion <= 4; ++motion) {
    const Measurement measurement = bench.measured(bench.motion({.motion = motion}), kCoarse, 0.3, motion);
    EXPECT_LT(measurement.logs[0].filter.band, 10);
    count(bench, bench.estimated(measurement), coverages);
  }
  EXPECT_GT(coverages.at("all").share(), 0.88);
}

TEST(PracticalLog, TheEncodersStepIsFound) {
  Bench& bench = ur5();
  const Measurement measurement = bench.measured(bench.motion({.seconds = 5}), kEncoderStep, 1);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(measurement.logs[0].q_noise[i].step, kEncoderStep, 1e-9);
    EXPECT_NEAR(measurement.logs[0].q_noise[i].deviation, kEncoderStep / std::sqrt(12.0), 0.3e-4);
    EXPECT_NEAR(measurement.logs[0].tau_noise[i].deviation, testing::practical_ur5().noise[i], 0.1);
  }
}

}  // namespace
}  // namespace flatdyn
