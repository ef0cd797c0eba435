// SPDX-License-Identifier: GPL-2.0-or-later
// Headings as people and their tools write them: which column is which joint's, and what is not clear.
#include "robot/input/csv/heading.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/input/csv/text.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The joints of a UR5, in the robot's order: shoulder_pan_joint, shoulder_lift_joint, elbow_joint, wrist_1_joint, …
const Mechanism& six_joints() {
  static const LoadedRobot model = testing::model_of("ur5.urdf");
  return model.mechanism;
}

const Mechanism& two_joints() {
  static const LoadedRobot model = testing::model_of("planar_2r_example_7_2.toml");
  return model.mechanism;
}

struct Heading {
  Diagnostics found;
  std::vector<int> columns;  // -1: none

  Heading(const std::string& text, CsvQuantity quantity, const Mechanism& mechanism, const std::string& row = "") {
    CsvHeading heading(csv_entries(text, separator_of(text)), csv_entries(row, separator_of(text)), {"log.csv", 1},
                       mechanism, found);
    for (const auto& source : heading.find(quantity)) columns.push_back(source ? static_cast<int>(source->column) : -1);
    heading.finish();
  }
  std::string messages() const {
    std::string all;
    for (const Diagnostic& each : found.all()) all += to_string(each) + "\n";
    return all;
  }
};

struct Set {
  const char* heading;
  std::vector<int> columns;
  const char* message;  // part of what is said; "": nothing
};

TEST(CsvHeading, SetsAreCountedFromOneOrFromZero) {
  const Set sets[] = {
      {"q1,q2,q3,q4,q5,q6", {0, 1, 2, 3, 4, 5}, ""},
      {"q6,q5,q4,q3,q2,q1", {5, 4, 3, 2, 1, 0}, ""},
      {"q_1,q_2,q_3,q_4,q_5,q_6", {0, 1, 2, 3, 4, 5}, ""},
      {"q01,q02,q03,q04,q05,q06", {0, 1, 2, 3, 4, 5}, ""},
      {"q(1),q(2),q(3),q(4),q(5),q(6)", {0, 1, 2, 3, 4, 5}, ""},
      {"q0,q1,q2,q3,q4,q5", {0, 1, 2, 3, 4, 5}, "log.csv:1: note: columns counted from 0: q0 to q5\n"},
      {"q[5],q[0],q[1],q[2],q[3],q[4]", {1, 2, 3, 4, 5, 0}, "note: columns counted from 0: q[0] to q[5]\n"},
      {"q1,q2,q4,q5,q6", {0, 1, -1, 2, 3, 4}, ""},  // whoever needs q3 says that it is missing
      {"q1,q2,q3,q4,q5,q6,q7",
       {0, 1, 2, 3, 4, 5},
       "warning: columns of joints that the robot does not have (it has 6) "
       "are not used: q7\n"},
      {"q0,q1,q2,q3,q4",
       {-1, -1, -1, -1, -1, -1},
       "error: columns q0, q1, q2, q3, q4 are neither q0 to q5 nor q1 to q6, the robot has 6"},
      {"q0,q1,q2,q3,q4,q5,q6",
       {-1, -1, -1, -1, -1, -1},
       "error: columns q0, q1, q2, q3, q4, q5, q6 are neither q0 to q5 nor q1 to q6, the robot has 6"},
      {"q0,q1,q2,q_elbow_joint",
       {-1, -1, 3, -1, -1, -1},
       "error: columns q0, q1, q2 are neither q0 to q5 nor q1 to q6, the robot has 6"},
      {"q1,q2,q3,q4,q5,qd0,qd1,qd2,qd3,qd4,qd5",
       {-1, -1, -1, -1, -1, -1},
       "error: columns q1, q2, q3, q4, q5 are neither q0 to q5 nor q1 to q6, and qd0 is counted from 0"},
      {"q1,q1,q2", {0, 2, -1, -1, -1, -1}, "error: column \"q1\" is there twice"},
      {"q3,q_elbow_joint",
       {-1, -1, 0, -1, -1, -1},
       "error: columns \"q3\" and \"q_elbow_joint\" are the same quantity"},
  };
  for (const auto& [text, columns, message] : sets) {
    const Heading heading(text, CsvQuantity::q, six_joints());
    EXPECT_EQ(heading.columns, columns) << text;
    if (message[0] == 0) {
      EXPECT_EQ(heading.messages(), "") << text;
    } else {
      EXPECT_THAT(heading.messages(), HasSubstr(message)) << text;
    }
  }
}

