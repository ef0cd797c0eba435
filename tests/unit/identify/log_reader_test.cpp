// SPDX-License-Identifier: GPL-2.0-or-later
// Logs as people write them, with typical mistakes: each one is reported with its line.
#include "laboratory/identify/log_reader.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <functional>
#include <numbers>

#include "laboratory/identify/motion_stream.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const Mechanism& planar_arm() {
  static const LoadedRobot model = testing::model_of("planar_2r_example_7_2.toml");
  return model.mechanism;
}

class LogTest : public ::testing::Test {
 protected:
  std::filesystem::path file = std::filesystem::temp_directory_path() / fmt::format("flatdyn-log-{}.csv", ::getpid());
  Diagnostics found;

  ~LogTest() override { std::filesystem::remove(file); }

  void write(const std::string& text) const { std::ofstream(file) << text; }

  std::vector<std::vector<double>> read(const std::string& text, bool torques = true) {
    write(text);
    std::vector<std::vector<double>> samples;
    LogReader reader(file, planar_arm(), {torques}, found);
    if (found.has_errors()) return samples;
    std::vector<double> channels(static_cast<std::size_t>(reader.layout().channels()));
    while (reader.next(channels.data())) samples.push_back(channels);
    return samples;
  }

  void read_all() {
    const StreamPlan plan = plan_stream(file, planar_arm(), {}, found);
    ASSERT_TRUE(found.all().empty());
    stream(
        file, planar_arm(), plan, [](const double*) {}, found);
  }

  // The only error, as "line: message".
  std::string error() const {
    for (const Diagnostic& each : found.all()) {
      if (each.severity == Severity::error) return fmt::format("{}: {}", each.place.line, each.message);
    }
    return "none";
  }
};

TEST_F(LogTest, ColumnsComeInAnyOrderByNumberOrName) {
  const auto samples =
      read("tau_theta_2, q1, time, tau1, q_theta_2, room\n# a comment\n\n4, 1, 0.5, 3, 2, kitchen\r\n");
  EXPECT_EQ(error(), "none");
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_THAT(samples[0], ElementsAre(0.5, 1, 2, 3, 4));
  EXPECT_THAT(found.all().at(0).message, HasSubstr("not used: room"));
}

TEST_F(LogTest, UnitsAreMadeSI) {
  const auto samples = read("t [ms],q1[deg],q2 (rad),tau1 [Nmm],tau2,qd1 [deg/s],qd2\n500,180,2,3000,4,-90,6\n");
  EXPECT_EQ(error(), "none");
  ASSERT_EQ(samples.size(), 1u);
  const double pi = std::numbers::pi;
  EXPECT_THAT(samples[0], ::testing::Pointwise(::testing::DoubleEq(), {0.5, pi, 2.0, 3.0, 4.0, -pi / 2, 6.0}));
}

TEST_F(LogTest, WhatIsWrongWithTheHeadingIsSaid) {
  const std::pair<const char*, const char*> cases[] = {
      {"t,q1,tau1,tau2\n", "1: no column for the positions: q2"},
      {"q1,q2,tau1,tau2\n", "1: no column for the time: t"},
      {"t,q1,q2,tau1,tau2,qd2\n", "1: no column for qd1"},
      {"t,q1,q2,tau1,tau2,q_theta_1\n", "1: columns \"q1\" and \"q_theta_1\" are the same quantity"},
      {"t,q1,q1,q2,tau1,tau2\n", "1: column \"q1\" is there twice"},
      {"t,q0,q1,q2,tau0,tau1\n", "1: columns q0, q1, q2 are neither q0 to q1 nor q1 to q2, the robot has 2"},
      {"# t,q1,q2,tau1,tau2\n0,1,2,3,4\n", "2: there is a row of numbers where the heading is expected"},
      {"t,q1 [grad],q2,tau1,tau2\n", "1: column \"q1\": unknown unit \"grad\""},
      {"t q1 q2 tau1 tau2\n", "1: no column for the time: t"},
      {"\x1F\x8B\b,", "1: the file is compressed"},
      {"", "0: no samples in the file"},
  };
  for (const auto& [text, message] : cases) {
    found = {};
    read(text);
    EXPECT_EQ(error(), message) << text;
  }
}

