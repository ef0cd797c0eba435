// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn generate --language rust`: cargo builds the crate, its own test and its example pass, clippy finds nothing,
// and another crate calls it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

class Rust : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("cargo clippy --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "cargo is not installed";
  }

  void generate(const std::string& arguments) const {
    const Outcome outcome = run_flatdyn(fmt::format("generate {} --language rust -o '{}'", arguments, folder_.path()));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("the text, read back, says the same"));
  }

  // Runs cargo in a folder; "" if it succeeds, and what it says otherwise.
  std::string cargo(const std::string& command, const std::string& crate) const {
    const std::string line = fmt::format("cd '{}/{}' && CARGO_TARGET_DIR=../target cargo {} --offline > ../log 2>&1",
                                         folder_.path(), crate, command);
    return std::system(line.c_str()) == 0 ? "" : command + ": " + folder_.read("log");
  }

  Scratch folder_;
};

// Robots with loops, a ball, free symbols, coupled joints, whole and in parts, with and without std.
TEST_F(Rust, IsACrateWithoutAWarning) {
  for (const auto& [robot, options] : {std::pair("four_bar.toml", ""), std::pair("finger.toml", "--max-lines 40"),
                                       std::pair("planar_2r.toml", "--scalar float"),
                                       std::pair("panda.urdf", "--functions gravity,inverse_dynamics --fma"),
                                       std::pair("quadruped12.urdf", "--base floating --functions inverse_dynamics")}) {
    const std::string name = std::string(robot).substr(0, std::string(robot).find('.'));
    generate(fmt::format("robots/{} {}", robot, options));
    EXPECT_EQ(cargo("clippy --quiet", name).substr(0, 2000), "") << robot;
    EXPECT_EQ(folder_.read("log"), "") << robot;
    EXPECT_EQ(cargo("test --quiet", name).substr(0, 2000), "") << robot;
  }
}

TEST_F(Rust, IsCalledByAnotherCrate) {
  generate("robots/panda.urdf --functions inverse_dynamics,forward_dynamics,kinetic_energy");
  std::filesystem::create_directories(folder_.path() + "/arm/src");
  folder_.write("arm/Cargo.toml",
                "[package]\nname = \"arm\"\nversion = \"0.1.0\"\nedition = \"2021\"\n"
                "[dependencies]\npanda = { path = \"../panda\" }\n");
  folder_.write("arm/src/main.rs", R"rust(use panda::{forward_dynamics, inverse_dynamics, JOINT_COUNT, JOINT_NAMES};
fn main() {
    let q = [0.1, -0.2, 0.3, -1.5, 0.5, 1.2, 0.4];
    let qd = [1.0, 2.0, -1.0, 0.5, 0.2, -0.3, 1.0];
    let qdd = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
    let (mut tau, mut back) = ([0.0; JOINT_COUNT], [0.0; JOINT_COUNT]);
    inverse_dynamics(&q, &qd, &qdd, &mut tau);
    assert!(forward_dynamics(&q, &qd, &tau, &mut back));
    assert!(back.iter().zip(&qdd).all(|(a, b)| (a - b).abs() < 1e-9));
    assert!(panda::kinetic_energy(&q, &qd) > 0.0);
    assert_eq!(JOINT_NAMES[0], "panda_joint1");
}
)rust");
  EXPECT_EQ(cargo("run --quiet", "arm"), "");
}

// Names of symbols and files that are words of Rust get a line or a number behind them.
TEST_F(Rust, AvoidsItsOwnWords) {
  folder_.write("loop.toml",
                "name = \"loop\"\ngravity = [0, 0, \"-in\"]\n[[link]]\njoint = \"a\\\"ü\"\nmass = \"ref\"\n"
                "com = [\"self\", 0, 0]\nrpy = [\"pi/2\", 0, 0]\ninertia = { xx = 1, yy = 1, zz = 1 }\n"
                "inertia_about = \"com\"\n");
  generate("'" + folder_.path() + "/loop.toml'");
  EXPECT_THAT(folder_.read("loop/Cargo.toml"), HasSubstr("name = \"loop_\""));
  EXPECT_THAT(folder_.read("loop/src/lib.rs"), HasSubstr(R"(["a\"\u{fc}"])"));
  EXPECT_EQ(cargo("test --quiet", "loop").substr(0, 2000), "");
}

TEST_F(Rust, IsVerifiedAsItIsHeld) {
  generate("robots/planar_2r.toml --functions gravity");
  const std::string crate = folder_.path() + "/planar_2r/";
  for (const char* file : {"src/lib.rs", "Cargo.toml"}) {
    const Outcome outcome = run_flatdyn("verify robots/planar_2r.toml --header '" + crate + file + "'");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  }
  folder_.write("planar_2r/Cargo.toml", folder_.read("planar_2r/Cargo.toml") + "[dependencies]\n");
  const Outcome outcome = run_flatdyn("verify robots/planar_2r.toml --header '" + crate + "src/lib.rs'");
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("Cargo.toml:"));
}

}  // namespace
}  // namespace flatdyn::testing
