// SPDX-License-Identifier: GPL-2.0-or-later
// Logs that are not what they say: each is noticed, and its reason named.
#include "laboratory/identify/identification.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "support/names.hpp"
#include "support/practical_bench.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using testing::kEncoderStep;
using testing::SimulatedSample;
using Bench = testing::PracticalBench;

// A change of every sample of a log, and the text that names it.
struct WrongLog {
  const char* name;
  void (*change)(SimulatedSample& sample);
  const char* text;
};

constexpr WrongLog kWrongLogs[] = {
    {"torque_sign", [](SimulatedSample& s) { s.tau(2) *= -1; },
     "joint \"elbow_joint\": its torques look as if their sign were reversed"},
    {"position_sign", [](SimulatedSample& s) { s.q(2) *= -1; },
     "joint \"elbow_joint\": its positions look as if their sign were reversed"},
    {"torques_exchanged", [](SimulatedSample& s) { std::swap(s.tau(1), s.tau(2)); },
     "joint \"shoulder_lift_joint\" and joint \"elbow_joint\": their torques look exchanged"},
    {"positions_exchanged", [](SimulatedSample& s) { std::swap(s.q(3), s.q(4)); },
     "joint \"wrist_1_joint\" and joint \"wrist_2_joint\": their positions look exchanged"},
    {"joints_exchanged",
     [](SimulatedSample& s) {
       std::swap(s.q(0), s.q(2));
       std::swap(s.tau(0), s.tau(2));
     },
     "joint \"shoulder_pan_joint\" and joint \"elbow_joint\" look exchanged: the positions and the torques of both"},
    {"zero_off_by_5_degrees", [](SimulatedSample& s) { s.q(1) += 5 * std::numbers::pi / 180; },
     "joint \"shoulder_lift_joint\": its zero looks"},
    {"zero_off_by_90_degrees", [](SimulatedSample& s) { s.q(3) += std::numbers::pi / 2; },
     "joint \"wrist_1_joint\": its zero looks"},
    {"gain", [](SimulatedSample& s) { s.tau(1) *= 1.2; },
     "joint \"shoulder_lift_joint\": its torques look 1.2 times too large"},
    {"unit", [](SimulatedSample& s) { s.tau(3) *= 1000; }, "joint \"wrist_1_joint\": its torques look 99"},
    {"first_torque_sign", [](SimulatedSample& s) { s.tau(1) *= -1; },
     "joint \"shoulder_lift_joint\": its torques look as if their sign were reversed"},
    {"friction_of_loads",
     [](SimulatedSample& s) {
       const double sign = s.qd(1) < 0 ? -1 : 1, carried = s.tau(1) - 8 * s.qd(1) - 9 * sign;  // practical_ur5()
       s.tau(1) += 0.1 * std::abs(carried) * sign;
     },
     "friction looks larger where drives carry more (--friction load"},
    {"offset", [](SimulatedSample& s) { s.tau(1) += 2; }, "joint \"shoulder_lift_joint\": its torques look as if"},
};

class LackOfFit : public ::testing::TestWithParam<WrongLog> {
 protected:
  Bench& bench = testing::ur5();
  std::vector<JointFit> fits;

  std::optional<FitHypothesis> reason_of(const std::vector<SimulatedSample>& samples) {
    const Measurement measurement = bench.measured(samples, kEncoderStep, 1);
    fits = fit_quality(measurement.observations, measurement.logs, bench.estimated(measurement).values,
                       bench.acceleration_rows());
    return best_hypothesis(bench.model(), bench.plain(), measurement, fits);
  }
};

TEST_P(LackOfFit, IsNoticedAndNamed) {
  std::vector<SimulatedSample> samples = bench.motion({.seconds = 12});
  for (SimulatedSample& sample : samples) GetParam().change(sample);
  const std::optional<FitHypothesis> reason = reason_of(samples);
  EXPECT_TRUE(std::any_of(fits.begin(), fits.end(), [](const JointFit& fit) { return fit.is_suspicious(); }));
  ASSERT_TRUE(reason);
  EXPECT_THAT(reason->text, HasSubstr(GetParam().text));
  EXPECT_GT(reason->explained, 0.6);
}

