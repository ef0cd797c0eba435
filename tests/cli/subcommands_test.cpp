// SPDX-License-Identifier: GPL-2.0-or-later
// The output and the files of each subcommand.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kPendulum = "robots/pendulum_motor.toml";

TEST(Generate, WritesAHeaderThatCompilesAloneAndReportsWhatItDid) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn("generate robots/puma560.toml -o " + scratch.path("new/folder"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("robot puma560: 6 joints"));
  for (const char* text : {"inverse_dynamics ", "sin/cos", "q_2 to q_5", "zeros", "wrote "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
  const std::string command = fmt::format(
      "g++ -std=c++17 -Wall -Wextra -Wconversion -Werror -fno-exceptions -fno-rtti -fsyntax-only -x c++ '{}'",
      scratch.path("new/folder/puma560.hpp"));
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(Generate, FusesTwoFunctionsOrMore) {
  EXPECT_EQ(run_flatdyn("generate robots/ur5.urdf -q -o /nowhere/at/all --fuse gravity").code, 2);
}

// Stages are called as their comment says, with -Wshadow and -Wunused; members agree with the functions.
TEST(Generate, WritesStagesAndFusedFunctions) {
  const Scratch scratch;
  const std::string functions = "inertia_matrix,gravity,bias,forward_dynamics,kinetic_energy";
  const Outcome outcome =
      run_flatdyn(fmt::format("generate robots/scara.toml -o {} --functions {} --stages {} --fuse {}", scratch.path(),
                              functions, functions, "inertia_matrix,gravity"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* text : {"inertia_matrix_gravity ", "at ", "with ", "Motion::bias "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
  scratch.write("main.cpp", R"(
#include <cstring>
#include "scara.hpp"
double difference(const double* a, const double* b, int n) {
  double largest = 0;
  for (int i = 0; i < n; ++i) largest = std::fmax(largest, std::fabs(a[i] - b[i]));
  return largest;
}
int main() {
  scara::Parameters<> parameters;
  double values[sizeof parameters / sizeof(double)];
  for (double& value : values) value = 1 + 0.1 * static_cast<double>(&value - values);
  std::memcpy(&parameters, values, sizeof parameters);
  const double q[4] = {0.3, -0.7, 0.2, 1.1}, qd[4] = {0.5, -1.5, 2.0, 0.1}, tau[4] = {1, 2, 3, 4};
  double B[16], B2[16], B3[16], g[4], g2[4], g3[4], n[4], n2[4], qdd[4], qdd2[4];
  const auto here = scara::at(parameters, q);
  here.inertia_matrix(B);
  here.gravity(g);
  const auto moving = here.with(qd);
  moving.bias(n);
  const bool ok = moving.forward_dynamics(tau, qdd);
  scara::inertia_matrix(parameters, q, B2);
  scara::gravity(parameters, q, g2);
  scara::inertia_matrix_gravity(parameters, q, B3, g3);
  scara::bias(parameters, q, qd, n2);
  const bool ok2 = scara::forward_dynamics(parameters, q, qd, tau, qdd2);
  const double T = moving.kinetic_energy() - scara::kinetic_energy(parameters, q, qd);
  return ok && ok2 && difference(B, B2, 16) + difference(B, B3, 16) + difference(g, g2, 4) + difference(g, g3, 4) +
                 difference(n, n2, 4) + difference(qdd, qdd2, 4) + std::fabs(T) < 1e-9 ? 0 : 1;
}
)");
  const std::string command = fmt::format(
      "g++ -std=c++17 -Wall -Wextra -Wconversion -Wshadow -Wunused -Werror -fno-exceptions -fno-rtti -I'{0}' "
      "'{0}/main.cpp' -o '{0}/main' && '{0}/main'",
      scratch.path());
  EXPECT_EQ(std::system(command.c_str()), 0);
}

// Two runs have different addresses, so GiNaC sorts differently in each.
TEST(Generate, GivesTheSameBytesInEveryRunFromEveryFolder) {
  const Scratch scratch;
  std::string first;
  for (int run = 0; run < 4; ++run) {
    const std::string folder = fmt::format("run{}", run);
    ASSERT_EQ(run_flatdyn("generate robots/scara.toml -q --stages inertia_matrix,bias,forward_dynamics -o " +
                          scratch.path(folder))
                  .code,
              0);
    const std::string text = scratch.read(folder + "/scara.hpp") + scratch.read(folder + "/scara.json");
    if (run == 0) first = text;
    EXPECT_EQ(text, first);
    EXPECT_THAT(text, Not(HasSubstr(scratch.path())));
  }
}

TEST(Generate, EmitsWhatIsAskedForAndNothingElse) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn(fmt::format("generate robots/ur5.urdf -q -o {} --functions gravity,jacobian:forearm_link "
                                    "--scalar float --namespace acme::arm",
                                    scratch.path()))
                .code,
            0);
  const std::string header = scratch.read("ur5.hpp");
  EXPECT_THAT(header, HasSubstr("namespace acme::arm {"));
  EXPECT_THAT(header, HasSubstr("using Real = float;"));
  EXPECT_THAT(header, HasSubstr("inline void gravity("));
  EXPECT_THAT(header, HasSubstr("inline void jacobian_forearm_link("));
  EXPECT_THAT(header, Not(HasSubstr("inverse_dynamics")));
}

TEST(Generate, WritesFunctionsAfterPassesAndHowLongTheyTook) {
  const Scratch scratch;
  const std::string command = fmt::format("generate {} --functions gravity -o {} ", kPendulum, scratch.path("out"));
  const Outcome outcome = run_flatdyn(command + "--dump-after derived,share_sums --trace");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* text : {"step", "reading", "proving", "function", "share_sums"}) {
    EXPECT_THAT(outcome.err, HasSubstr(text));
  }
  const std::string before = scratch.read("out/pendulum_motor.gravity.0.derived.txt"),
                    after = scratch.read("out/pendulum_motor.gravity.1.share_sums.txt");
  for (const std::string& text : {before, after}) {
    EXPECT_THAT(text, StartsWith("function gravity\n"));
    EXPECT_THAT(text, HasSubstr("= sin %"));
  }
  EXPECT_EQ(scratch.read("out/pendulum_motor.gravity.1.rescale.txt"), "");
  const Outcome misspelt = run_flatdyn(command + "--dump-after share_sum");
  EXPECT_EQ(misspelt.code, 2);
  EXPECT_THAT(misspelt.err, HasSubstr("--dump-after: there is no pass \"share_sum\""));
  EXPECT_THAT(misspelt.err, HasSubstr("share_sums"));
}

// The one joint moves no mass: B is singular, everything else is well defined.
TEST(Generate, LeavesOutForwardDynamicsWhereBIsSingular) {
  const Scratch scratch;
  scratch.write("empty.toml", "[[link]]\n");
  const std::string generate = "generate " + scratch.path("empty.toml") + " -o " + scratch.path();
  const Outcome all = run_flatdyn(generate);
  EXPECT_EQ(all.code, 0);
  EXPECT_THAT(all.err, HasSubstr("warning: left out forward_dynamics: B(q) is singular, because joint \"joint1\""));
  EXPECT_THAT(scratch.read("empty.hpp"), Not(HasSubstr("void forward_dynamics(")));
  EXPECT_THAT(scratch.read("empty.hpp"), HasSubstr("void inverse_dynamics("));
  const Outcome asked = run_flatdyn(generate + " --functions forward_dynamics");
  EXPECT_EQ(asked.code, 4);
  EXPECT_THAT(asked.err, HasSubstr("empty.toml:1: error: forward_dynamics: B(q) is singular, because joint \"joint1\" "
                                   "(line 1) moves no inertia: link \"link1\" has none about its axis"));
  EXPECT_EQ(run_flatdyn("verify " + scratch.path("empty.toml") + " --states 5").code, 0);
}

// Every joint of this planar arm moves the point mass, but three of them cannot move it independently.
TEST(Generate, LeavesOutForwardDynamicsWhereJointsMoveOneMass) {
  const Scratch scratch;
  scratch.write("mass.toml",
                "[[link]]\n[[link]]\nxyz = [0.4, 0, 0]\n[[link]]\nxyz = [0.3, 0, 0]\nmass = 1\n"
                "com = [0.2, 0, 0]\n");
  const std::string generate = "generate " + scratch.path("mass.toml") + " -o " + scratch.path();
  const Outcome all = run_flatdyn(generate);
  EXPECT_EQ(all.code, 0);
  EXPECT_THAT(all.err, HasSubstr("warning: left out forward_dynamics: B(q) is singular at every position"));
  EXPECT_EQ(run_flatdyn(generate + " --functions forward_dynamics").code, 4);
}

// A mass on the joint's axis is not a mistake of the file: the only warning is about functions left out.
TEST(Generate, LeavesOutNothingUnderWerror) {
  const Scratch scratch;
  scratch.write("on_axis.toml", "[[link]]\nmass = 1\n");
  const std::string file = scratch.path("on_axis.toml"), folder = scratch.path("out");
  ASSERT_EQ(run_flatdyn("inspect -Werror " + file).code, 0);
  const Outcome strict = run_flatdyn("generate -Werror " + file + " -o " + folder);
  EXPECT_EQ(strict.code, 3);
  EXPECT_THAT(strict.err, HasSubstr("left out forward_dynamics"));
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(Generate, KeepsTheOldHeaderWhenTheInputIsWrong) {
  const Scratch scratch;
  scratch.write("arm.toml", "[[link]]\nmas = 1\n");
  scratch.write("arm.hpp", "as it was");
  EXPECT_EQ(run_flatdyn("generate " + scratch.path("arm.toml") + " -o " + scratch.path()).code, 3);
  EXPECT_EQ(scratch.read("arm.hpp"), "as it was");
}

// A planar joint, whose three coordinates come first.
TEST(Verify, PassesAnArmOnAPlatform) {
  const Outcome outcome = run_flatdyn(
      "verify docs/examples/mobile_manipulator.toml -q --json --states 4 --functions "
      "inverse_dynamics,inertia_matrix,forward_dynamics,jacobian");
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  for (const json& function : json::parse(outcome.out)["functions"]) EXPECT_TRUE(function["proven"]) << function;
}

TEST(Json, IsValidOnEverySubcommand) {
  const Scratch scratch;
  scratch.write("states.csv", "q1\n0.5\n");
  const std::string robot = kPendulum;
  const std::string parameters = "robots/planar_2r_example_7_2.toml";
  scratch.write("two.csv", "q1,q2\n0.5,0.25\n");
  for (const std::string& arguments :
       {"generate " + parameters + " --json -o " + scratch.path("out"), "inspect " + robot + " --json",
        "derive " + robot + " --json", "derive " + robot + " --json --latex",
        "verify " + robot + " --json --states 5 --functions gravity",
        "eval " + parameters + " --json --function gravity --states " + scratch.path("two.csv")}) {
    const Outcome outcome = run_flatdyn(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
    EXPECT_TRUE(json::accept(outcome.out)) << arguments << "\n" << outcome.out;
  }
}

TEST(Json, InspectHasTheModelInNumbers) {
  const json model = json::parse(run_flatdyn("inspect robots/panda.urdf --json").out);
  EXPECT_EQ(model["robot"], "panda");
  ASSERT_EQ(model["joints"].size(), 7u);
  EXPECT_EQ(model["joints"][3]["name"], "panda_joint4");
  EXPECT_EQ(model["joints"][3]["upper"], -0.0698);
  EXPECT_EQ(model["gravity"], json({0.0, 0.0, -9.81}));
  EXPECT_EQ(model["joints"][0]["canonical"]["inertia_about_origin"].size(), 3u);
  EXPECT_EQ(model["links"][1]["name"], "panda_link2");
  EXPECT_NEAR(model["links"][1]["length"].get<double>(), 0.316, 1e-12);
}

// Limits of a file in degrees are shown as they are written there, those of other files in rad.
TEST(Inspect, ShowsTheDegreesOfAFileAsDegrees) {
  const Scratch scratch;
  scratch.write("arm.toml",
                "angles = \"deg\"\n[[link]]\nmass = 1\ncom = [1, 0, 0]\n"
                "limits = { lower = -170, upper = 22.5, velocity = 180, acceleration = 600, effort = 20 }\n"
                "[[link]]\ntype = \"prismatic\"\nmass = 1\nlimits = { lower = -1, upper = 1, velocity = 2 }\n");
  const std::string shown = run_flatdyn("inspect " + scratch.path("arm.toml")).out;
  EXPECT_THAT(shown, HasSubstr(" [-170, 22.5] deg  180 deg/s  20      600 deg/s^2"));
  EXPECT_THAT(shown, HasSubstr(" [-1, 1]           2          -       -"));
  scratch.write("arm.xml",
                "<mujoco><worldbody><body><inertial pos=\"1 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>"
                "<joint name=\"a\" range=\"-45 60\" limited=\"true\"/></body></worldbody></mujoco>");
  EXPECT_THAT(run_flatdyn("inspect " + scratch.path("arm.xml")).out, HasSubstr("[-45, 60] deg"));
  EXPECT_THAT(run_flatdyn("inspect robots/panda.urdf").out, HasSubstr("[-2.8973, 2.8973]   2.175"));
}

TEST(Help, OpensWithTwoRunnableExamples) {
  for (const std::string command :
       {"", "generate ", "inspect ", "derive ", "verify ", "eval ", "excite ", "torques "}) {
    const Outcome outcome = run_flatdyn(command + "--help");
    EXPECT_EQ(outcome.code, 0) << command;
    EXPECT_THAT(outcome.out.substr(0, outcome.out.find("Usage")),
                MatchesRegex("[^\n]+\n\n  flatdyn [a-z]+ [^\n]+\n(      [^\n]+\n)?  flatdyn [a-z]+ [^\n]+\n(.|\n)*"));
  }
  EXPECT_THAT(run_flatdyn("--version").out, StartsWith("flatdyn "));
}

TEST(Help, HasACommandsOwnOptionsBeforeThoseForAnyRobot) {
  const std::string help = run_flatdyn("generate --help").out;
  const std::size_t any_robot = help.find("\nOptions for any robot:\n");
  ASSERT_NE(any_robot, std::string::npos) << help;
  EXPECT_LT(help.find("--stages"), any_robot);
  EXPECT_GT(help.find("--snap"), any_robot);
  EXPECT_THAT(help, Not(HasSubstr("\n\n\n")));
}

TEST(Derive, PrintsThePlanarArmAsTheTextbookDoes) {
  const Outcome outcome = run_flatdyn("derive -q robots/planar_2r.toml");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("b_22 = I_l2 + m_l2 l_2^2 + k_r2^2 I_m2\n"));
  EXPECT_THAT(outcome.out, HasSubstr("g_1 = (m_l1 l_1 + m_l2 a_1 + m_m2 a_1) g c_1 + m_l2 l_2 g c_12\n"));
}

// m l² = 1.000000000001 · 0.01, and 10/7 · 0.3² = 9/70, in full.
TEST(Derive, PrintsNumbersExactly) {
  const Scratch scratch;
  const auto derived = [&scratch](const std::string& second, const std::string& options) {
    scratch.write("arm.toml",
                  "name = \"arm\"\ngravity = [0, \"-9.80665\", 0]\n[[link]]\njoint = \"a\"\n"
                  "mass = \"1.000000000001\"\ncom = [0.1, 0, 0]\n[[link]]\njoint = \"b\"\n" +
                      second + "mass = \"10/7\"\ncom = [0.3, 0, 0]\n");
    const Outcome outcome = run_flatdyn("derive -q " + scratch.path("arm.toml") + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string exact = derived("", "");
  EXPECT_THAT(exact, HasSubstr("b_22 = 9/70\n"));
  EXPECT_THAT(exact, HasSubstr("b_11 = 97000000000007/700000000000000\n"));
  EXPECT_THAT(exact, Not(HasSubstr("rounded")));
  EXPECT_THAT(derived("", " --latex"), HasSubstr("b_{22} &= \\frac{9}{70}\n"));
  EXPECT_THAT(derived("", " --digits 4"), HasSubstr("b_22 = 0.1286\n"));
  EXPECT_THAT(derived("", " --digits 4"), HasSubstr("numbers are rounded to 4 digits\n"));
  // Sine and cosine of an angle are rational to 40 digits.
  const std::string turned = derived("xyz = [0.1, 0, 0]\nrpy = [0.3, 0.2, 0.1]\n", "");
  EXPECT_THAT(turned, HasSubstr("b_22 = 9/70\n"));
  EXPECT_THAT(turned, HasSubstr("... "));
  EXPECT_THAT(turned, HasSubstr("numbers that end in ... are rounded to 17 digits"));
  EXPECT_THAT(json::parse(derived("", " --json"))["inertia"][2]["text"], "9/70");
}

// The example arm: b_11 = 200.01 + 50 c_2 and so on; at q = 0 everything is a sum of its constants.
TEST(Eval, GivesAMatrixRowByRow) {
  const Scratch scratch;
  scratch.write("states.csv", "q_theta_1,q_theta_2\n0,0\n");
  const std::string arguments =
      "eval -q robots/planar_2r_example_7_2.toml --function inertia_matrix --states " + scratch.path("states.csv");
  const std::string expected = "q_theta_1,q_theta_2,B_1_1,B_1_2,B_2_1,B_2_2\n0,0,250.01,48.5,48.5,122.5\n";
  EXPECT_EQ(run_flatdyn(arguments).out, expected);
  EXPECT_EQ(run_flatdyn(arguments + " --reference").out, expected);
  EXPECT_EQ(run_flatdyn(arguments + " --digits 50").out, expected);
  EXPECT_EQ(run_flatdyn(arguments + " -o " + scratch.path("B.csv")).out, "");
  EXPECT_EQ(scratch.read("B.csv"), expected);
}

// All digits of what is inverted cancel, in any precision.
TEST(Eval, SaysThatATaskIsSingular) {
  const Scratch scratch;
  scratch.write("stretched.csv", "q1,q2,q3\n0.4,1e-3,0\n0.4,0,0\n");
  for (const char* options : {"", " --digits 40", " --reference", " --reference --digits 40"}) {
    const Outcome outcome = run_flatdyn("eval docs/examples/planar_3r.toml --function operational_inertia --states " +
                                        scratch.path("stretched.csv") + options);
    EXPECT_EQ(outcome.code, 3) << options;
    EXPECT_THAT(outcome.err, HasSubstr("stretched.csv:3: error: the tip's task is singular here")) << options;
    EXPECT_THAT(outcome.err, Not(HasSubstr("stretched.csv:2"))) << options;
  }
}

// One panel for each row of a matrix, over time if the table has it.
TEST(Eval, DrawsWhatItComputes) {
  const Scratch scratch;
  scratch.write("motion.csv", "time,q1,q2\n0,0.1,0.2\n1,0.3,-0.4\n2,0.5,0.1\n");
  const std::string eval = "eval robots/planar_2r_example_7_2.toml -q --function inertia_matrix --states ";
  const Outcome outcome = run_flatdyn(eval + scratch.path("motion.csv") + " --plot " + scratch.path("B.svg"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("time,q1,q2,B_1_1,B_1_2,B_2_1,B_2_2\n0,"));
  const std::string picture = scratch.read("B.svg");
  for (const char* text : {"B_1_1", "B_2_2", "t in s", "planar_2r_example_7_2: inertia_matrix"}) {
    EXPECT_THAT(picture, HasSubstr(text));
  }
  scratch.write("none.csv", "q1,q2\n");
  const Outcome none = run_flatdyn(eval + scratch.path("none.csv") + " --plot " + scratch.path("none.svg"));
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, HasSubstr("there is no row to draw"));
  EXPECT_EQ(run_flatdyn(eval + scratch.path("motion.csv") + " -o " + scratch.path("motion.csv")).code, 2);
}

TEST(Eval, NamesTheColumnThatIsWrong) {
  const Scratch scratch;
  scratch.write("states.csv", "q1,q2\n0,zero\n");
  const Outcome outcome = run_flatdyn("eval -q robots/planar_2r_example_7_2.toml --function gravity --states " +
                                      scratch.path("states.csv"));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("states.csv:2:"));
}

}  // namespace
}  // namespace flatdyn::testing