// The last five of a set from q0 to q5 look like that, too.
TEST(CsvHeading, ASetWithoutTheLastJointMayLackItsZero) {
  EXPECT_THAT(
      Heading("q1,q2,q3,q4,q5", CsvQuantity::q, six_joints()).messages(),
      HasSubstr("warning: q1 to q5: the last joint has no column; is the set counted from 0, and its 0 missing?"));
  EXPECT_EQ(Heading("q1,q2,q3,q4", CsvQuantity::q, six_joints()).messages(), "");
  Diagnostics found;  // where all are needed, the missing one is an error
  CsvHeading heading({"q1"}, {}, {"log.csv", 1}, two_joints(), found);
  EXPECT_TRUE(heading.require(CsvQuantity::q, "positions").empty());
  EXPECT_THAT(found.all().at(0).message, HasSubstr("no column for the positions: q2"));
}

TEST(CsvHeading, ASetFromZeroStandsBesideOneFromOne) {
  Diagnostics found;
  CsvHeading heading({"q0", "q1", "tau_1", "tau_2"}, {}, {"log.csv", 1}, two_joints(), found);
  EXPECT_EQ(heading.require(CsvQuantity::q, "positions").size(), 2u);
  EXPECT_EQ(heading.require(CsvQuantity::tau, "torques").at(1).column, 3u);
  heading.finish();
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_EQ(found.all()[0].message, "columns counted from 0: q0 to q1");
}

