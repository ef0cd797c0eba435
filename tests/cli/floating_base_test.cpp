// SPDX-License-Identifier: GPL-2.0-or-later
// Robots with a floating base on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kBody = R"(name = "body"
[base]
motion = "floating"
mass = 2
inertia = { xx = 1, yy = 2, zz = 3 }
inertia_about = "com"
)";

// f = m (ω × v - g_b), n = ω × I ω.
TEST(FloatingEval, ReadsTheBaseByItsNames) {
  const Scratch scratch;
  scratch.write("body.toml", kBody);
  scratch.write("states.csv",
                "base_gx,base_gy,base_gz,base_vx,base_vy,base_vz,base_wx,base_wy,base_wz,base_dvx,base_dvy,base_dvz,"
                "base_dwx,base_dwy,base_dwz\n0,0,-10,1,0,0,0,1,2,0,0,0,0,0,0\n");
  const Outcome outcome = run_flatdyn("eval " + scratch.path("body.toml") + " --function inverse_dynamics --states " +
                                      scratch.path("states.csv"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(",0,4,18,2,0,0"));
  const Outcome reference =
      run_flatdyn("eval " + scratch.path("body.toml") + " --function inverse_dynamics --reference --states " +
                  scratch.path("states.csv"));
  EXPECT_EQ(reference.out, outcome.out);
}

TEST(FloatingBase, IsRefusedWhereItIsNotSupported) {
  const Scratch scratch;
  scratch.write("body.toml", kBody);
  const Outcome christoffel =
      run_flatdyn("generate " + scratch.path("body.toml") + " --functions christoffel -o " + scratch.path("out"));
  EXPECT_EQ(christoffel.code, 4);
  EXPECT_THAT(christoffel.err,
              HasSubstr("body.toml:2: error: function \"christoffel\" needs velocities that are derivatives"));
  const Outcome fixed = run_flatdyn("generate robots/ur5.urdf --functions centre_of_mass -o " + scratch.path("out"));
  EXPECT_EQ(fixed.code, 2);
  EXPECT_THAT(fixed.err, HasSubstr("--base floating"));
}

// Euler's equations, and the names of all entries in their order.
TEST(FloatingDerive, PrintsTextLatexAndJson) {
  const Scratch scratch;
  scratch.write("body.toml", kBody);
  const std::string derive = "derive -q " + scratch.path("body.toml");
  const Outcome text = run_flatdyn(derive), latex = run_flatdyn(derive + " --latex");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("\n2 dv_x - 2 v_y omega_z + 2 v_z omega_y - 2 g_x = f_x\n"));
  EXPECT_THAT(text.out, HasSubstr("\n2 domega_y - 2 omega_x omega_z = n_y\n"));
  EXPECT_THAT(latex.out, HasSubstr("n_{y} &= 2 \\dot{\\omega}_{y} - 2 \\omega_{x} \\omega_{z}"));
  EXPECT_THAT(latex.out, HasSubstr("% omega_x, omega_y, omega_z: angular velocity of the base, in base axes, rad/s\n"));
  const nlohmann::json read = nlohmann::json::parse(run_flatdyn(derive + " --json").out);
  EXPECT_EQ(read["entries"].size(), 6u);
  EXPECT_EQ(read["entries"][3],
            nlohmann::json({{"velocity", "omega_x"}, {"acceleration", "domega_x"}, {"torque", "n_x"}}));
  EXPECT_EQ(read["velocity_terms"][0]["name"], "h_126");
  EXPECT_EQ(read["velocity_terms"][0]["text"], "-2");
  EXPECT_FALSE(read.contains("christoffel"));
  EXPECT_THAT(run_flatdyn(derive + " --gravity off").out, Not(HasSubstr("g_x")));
}

TEST(FloatingBase, HasOtherConventionsInCppOnly) {
  const Scratch scratch;
  scratch.write("body.toml", kBody);
  const std::string generate = "generate " + scratch.path("body.toml") + " --convention ";
  const std::string out = " -o " + scratch.path("out");
  const Outcome fixed = run_flatdyn("generate robots/planar_2r.toml --convention mujoco" + out);
  EXPECT_EQ(fixed.code, 4);
  EXPECT_THAT(fixed.err, HasSubstr("--convention: the robot has neither a floating base nor spherical joints"));
  const Outcome c = run_flatdyn(generate + "mujoco --language c" + out);
  EXPECT_EQ(c.code, 2);
  EXPECT_THAT(c.err, HasSubstr("--convention: not in C"));
  EXPECT_EQ(run_flatdyn(generate + "mojoco" + out).code, 2);
  EXPECT_EQ(run_flatdyn(generate + "mujoco -o -").code, 2);
  const Outcome alone = run_flatdyn(generate + "mujoco --functions coriolis_matrix" + out);
  EXPECT_EQ(alone.code, 0);
  EXPECT_THAT(alone.err,
              HasSubstr("coriolis_matrix is left out of mujoco: in axes of the world it needs inertia_matrix"));
  // Steps take no pose apart where linear velocities are in world axes.
  EXPECT_THAT(scratch.read("out/body_mujoco.hpp"), Not(HasSubstr("class Base")));
  EXPECT_THAT(scratch.read("out/body_mujoco.hpp"),
              HasSubstr("another robot: generate both again\");\n\nnamespace detail"));
  EXPECT_EQ(run_flatdyn(generate + "pinocchio --functions potential_energy" + out).code, 0);
  EXPECT_THAT(scratch.read("out/body_pinocchio.hpp"), HasSubstr("class Base"));
}

