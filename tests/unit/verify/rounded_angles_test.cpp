// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/rounded_angles.hpp"

#include <gmock/gmock.h>

#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class RoundedAngles : public RobotFiles {
 protected:
  // An arm of three links whose axes are at these angles to each other.
  std::string arm(const std::string& first, const std::string& second) const {
    return write("arm.toml",
                 "dh = \"modified\"\n[[link]]\nmass = 1\ncom = [0.1, 0.2, 0]\n[[link]]\nmass = 1\na = 0.1\n"
                 "com = [0.1, 0, 0.1]\nalpha = " +
                     first + "\n[[link]]\nmass = 1\na = 0.2\ncom = [0.1, 0, 0]\nalpha = " + second + "\n");
  }
  // The messages about the robot in this file; with operation counts if inverse dynamics are made.
  Diagnostics said_of(const std::string& file, bool with_functions) const {
    PipelineOptions options;
    options.functions = {"inverse_dynamics"};
    const LoadedRobot model = load_robot(file, options);
    Progress silent(true);
    Diagnostics findings, none;
    std::vector<OptimisedFunction> functions;
    if (with_functions) functions = make_functions(model, options, silent, none);
    note_rounded_angles(model, options, functions, findings);
    return findings;
  }
};

TEST_F(RoundedAngles, AreAskedForWithWhatTheyCost) {
  const Diagnostics said = said_of(arm("1.57", "-0.785"), true);
  ASSERT_EQ(said.all().size(), 1U);
  const Diagnostic& note = said.all().front();
  EXPECT_EQ(note.severity, Severity::note);
  EXPECT_EQ(note.place.line, 9);
  EXPECT_THAT(note.message, HasSubstr("1.57 and 1 other angle may stand for multiples of pi/12, rounded; with these, "
                                      "inverse dynamics take "));
  EXPECT_EQ(note.hint, "if so, write more digits, or --snap 1e-3");
}

TEST_F(RoundedAngles, AreAskedForWithoutFunctions) {
  const Diagnostics said = said_of(arm("3.14", "0.3"), false);
  ASSERT_EQ(said.all().size(), 1U);
  EXPECT_THAT(said.all()[0].message, HasSubstr("3.14 may stand for a multiple of pi/12, rounded"));
  EXPECT_THAT(said.all()[0].message, Not(HasSubstr("operations")));
  EXPECT_EQ(said.all()[0].hint, "if so, write more digits, or --snap 2e-3");
}

TEST_F(RoundedAngles, AreNoOthers) {
  for (const char* other : {"1.5708", "0", "0.3", "1.6", "1.56", "0.001", "1.571001", "\"1.57\""}) {
    EXPECT_TRUE(said_of(arm(other, "0"), false).all().empty()) << other;
  }
}

}  // namespace
}  // namespace flatdyn
