// SPDX-License-Identifier: GPL-2.0-or-later
// Commands on robots with closed loops, as users call them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "cli/program.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class ClosedLoops : public ::testing::Test {
 protected:
  Outcome eval(const std::string& states, const std::string& options) {
    scratch.write("states.csv", states);
    return run_flatdyn("eval robots/slider_crank.toml -q --states " + scratch.path("states.csv") + " " + options);
  }

  const Scratch scratch;
};

TEST_F(ClosedLoops, SingularOnesHaveNoReferenceEither) {
  // The rod across the slider's way: it does not say where the slider goes.
  const std::string states = "q1,q2,q3,qd1,qdd1\n0.3,-0.45,0.44,1,0\n1,0.57079632679489656,0.08,1,0\n";
  for (const char* reference : {"", " --reference", " --reference --digits 30"}) {
    const Outcome outcome = eval(states, std::string("--function inverse_dynamics") + reference);
    EXPECT_EQ(outcome.code, 3) << reference;
    EXPECT_THAT(outcome.err, HasSubstr("states.csv:3: error: a closed loop is singular here")) << reference;
  }
}

TEST_F(ClosedLoops, OpenOnesAreSaidSo) {
  scratch.write("open.csv", "q1,q2,q3,qd1,qdd1\n0.3,0.45,0.44,1,0\n");
  const Outcome open =
      run_flatdyn("eval robots/slider_crank.toml --function inverse_dynamics --states " + scratch.path("open.csv"));
  EXPECT_EQ(open.code, 0) << open.err;
  EXPECT_THAT(open.err, HasSubstr("open.csv:2: warning: the loops are open here, by 0."));
}

// In a plane, a hinge's axis says no more than its point.
TEST_F(ClosedLoops, AxesInAPlaneAreWrittenAsPoints) {
  const std::string points = text_of_robot("four_bar.toml");
  std::string axes = points;
  axes.insert(axes.find("dependent = "), "from_axis = [0, 0, 1]\nto_axis = [0, 0, -2]\n");
  std::string headers[2];
  for (const bool has_axes : {false, true}) {
    scratch.write("four_bar.toml", has_axes ? axes : points);
    ASSERT_EQ(run_flatdyn("generate " + scratch.path("four_bar.toml") + " -q -o " + scratch.path("out")).code, 0);
    std::istringstream lines(scratch.read("out/four_bar.hpp"));
    for (std::string line; std::getline(lines, line);) {
      const bool has_hash = line.starts_with("// Input: ") || line.find("FLATDYN_FOUR_BAR_HPP_") != std::string::npos;
      if (!has_hash) headers[has_axes] += line + "\n";
    }
  }
  EXPECT_GT(headers[0].size(), 10000U);
  EXPECT_TRUE(headers[0] == headers[1]);
}

TEST_F(ClosedLoops, RatesOfAllJointsAreRefused) {
  const Outcome outcome = eval("q1,q2,q3,qd1,qd2,qd3,qdd1\n0.3,-0.45,0.44,1,0,0,0\n", "--function inverse_dynamics");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("column qd2: qd has 1 entries, of the independent joints"));
  EXPECT_THAT(outcome.err, HasSubstr("qd_theta_1"));
}

// The worst states that are found can be looked at.
TEST_F(ClosedLoops, LoseNoMoreThanTheReference) {
  const Outcome stressed = run_flatdyn(fmt::format(
      "stress robots/slider_crank.toml -q --functions inverse_dynamics,forward_dynamics,loop_step --states 100 "
      "--edges 50 --evaluations 100 -o {}",
      scratch.path("found")));
  ASSERT_EQ(stressed.code, 0) << stressed.err;
  EXPECT_THAT(stressed.out, HasSubstr("loop_step"));
  const Outcome worst = run_flatdyn("eval robots/slider_crank.toml -q --function inverse_dynamics --states " +
                                    scratch.path("found/worst_inverse_dynamics_double.csv"));
  EXPECT_EQ(worst.code, 0) << worst.err;
}

// q is that of all joints, in the order that every command has, and can be read again.
TEST_F(ClosedLoops, HaveAllPositionsAlongATrajectory) {
  scratch.write("turn.toml",
                "start = [1.57, 1.57]\n[[segment]]\nby = [0.1, -0.1]\nprofile = \"triangular\"\nduration = 0.3\n");
  const auto torques = [this](const std::string& trajectory, const std::string& output) {
    return run_flatdyn(fmt::format("torques robots/five_bar.toml -q --trajectory {} -o {} --plot {}.svg",
                                   scratch.path(trajectory), scratch.path(output), scratch.path(output)));
  };
  ASSERT_EQ(torques("turn.toml", "first.csv").code, 0);
  const std::string first = scratch.read("first.csv");
  EXPECT_THAT(first, StartsWith("t,q1,q2,q3,q4,qd1,qd2,qdd1,qdd2,tau1,tau2,"));
  EXPECT_THAT(scratch.read("first.csv.svg"), HasSubstr("left_elbow"));
  ASSERT_EQ(torques("first.csv", "again.csv").code, 0);
  EXPECT_EQ(scratch.read("again.csv"), first);
  const Outcome scaled =
      run_flatdyn(fmt::format("scale robots/five_bar.toml -q --trajectory {} --torque-limits 1,1 -o {}",
                              scratch.path("turn.toml"), scratch.path("scaled.csv")));
  ASSERT_EQ(scaled.code, 0) << scaled.err;
  EXPECT_THAT(scratch.read("scaled.csv"), StartsWith("t,q1,q2,q3,q4,qd1,qd2,qdd1,qdd2,tau1,tau2\n"));
}

