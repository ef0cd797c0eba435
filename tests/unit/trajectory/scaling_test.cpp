// SPDX-License-Identifier: GPL-2.0-or-later
// Motions at another pace: the linear law against its definition; the time-optimal one against the linear one, against
// limits, and where it is known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "laboratory/trajectory/plan_motion.hpp"
#include "laboratory/trajectory/time_optimal.hpp"
#include "support/sprung_puma.hpp"

namespace flatdyn {
namespace {

using testing::model_of;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Case {
  LoadedRobot model;
  Trajectory trajectory, sides;  // as planned, and with both sides of jumps
  PathCoefficients grid, path;   // the coefficients of these
  PaceLimits limits;
  PathTorques torques;
};

PlacedProfile triangular(double duration, std::size_t joints) {
  return {VelocityShape::triangular, {{"duration", std::vector<double>(joints, duration)}}, {}, {}};
}

// Every joint moves forth and back with a pause in between; the limits scale with the motion's needs.
Case case_of(LoadedRobot model, double torque_part, int intervals = 600) {
  const auto n = static_cast<std::size_t>(model.mechanism.size());
  TrajectoryPlan plan;
  JointPosture there(n), back(n);
  for (std::size_t i = 0; i < n; ++i) {
    there[i] = 0.4 + 0.1 * static_cast<double>(i);
    back[i] = -0.7;
  }
  plan.start = JointPosture(n, 0.3);
  plan.segments = {{JointMove{there, true, triangular(0.5, n)}, {}},
                   {Dwell{0.1}, {}},
                   {JointMove{back, true, triangular(0.6, n)}, {}}};
  Diagnostics found;
  Trajectory trajectory = planned_motion(plan, TipKinematics(model.robot), found, intervals);
  EXPECT_TRUE(found.all().empty());
  Progress quiet(true);
  PathTorques torques(model, false, quiet);
  Trajectory sides = with_both_sides(trajectory);
  PathCoefficients grid = torques.coefficients(trajectory), path = torques.coefficients(sides);
  PaceLimits limits{std::vector<double>(n, 3.0), std::vector<double>(n, 20.0), std::vector<double>(n, 0.0)};
  for (std::size_t k = 0; k < path.d.size(); ++k) {
    const double tau = path.a[k] + path.b[k] + path.d[k];
    double& limit = limits.torque[k % n];
    limit = std::max({limit, 1.05 * std::abs(path.d[k]), torque_part * std::abs(tau)});
  }
  return {std::move(model), std::move(trajectory), std::move(sides),  std::move(grid),
          std::move(path),  std::move(limits),     std::move(torques)};
}

Case case_of(const char* robot, double torque_part, int intervals = 600) {
  return case_of(model_of(robot), torque_part, intervals);
}

TEST(PathTorques, AreThoseOfTheMotionAtAnyPace) {
  Case c = case_of(testing::sprung_puma(), 1);
  for (const double pace : {0.5, 1.0, 3.0}) {
    const Trajectory other = slowed(c.sides, pace);
    const std::vector<std::vector<double>> tau = c.torques.torques(other);
    const double u = 1 / pace;
    for (std::size_t k = 0; k < c.path.d.size(); ++k) {
      const double expected = c.path.a[k] * u * u + c.path.b[k] * u + c.path.d[k];
      EXPECT_NEAR(tau[k / 6][k % 6], expected, 1e-10) << k;
    }
  }
}

// The time between samples that are both at rest.
double waiting_time(const Trajectory& trajectory) {
  const auto rests = [](const TrajectoryPoint& point) { return point.qd == std::vector<double>(point.qd.size(), 0); };
  double time = 0;
  for (std::size_t k = 1; k < trajectory.points.size(); ++k) {
    const TrajectoryPoint &before = trajectory.points[k - 1], &here = trajectory.points[k];
    if (rests(before) && rests(here)) time += here.time - before.time;
  }
  return time;
}

class ScalingOf : public ::testing::TestWithParam<const char*> {};

// At c the deciding limit is reached and none exceeded; at a slightly smaller c it is exceeded.
TEST_P(ScalingOf, TheLinearLawIsTheLeast) {
  Case c = case_of(GetParam(), 0.7);
  const std::optional<LinearScaling> law = linear_scaling(c.sides, c.path, c.limits, 1e-6);
  ASSERT_TRUE(law && law->decided_by);
  const auto use = [&](double pace) {
    const Trajectory scaled = slowed(c.sides, pace);
    return largest_limit_use(scaled, c.torques.torques(scaled), c.limits);
  };
  const LargestLimitUse used = use(law->c);
  EXPECT_NEAR(used.part, 1, 1e-12);
  EXPECT_EQ(used.kind, law->decided_by->kind);
  EXPECT_EQ(used.joint, law->decided_by->joint);
  EXPECT_GT(use(law->c * (1 - 1e-6)).part, 1 + 1e-8);
  EXPECT_LT(use(law->c * 1.01).part, 1);
}

TEST_P(ScalingOf, TheTimeOptimalLawKeepsLimitsAndIsNeverSlower) {
  for (const double part : {0.3, 0.7, 1.5}) {
    Case c = case_of(GetParam(), part);
    const std::optional<LinearScaling> linear = linear_scaling(c.sides, c.path, c.limits, 1e-6);
    ASSERT_TRUE(linear);
    const TimeLaw law = time_optimal_law(c.trajectory, c.grid, c.limits, linear->c);
    const Trajectory fast = paced(c.trajectory, law);
    const Trajectory both = with_both_sides(fast);
    EXPECT_GT(both.points.size(), 1.9 * static_cast<double>(fast.points.size()));
    EXPECT_LE(largest_limit_use(both, c.torques.torques(both), c.limits).part, 1 + 1e-9) << part;
    EXPECT_LT(fast.duration(), linear->c * c.trajectory.duration() * (1 - 1e-3)) << part;
    for (std::size_t k = 1; k < law.time.size(); ++k) ASSERT_GT(law.time[k], law.time[k - 1]);
    EXPECT_NEAR(waiting_time(fast), 0.1 * std::min(1.0, linear->c), 1e-9) << part;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, ScalingOf,
                         ::testing::Values("planar_2r_example_7_2.toml", "puma560.toml", "panda.urdf"),
                         [](const auto& test) {
                           const std::string name = test.param;
                           return name.substr(0, name.find('.'));
                         });

// One joint under a limit of acceleration alone: bang-bang, T = 2 sqrt(D / a), whatever the given profile.
TEST(TimeOptimal, IsBangBangUnderALimitOfAcceleration) {
  const double D = 1.3, a = 7;
  Trajectory slow;
  const VelocityProfile profile(D, {VelocityShape::trapezoidal, 3, {}, {}, 1});
  constexpr int kGrid = 3000;
  for (int k = 0; k <= kGrid; ++k) {
    const double t = 3.0 * k / kGrid;
    const Progression here = profile.at(t, k < kGrid ? Side::after : Side::before);
    slow.points.push_back({t, {here.position}, {here.speed}, {here.acceleration}, {}});
  }
  const std::vector<double> zero(kGrid + 1, 0);
  const PathCoefficients path{1, zero, zero, zero, zero, zero};
  const TimeLaw law = time_optimal_law(slow, path, {{kInfinite}, {a}, {kInfinite}}, 1);
  EXPECT_NEAR(law.time.back(), 2 * std::sqrt(D / a), 2e-3);
  const TimeLaw with_speed = time_optimal_law(slow, path, {{1.5}, {a}, {kInfinite}}, 1);
  EXPECT_NEAR(with_speed.time.back(), D / 1.5 + 1.5 / a, 2e-3);
}

// Each round of linearising friction is faster than the one before, and limits hold with the real friction.
TEST(TimeOptimal, LinearisesFrictionUntilItIsExact) {
  Case c = case_of("puma560.toml", 0.6);
  const std::optional<LinearScaling> linear = linear_scaling(c.sides, c.path, c.limits, 1e-6);
  const TimeLaw law = time_optimal_law(c.trajectory, c.grid, c.limits, linear->c);
  EXPECT_GT(law.rounds, 1);
  EXPECT_LT(law.rounds, 40);
  const Trajectory fast = paced(c.trajectory, law);
  const LargestLimitUse used = largest_limit_use(fast, c.torques.torques(fast), c.limits);
  EXPECT_LE(used.part, 1 + 1e-9);
  EXPECT_GT(used.part, 1 - 1e-4);
}

// A straight line in joint space is one path however it was sampled: steps of the given acceleration must have no
// effect. Sampled with a triangle and with a trapezium, the law takes the same time, from plans and from their samples.
TEST(TimeOptimal, DependsOnThePathAlone) {
  const LoadedRobot model = model_of("planar_2r_example_7_2.toml");
  Progress quiet(true);
  PathTorques torques(model, false, quiet);
  const double most = std::numeric_limits<double>::max();
  const PaceLimits limits{{most, most}, {most, most}, {3000, 3000}};
  std::vector<double> durations;
  for (const bool triangle : {true, false}) {
    for (const bool as_samples : {false, true}) {
      TrajectoryPlan plan;
      plan.start = TipPosture{{0.2, 0, 0}, Elbow::down, {}, {}};
      PlacedProfile profile = triangular(0.5, 2);
      if (!triangle) {
        profile.shape = VelocityShape::trapezoidal;
        profile.given["acceleration_time"] = {0.1, 0.1};
      }
      plan.segments = {{JointMove{JointPosture{1.5, 1.5}, true, profile}, {}}};
      Diagnostics found;
      Trajectory trajectory = planned_motion(plan, TipKinematics(model.robot), found, 4000);
      if (as_samples) {
        for (TrajectoryPoint& point : trajectory.points) point.qdd_before.clear();
        mark_jumps(trajectory);
      }
      const PathCoefficients path = torques.coefficients(trajectory);
      const Trajectory sides = with_both_sides(trajectory);
      const double c = linear_scaling(sides, torques.coefficients(sides), limits, 1e-6)->c;
      durations.push_back(time_optimal_law(trajectory, path, limits, c).time.back());
    }
  }
  for (const double duration : durations) EXPECT_NEAR(duration, durations.front(), 1e-3 * duration);
  EXPECT_EQ(durations[0], durations[1]);
}

TEST(LinearScaling, IsRefusedWhereRestIsTooMuch) {
  Case c = case_of("puma560.toml", 1);
  std::size_t worst = 0;
  for (std::size_t k = 0; k < c.path.d.size(); ++k) {
    if (k % 6 == 1 && std::abs(c.path.d[k]) > std::abs(c.path.d[worst * 6 + 1])) worst = k / 6;
  }
  c.limits.torque[1] = 0.9 * std::abs(c.path.d[worst * 6 + 1]);
  c.limits.torque[2] = 1e6;
  EXPECT_FALSE(linear_scaling(c.sides, c.path, c.limits, 1e-6));
  const LargestLimitUse load = largest_static_load(c.path, c.limits);
  EXPECT_EQ(load.joint, 1u);
  EXPECT_EQ(load.point, worst);
  EXPECT_NEAR(load.part, 1 / 0.9, 1e-12);
}

// Forbidden on both sides: a gravity of 10 with a limit of 6 is possible only if the motion helps, 10 − 8 u² ≤ 6, and
// is not too fast, 10 − 8 u² ≥ −6.
TEST(LinearScaling, TakesTheLargestOfAllowedPieces) {
  Trajectory point;
  point.points = {{0, {0}, {1}, {1}, {}}};
  const PathCoefficients path{1, {1}, {-8}, {0}, {10}, {-8}};
  const PaceLimits limits{{kInfinite}, {kInfinite}, {6}};
  const std::optional<LinearScaling> law = linear_scaling(point, path, limits, 1e-3);
  ASSERT_TRUE(law);
  EXPECT_NEAR(1 / law->c, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(linear_scaling(point, path, limits, 1)->c, 1, 0);
  EXPECT_FALSE(linear_scaling(point, path, limits, 2));
}

TEST(TimeOptimal, NeedsALimit) {
  Case c = case_of("planar_2r_example_7_2.toml", 1, 20);
  const std::vector<double> none(2, kInfinite);
  try {
    time_optimal_law(c.trajectory, c.grid, {none, none, none}, 1);
    ADD_FAILURE();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::unsupported);
  }
}

}  // namespace
}  // namespace flatdyn