TEST_F(LogTest, WhatIsWrongWithALineIsSaid) {
  const std::pair<const char*, const char*> cases[] = {
      {"0,1,2,3,\n", "2: column \"tau2\": missing value"},
      {"0,1,,3,4\n", "2: column \"q2\": missing value"},
      {"0,1,2,3\n", "2: 4 entries, but the heading has 5 columns"},
      {"0,1,2,3,4,5\n", "2: more than the 5 entries that the heading has"},
      {"0,1,2,x,4\n", "2: column \"tau1\": \"x\" is not a finite number"},
      {"0,1,nan,3,4\n", "2: column \"q2\": \"nan\" is not a finite number"},
      {"0,1,+-2,3,4\n", "2: column \"q2\": \"+-2\" is not a finite number"},
      {"0,1,\"2,3,4\n", "2: column \"q2\": \"\"2\" is not a finite number"},
      {"0,1,1e999,3,4\n", "2: column \"q2\": \"1e999\" is not a finite number"},
      {"0,1,2,3,4\n0,1,2,3,4\n", "3: time does not grow: 0 s is there twice"},
  };
  for (const auto& [lines, message] : cases) {
    found = {};
    read(std::string("t,q1,q2,tau1,tau2\n") + lines);
    EXPECT_EQ(error(), message) << lines;
  }
}

TEST_F(LogTest, ColumnsMayBeCountedFromZero) {
  const auto samples = read("t,q0,q1,tau1,tau2\n0,1,2,3,4\n");
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_THAT(samples[0], ElementsAre(0, 1, 2, 3, 4));
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_EQ(found.all()[0].message, "columns counted from 0: q0 to q1");
}

TEST_F(LogTest, OtherSeparatorsAndDecimalCommasAreRead) {
  for (const char* text :
       {"\xEF\xBB\xBFt;q1;q2;\"tau1\";tau2;room\r\n0,5;1;+2,0;\"3\";-4e0;\"a;b\"\r\n",
        "t\tq1\tq2\ttau1\ttau2\n0.5\t1\t 2\t3\t-4\n", "t,q1,q2,tau1,tau2,room\n0.5,1,2,3,-4,\"a,b\"\n"}) {
    found = {};
    const auto samples = read(text);
    EXPECT_EQ(error(), "none") << text;
    ASSERT_EQ(samples.size(), 1u) << text;
    EXPECT_THAT(samples[0], ElementsAre(0.5, 1, 2, 3, -4)) << text;
  }
  read("t;q1;q2;tau1;tau2\n0;1,5;2;3;4\n1;1.234;2;3;4\n");
  EXPECT_EQ(error(), "3: column \"q1\": \"1.234\" is not a finite number");
  EXPECT_THAT(found.all().back().hint, HasSubstr("decimal points, or all of them decimal commas"));
}

// A double can distinguish 1.4e18 from 1.4e18 + 256, but not smaller steps.
TEST_F(LogTest, ClocksKeepTheirDigits) {
  const std::pair<const char*, const char*> logs[] = {
      {"timestamp,q1,q2,tau1,tau2\n1400000000000000001,0,0,0,0\n1400000000001000002,0,0,0,0\n",
       "column \"timestamp\": nanoseconds since 1970, by the size of 1400000000000000001; times count from the first "
       "row"},
      {"header.stamp.secs,header.stamp.nsecs,q1,q2,tau1,tau2\n1400000000,999999999,0,0,0,0\n1400000001,1000000,0,0,0,"
       "0\n",
       "column \"header.stamp.secs\": seconds, and header.stamp.nsecs nanoseconds; times count from the first row"}};
  for (const auto& [text, message] : logs) {
    found = {};
    const auto samples = read(text);
    ASSERT_EQ(samples.size(), 2u) << text;
    EXPECT_DOUBLE_EQ(samples[0][0], 0);
    EXPECT_DOUBLE_EQ(samples[1][0], 0.001000001) << text;
    ASSERT_EQ(found.all().size(), 1u);
    EXPECT_EQ(found.all()[0].message, message);
  }
  read("timestamp,q1,q2,tau1,tau2\n1400000000000000001,0,0,0,0\nnow,0,0,0,0\n");
  EXPECT_EQ(error(), "3: column \"timestamp\": \"now\" is no time");
}