// A simulated motion is read as a trajectory, and needs the torques that it was made with.
TEST_F(ClosedLoops, MoveAndNeedTheTorquesThatMovedThem) {
  scratch.write("push.toml", "duration = 0.2\nrate = 100\n[start]\nq = [0.5]\n[torque]\nconstant = [0.05]\n");
  const Outcome moved = run_flatdyn(fmt::format("simulate robots/slider_crank.toml -q --simulation {} -o {}",
                                                scratch.path("push.toml"), scratch.path("motion.csv")));
  ASSERT_EQ(moved.code, 0) << moved.err;
  EXPECT_THAT(scratch.read("motion.csv"), StartsWith("t,q1,q2,q3,qd1,qdd1,tau1,friction1,kinetic,"));
  const Outcome torques = run_flatdyn(fmt::format("torques robots/slider_crank.toml -q --json --trajectory {} -o {}",
                                                  scratch.path("motion.csv"), scratch.path("torques.csv")));
  ASSERT_EQ(torques.code, 0) << torques.err;
  EXPECT_THAT(scratch.read("torques.csv"), HasSubstr("centrifugal_1_1"));
  const Outcome scaled =
      run_flatdyn(fmt::format("scale robots/slider_crank.toml -q --torque-limits 0.04 --trajectory {} -o {}",
                              scratch.path("motion.csv"), scratch.path("slow.csv")));
  EXPECT_EQ(scaled.code, 0) << scaled.err;
}

TEST_F(ClosedLoops, LimitsOfDependentJointsAreNotWatchedAndThatIsSaid) {
  std::string text = text_of_robot("slider_crank.toml");
  const std::string slider = "joint = \"x\"\n";
  text.insert(text.find(slider) + slider.size(), "limits = { lower = 0.3, upper = 0.4, velocity = 1, effort = 1 }\n");
  scratch.write("limited.toml", text);
  scratch.write("stop.toml", "duration = 0.1\njoint_limits = \"stop\"\n");
  const Outcome outcome = run_flatdyn(fmt::format("simulate {} --simulation {} -o {}", scratch.path("limited.toml"),
                                                  scratch.path("stop.toml"), scratch.path("motion.csv")));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("stop.toml:2: warning: joint_limits: joint \"x\" follows from a closed loop"));
}

// A slider that pushes the crank through its dead centre.
TEST_F(ClosedLoops, EndAtASingularPosition) {
  std::string text = text_of_robot("slider_crank.toml");
  const std::string dependent = R"(dependent = ["theta_2", "x"])";
  text.replace(text.find(dependent), dependent.size(), R"(dependent = ["theta_1", "theta_2"])");
  scratch.write("driven.toml", text);
  scratch.write("push.toml", "duration = 5\n[torque]\nconstant = [1]\n");
  const Outcome outcome = run_flatdyn(fmt::format("simulate {} -q --simulation {} -o {}", scratch.path("driven.toml"),
                                                  scratch.path("push.toml"), scratch.path("motion.csv")));
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_THAT(outcome.err, ::testing::AnyOf(HasSubstr("the loops cannot be closed beyond x = 0.4"),
                                            HasSubstr("the loops are singular at x = 0.4")));
  EXPECT_FALSE(std::filesystem::exists(scratch.path("motion.csv")));
}

TEST_F(ClosedLoops, AreEmittedInAllForms) {
  int count = 0;
  for (const char* form : {"", "--language c", "--language javascript", "--form pair", "--python",
                           "--stages inertia_matrix,inverse_dynamics --fuse gravity,loop_motion"}) {
    const Outcome outcome = run_flatdyn(
        fmt::format("generate robots/five_bar.toml -q {} -o {}", form, scratch.path(fmt::format("out{}", ++count))));
    EXPECT_EQ(outcome.code, 0) << form << "\n" << outcome.err;
  }
}

// Positions of the assembly are for joints that move.
TEST_F(ClosedLoops, MayHaveJointsHeldThatTheAssemblyNames) {
  const Outcome outcome = run_flatdyn("inspect robots/five_bar.toml --fix left=1.57");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("3 joints, 1 of them independent"));
}

TEST(AdaptiveRegressor, OfAFloatingBaseIsWritten) {
  const Scratch scratch;
  const Outcome outcome =
      run_flatdyn("generate docs/examples/floating_body.toml -q --functions adaptive_regressor --convention pose -o " +
                  scratch.path("out"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

}  // namespace
}  // namespace flatdyn::testing
