// SPDX-License-Identifier: GPL-2.0-or-later
// Positions that may be in degrees, in trajectories and in simulations, which ask in the same words.
#include "laboratory/trajectory/plan_reader.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <numbers>

#include "base/system/temporary_folder.hpp"
#include "laboratory/simulate/simulation.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// An arm of four joints: with limits, without, a continuous one, and a prismatic one.
LoadedRobot arm() {
  return testing::model_of_toml(
      "[[link]]\njoint = \"a\"\nmass = 1\nlimits = { lower = -8, upper = 8 }\n"
      "[[link]]\njoint = \"b\"\nmass = 1\nxyz = [0, 0, 1]\n"
      "[[link]]\njoint = \"c\"\ntype = \"continuous\"\nmass = 1\nxyz = [1, 0, 0]\n"
      "[[link]]\njoint = \"s\"\ntype = \"prismatic\"\nmass = 1\n");
}

std::vector<std::string> messages(const Diagnostics& found) {
  std::vector<std::string> all;
  for (const Diagnostic& each : found.all()) {
    EXPECT_EQ(each.severity, Severity::warning) << to_string(each);
    EXPECT_FALSE(each.kind.empty());
    all.push_back(each.message);
  }
  return all;
}

// The messages about a trajectory that starts there.
std::vector<std::string> asked_of_start(const std::string& start, const std::string& top = "") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "plan.toml";
  std::ofstream(file) << top << "start = " << start << "\n[[segment]]\ndwell = 1\n";
  Diagnostics found;
  read_plan(file, arm().mechanism, found);
  return messages(found);
}

struct ReadSimulation {
  Simulation simulation;
  std::vector<std::string> asked;
};

ReadSimulation simulation_of(const std::string& text) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "simulation.toml";
  std::ofstream(file) << text;
  const LoadedRobot model = arm();
  ReadSimulation read{resting(model.robot, model.mechanism), {}};
  Diagnostics found;
  read_simulation(file, model.robot, model.mechanism, read.simulation, found);
  read.asked = messages(found);
  return read;
}

TEST(TrajectoryUnits, PositionsThatMayBeInDegreesAreAskedAbout) {
  EXPECT_THAT(asked_of_start("[0, -90, 90, 90]"),
              ElementsAre("start, joint \"b\": -90 rad is 14 turns; were degrees meant?",
                          "start, joint \"c\": 90 rad is 14 turns; were degrees meant?"));
  EXPECT_THAT(asked_of_start("[8, 6.28, 40, 100]"), IsEmpty());
  EXPECT_THAT(asked_of_start("[8.1, 6.3, 45, 0]"), ::testing::SizeIs(3));
  EXPECT_THAT(asked_of_start("{ b = 90 }"), ElementsAre("start, joint \"b\": 90 rad is 14 turns; were degrees meant?"));
}

TEST(TrajectoryUnits, DegreesThatAreSaidAndExpressionsInPiAreNot) {
  EXPECT_THAT(asked_of_start("[0, -90, 90, 0]", "angles = \"deg\"\n"), IsEmpty());
  EXPECT_THAT(asked_of_start("[0, \"-10*pi\", 0, 0]"), IsEmpty());
}

TEST(TrajectoryUnits, PiInDegreesIsAnError) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "plan.toml";
  std::ofstream(file) << "angles = \"deg\"\nstart = [90, \"pi/2\", 0, 0]\n[[segment]]\ndwell = 1\n";
  Diagnostics found;
  read_plan(file, arm().mechanism, found);
  ASSERT_EQ(found.all().size(), 1U);
  EXPECT_EQ(found.all()[0].message, "start, joint \"b\": an expression with pi in a file in degrees: which are meant?");
}

TEST(SimulationUnits, PositionsThatMayBeInDegreesAreAskedAbout) {
  EXPECT_THAT(simulation_of("[start]\nq = [0, -90, 90, 90]\n").asked,
              ElementsAre("q, joint \"b\": -90 rad is 14 turns; were degrees meant?",
                          "q, joint \"c\": 90 rad is 14 turns; were degrees meant?"));
  EXPECT_THAT(simulation_of("[torque.pd]\nkp = 100\nposition = [0, 45, 0, 0]\n").asked,
              ElementsAre("position, joint \"b\": 45 rad is 7.2 turns; were degrees meant?"));
  EXPECT_THAT(simulation_of("[start]\nq = [8, 6.28, 40, 100]\nqd = 500\n[torque.pd]\nkp = 900\nkd = 90\n").asked,
              IsEmpty());
}

TEST(SimulationUnits, MayBeInDegrees) {
  const ReadSimulation read = simulation_of(
      "angles = \"deg\"\n[start]\nq = [0, -90, 180, 0.5]\nqd = [90, 0, 0, 2]\n[torque.pd]\nkp = 90\n"
      "position = [0, 45, 0, 1]\n");
  EXPECT_THAT(read.asked, IsEmpty());
  const double pi = std::numbers::pi;
  EXPECT_THAT(read.simulation.q, ElementsAre(0, -pi / 2, pi, 0.5));
  EXPECT_THAT(read.simulation.qd, ElementsAre(pi / 2, 0, 0, 2));
  EXPECT_THAT(read.simulation.feedback->position, ElementsAre(0, pi / 4, 0, 1));
  EXPECT_THAT(read.simulation.feedback->kp, ElementsAre(90, 90, 90, 90));
}

}  // namespace
}  // namespace flatdyn
