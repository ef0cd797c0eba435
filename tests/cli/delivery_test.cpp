// SPDX-License-Identifier: GPL-2.0-or-later
// Outputs that are compared or only named instead of written, and the dependencies that a build tool gets.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string generate(const std::string& folder, const std::string& more = "", const std::string& robot = "") {
  return fmt::format("generate {} -q --functions gravity -o '{}' {}",
                     robot.empty() ? "robots/pendulum_motor.toml" : robot, folder, more);
}

TEST(Check, PassesOnWhatARunHasWritten) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn(generate(scratch.path())).code, 0);
  const Outcome outcome = run_flatdyn(generate(scratch.path(), "--check"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("up to date: " + scratch.path("pendulum_motor.hpp")));
}

TEST(Check, NamesTheFirstLineThatDiffersAndWritesNothing) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn(generate(scratch.path())).code, 0);
  const std::string edited = "// edited\n" + scratch.read("pendulum_motor.hpp");
  scratch.write("pendulum_motor.hpp", edited);
  const Outcome outcome = run_flatdyn(generate(scratch.path(), "--check"));
  EXPECT_EQ(outcome.code, 7);
  EXPECT_THAT(outcome.err, HasSubstr("pendulum_motor.hpp: is not what this run would write: from line 1 on"));
  EXPECT_EQ(scratch.read("pendulum_motor.hpp"), edited);
}

TEST(Check, SaysWhatIsMissing) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn(generate(scratch.path(), "--check"));
  EXPECT_EQ(outcome.code, 7);
  EXPECT_THAT(outcome.err, HasSubstr("it is not there"));
  EXPECT_TRUE(scratch.is_empty());
}

TEST(DryRun, NamesTheOutputsAndWritesNothing) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn(generate(scratch.path(), "-n --depfile " + scratch.path("d")));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* name : {"pendulum_motor.hpp", "pendulum_motor.json", "d"}) {
    EXPECT_THAT(outcome.out, HasSubstr("would write " + scratch.path(name) + "\n"));
  }
  EXPECT_TRUE(scratch.is_empty());
}

// Header and source belong together: each is compared, named and listed as a target.
TEST(Pair, IsDeliveredAsTwoFiles) {
  const Scratch scratch;
  const std::string pair = "--form pair --scalar double,float";
  const Outcome named = run_flatdyn(generate(scratch.path(), pair + " -n"));
  EXPECT_EQ(named.code, 0) << named.err;
  for (const char* name : {"pendulum_motor.hpp", "pendulum_motor.cpp", "pendulum_motor.json"}) {
    EXPECT_THAT(named.out, HasSubstr("would write " + scratch.path(name) + "\n"));
  }
  ASSERT_EQ(run_flatdyn(generate(scratch.path(), pair + " --depfile " + scratch.path("d"))).code, 0);
  EXPECT_THAT(scratch.read("d"),
              StartsWith(fmt::format("{} {} {}: ", scratch.path("pendulum_motor.hpp"),
                                     scratch.path("pendulum_motor.cpp"), scratch.path("pendulum_motor.json"))));
  EXPECT_THAT(scratch.read("pendulum_motor.json"), HasSubstr("\"source\": \"pendulum_motor.cpp\""));
  EXPECT_EQ(run_flatdyn(generate(scratch.path(), pair + " --check")).code, 0);
  scratch.write("pendulum_motor.cpp", scratch.read("pendulum_motor.cpp") + "// edited\n");
  const Outcome outdated = run_flatdyn(generate(scratch.path(), pair + " --check"));
  EXPECT_EQ(outdated.code, 7);
  EXPECT_THAT(outdated.err, HasSubstr("pendulum_motor.cpp: is not what this run would write"));
  std::filesystem::remove(scratch.path("pendulum_motor.cpp"));
  EXPECT_EQ(run_flatdyn(generate(scratch.path(), pair + " --check")).code, 7);
}

