// SPDX-License-Identifier: GPL-2.0-or-later
// Torques that the model lacks, such as the ripple of gears. They are taken at another time than the motion, so that
// they have nothing to do with it: what they do to the parameters is chance, and intervals hold it.
#include <gtest/gtest.h>

#include "support/practical_bench.hpp"

namespace flatdyn {
namespace {

using testing::panda;
using testing::SimulatedSample;
using testing::ur5;
using Bench = testing::PracticalBench;

// The errors of an estimate's torques on a motion without noise: root mean squares, divided by the arm's noise.
double error_on(const Measurement& other, const Bench& bench, const Estimate& found) {
  double sum = 0;
  for (std::size_t i = 0; i < other.observations.joints.size(); ++i) {
    sum += std::pow(other.observations.joints[i].rms_residual(found.values) / bench.arm().noise[i], 2);
  }
  return std::sqrt(sum);
}

// A torque that the model lacks, by position and rate of its joint, 1 at most.
double ripple(double q, double) { return std::sin(17 * q); }
double friction_near_rest(double, double qd) { return std::tanh(qd / 0.1) - std::tanh(qd / 0.5); }
using Misfit = double (*)(double q, double qd);

// Adds three standard deviations of the arm's noise of it.
void add_misfit(const Bench& bench, Misfit misfit, std::size_t shift, std::vector<SimulatedSample>& samples) {
  constexpr double kTimes = 3;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const SimulatedSample& other = samples[(k + shift) % samples.size()];
    for (Eigen::Index i = 0; i < other.q.size(); ++i) {
      samples[k].tau(i) += kTimes * bench.arm().noise[static_cast<std::size_t>(i)] * misfit(other.q(i), other.qd(i));
    }
  }
}

// Counts 95 % intervals, and those that hold the truth.
struct HeldTruths {
  double inside = 0, all = 0;

  void add(const Bench& bench, const Estimate& found) {
    constexpr double kTwoSided95 = 1.959964;
    for (int k = 0; k < bench.model().parameters(); ++k) {
      if (!std::isfinite(found.standard_deviations(k))) continue;
      inside += std::abs(found.values(k) - bench.truth(k)) <= kTwoSided95 * found.standard_deviations(k) ? 1 : 0;
      ++all;
    }
  }
  double share() const { return inside / all; }
};

// A motion of 10 s is repeated once, and the ripple with it. All parameters are told, and are as good on another motion
// as those of plain weighted least squares.
TEST(MisfitTest, IsNotTakenForNoiseOfPositions) {
  for (Bench* bench : {&ur5(), &panda()}) {
    HeldTruths coverage;
    const Measurement other = bench->measured(bench->motion({.motion = 11}), 0, 0);
    for (unsigned motion = 1; motion <= 4; ++motion) {
      std::vector<SimulatedSample> samples = bench->motion({.motion = motion});
      add_misfit(*bench, ripple, 7000, samples);
      const Measurement measurement = bench->measured(samples, 3e-5, 0.3, motion);
      const Estimate found = bench->estimated(measurement),
                     plain = estimate(measurement.observations, bench->equations().file_values());
      EXPECT_TRUE(found.standard_deviations.allFinite()) << bench->arm().file << ", motion " << motion;
      EXPECT_LT(error_on(other, *bench, found), 1.1 * error_on(other, *bench, plain)) << bench->arm().file;
      coverage.add(*bench, found);
    }
    EXPECT_GT(coverage.share(), 0.9) << bench->arm().file;
    EXPECT_LT(coverage.share(), 0.995) << bench->arm().file;
  }
}

TEST(MisfitTest, IsInTheIntervalsOf96Logs) {
  for (Bench* bench : {&ur5(), &panda()}) {
    for (const Misfit misfit : {ripple, friction_near_rest}) {
      for (const double fundamental : {0.05, 0.1}) {
        HeldTruths coverage;
        for (unsigned motion = 1; motion <= 12; ++motion) {
          std::vector<SimulatedSample> samples = bench->motion({.motion = motion, .fundamental = fundamental});
          add_misfit(*bench, misfit, 2500 + 1300 * motion, samples);
          coverage.add(*bench, bench->estimated(bench->measured(samples, 3e-5, 0.3, motion)));
        }
        EXPECT_GT(coverage.share(), 0.88) << bench->arm().file << ", " << fundamental << " Hz";
        EXPECT_LT(coverage.share(), 0.985) << bench->arm().file << ", " << fundamental << " Hz";
      }
    }
  }
}

}  // namespace
}  // namespace flatdyn