// Meanings of outputs go on in a second line, and so does a sum of three terms.
TEST(FloatingBase, HasNoLongLinesAboutArguments) {
  const Scratch scratch;
  scratch.write("body.toml", kBody);
  const Outcome outcome = run_flatdyn("generate " + scratch.path("body.toml") +
                                      " --convention mujoco --gravity=0.123456789,-0.23456789,-9.7123456 --functions "
                                      "inverse_dynamics,regressor,centroidal_bias,inertia_matrix,coriolis_matrix -o " +
                                      scratch.path("out"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string core = scratch.read("out/body.hpp"), adapted = scratch.read("out/body_mujoco.hpp");
  EXPECT_THAT(core, HasSubstr("\n//   Y[60]  "));
  EXPECT_THAT(adapted, HasSubstr("g_b[k] = R_[0][k] * Scalar(0.123456789) +\n"));
  std::istringstream lines(core + adapted);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("//   ") && line.find("g_b[k]") == std::string::npos) continue;
    EXPECT_LE(line.size(), 100u) << line;
  }
}

TEST(FloatingBase, NeedsGravityInItsAxes) {
  const Scratch scratch;
  scratch.write("body.toml", kBody);
  scratch.write("states.csv", "base_vx\n1\n");
  const Outcome outcome =
      run_flatdyn("eval " + scratch.path("body.toml") + " --function gravity --states " + scratch.path("states.csv"));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("gravity is that in base axes: 0, 0, -9.81 where z of the base points up"));
}

// The quaternion of the base tells gravity in its axes, in all digits; one that is not of norm 1 is warned of.
TEST(FloatingBase, TakesGravityFromThePose) {
  const Scratch scratch;
  scratch.write("body.toml", kBody);
  scratch.write("pose.csv",
                "base_x,base_y,base_z,base_qw,base_qx,base_qy,base_qz\n1,2,3,0.1,0.5,0.7,0.5\n0,0,0,2,0,0,0\n");
  scratch.write("gravity.csv", "base_gx,base_gy,base_gz\n-3.5316,-7.848,4.7088\n0,0,-39.24\n");
  const auto values = [&](const std::string& states) {
    const Outcome outcome = run_flatdyn("eval " + scratch.path("body.toml") + " --function gravity --digits 30 " +
                                        "--states " + scratch.path(states));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    if (states == "pose.csv") {
      EXPECT_THAT(outcome.err, HasSubstr("pose.csv:3: warning: the quaternion of the floating base has norm 2"));
    }
    std::istringstream lines(outcome.out);
    std::vector<std::string> rows;
    for (std::string line; std::getline(lines, line);) rows.push_back(line);
    const std::size_t inputs = states == "pose.csv" ? 7 : 3;
    for (std::string& row : rows) {
      for (std::size_t k = 0; k < inputs; ++k) row = row.substr(row.find(',') + 1);
    }
    return rows;
  };
  EXPECT_EQ(values("pose.csv"), values("gravity.csv"));
}

TEST(FloatingBase, IsConvertedToUrdfAndBack) {
  const Scratch scratch;
  scratch.write("body.toml", kBody);
  const std::string urdf = scratch.path("body.urdf"), toml = scratch.path("again.toml");
  EXPECT_EQ(run_flatdyn("convert " + scratch.path("body.toml") + " -o " + urdf).code, 0);
  EXPECT_EQ(run_flatdyn("convert " + urdf + " -o " + toml).code, 0);
  EXPECT_THAT(run_flatdyn("inspect -q " + toml).out, StartsWith("robot body: 0 joints, floating base"));
}

// A base that is held still is a base that does not move, whatever the file says.
TEST(FloatingBase, IsHeldByTheOption) {
  const Scratch scratch;
  scratch.write("body.toml", kBody);
  const Outcome held = run_flatdyn("inspect --base fixed " + scratch.path("body.toml"));
  EXPECT_EQ(held.code, 3);
  EXPECT_THAT(held.err, HasSubstr("no joint of this robot moves"));
}

// It stays as the file turns it, as by --fix, so that gravity has its direction.
TEST(FloatingBase, IsHeldWhereTheFilePutsIt) {
  const Scratch scratch;
  scratch.write("turned.xml", R"(<mujoco><worldbody><body name="b" euler="0 90 0"><freejoint name="f"/><geom size=".1"/>
    <body pos=".5 0 0"><joint axis="0 1 0"/><joint axis="1 0 0"/><geom size=".1" pos=".3 .1 0"/></body></body></worldbody></mujoco>)");
  scratch.write("states.csv", "q1,q2\n0.4,0.3\n");
  const std::string rest = " --function gravity -q --states " + scratch.path("states.csv");
  const Outcome by_option = run_flatdyn("eval " + scratch.path("turned.xml") + " --base fixed" + rest);
  EXPECT_EQ(by_option.code, 0) << by_option.err;
  EXPECT_EQ(by_option.out, run_flatdyn("eval " + scratch.path("turned.xml") + " --fix f" + rest).out);
}

}  // namespace
}  // namespace flatdyn::testing