TEST_F(LogTest, JointsOfAMessageKeepTheirOrder) {
  const std::string heading =
      "%time,field.name0,field.name1,field.position0,field.position1,field.effort0,field.effort1\n";
  const auto samples = read(heading + "0,theta_2,theta_1,1,2,3,4\n1000000,theta_2,theta_1,1,2,3,4\n");
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_THAT(samples[1], ElementsAre(0.001, 2, 1, 4, 3));
  read(heading + "0,theta_2,theta_1,1,2,3,4\n1000000,theta_1,theta_2,1,2,3,4\n");
  EXPECT_EQ(error(), "3: column \"field.name0\" is not \"theta_2\", as in the first row");
}

TEST_F(LogTest, NumbersMayHaveAPlusOrQuotationMarksOrBeNearlyZero) {
  const auto samples = read("t,q1,q2,tau1,tau2\n+0.5,\"-1\", \"+2\" ,1e-400,+3e+1\n");
  EXPECT_EQ(error(), "none");
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_THAT(samples[0], ElementsAre(0.5, -1, 2, 0, 30));
}

TEST_F(LogTest, ColumnsThatAreNotUsedAreNamedUpToTen) {
  std::string heading = "t,q1,q2,tau1,tau2,";
  for (int k = 1; k < 12; ++k) heading += fmt::format(",x{}", k);
  read(heading + "\n");
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_EQ(found.all()[0].message,
            "columns that are not used: (no name), x1, x2, x3, x4, x5, x6, x7, x8, x9 and 2 more");
}

TEST_F(LogTest, ColumnsOfJointsThatTheRobotDoesNotHaveAreAWarning) {
  read("t,q1,q2,q3,tau1,tau2,tau_3,q_ref\n");
  ASSERT_EQ(found.all().size(), 2u);
  EXPECT_EQ(found.all()[0].severity, Severity::note);
  EXPECT_EQ(found.all()[1].severity, Severity::warning);
  EXPECT_EQ(found.all()[1].message,
            "columns of joints that the robot does not have (it has 2) are not used: q3, tau_3");
}