TEST(Pair, IsOfCppOnly) {
  const auto refused = [](const std::string& options) {
    const Outcome outcome = run_flatdyn(generate("/nowhere/at/all", options));
    EXPECT_EQ(outcome.code, 2) << options;
    return outcome.err;
  };
  EXPECT_THAT(refused("--form pair --language c"), HasSubstr("--form: C has one form only"));
  EXPECT_THAT(refused("--form pair --python"), HasSubstr("--form: C has one form only"));
  EXPECT_THAT(refused("--form pair --language javascript"), HasSubstr("--form: JavaScript has one form only"));
  EXPECT_THAT(refused("--fma --language javascript"), HasSubstr("--fma: JavaScript has no fused multiply-add"));
  EXPECT_THAT(refused("--limbs lanes --language c"), HasSubstr("--limbs lanes: not in C"));
  EXPECT_THAT(refused("--limbs lanes --python"), HasSubstr("--limbs lanes: not in C"));
  EXPECT_THAT(refused("--limbs lanes --fma"), HasSubstr("--limbs lanes: not with fused multiply-adds"));
  EXPECT_THAT(refused("--fma --python"), HasSubstr("--fma: the module for Python is without"));
  EXPECT_THAT(refused("--fma --firmware cortex-m4 --scalar double"), HasSubstr("fused multiply-adds in float only"));
  EXPECT_THAT(refused("--scalar double,float"), HasSubstr("use --form pair"));
  EXPECT_THAT(refused("--scalar double,float --language c"), HasSubstr("name one"));
  EXPECT_THAT(refused("--form pair --scalar double,double"), HasSubstr("scalar \"double\" is named twice"));
  EXPECT_THAT(refused("--form pair --scalar double,half"), HasSubstr("half"));
}

TEST(LimbsInLanes, SaySoWhereTheyHaveNoEffect) {
  const Scratch scratch;
  const auto notes = [&](const std::string& robot) {
    return run_flatdyn("generate " + robot + " --limbs lanes --functions gravity,forward_kinematics -o " +
                       scratch.path())
        .err;
  };
  const std::string of_legs = notes("robots/quadruped12.urdf");
  EXPECT_THAT(of_legs, HasSubstr("--limbs lanes has no effect on forward_kinematics: it saves nothing there"));
  EXPECT_THAT(scratch.read("quadruped12.hpp"), HasSubstr("using Limbs4 = detail::Limbs<Scalar, 4>;"));
  EXPECT_THAT(notes("robots/ur5.urdf"), HasSubstr("no effect: the robot has no limbs of the same structure"));
}

// A light link far out. The program chooses units for masses by it, so some constants are outside float's range. Its
// length of 1e-20 m is dust, which --snap 0 keeps.
constexpr const char* kLightLink = R"(<robot name="light">
  <link name="base"/>
  <link name="arm"><inertial><origin xyz="0.5 0 0"/><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="tip"><inertial><origin xyz="1e-20 0 0"/><mass value="1e-25"/>
    <inertia ixx="1e-29" ixy="0" ixz="0" iyy="1e-29" iyz="0" izz="1e-29"/></inertial></link>
  <joint name="shoulder" type="continuous"><origin rpy="1.5 0 0"/><parent link="base"/><child link="arm"/>
    <axis xyz="0 0 1"/></joint>
  <joint name="wrist" type="continuous"><origin xyz="1 0 0" rpy="1 0 0"/><parent link="arm"/><child link="tip"/>
    <axis xyz="0 0 1"/></joint>
</robot>
)";

