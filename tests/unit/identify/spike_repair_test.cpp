// SPDX-License-Identifier: GPL-2.0-or-later
// Wrong readings of an encoder: they are repaired, and they hide nothing of the noise.
#include "laboratory/identify/spike_repair.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "support/practical_bench.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using testing::kEncoderStep;
using testing::SimulatedSample;

class Collected : public SampleReceiver {
 public:
  void restart() override {}
  void sample(const RawSample& sample) override { q.push_back(sample.channels[LogLayout::q()]); }
  std::vector<double> q;
};

class SpikeRepairTest : public ::testing::Test {
 protected:
  StreamPlan plan;
  Collected collected;
  Diagnostics found;

  SpikeRepairTest() {
    plan.heading.layout.joints = plan.heading.layout.positions = 1;
    plan.heading.columns = {{"t", LogColumn::Role::number, 0}, {"q1", LogColumn::Role::number, 1}};
    plan.heading.layout.has_torques = false;
    plan.filter = {0.001, 10, 1};
    plan.noise = {{}, {kEncoderStep, kEncoderStep / std::sqrt(12.0)}};
  }
  static double rounded(double q) { return kEncoderStep * std::round(q / kEncoderStep); }
  // A joint that swings, with up to 2.4 rad/s.
  static std::vector<double> swing() {
    std::vector<double> q;
    for (int k = 0; k < 2000; ++k) q.push_back(rounded(0.8 * std::sin(0.003 * k)));
    return q;
  }
  std::vector<double> repaired(const std::vector<double>& q) {
    collected.q.clear();
    SpikeRepair repair(plan, collected);
    for (std::size_t k = 0; k < q.size(); ++k) {
      const double channels[] = {0.001 * static_cast<double>(k), q[k]};
      repair.sample({channels, static_cast<long>(k), static_cast<long>(k), static_cast<int>(k) + 2});
    }
    repair.flush();
    found = {};
    repair.finish("log.csv", found);
    return collected.q;
  }
};

TEST_F(SpikeRepairTest, LeavesASoundSignalAsItIs) {
  EXPECT_EQ(repaired(swing()), swing());
  EXPECT_TRUE(found.all().empty());
}

// Positions without noise, 125 a second: the curve through neighbours is not exact where the joint turns around.
TEST_F(SpikeRepairTest, LeavesAnExactSignalAsItIs) {
  plan.noise = {{}, {0, 1e-12}};
  std::vector<double> q;
  for (int k = 0; k < 1000; ++k) q.push_back(0.5 * std::sin(0.15 * k));
  EXPECT_EQ(repaired(q), q);
}

TEST_F(SpikeRepairTest, InterpolatesUpToThreeReadings) {
  std::vector<double> q = swing();
  for (const auto& [at, size] :
       {std::pair(300, 0.5), {700, -0.02}, {701, 0.3}, {1200, 0.1}, {1201, 0.1}, {1202, 0.2}}) {
    q[static_cast<std::size_t>(at)] += size;
  }
  const std::vector<double> expected = swing(), after = repaired(q);
  ASSERT_EQ(after.size(), expected.size());
  for (std::size_t k = 0; k < after.size(); ++k) EXPECT_NEAR(after[k], expected[k], 3 * kEncoderStep) << k;
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_EQ(found.all()[0].place, (Place{"log.csv", 302}));
  EXPECT_THAT(found.all()[0].message,
              HasSubstr("q1: a reading is far from those beside it, by 0.5 at 0.3 s; 6 such readings in all"));
}

TEST_F(SpikeRepairTest, LeavesJumpsAndLongerBlocksAsTheyAre) {
  std::vector<double> q = swing();
  for (std::size_t k = 500; k < 506; ++k) q[k] += 0.2;
  for (std::size_t k = 1500; k < q.size(); ++k) q[k] += 0.3;
  EXPECT_EQ(repaired(q), q);
}

TEST(ChannelNoise, OfAnEncoderHasNoSpikesInIt) {
  ChannelNoiseMeter sound, spiky;
  testing::Uniform draw(4);
  for (int k = 0; k < 4000; ++k) {
    const double q = kEncoderStep * std::round(std::sin(0.003 * k) / kEncoderStep);
    sound.add(q);
    spiky.add(k % 400 == 50 ? q + 0.5 : q);
  }
  EXPECT_NEAR(sound.noise().deviation, kEncoderStep / std::sqrt(12.0), 0.1 * kEncoderStep);
  EXPECT_NEAR(spiky.noise().deviation, sound.noise().deviation, 0.1 * sound.noise().deviation);
}

// Twenty wrong readings are repaired, and reported where the first of them is.
TEST(SpikesOfPositions, DoNotHideWhatTheMotionTells) {
  testing::PracticalBench& bench = testing::ur5();
  std::vector<SimulatedSample> samples = bench.motion({.seconds = 12});
  for (std::size_t k = 0; k < 20; ++k) samples[700 + 531 * k].q(2) += k % 2 == 0 ? 0.5 : 0.02;
  const Measurement measurement = bench.measured(samples, kEncoderStep, 1);
  ASSERT_EQ(bench.warnings.size(), 1u);
  EXPECT_THAT(bench.warnings[0], HasSubstr("q3: a reading is far from those beside it, by 0.5 at 0.7 s; 20 such"));
  EXPECT_EQ(bench.warning_lines[0], 702);
  EXPECT_LT(measurement.logs[0].rest_speed[2], 0.005);
  const Estimate found = bench.estimated(measurement);
  for (int k = 0; k < bench.model().parameters(); ++k) {
    EXPECT_NEAR(found.values(k), bench.truth(k), 4.5 * found.standard_deviations(k)) << k;
  }
}

}  // namespace
}  // namespace flatdyn