INSTANTIATE_TEST_SUITE_P(Logs, LackOfFit, ::testing::ValuesIn(kWrongLogs),
                         [](const auto& wrong) { return std::string(wrong.param.name); });

TEST_F(LackOfFit, IsNotSeenInSoundLogs) {
  EXPECT_FALSE(reason_of(bench.motion({})));
  for (const JointFit& fit : fits) {
    EXPECT_GT(fit.ratio, 0.8);
    EXPECT_LT(fit.ratio, 1.3);
    EXPECT_LT(fit.correlation, 0.45);
    EXPECT_TRUE(fit.is_sound());
    EXPECT_FALSE(fit.limit);
  }
}

TEST_F(LackOfFit, ByTorquesThatAreLateIsNamed) {
  for (const std::size_t late : {5u, 40u}) {  // samples, 1 ms each
    std::vector<SimulatedSample> samples = bench.motion({.seconds = 12});
    for (std::size_t k = samples.size() - 1; k >= late; --k) samples[k].tau = samples[k - late].tau;
    const std::optional<FitHypothesis> reason = reason_of(samples);
    ASSERT_TRUE(reason);
    EXPECT_THAT(reason->text,
                ::testing::ContainsRegex(late == 5 ? "look (5|5\\.[12]|4\\.[89]) ms late" : "look 40 ms late"));
  }
}

TEST_F(LackOfFit, ByTorquesOfOneJointThatAreLateIsNamed) {
  constexpr std::size_t kLate = 12;  // samples, 1 ms each
  std::vector<SimulatedSample> samples = bench.motion({.seconds = 12});
  for (std::size_t k = samples.size() - 1; k >= kLate; --k) samples[k].tau(4) = samples[k - kLate].tau(4);
  const std::optional<FitHypothesis> reason = reason_of(samples);
  ASSERT_TRUE(reason);
  EXPECT_THAT(reason->text, HasSubstr("joint \"wrist_2_joint\": its torques look 12 ms late"));
}

TEST_F(LackOfFit, ByFrictionThatIsLargerNearRestIsNamed) {
  std::vector<SimulatedSample> samples = bench.motion({});
  for (SimulatedSample& sample : samples) {
    for (int i = 0; i < 6; ++i) {
      const double qd = sample.qd(i), part = qd / 0.1;
      sample.tau(i) +=
          0.4 * bench.arm().coulomb[static_cast<std::size_t>(i)] * std::exp(-part * part) * ((qd > 0) - (qd < 0));
    }
  }
  const std::optional<FitHypothesis> reason = reason_of(samples);
  ASSERT_TRUE(reason);
  EXPECT_THAT(reason->text, HasSubstr("--friction stribeck"));
}

TEST_F(LackOfFit, ByFrictionThatIsLeftOutIsNamed) {
  Progress quiet(true);
  const TorqueModel model(bench.plain(), ParameterSet::inertial, quiet);
  const TorqueEquations equations(model);
  const Measurement measurement = bench.measured(bench.motion({.seconds = 12}), kEncoderStep, 1, 1, {}, &equations);
  const Estimate found = estimate_of(equations, measurement, {});
  fits = fit_quality(measurement.observations, measurement.logs, found.values, equations.acceleration_rows());
  const std::optional<FitHypothesis> reason = best_hypothesis(model, bench.plain(), measurement, fits);
  ASSERT_TRUE(reason);
  EXPECT_THAT(reason->text, HasSubstr("--parameters full"));
}

// Torques of a robot that compensates gravity itself, and reports what is left.
TEST_F(LackOfFit, ByGravityThatIsLeftOutIsNamed) {
  LoadedRobot weightless = bench.arm().truth();
  weightless.robot.gravity = {0, 0, 0};
  const std::optional<FitHypothesis> reason = reason_of(practical_motion(bench.arm(), weightless, {.seconds = 12}));
  ASSERT_TRUE(reason);
  EXPECT_THAT(reason->text, HasSubstr("--gravity off"));
}

