// SPDX-License-Identifier: GPL-2.0-or-later
// flatdyn torques on Example 7.2: the textbook's remarks on figures 7.5 to 7.11, and Problem 7.7.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kTorques = "torques robots/planar_2r_example_7_2.toml -q --trajectory ";
// (7.82) with the data of Example 7.2: I_l + m l² + k² I_m, and 2 m l a of the second link.
constexpr double kB22 = 10 + 50 * 0.25 + 100 * 100 * 0.01;

using Columns = std::map<std::string, std::vector<double>>;

Columns columns_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, entry;
  std::vector<std::string> names;
  std::getline(lines, line);
  for (std::istringstream parts(line); std::getline(parts, entry, ',');) names.push_back(entry);
  Columns columns;
  while (std::getline(lines, line)) {
    std::istringstream parts(line);
    for (const std::string& name : names) {
      std::getline(parts, entry, ',');
      columns[name].push_back(std::stod(entry));
    }
  }
  return columns;
}

class Example72 : public ::testing::Test {
 protected:
  Columns run(const std::string& name) {
    const Outcome outcome = run_flatdyn(
        fmt::format("{} docs/examples/planar_2r_{}.toml -o {}", kTorques, name, scratch_.path(name + ".csv")));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return columns_of(scratch_.read(name + ".csv"));
  }

  Scratch scratch_;
};

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

double spread(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  const auto [least, greatest] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                                     values.begin() + static_cast<std::ptrdiff_t>(end));
  return *greatest - *least;
}

std::size_t last_nonzero(const std::vector<double>& values) {
  std::size_t last = 0;
  for (std::size_t k = 0; k < values.size(); ++k) last = values[k] != 0 ? k : last;
  return last;
}

// Fig. 7.5 and 7.6.
TEST_F(Example72, JointMotionsOfEqualDuration) {
  Columns c = run("triangular");
  const std::size_t samples = 501, half = 250;
  const double a = 4 * (std::numbers::pi / 2) / 0.25;
  ASSERT_EQ(c["t"].size(), samples);
  EXPECT_EQ(c["t"].back(), 0.5);
  for (const char* joint : {"1", "2"}) {
    EXPECT_NEAR(c[std::string("q") + joint].back() - c[std::string("q") + joint].front(), std::numbers::pi / 2, 1e-12);
    EXPECT_NEAR(largest(c[std::string("qd") + joint]), 2 * (std::numbers::pi / 2) / 0.5, 1e-12);
    for (std::size_t k = 0; k < samples; ++k) {
      EXPECT_NEAR(c[std::string("qdd") + joint][k], k < half ? a : -a, 1e-10);
    }
  }
  // "The inertia torque at Joint 1 due to Joint 1 acceleration follows the time history of the acceleration": its sign
  // does, its size is b_11(q2) > 0.
  for (std::size_t k = 0; k < samples; ++k) EXPECT_GT(c["inertia_1_1"][k] * c["qdd1"][k], 0);
  // "... at Joint 2 due to Joint 2 acceleration is piecewise constant".
  for (std::size_t k = 0; k < samples; ++k) EXPECT_NEAR(c["inertia_2_2"][k], kB22 * (k < half ? a : -a), 1e-9);
  // "... due to acceleration of the other joint confirm the symmetry of the inertia matrix".
  EXPECT_EQ(c["inertia_1_2"], c["inertia_2_1"]);
  // "The Coriolis effect is present only at Joint 1".
  EXPECT_GT(largest(c["coriolis_1_1_2"]), 1000);
  EXPECT_EQ(c.count("coriolis_2_1_2"), 0u);
  // "The centrifugal and Coriolis torques reflect the above symmetry": c_122 = −c_211 = c_112, and the rates are equal.
  for (std::size_t k = 0; k < samples; ++k) {
    EXPECT_NEAR(c["centrifugal_1_2"][k], -c["centrifugal_2_1"][k], 1e-9);
    EXPECT_NEAR(c["coriolis_1_1_2"][k], 2 * c["centrifugal_1_2"][k], 1e-9);
  }
  // h = −m l a sin q2 changes its sign where the arm folds, at q2 = π.
  for (std::size_t k = 1; k + 1 < samples; ++k)
    EXPECT_GT(c["centrifugal_1_2"][k] * (c["q2"][k] - std::numbers::pi), 0) << k;
}