TEST_F(LogTest, WhereTorquesAreNotNeededTheyAreNotRead) {
  for (const char* text :
       {"t,q1,q2,fx,fy,fz,mx,my,mz\n0,1,2,3,4,5,6,7,8\n", "t,q1,q2,tau2,fx,fy,fz,mx,my,mz\n0,1,2,none,3,4,5,6,7,8\n"}) {
    const auto samples = read(text, false);
    EXPECT_EQ(error(), "none");
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_THAT(samples[0], ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
  }
}

TEST_F(LogTest, SayingStopsAfterTwentyErrors) {
  std::string text = "t,q1,q2,tau1,tau2\n";
  for (int k = 0; k < 100; ++k) text += "no,1,2,3,4\n";
  read(text);
  EXPECT_EQ(found.all().size(), 20u);
}

TEST_F(LogTest, AFileThatIsNotThereIsAFailureOfReading) {
  EXPECT_THROW(LogReader("/nowhere/log.csv", planar_arm(), {}, found), Failure);
}

// The log of a sine whose rates are `scale` times the right ones.
std::string sine_log(double position_scale, double rate_scale) {
  std::string text = "t,q1,q2,tau1,tau2,qd1,qd2\n";
  for (int k = 0; k < 200; ++k) {
    const double t = 0.01 * k;
    text += fmt::format("{},{},0,0,0,{},0\n", t, position_scale * std::sin(3 * t), rate_scale * 3 * std::cos(3 * t));
  }
  return text;
}

TEST_F(LogTest, DegreesThatAreNotDeclaredAreNoticed) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const std::pair<double, const char*> cases[] = {{1 / kDegrees, "is q1 in degrees?"},
                                                  {kDegrees, "is qd1 in degrees?"}};
  for (const auto& [scale, hint] : cases) {
    found = {};
    write(sine_log(1, scale));
    plan_stream(file, planar_arm(), {}, found);
    ASSERT_TRUE(found.has_errors());
    EXPECT_THAT(found.all().at(0).hint, HasSubstr(hint));
    EXPECT_EQ(found.all().at(0).place.line, 2);
  }
  found = {};
  write(sine_log(1, 1));
  plan_stream(file, planar_arm(), {}, found);
  EXPECT_TRUE(found.all().empty());
}

// The log of a planar arm without limits, with q1 given as a function of time.
std::string motion_log(int samples, double step, const std::function<double(double)>& q1) {
  std::string text = "t,q1,q2,tau1,tau2\n";
  for (int k = 0; k < samples; ++k) text += fmt::format("{},{},0,0,0\n", step * k, q1(step * k));
  return text;
}

TEST_F(LogTest, DegreesOfAJointWithoutLimitsAreAWarning) {
  write(motion_log(200, 0.01, [](double t) { return 150 * std::sin(t); }));
  read_all();
  ASSERT_EQ(found.all().size(), 2u);
  for (const Diagnostic& each : found.all()) {
    EXPECT_EQ(each.severity, Severity::warning);
    EXPECT_THAT(each.hint, HasSubstr("q1 [deg]"));
  }
}

TEST_F(LogTest, MessagesNameColumnsAsTheyAreWritten) {
  std::string text = motion_log(200, 0.01, [](double t) { return 150 * std::sin(t); });
  text.replace(0, text.find('\n'), "t,q0,q1,tau0,tau1");
  write(text);
  const StreamPlan plan = plan_stream(file, planar_arm(), {}, found);
  stream(
      file, planar_arm(), plan, [](const double*) {}, found);
  EXPECT_THAT(found.all().back().hint, HasSubstr("q0 [deg]"));
}

// The jump is long after the lines from which the plan is made.
TEST_F(LogTest, AnAngleThatJumpsIsFoundWhereverItIs) {
  write(motion_log(20000, 0.01, [](double t) { return std::sin(t) + (t < 150 ? 0 : 2 * std::numbers::pi); }));
  read_all();
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_EQ(found.all()[0].severity, Severity::warning);
  EXPECT_EQ(found.all()[0].place.line, 15002);
  EXPECT_THAT(found.all()[0].hint, HasSubstr("must not jump by whole turns"));
}

TEST_F(LogTest, RatesInDegreesAreNoticedOfARobotThatStandsStillForLong) {
  std::string text = "t,q1,q2,tau1,tau2,qd1,qd2\n";
  for (int k = 0; k < 12000; ++k) {
    const double t = std::max(0.0, 0.01 * (k - 10000));
    text += fmt::format("{},{},0,0,0,{},0\n", 0.01 * k, std::sin(3 * t), t > 0 ? 172 * std::cos(3 * t) : 0);
  }
  write(text);
  read_all();
  EXPECT_EQ(error(), "2: qd1 is not the rate of change of q1: q1 changes 0.0174 times as fast");
}