TEST(Float, SaysWhichConstantsAreNothingThere) {
  const Scratch scratch;
  scratch.write("light.urdf", kLightLink);
  const auto generated = [&scratch](const std::string& options) {
    return run_flatdyn(fmt::format("generate {} -o {} --functions inverse_dynamics --snap 0 {}",
                                   scratch.path("light.urdf"), scratch.path("out"), options));
  };
  const Outcome in_double = generated("");
  EXPECT_EQ(in_double.code, 0);
  EXPECT_THAT(in_double.err, Not(HasSubstr("float")));
  for (const char* options : {"--scalar float", "--form pair --scalar double,float"}) {
    const Outcome in_float = generated(options);
    EXPECT_EQ(in_float.code, 0);
    EXPECT_THAT(in_float.err, HasSubstr("light.urdf: warning: float is too narrow for constants of the code: "));
    EXPECT_THAT(in_float.err, HasSubstr("becomes 0 (inverse_dynamics)"));
    EXPECT_THAT(in_float.err, Not(HasSubstr("infinite")));
    EXPECT_THAT(in_float.err, HasSubstr("hint: generate code in double, or write the robot in units"));
    EXPECT_THAT(in_float.out, HasSubstr("constants rounded to double, and float rounds these once more"));
  }
}

TEST(Float, RefusesConstantsThatAreInfiniteThereInC) {
  const Scratch scratch;
  scratch.write("heavy.toml", "[[link]]\nmass = 1e30\ncom = [1e10, 0, 0]\n");
  const std::string generate = fmt::format("generate {} -o {} --functions inverse_dynamics --scalar float",
                                           scratch.path("heavy.toml"), scratch.path("out"));
  const Outcome in_cpp = run_flatdyn(generate);
  EXPECT_EQ(in_cpp.code, 0);
  EXPECT_THAT(in_cpp.err, HasSubstr("constants of the code: 1e+50 becomes infinite (inverse_dynamics)"));
  const Outcome in_c = run_flatdyn(generate + " --language c");
  EXPECT_EQ(in_c.code, 3);
  EXPECT_THAT(in_c.err, HasSubstr("a constant of the code is 1e+50, which is infinite in float"));
}

TEST(Float, RefusesSuchConstantsWhereWarningsAreErrors) {
  const Scratch scratch;
  scratch.write("light.urdf", kLightLink);
  const Outcome outcome =
      run_flatdyn(fmt::format("generate {} -o {} --functions inverse_dynamics --snap 0 --scalar float -Werror",
                              scratch.path("light.urdf"), scratch.path("out")));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_FALSE(std::filesystem::exists(scratch.path("out")));
}

TEST(Float, IsWideEnoughForARobot) {
  const Scratch scratch;
  const Outcome outcome = run_flatdyn(generate(scratch.path(), "--scalar float"));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, Not(HasSubstr("float")));
  EXPECT_THAT(scratch.read("pendulum_motor.hpp"), HasSubstr("the nearest doubles, which float rounds again"));
}

TEST(DryRun, IsNoCheck) { EXPECT_EQ(run_flatdyn(generate("/nowhere/at/all", "-n --check")).code, 2); }

// A scene, and the robot file over which the robot file is written, count, too; make accepts the rule as it is.
TEST(Depfile, NamesEveryFileThatWasRead) {
  const Scratch scratch;
  scratch.write("a pendulum.toml",
                fmt::format("robot = '{}/robots/pendulum_motor.toml'\nname = 'mine'\n", FLATDYN_SOURCE_DIR));
  scratch.write("still.toml", "static = true\n");
  const std::string more =
      fmt::format("--scene '{}' --depfile '{}'", scratch.path("still.toml"), scratch.path("out.d"));
  const Outcome outcome =
      run_flatdyn(generate(scratch.path(), more, fmt::format("'{}'", scratch.path("a pendulum.toml"))));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string rule = scratch.read("out.d");
  EXPECT_THAT(rule, StartsWith(scratch.path("mine.hpp") + " " + scratch.path("mine.json") + ": \\\n"));
  for (const char* file : {"a\\ pendulum.toml", "/robots/pendulum_motor.toml", "/still.toml"}) {
    EXPECT_THAT(rule, HasSubstr(file));
  }
  scratch.write("Makefile",
                fmt::format("include {}\n{}:\n\t@echo made anew\n", scratch.path("out.d"), scratch.path("mine.hpp")));
  const std::string make =
      fmt::format("make -s -C '{}' '{}' > '{}' 2>&1", scratch.path(), scratch.path("mine.hpp"), scratch.path("log"));
  ASSERT_EQ(std::system(make.c_str()), 0) << scratch.read("log");
  EXPECT_EQ(scratch.read("log").find("made anew"), std::string::npos);
  scratch.write("still.toml", "static = true  # changed\n");
  ASSERT_EQ(std::system(make.c_str()), 0) << scratch.read("log");
  EXPECT_THAT(scratch.read("log"), HasSubstr("made anew"));
}