TEST(CsvHeading, AForceIsCountedFromZeroToo) {
  EXPECT_THAT(Heading("h_e0,h_e1,h_e2,h_e3,h_e4,h_e5", CsvQuantity::h_e, two_joints()).columns,
              ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(Heading("mz,my,mx,fz,fy,fx", CsvQuantity::h_e, two_joints()).columns, ElementsAre(5, 4, 3, 2, 1, 0));
}

TEST(CsvHeading, MessagesNameTheirJoints) {
  const std::string plot =
      "__time,/joint_states/elbow_joint/position,/joint_states/finger/position,/joint_states/shoulder_lift_joint/"
      "position,/joint_states/elbow_joint/velocity";
  const Heading heading(plot, CsvQuantity::q, six_joints());
  EXPECT_THAT(heading.columns, ElementsAre(-1, 3, 1, -1, -1, -1));
  EXPECT_THAT(heading.messages(), HasSubstr("columns that are not used: __time, /joint_states/finger/position, "));
  EXPECT_THAT(Heading("joint_states.elbow_joint.effort", CsvQuantity::tau, six_joints()).columns,
              ElementsAre(-1, -1, 0, -1, -1, -1));
  EXPECT_THAT(Heading("/a/elbow_joint/position,/b/elbow_joint/position", CsvQuantity::q, six_joints()).messages(),
              HasSubstr("columns \"/a/elbow_joint/position\" and \"/b/elbow_joint/position\" are the same quantity"));
  // The robot's own names count before those of messages.
  const Heading both("q1,q2,/desired/theta_1/position", CsvQuantity::q, two_joints());
  EXPECT_THAT(both.columns, ElementsAre(0, 1));
  EXPECT_THAT(both.messages(), HasSubstr("note: columns that are not used: /desired/theta_1/position"));
}

TEST(CsvHeading, ArraysOfMessagesHaveAnOrderOfTheirOwn) {
  for (const char* text : {"position[0],position[1]", "field.position0,field.position1",
                           "/joint_states/position.0,/joint_states/position.1"}) {
    const Heading heading(text, CsvQuantity::q, two_joints());
    EXPECT_THAT(heading.columns, ElementsAre(0, 1)) << text;
    EXPECT_THAT(heading.messages(), HasSubstr("warning: no column tells which joints ")) << text;
    EXPECT_THAT(heading.messages(), HasSubstr("The robot's order: theta_1, theta_2")) << text;
  }
  const Heading told("field.name0,field.name1,field.name2,field.position0,field.position1,field.position2",
                     CsvQuantity::q, two_joints(), "theta_2,gripper,theta_1,0,0,0");
  EXPECT_THAT(told.columns, ElementsAre(5, 3));
  EXPECT_EQ(told.messages(), "log.csv:1: note: columns that are not used: field.position1\n");
  const Heading lacking("name[0],position[0],position[1]", CsvQuantity::q, two_joints(), "theta_2,0,0");
  EXPECT_THAT(lacking.messages(), HasSubstr("no column tells which joint \"position[1]\" belongs to"));
}

TEST(CsvHeading, DegreesAreExact) {
  Diagnostics found;
  CsvHeading heading({"q1 [deg]", "q2 (rad)", "qd1 [\xC2\xB0/s]", "qd2", "tau1 [N m]", "tau2 [mNm]"}, {},
                     {"log.csv", 1}, two_joints(), found);
  EXPECT_EQ(heading.require(CsvQuantity::q, "positions").at(0).factor, GiNaC::Pi / 180);
  EXPECT_EQ(heading.require(CsvQuantity::q, "positions").at(1).factor, 1);
  EXPECT_EQ(heading.all_or_none(CsvQuantity::qd).at(0).factor, GiNaC::Pi / 180);
  EXPECT_EQ(heading.require(CsvQuantity::tau, "torques").at(1).factor, GiNaC::numeric(1, 1000));
  EXPECT_TRUE(found.all().empty());
}

TEST(CsvHeading, AUnitThatIsNoneOfTheQuantityIsAnError) {
  for (const char* text : {"q1 [grad]", "q1 [mm]", "q1 [deg/s]"}) {
    EXPECT_THAT(Heading(text, CsvQuantity::q, two_joints()).messages(), HasSubstr("known units: rad, deg")) << text;
  }
}

struct Clock {
  const char *heading, *first, *later;
  double seconds;       // of the later row
  const char* message;  // part of what is said; "": nothing
};

// A millisecond and a bit in the last digits of a clock that a double cannot hold.
TEST(CsvHeading, TimesAreFoundAndKeepTheirDigits) {
  const Clock clocks[] = {
      {"t", "0.5", "0.75", 0.75, ""},
      {"Time", "0.5", "0.75", 0.75, ""},
      {"Time (ms)", "500", "750", 0.75, ""},
      {"t", "1400000000000000123", "1400000000001000124", 0.001000001, "nanoseconds since 1970, by the size of 14"},
      {"timestamp", "1400000000123456", "1400000000124457", 0.001001, "microseconds since 1970"},
      {"__time", "1400000000123", "1400000000124", 0.001, "milliseconds since 1970"},
      {"__time", "1400000000.123456789", "1400000000.124456790", 0.001000001, "note: column \"__time\": times count"},
      {"%time", "2000000000", "2001000000", 2.001, "nanoseconds, as ROS writes them"},
      {"t [ns]", "1400000000000000123", "1400000000000000125", 2e-9, "times count from the first row"},
      {"header.stamp.secs,header.stamp.nsecs", "1400000000,999999999", "1400000001,000000001", 2e-9, "count from"},
      {"/joint_states/header/stamp/sec,/joint_states/header/stamp/nanosec", "3,999000000", "4,000000000", 4, "seconds"},
      {"secs,nsecs", "3,0", "4,500000000", 4.5, "seconds, and nsecs nanoseconds"},
      {"timestamp,t", "7,1", "9,2", 2, "not used: timestamp"},
  };
  for (const auto& [text, first, later, seconds, message] : clocks) {
    Diagnostics found;
    CsvHeading heading(csv_entries(text, ','), csv_entries(first, ','), {"log.csv", 1}, two_joints(), found);
    const std::optional<CsvTime> time = heading.require_time();
    heading.finish();
    ASSERT_TRUE(time) << text;
    const std::vector<std::string> row = csv_entries(later, ',');
    const std::optional<double> read = time->nanoseconds
                                           ? time->clock.seconds(row[time->column], row[*time->nanoseconds])
                                           : time->clock.seconds(row[time->column]);
    EXPECT_DOUBLE_EQ(read.value_or(-1), seconds) << text;
    std::string messages;
    for (const Diagnostic& each : found.all()) messages += to_string(each) + "\n";
    if (message[0] == 0) {
      EXPECT_EQ(messages, "") << text;
    } else {
      EXPECT_THAT(messages, HasSubstr(message)) << text;
    }
  }
}

TEST(CsvHeading, TimesThatAreNotClearAreErrors) {
  const std::pair<const char*, const char*> headings[] = {
      {"t,time", "several columns are times: t, time"},
      {"/a/header/stamp,/b/header/stamp", "several columns are times: /a/header/stamp, /b/header/stamp"},
      {"header.stamp.secs", "column header.stamp.secs: there is no column of its nanoseconds"},
      {"t [min]", "column \"t\": unknown unit \"min\""},
      {"q1", "no column for the time: t"},
  };
  for (const auto& [text, message] : headings) {
    Diagnostics found;
    CsvHeading heading(csv_entries(text, ','), {}, {"log.csv", 1}, two_joints(), found);
    heading.require_time();
    ASSERT_TRUE(found.has_errors()) << text;
    EXPECT_EQ(found.all()[0].message, message) << text;
  }
}

TEST(CsvClock, WhatIsNoTimeIsNone) {
  const CsvClock clock{1, ExactTime{1400000000, 0}};
  for (const char* text : {"", "-", "1.2.3", "x", "nan", "inf", "1,5", "99999999999999999999999x"}) {
    EXPECT_FALSE(clock.seconds(text)) << text;
  }
  for (const char* nanoseconds : {"", "-1", "1000000000", "1.5", "x"}) {
    EXPECT_FALSE(clock.seconds("1400000000", nanoseconds)) << nanoseconds;
  }
  EXPECT_DOUBLE_EQ(clock.seconds("1.4e9").value_or(-1), 0);
  EXPECT_DOUBLE_EQ(clock.seconds("-1400000000").value_or(-1), -2.8e9);
}

}  // namespace
}  // namespace flatdyn
