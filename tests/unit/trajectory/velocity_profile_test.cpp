// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/velocity_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace flatdyn {
namespace {

using ::testing::HasSubstr;

constexpr auto kTriangular = VelocityShape::triangular;
constexpr auto kTrapezoidal = VelocityShape::trapezoidal;

// Checks that speed is the derivative of position, and acceleration that of speed, except at jumps.
void expect_consistent(const VelocityProfile& profile) {
  const double T = profile.duration(), h = 1e-6 * T;
  for (int k = 1; k < 40; ++k) {
    const double t = T * (k + 0.37) / 41;
    const Progression before = profile.at(t - h), here = profile.at(t), after = profile.at(t + h);
    EXPECT_NEAR((after.position - before.position) / (2 * h), here.speed, 1e-6 * profile.speed()) << t;
    EXPECT_NEAR((after.speed - before.speed) / (2 * h), here.acceleration, 1e-6 * profile.acceleration()) << t;
    EXPECT_LE(std::abs(here.speed), profile.speed() * (1 + 1e-12));
  }
  EXPECT_EQ(profile.at(0).position, 0);
  EXPECT_EQ(profile.at(0).speed, 0);
  EXPECT_EQ(profile.at(T).position, profile.distance());
  EXPECT_EQ(profile.at(T).acceleration, 0);
  EXPECT_EQ(profile.at(T, Side::before).acceleration, std::copysign(profile.acceleration(), -profile.distance()));
}

// Every pair of numbers that determines a trapezium gives the same one.
TEST(VelocityProfile, FromWhatIsGiven) {
  const double T = 0.5, t_a = 0.15, v = 4, a = v / t_a, D = v * (T - t_a);
  const std::vector<ProfileRequest> requests = {{kTrapezoidal, T, {}, {}, t_a}, {kTrapezoidal, T, {}, v, {}},
                                                {kTrapezoidal, T, a, {}, {}},   {kTrapezoidal, {}, {}, v, t_a},
                                                {kTrapezoidal, {}, a, v, {}},   {kTrapezoidal, {}, a, {}, t_a},
                                                {kTrapezoidal, T, a, v, t_a}};
  for (const double sign : {1.0, -1.0}) {
    for (const ProfileRequest& request : requests) {
      const VelocityProfile profile(sign * D, request);
      EXPECT_NEAR(profile.duration(), T, 1e-12);
      EXPECT_NEAR(profile.acceleration_time(), t_a, 1e-12);
      EXPECT_NEAR(profile.speed(), v, 1e-11);
      EXPECT_NEAR(profile.acceleration(), a, 1e-9);
      expect_consistent(profile);
    }
  }
}

// D = a T² / 4 = v T / 2.
TEST(VelocityProfile, OfATriangle) {
  const double D = 1.5, T = 0.5, a = 4 * D / (T * T), v = 2 * D / T;
  for (const ProfileRequest& request :
       {ProfileRequest{kTriangular, T, {}, {}, {}}, ProfileRequest{kTriangular, {}, a, {}, {}},
        ProfileRequest{kTriangular, {}, {}, v, {}}, ProfileRequest{kTriangular, {}, {}, {}, T / 2},
        ProfileRequest{kTriangular, T, a, v, T / 2}, ProfileRequest{kTrapezoidal, T, a, {}, {}}}) {
    const VelocityProfile profile(D, request);
    EXPECT_NEAR(profile.duration(), T, 1e-12);
    EXPECT_NEAR(profile.acceleration(), a, 1e-6);
    expect_consistent(profile);
  }
}

TEST(VelocityProfile, OfNoDistanceRests) {
  EXPECT_EQ(VelocityProfile(0, {kTrapezoidal, {}, {}, 2, 0.1}).duration(), 0);
  const VelocityProfile waits(0, {kTriangular, 2, {}, {}, {}});
  EXPECT_EQ(waits.duration(), 2);
  EXPECT_EQ(waits.at(1).acceleration, 0);
}

struct Conflict {
  ProfileRequest request;
  const char *key, *says;
};

class Conflicts : public ::testing::TestWithParam<Conflict> {};

TEST_P(Conflicts, AreSaidOfTheKeyAtFault) {
  try {
    const VelocityProfile profile(1, GetParam().request);
    ADD_FAILURE() << "made, of " << profile.duration() << " s";
  } catch (const ProfileConflict& conflict) {
    EXPECT_EQ(conflict.key(), GetParam().key);
    EXPECT_THAT(conflict.what(), HasSubstr(GetParam().says));
    EXPECT_FALSE(conflict.hint().empty());
  }
}

INSTANTIATE_TEST_SUITE_P(
    VelocityProfile, Conflicts,
    ::testing::Values(Conflict{{kTriangular, {}, {}, {}, {}}, "", "needs its duration"},
                      Conflict{{kTrapezoidal, 1, {}, {}, {}}, "", "needs two numbers"},
                      Conflict{{kTriangular, 0, {}, {}, {}}, "duration", "duration is 0"},
                      Conflict{{kTriangular, {}, -2, {}, {}}, "acceleration", "acceleration is -2"},
                      Conflict{{kTriangular, 1, 5, {}, {}}, "acceleration", "from the rest it is 4"},
                      Conflict{{kTriangular, 1, {}, 2.5, {}}, "speed", "from the rest it is 2"},
                      Conflict{{kTriangular, 1, {}, {}, 0.4}, "acceleration_time", "from the rest it is 0.5"},
                      Conflict{{kTrapezoidal, 1, 3.9, {}, {}}, "acceleration", "at least 4"},
                      Conflict{{kTrapezoidal, 1, {}, 0.9, {}}, "speed", "too short"},
                      Conflict{{kTrapezoidal, 1, {}, 2.1, {}}, "speed", "more than half"},
                      Conflict{{kTrapezoidal, 1, {}, {}, 0.6}, "acceleration_time", "more than half"},
                      Conflict{{kTrapezoidal, {}, {}, 5, 0.3}, "speed", "more than half"},
                      Conflict{{kTrapezoidal, 1, 5, 1.2, {}}, "acceleration", "from the rest it is 7.2"}));

}  // namespace
}  // namespace flatdyn
