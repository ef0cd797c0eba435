// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "report/identification_report.hpp"
#include "support/identified_arm.hpp"

namespace flatdyn {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// The result of a motion without noise, with links that are this far from π_b.
Identification result_of(const testing::Arm& arm, double misfit, bool converged) {
  Identification found;
  found.measurement.observations = arm.observed(testing::simulated(arm.robot, {.samples = 50}));
  found.estimate = estimate(found.measurement.observations, arm.truth());
  found.physical.pi_b = found.estimate.values;
  found.physical.largest_misfit = misfit;
  found.physical.converged = converged;
  found.fits.resize(found.measurement.observations.joints.size());
  return found;
}

TEST(IdentificationWarnings, DoNotBlameTheLogWhereTheSearchDidNotConverge) {
  const testing::Arm arm("planar_2r_example_7_2.toml");
  EXPECT_THAT(plausibility_warnings(arm.torque, result_of(arm, 36, false)),
              ElementsAre(AllOf(HasSubstr("did not converge"), HasSubstr("36 standard deviations"),
                                Not(HasSubstr("units")), Not(HasSubstr("noise")))));
}

TEST(IdentificationWarnings, SayWhatMayBeWrongWhereTheNearestLinksAreFar) {
  const testing::Arm arm("planar_2r_example_7_2.toml");
  EXPECT_THAT(plausibility_warnings(arm.torque, result_of(arm, 9, true)), IsEmpty());
  EXPECT_THAT(plausibility_warnings(arm.torque, result_of(arm, 36, true)),
              ElementsAre(AllOf(HasSubstr("36 standard deviations"), HasSubstr("units or geometry"),
                                HasSubstr("--parameters full"))));
}

TEST(IdentificationWarnings, AskForAllParametersOnlyWhereSomeAreLeftOut) {
  const testing::Arm arm("planar_2r_example_7_2.toml", ParameterSet::full);
  EXPECT_THAT(plausibility_warnings(arm.torque, result_of(arm, 36, true)),
              ElementsAre(AllOf(HasSubstr("units or geometry"), Not(HasSubstr("--parameters full")))));
}

// The residual that the links leave of a joint is compared with the largest torque: a wrist that hardly needs any is
// exact enough.
TEST(IdentificationWarnings, SayNothingOfWhatLinksLeaveOfATinyTorque) {
  const testing::Arm arm("planar_2r_example_7_2.toml");
  Identification found = result_of(arm, 0, true);
  ASSERT_EQ(parameter_name(arm.torque.base().columns.back()), "Im2");
  found.physical.pi_b.tail(1).array() += 1e-6;
  EXPECT_THAT(plausibility_warnings(arm.torque, found), ElementsAre(HasSubstr("the links leave")));
  found.measurement.observations.joints.back().R *= 1e-3;
  EXPECT_THAT(plausibility_warnings(arm.torque, found), IsEmpty());
}

// Masses are negative where gravity's direction is searched and found to be the opposite.
TEST(IdentificationWarnings, NameMassesThatAreNegative) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("flatdyn-lift-{}.toml", ::getpid());
  std::ofstream(path) << "[[link]]\njoint = \"lift\"\ntype = \"prismatic\"\naxis = [0, 0, 1]\nmass = 2\n"
                         "[[link]]\njoint = \"turn\"\naxis = [0, 1, 0]\nmass = 1\ncom = [0.2, 0, 0]\n"
                         "inertia = { yy = 0.1, zz = 0.1 }\ninertia_about = \"com\"\n";
  const testing::Arm arm(load_robot(path, {}));
  std::filesystem::remove(path);
  Identification found = result_of(arm, 0, true);
  const std::vector<int>& columns = arm.torque.base().columns;
  const auto mass =
      std::find_if(columns.begin(), columns.end(), [](int index) { return parameter_of(index) == Parameter::m; });
  ASSERT_NE(mass, columns.end());
  const Eigen::Index k = mass - columns.begin();
  EXPECT_THAT(plausibility_warnings(arm.torque, found), IsEmpty());
  found.estimate.values(k) = -1;
  EXPECT_THAT(plausibility_warnings(arm.torque, found),
              ::testing::Contains(HasSubstr("no mass can be: " + parameter_name(*mass))));
}

}  // namespace
}  // namespace flatdyn