// Fig. 7.7 and 7.8.
TEST_F(Example72, JointMotionsOfDifferentDuration) {
  Columns c = run("trapezoidal");
  EXPECT_NEAR(largest(c["qd1"]), 5, 1e-12);
  EXPECT_NEAR(largest(c["qd2"]), 5, 1e-12);
  EXPECT_NEAR(std::cos(c["q1"].back()) + std::cos(c["q1"].back() + c["q2"].back()), 1.8, 1e-12);
  EXPECT_NEAR(std::sin(c["q1"].back()) + std::sin(c["q1"].back() + c["q2"].back()), 0, 1e-12);
  // "... opposite ... in that portion of trajectory when the two accelerations have the same magnitude but opposite
  // sign": while both speed up, 0.15 s.
  for (std::size_t k = 0; k < 150; ++k) {
    EXPECT_NEAR(c["qdd1"][k], -c["qdd2"][k], 1e-9);
    EXPECT_NEAR(c["inertia_1_2"][k], -c["inertia_2_1"][k], 1e-9);
  }
  // "the centrifugal effect induced at Joint 1 by Joint 2 velocity dies out later than ... at Joint 2 by Joint 1".
  const double end_1 = c["t"][last_nonzero(c["centrifugal_2_1"])], end_2 = c["t"][last_nonzero(c["centrifugal_1_2"])];
  EXPECT_NEAR(end_1, (c["q1"].back() - c["q1"].front()) / 5 + 0.15, 1e-3);
  EXPECT_NEAR(end_2, (c["q2"].front() - c["q2"].back()) / 5 + 0.15, 1.1e-3);
  EXPECT_GT(end_2, end_1 + 0.2);
  // "The gravitational torque at Joint 2 is practically constant in the first portion of the trajectory, since Link 2
  // is almost kept in the same posture": while both joints move with opposite rates.
  EXPECT_LT(spread(c["gravity_2"], 0, 200), 0.01 * 245.25);
  EXPECT_GT(spread(c["gravity_2"], 200, c["t"].size()), 0.5 * 245.25);
  // "As for the gravitational torque at Joint 1, instead, the centre of mass ... moves away".
  EXPECT_TRUE(std::is_sorted(c["gravity_1"].begin(), c["gravity_1"].end()));
  EXPECT_GT(c["gravity_1"].back(), 5 * c["gravity_1"].front());
}

// Fig. 7.9 to 7.11.
TEST_F(Example72, AStraightLineOfTheTip) {
  Columns c = run("line");
  EXPECT_NEAR(c["t"].back(), 0.47, 1e-12);
  for (std::size_t k = 0; k < c["t"].size(); ++k) {
    const double q1 = c["q1"][k], q12 = q1 + c["q2"][k], qd1 = c["qd1"][k], qd12 = qd1 + c["qd2"][k], t = c["t"][k];
    const double speed = t < 0.15 ? t / 0.15 * 5 : t > 0.32 ? (0.47 - t) / 0.15 * 5 : 5;
    EXPECT_NEAR(std::sin(q1) + std::sin(q12), 0, 1e-12);
    EXPECT_NEAR(-std::sin(q1) * qd1 - std::sin(q12) * qd12, speed, 1e-9);
    EXPECT_NEAR(std::cos(q1) * qd1 + std::cos(q12) * qd12, 0, 1e-9);
  }
  // "... differs from the corresponding ones in the operational space": rates change while the tip's speed does not.
  EXPECT_GT(spread(c["qd1"], 150, 320), 0.9);
  EXPECT_GT(spread(c["qd2"], 150, 320), 1.8);
  // With links of equal length and the tip on the axis, q2 = −2 q1 all along, so b_12 relates the other joint's
  // accelerations: the coupling at joint 1 is twice that at joint 2, opposite.
  for (std::size_t k = 0; k < c["t"].size(); ++k) {
    EXPECT_NEAR(c["inertia_1_2"][k], -2 * c["inertia_2_1"][k], 1e-7);
    EXPECT_NEAR(c["centrifugal_1_2"][k], -4 * c["centrifugal_2_1"][k], 1e-8);
  }
  EXPECT_EQ(c.count("coriolis_2_1_2"), 0u);
  EXPECT_GT(c["gravity_1"].back(), 8 * c["gravity_1"].front());
}

