// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/positions.hpp"

#include <gmock/gmock.h>

#include "support/written_model.hpp"
#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class CsvPositions : public RobotFiles {
 protected:
  // The questions about these states of a joint with limits, one without, and one that slides.
  std::vector<std::string> asked(const std::string& states) {
    return asked_of(
        "[[link]]\nmass = 1\nlimits = { lower = -8, upper = 8 }\n"
        "[[link]]\nmass = 1\nxyz = [0, 0, 1]\n"
        "[[link]]\nmass = 1\ntype = \"prismatic\"\n",
        states);
  }

  std::vector<std::string> asked_of(const std::string& robot, const std::string& states) {
    const Mechanism mechanism = testing::model_of_toml(robot).mechanism;
    Diagnostics found;
    const CsvTable table = read_csv(write("states.csv", states), found);
    CsvHeading heading = table.heading("states.csv", mechanism, found);
    warn_of_positions(table, heading.find(CsvQuantity::q), mechanism, "states.csv", found);
    std::vector<std::string> messages;
    for (const Diagnostic& each : found.all()) messages.push_back(to_string(each));
    return messages;
  }
};

TEST_F(CsvPositions, AreAskedAboutOnceForEachJoint) {
  EXPECT_THAT(asked("q1,q2,q3\n0,0,0\n90,-45,90\n90,90,90\n"),
              ElementsAre("states.csv:3: warning: q1: 90 rad is 14 turns; were degrees meant?\n"
                          "    hint: if so, write the column's heading as q1 [deg]",
                          "states.csv:3: warning: q2: -45 rad is 7.2 turns; were degrees meant?\n"
                          "    hint: if so, write the column's heading as q2 [deg]"));
}

TEST_F(CsvPositions, AreNotAskedAboutWithinWhatIsExpectedOrWithAUnit) {
  EXPECT_THAT(asked("q1,q2,q3\n8,49.9,800\n-8,-44,0\n"), IsEmpty());
  EXPECT_THAT(asked("q1 [deg],q2 [rad],q3\n90,90,0\n"), IsEmpty());
}

TEST_F(CsvPositions, OfQuaternionsAreWarnedAboutByTheirNorm) {
  const std::string robot =
      "[[link]]\nmass = 1\n"
      "[[link]]\nname = \"ball\"\njoint = \"ball\"\ntype = \"spherical\"\nmass = 1\ncom = [0.1, 0, 0]\n";
  EXPECT_THAT(asked_of(robot, "q1,q2,q3,q4,q5\n0,1,0,0,0\n0,0.6,0,0.8,0\n0,0.6000001,0,0.8,0\n"), IsEmpty());
  EXPECT_THAT(
      asked_of(robot, "q1,q_ball.qw,q_ball.qx,q_ball.qy,q_ball.qz\n0,1,0,0,0\n0,0,0,90,0\n0,2,0,0,0\n"),
      ElementsAre("states.csv:3: warning: the quaternion of the spherical joint \"ball\" has norm 90: functions "
                  "hold for norm 1\n    hint: divide the four numbers by their norm"));
}

}  // namespace
}  // namespace flatdyn