// Torques of motors before their gears are small, gravity's like all others.
TEST_F(LackOfFit, BySmallTorquesIsNotLaidOnGravity) {
  std::vector<SimulatedSample> samples = bench.motion({.seconds = 12});
  for (SimulatedSample& sample : samples) sample.tau /= 100;
  const Measurement measurement = bench.measured(samples, kEncoderStep, 0.01);
  fits = fit_quality(measurement.observations, measurement.logs, bench.estimated(measurement).values,
                     bench.acceleration_rows());
  EXPECT_FALSE(best_hypothesis(bench.model(), bench.plain(), measurement, fits));
}

TEST_F(LackOfFit, ByTorquesThatAreCutOffIsNoticed) {
  std::vector<SimulatedSample> samples = bench.motion({.seconds = 12});
  for (SimulatedSample& sample : samples) sample.tau(1) = std::max(sample.tau(1), -42.0);
  reason_of(samples);
  ASSERT_TRUE(fits[1].limit);
  EXPECT_NEAR(*fits[1].limit, -42, 0.5);
  EXPECT_FALSE(fits[1].is_sound());
}

TEST_F(LackOfFit, ByOffsetsGoesWithThem) {
  const double offsets[] = {1, -2, 0.5, 0.2, -0.1, 0.3};
  std::vector<SimulatedSample> samples = bench.motion({});
  for (SimulatedSample& sample : samples) {
    for (int i = 0; i < 6; ++i) sample.tau(i) += offsets[i];
  }
  const TorqueEquations equations(bench.model(), {.offsets = true});
  const Measurement measurement = bench.measured(samples, kEncoderStep, 1, 1, {}, &equations);
  EstimateOptions options;
  options.acceleration_rows = equations.acceleration_rows();
  const Estimate found = estimate(measurement.observations, equations.file_values(), options);
  ASSERT_EQ(found.values.size(), bench.model().parameters() + 6);
  for (int i = 0; i < 6; ++i) {
    const Eigen::Index k = bench.model().parameters() + i;
    EXPECT_NEAR(found.values(k), offsets[i], 4 * found.standard_deviations(k)) << i;
    EXPECT_LT(found.standard_deviations(k), 0.2) << i;
  }
}

TEST_F(LackOfFit, BySpringsGoesWithThem) {
  const double stiffness[] = {40, 25, 0, 8, 3, 5}, relaxed_at[] = {0.3, -1, 0, 0.5, 2, -0.4};
  std::vector<SimulatedSample> samples = bench.motion({});
  for (SimulatedSample& sample : samples) {
    for (int i = 0; i < 6; ++i) sample.tau(i) += stiffness[i] * (sample.q(i) - relaxed_at[i]);
  }
  const TorqueEquations equations(bench.model(), {.springs = true});
  const Measurement measurement = bench.measured(samples, kEncoderStep, 1, 1, {}, &equations);
  const Estimate found = estimate_of(equations, measurement, {});
  ASSERT_EQ(found.values.size(), bench.model().parameters() + 12);
  for (int i = 0; i < 6; ++i) {
    const Eigen::Index k = bench.model().parameters() + 2 * i;
    EXPECT_EQ(equations.names()[static_cast<std::size_t>(k) + 1], fmt::format("kq{}", i + 1));
    EXPECT_NEAR(found.values(k), stiffness[i], 4 * found.standard_deviations(k)) << i;
    EXPECT_NEAR(found.values(k + 1), stiffness[i] * relaxed_at[i], 4 * found.standard_deviations(k + 1)) << i;
    EXPECT_LT(found.standard_deviations(k), 1) << i;
  }
}

// The base hangs from the ceiling, or leans by 0.3 rad.
TEST_F(LackOfFit, ByGravityFromElsewhereIsNamed) {
  for (const double angle : {0.3, std::numbers::pi}) {
    const testing::PracticalArm arm = bench.arm();
    const auto exact = [](double value) { return exact_decimal(fmt::format("{:.12f}", value)); };
    const Vec3 gravity = {exact(9.81 * std::sin(angle)), 0, exact(-9.81 * std::cos(angle))};
    LoadedRobot leaning = arm.truth();
    leaning.robot.gravity = gravity;
    const std::optional<FitHypothesis> reason = reason_of(practical_motion(arm, leaning, {.seconds = 12}));
    ASSERT_TRUE(reason);
    EXPECT_THAT(reason->text, HasSubstr("gravity looks as if it came from another direction"));
    EXPECT_THAT(reason->text, HasSubstr(angle < 1 ? "17." : "180 degrees"));
  }
}