// Problem 7.7: Jᵀ f in addition to the other torques. At joint 1 it is f_y x − f_x y of the tip; along the line that
// grows with x.
TEST_F(Example72, WithAForceAtTheTip) {
  for (const std::string name : {"triangular", "trapezoidal", "line"}) {
    Columns without = run(name), with = run(name + "_force");
    for (std::size_t k = 0; k < without["t"].size(); ++k) {
      const double q1 = with["q1"][k], q12 = q1 + with["q2"][k];
      const double x = std::cos(q1) + std::cos(q12), y = std::sin(q1) + std::sin(q12);
      EXPECT_NEAR(with["tip_force_1"][k], 500 * (x - y), 1e-9);
      EXPECT_NEAR(with["tip_force_2"][k], 500 * (std::cos(q12) - std::sin(q12)), 1e-9);
      for (const std::string joint : {"1", "2"}) {
        EXPECT_NEAR(with["tau" + joint][k] - without["tau" + joint][k], with["tip_force_" + joint][k], 1e-8);
      }
    }
    if (name != "line") continue;
    EXPECT_NEAR(with["tip_force_1"].front(), 100, 1e-9);
    EXPECT_NEAR(with["tip_force_1"].back(), 900, 1e-9);
  }
}

TEST_F(Example72, ReportsPeaksForPeopleAndPrograms) {
  const std::string csv = scratch_.path("out.csv");
  const Outcome people = run_flatdyn(
      "torques robots/planar_2r_example_7_2.toml --trajectory docs/examples/planar_2r_triangular.toml -o " + csv);
  ASSERT_EQ(people.code, 0) << people.err;
  EXPECT_THAT(people.out, StartsWith("0.5 s, 501 samples; largest torques"));
  EXPECT_THAT(people.out, HasSubstr("\ntheta_2  N m "));
  EXPECT_THAT(people.out, HasSubstr("wrote " + csv));
  EXPECT_THAT(scratch_.read("out.csv"), StartsWith("t,q1,q2,qd1,qd2,qdd1,qdd2,tau1,tau2,inertia_1_1,inertia_1_2,"
                                                   "centrifugal_1_2,coriolis_1_1_2,gravity_1,inertia_2_1,"));
  const Outcome programs =
      run_flatdyn(kTorques + std::string("docs/examples/planar_2r_triangular.toml --json -o ") + csv);
  const json result = json::parse(programs.out);
  EXPECT_EQ(result["samples"], 501);
  EXPECT_LT(result["disagreement"], 1e-14);
  EXPECT_NEAR(result["joints"][1]["contributions"]["own_inertia"], kB22 * 8 * std::numbers::pi, 1e-9);
  EXPECT_FALSE(result["joints"][1]["contributions"].contains("coriolis"));
  EXPECT_EQ(result["files"], json::array({csv}));
}