TEST_F(LogTest, ManyTurnsAreAWarningOnce) {
  write(motion_log(2000, 0.01, [](double t) { return 6 * t; }));
  const StreamPlan plan = plan_stream(file, planar_arm(), {}, found);
  EXPECT_TRUE(found.all().empty());
  stream(
      file, planar_arm(), plan, [](const double*) {}, found);
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_THAT(found.all()[0].message, HasSubstr("has turned 8 times"));
}

TEST_F(LogTest, MillisecondsAreAWarning) {
  write(motion_log(200, 2, [](double t) { return std::sin(t / 500); }));
  plan_stream(file, planar_arm(), {}, found);
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_THAT(found.all()[0].hint, HasSubstr("t [ms]"));
}

// Poses may be any time apart, and rates from encoder noise tell nothing of the motion between them. Milliseconds are
// detected by rates that agree with them.
TEST_F(LogTest, PosesThatAreFarApartAreNoMilliseconds) {
  const auto poses = [](const std::function<double(int)>& rate, double scale) {
    std::string text = "t,q1,q2,tau1,tau2,qd1,qd2,qdd1,qdd2\n";
    for (int k = 0; k < 40; ++k) text += fmt::format("{},{},0,0,0,{},0,0,0\n", 5 * k, std::sin(scale * k), rate(k));
    return text;
  };
  write(poses([](int) { return 0; }, 1));
  read_all();
  write(poses([](int k) { return k % 2 == 0 ? 1e-3 : -2e-3; }, 1));
  read_all();
  EXPECT_TRUE(found.all().empty());
  write(poses([](int k) { return 20 * std::cos(0.1 * k); }, 0.1));  // 5 ms from line to line
  plan_stream(file, planar_arm(), {}, found);
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_THAT(found.all()[0].hint, HasSubstr("is the time in ms? Then write the column's heading as t [ms]"));
}

// Limits are checked on every line, not only on those from which the plan is made.
TEST_F(LogTest, APositionOutsideTheLimitsIsFoundWhereverItIs) {
  Mechanism limited = planar_arm();
  limited.bodies[0].limits.lower = Value{.number = -1, .place = {}};
  limited.bodies[0].limits.upper = Value{.number = 1, .place = {}};
  write(motion_log(20000, 0.01, [](double t) { return t < 150 ? 0 : 57; }));
  const StreamPlan plan = plan_stream(file, limited, {}, found);
  EXPECT_EQ(error(), "none");
  stream(
      file, limited, plan, [](const double*) {}, found);
  EXPECT_EQ(error(), "15002: q1 = 57 rad is far outside the limits of joint \"theta_1\", -1 to 1 rad");
}

TEST_F(LogTest, MillimetresOfASlidingJointAreAnError) {
  Mechanism sliding = planar_arm();
  sliding.bodies[0].prismatic = true;
  sliding.bodies[0].limits.lower = Value{.number = Number(-3) / 10, .place = {}};
  sliding.bodies[0].limits.upper = Value{.number = Number(1) / 2, .place = {}};
  write(motion_log(20, 0.01, [](double) { return 200; }));
  plan_stream(file, sliding, {}, found);
  EXPECT_EQ(error(), "2: q1 = 200 m is far outside the limits of joint \"theta_1\", -0.3 to 0.5 m");
  EXPECT_THAT(found.all().at(0).hint, HasSubstr("q1 [mm]"));
}

TEST_F(LogTest, WhatIsNotUsedIsSaidOnceThoughLogsAreReadTwice) {
  write("t,q1,q2,tau1,tau2,qd1,qd2,qdd1,qdd2,room\n0,0,0,0,0,0,0,0,0,1\n1e-2,0,0,0,0,0,0,0,0,1\n");
  const StreamPlan plan = plan_stream(file, planar_arm(), {}, found);
  EXPECT_EQ(stream(
                file, planar_arm(), plan, [](const double*) {}, found)
                .lines,
            2);
  EXPECT_EQ(found.all().size(), 1u);
}

}  // namespace
}  // namespace flatdyn