TEST_F(LackOfFit, ByReadingsThatAreLostIsNoticed) {
  const std::vector<SimulatedSample> samples = bench.motion({.seconds = 12});
  const auto warnings_of = [&](const auto& change) {
    std::vector<SimulatedSample> changed = samples;
    change(changed);
    bench.measured(changed, kEncoderStep, 0.1);
    return bench.warnings;
  };
  EXPECT_TRUE(warnings_of([](auto&) {}).empty());
  const auto frozen_position = [](auto& all) {
    for (std::size_t k = 4000; k < 5000; ++k) all[k].q(1) = all[4000].q(1);
  };
  EXPECT_THAT(warnings_of(frozen_position),
              ::testing::Contains("q2: does not change from 4 to 4.999 s, and then jumps"));
  const auto spikes = [](auto& all) {
    for (std::size_t k = 1000; k < 11000; k += 1000) all[k].tau(2) += 30;
  };
  EXPECT_THAT(warnings_of(spikes), ::testing::Contains("tau3: 10 spikes, the first at 1 s"));
  EXPECT_THAT(bench.warning_lines, ::testing::Contains(1002));
  // Many that are small are noise, and do not bury the one that is not.
  const auto one_among_small = [](auto& all) {
    for (std::size_t k = 500; k < 11000; k += 250) all[k].tau(2) += 0.8;
    all[7100].tau(2) += 30;
  };
  EXPECT_THAT(warnings_of(one_among_small),
              ::testing::IsSupersetOf({"tau3: 1 spike, the first at 7.1 s",
                                       "tau3: 42 readings in all lie 12 to 36 standard deviations of the noise from "
                                       "their neighbours; that many count as noise"}));
}

// The last reading may be near the next one: a torque with noise does not stay the same while its joint moves.
TEST_F(LackOfFit, ByReadingsThatAreHeldIsNoticed) {
  std::vector<SimulatedSample> samples = bench.motion({.seconds = 12});
  testing::Uniform draw(5);
  for (SimulatedSample& sample : samples) {
    for (int i = 0; i < 6; ++i) sample.tau(i) += bench.arm().noise[static_cast<std::size_t>(i)] * draw.normal();
  }
  std::vector<SimulatedSample> held = samples, frozen = samples;
  for (std::size_t k = 0; k < held.size(); ++k) held[k].tau = samples[k - k % 10].tau;
  bench.measured(held, kEncoderStep, 0);
  EXPECT_THAT(bench.warnings, ::testing::ElementsAre("tau1, tau2, tau3, tau4, tau5, tau6: the readings change at every "
                                                     "10th line only, and are 4.5 ms late on average"));
  for (std::size_t k = 3000; k < 4000; ++k) frozen[k].tau(1) = samples[4000].tau(1);
  EXPECT_EQ(bench.measured(frozen, kEncoderStep, 0).count.lost, 1);
  EXPECT_THAT(bench.warnings, ::testing::ElementsAre("tau2: does not change from 3 to 4 s, and then jumps"));
}

// A log of torques without noise: blocks that are frozen, and blocks of zeros.
TEST_F(LackOfFit, ByBlocksOfTorquesThatAreLostIsNoticed) {
  std::vector<SimulatedSample> samples = bench.motion({.seconds = 12});
  testing::Uniform draw(5);
  for (SimulatedSample& sample : samples) sample.tau(1) += 0.1 * draw.normal();
  for (std::size_t k = 3000; k < 4000; ++k) samples[k].tau(1) = 0;
  for (std::size_t k = 6000; k < 7000; ++k) samples[k].tau(2) = samples[6000].tau(2);
  bench.measured(samples, kEncoderStep, 0);
  EXPECT_THAT(bench.warnings, ::testing::Contains("tau2: is 0 from 3 to 3.999 s, and then jumps"));
  EXPECT_THAT(bench.warnings, ::testing::Contains("tau3: does not change from 6 to 6.999 s, and then jumps"));
}

}  // namespace
}  // namespace flatdyn