TEST(Depfile, IsNeitherAnInputNorAnotherOutput) {
  const Scratch scratch;
  EXPECT_EQ(run_flatdyn(generate(scratch.path(), "--depfile robots/pendulum_motor.toml")).code, 2);
  EXPECT_EQ(run_flatdyn(generate(scratch.path(), "--depfile " + scratch.path("pendulum_motor.hpp"))).code, 2);
  EXPECT_TRUE(scratch.is_empty());
}

// man reads every page without a warning, and every option of --help is on it.
TEST(Man, HasAPageForEverySubcommand) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn("man -o " + scratch.path("man")).code, 0);
  EXPECT_EQ(scratch.read("man/flatdyn.1"), run_flatdyn("man").out);
  EXPECT_EQ(scratch.read("man/flatdyn-generate.1"), run_flatdyn("man generate").out);
  for (const auto& page : std::filesystem::directory_iterator(scratch.path("man"))) {
    const std::string file = page.path().string();
    const std::string read = fmt::format("LC_ALL=C groff -K utf8 -man -ww -Tutf8 -P-cbou '{}' > '{}' 2> '{}'", file,
                                         scratch.path("text"), scratch.path("warnings"));
    ASSERT_EQ(std::system(read.c_str()), 0) << file;
    EXPECT_EQ(scratch.read("warnings"), "") << file;
    EXPECT_THAT(scratch.read("text"), HasSubstr("SYNOPSIS")) << file;
  }
  const std::string page = run_flatdyn("man generate").out;
  for (const char* option : {"\\-o, \\-\\-output", "\\-\\-functions", "\\-\\-check", "\\-W", "\\fIFOLDER\\fR"}) {
    EXPECT_THAT(page, HasSubstr(option));
  }
  EXPECT_EQ(run_flatdyn("man generat").code, 2);
  EXPECT_EQ(run_flatdyn("man generate -o -").out, page);
  EXPECT_EQ(run_flatdyn("man -o -").out, run_flatdyn("man").out);
  EXPECT_EQ(run_flatdyn("man generate -o " + scratch.path("one")).code, 2);
}

TEST(Help, IsThatOfTheOption) {
  EXPECT_EQ(run_flatdyn("help generate").out, run_flatdyn("generate --help").out);
  EXPECT_EQ(run_flatdyn("help").out, run_flatdyn("--help").out);
  const Outcome unknown = run_flatdyn("help generat");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean \"generate\"?"));
}

// The completions that bash offers for a line with the cursor at its end.
std::string completed(const std::string& line) {
  const Scratch scratch;
  scratch.write("complete", fmt::format(R"(source <('{}' completion)
compopt() {{ :; }}
read -ra COMP_WORDS <<< '{}'
[[ '{}' == *' ' ]] && COMP_WORDS+=('')
COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))
_flatdyn
printf '%s ' "${{COMPREPLY[@]}}"
)",
                                        FLATDYN_PROGRAM, line, line));
  const std::string command = fmt::format("cd '{}' && bash --norc '{}' > '{}' 2>&1", FLATDYN_SOURCE_DIR,
                                          scratch.path("complete"), scratch.path("offered"));
  EXPECT_EQ(std::system(command.c_str()), 0);
  return scratch.read("offered");
}