// The written samples are read again and give the same result.
TEST_F(Example72, FromItsOwnSamples) {
  Columns planned = run("line_force");
  const Outcome outcome =
      run_flatdyn(fmt::format("{} {} -o {}", kTorques, scratch_.path("line_force.csv"), scratch_.path("again.csv")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(scratch_.read("again.csv"), scratch_.read("line_force.csv"));
}

TEST(Torques, OfARobotWithFrictionByJointName) {
  const Scratch scratch;
  scratch.write("plan.toml",
                "rate = 200\nangles = \"deg\"\nstart = { elbow = 90 }\n[[segment]]\nby = { waist = 30, elbow = -20 }\n"
                "profile = \"trapezoidal\"\nspeed = 60\nacceleration_time = 0.1\n");
  const Outcome outcome =
      run_flatdyn(fmt::format("torques robots/puma560.toml -q --trajectory {} -o {} --plot {}",
                              scratch.path("plan.toml"), scratch.path("out.csv"), scratch.path("out.svg")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  Columns c = columns_of(scratch.read("out.csv"));
  EXPECT_NEAR(c["q1"].back(), std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(c["q3"].back(), std::numbers::pi / 180 * 70, 1e-12);
  EXPECT_NEAR(largest(c["qd1"]), std::numbers::pi / 3, 1e-12);
  EXPECT_GT(largest(c["viscous_1"]), 0);
  EXPECT_EQ(spread(c["coulomb_1"], 1, 90), 0);
  // Seven kinds of contributions are drawn instead of the many terms.
  for (const char* text : {"torque of waist", "own inertia", "coupling", "Coriolis", "friction"}) {
    EXPECT_THAT(scratch.read("out.svg"), HasSubstr(text));
  }
}

// The tip's place is found by damped least squares, followed by a straight line.
TEST(Torques, OfAnArmThatNeedsAGuess) {
  const Scratch scratch;
  const auto run = [&](const std::string& start) {
    scratch.write("plan.toml", "start = { tip = [0.5, 0, 0.4], " + start +
                                   " }\n[[segment]]\nline_to = [0.5, 0.2, 0.4]\nprofile = \"triangular\"\nspeed = 1\n");
    return run_flatdyn(fmt::format("torques robots/panda.urdf -q --trajectory {} -o {}", scratch.path("plan.toml"),
                                   scratch.path("out.csv")));
  };
  EXPECT_EQ(run("guess = [0, 0, 0, -1.5, 0, 1.5, 0]").code, 0);
  const Outcome elbow = run("elbow = \"down\"");
  EXPECT_EQ(elbow.code, 3);
  EXPECT_THAT(elbow.err, HasSubstr("plan.toml:1: error: elbow: the robot is no planar arm of two links"));
  const Outcome key = run("gues = [0, 0, 0, -1.5, 0, 1.5, 0]");
  EXPECT_EQ(key.code, 3);
  EXPECT_THAT(key.err, HasSubstr("did you mean \"guess\"?"));
}

TEST(Torques, SaysWhichLimitsAreExceeded) {
  const Scratch scratch;
  const std::string command =
      std::string(kTorques) + "docs/examples/planar_2r_line.toml --scene docs/examples/planar_2r_limits.toml -o ";
  const Outcome outcome = run_flatdyn(command + scratch.path("out.csv"));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("docs/examples/planar_2r_line.toml: warning: joint \"theta_2\": torque 8097"));
  EXPECT_THAT(outcome.err, HasSubstr("beyond its limit 800 N m"));
  const Outcome strict = run_flatdyn(command + scratch.path("strict.csv -Werror"));
  EXPECT_EQ(strict.code, 3);
  EXPECT_FALSE(std::filesystem::exists(scratch.path("strict.csv")));
}

TEST(Torques, DrawsWhatIsAskedFor) {
  const Scratch scratch;
  const std::string command = std::string(kTorques) + "docs/examples/planar_2r_line.toml -o " + scratch.path("out.csv");
  ASSERT_EQ(run_flatdyn(command + " --plot " + scratch.path("out.png")).code, 0);
  EXPECT_THAT(scratch.read("out.png"), StartsWith("\x89PNG"));
  ASSERT_EQ(run_flatdyn(command + " --plot " + scratch.path("out.svg")).code, 0);
  for (const char* text : {"<svg", "torque of theta_2", "Coriolis 1 2", "theta_1"}) {
    EXPECT_THAT(scratch.read("out.svg"), HasSubstr(text));
  }
}

TEST(Torques, RefusesWhatItCannotDo) {
  const Scratch scratch;
  const std::string out = " -o " + scratch.path("out.csv");
  const std::string plan = "docs/examples/planar_2r_line.toml";
  EXPECT_EQ(run_flatdyn(kTorques + plan).code, 2);
  EXPECT_EQ(run_flatdyn("torques robots/planar_2r_example_7_2.toml" + out).code, 2);
  EXPECT_EQ(run_flatdyn(kTorques + plan + out + " --plot " + scratch.path("out.pdf")).code, 2);
  EXPECT_EQ(run_flatdyn(kTorques + plan + " -o " + plan).code, 2);
  EXPECT_EQ(run_flatdyn(kTorques + std::string("nowhere.toml") + out).code, 6);
  EXPECT_EQ(run_flatdyn(kTorques + std::string("nowhere.csv") + out).code, 6);
  EXPECT_EQ(run_flatdyn("torques robots/planar_2r.toml --trajectory " + plan + out).code, 4);
  EXPECT_EQ(run_flatdyn(kTorques + plan + " -o /proc/nowhere/out.csv").code, 6);
  EXPECT_TRUE(scratch.is_empty());
}

}  // namespace
}  // namespace flatdyn::testing