TEST(Completion, OffersSubcommandsOptionsValuesFilesAndFunctions) {
  EXPECT_EQ(completed("flatdyn ge"), "generate ");
  EXPECT_EQ(completed("flatdyn generate --sc"), "--scalar --scene ");
  EXPECT_EQ(completed("flatdyn generate --scalar "), "double float ");
  EXPECT_EQ(completed("flatdyn generate robots/pan"), "robots/panda.urdf ");
  EXPECT_EQ(completed("flatdyn verify --functions gravity,coriolis_m"), "gravity,coriolis_matrix ");
  EXPECT_EQ(completed("flatdyn generate -o robo"), "robots ");
  EXPECT_EQ(completed("flatdyn man gen"), "generate ");
  EXPECT_EQ(completed("flatdyn help ver"), "verify ");
  EXPECT_EQ(completed("flatdyn completion "), "bash zsh fish ");
}

// Bash splits "--language=ja" into three words, and into one where = is no separator.
TEST(Completion, OffersValuesBehindAnEqualsSign) {
  EXPECT_EQ(completed("flatdyn generate --language = ja"), "javascript ");
  EXPECT_EQ(completed("flatdyn generate --form ="), "header pair ");
  EXPECT_EQ(completed("flatdyn generate --language=cu"), "--language=cuda ");
}

TEST(Completion, IsOfZsh) {
  if (std::system("command -v zsh > /dev/null") != 0) GTEST_SKIP() << "zsh is not installed";
  const Scratch scratch;
  scratch.write("zsh", run_flatdyn("completion zsh").out);
  // The functions of zsh's completion are replaced by some that print what they are asked for.
  scratch.write("ask", R"(compdef() { :; }
_describe() { print -l -- ${(P)2} }
_arguments() { print -l -- "$@" }
source ./zsh
words=(flatdyn ''); CURRENT=2; _flatdyn
words=(flatdyn generate --language=); CURRENT=3; _flatdyn
)");
  const std::string command = fmt::format("cd '{}' && zsh -f ask > offered 2>&1", scratch.path());
  ASSERT_EQ(std::system(command.c_str()), 0) << scratch.read("offered");
  const std::string offered = scratch.read("offered");
  EXPECT_THAT(offered, HasSubstr("generate:Write code that computes"));
  EXPECT_THAT(offered,
              ::testing::ContainsRegex("\\*--language=\\[[^]]*\\]:value:\\(c\\+\\+ c cuda javascript python\\)"));
}

TEST(Completion, IsOfFish) {
  if (std::system("command -v fish > /dev/null") != 0) GTEST_SKIP() << "fish is not installed";
  const Scratch scratch;
  scratch.write("fish", run_flatdyn("completion fish").out);
  const auto offered = [&scratch](const std::string& line) {
    const std::string command = fmt::format(
        "cd '{}' && HOME=. fish -N -c 'source fish; complete -C \"{}\"' > offered 2>&1", scratch.path(), line);
    EXPECT_EQ(std::system(command.c_str()), 0);
    return scratch.read("offered");
  };
  EXPECT_THAT(offered("flatdyn gen"), ::testing::StartsWith("generate\tWrite code"));
  EXPECT_THAT(offered("flatdyn generate --language=ja"), ::testing::StartsWith("--language=javascript\t"));
  EXPECT_THAT(offered("flatdyn generate --scalar "), ::testing::ContainsRegex("^double\t[^\n]*\nfloat\t"));
  EXPECT_THAT(offered("flatdyn verify --functions gravity,coriolis"), HasSubstr("gravity,coriolis_matrix"));
  EXPECT_EQ(offered("flatdyn man verif"), "verify\n");
}

}  // namespace
}  // namespace flatdyn::testing
