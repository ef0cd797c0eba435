// SPDX-License-Identifier: GPL-2.0-or-later
// Headers in other conventions as a user compiles them: exactly, in rational arithmetic, and in motion
// (tests/consumer/conventions).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <regex>
#include <sstream>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

const std::filesystem::path kConventionPrograms =
    std::filesystem::path(FLATDYN_SOURCE_DIR) / "tests" / "consumer" / "conventions";

constexpr const char* kAllConventions =
    " --convention pose,pinocchio,mujoco,mixed,featherstone --functions inverse_dynamics,inverse_dynamics_tip_force,"
    "inertia_matrix,coriolis_matrix,gravity,bias,forward_dynamics,kinetic_energy,forward_kinematics,jacobian,"
    "jacobian_dot_qd,inverse_dynamics_floating,centroidal_momentum_matrix,centroidal_bias,centre_of_mass,"
    "constrained_forward_dynamics,contact_inverse_dynamics,contact_impact,contact_jacobian,contact_bias";

// The text that the program prints with the robot's headers: "250 hold, 0 do not".
std::string printed(const GoldenCase& generation, const char* program, const char* compiler) {
  const TemporaryFolder folder;
  const std::string refusal = generate(FLATDYN_PROGRAM, FLATDYN_SOURCE_DIR, generation, folder.path());
  if (!refusal.empty()) return refusal;
  return output_of(folder.path(), fmt::format("{} -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror "
                                              "-ffp-contract=off -I. '{}' -o checks && ./checks",
                                              compiler, (kConventionPrograms / program).string()));
}

GoldenCase satellite() {
  return {(kConventionPrograms / "satellite.toml").string(),
          kAllConventions + fmt::format(" --scene '{}'", (kConventionPrograms / "contacts.toml").string())};
}

TEST(Conventions, AreExact) { EXPECT_EQ(printed(satellite(), "exact.cpp", "g++"), "250 hold, 0 do not\n"); }

TEST(Conventions, Move) { EXPECT_EQ(printed(satellite(), "motion.cpp", "g++"), "390 hold, 0 do not\n"); }

TEST(Conventions, CompileWithClang) {
  EXPECT_EQ(printed(satellite(), "motion.cpp", "clang++"), "390 hold, 0 do not\n");
}

TEST(Conventions, AreThoseOfBallsOnAFixedBase) {
  const GoldenCase wrist = {"docs/examples/ball_wrist.toml",
                            " --convention pose,pinocchio --functions inverse_dynamics,bias,jacobian"};
  EXPECT_EQ(printed(wrist, "fixed.cpp", "g++"), "0 do not hold\n");
}

TEST(ConventionsOfLoops, AgreeAndStepWithTheLoop) {
  const GoldenCase hopper = {"docs/examples/five_bar_hopper.toml",
                             " --convention pose,mujoco,mixed --functions inverse_dynamics,forward_dynamics,"
                             "inertia_matrix,coriolis_matrix,gravity,loop_closure,loop_step,loop_motion"};
  EXPECT_EQ(printed(hopper, "loops.cpp", "g++"), "0 do not hold\n");
}

// Spatial vectors have the angular part first: functions with such vectors of the tip are left out.
TEST(Conventions, LeaveOutTheTipOfAFixedBase) {
  const TemporaryFolder folder;
  const GoldenCase wrist = {"docs/examples/ball_wrist.toml",
                            " --convention featherstone --functions inverse_dynamics,jacobian"};
  ASSERT_EQ(generate(FLATDYN_PROGRAM, FLATDYN_SOURCE_DIR, wrist, folder.path()), "");
  const std::string header = content_of(folder.path() / "ball_wrist_featherstone.hpp");
  EXPECT_NE(header.find("inline void inverse_dynamics("), std::string::npos);
  EXPECT_EQ(header.find("jacobian"), std::string::npos);
}

// A row of the page's table: "| `mujoco` | 1 2 3, 0.8 0.6 0 0 | … |" has the name and the numbers of q, v, a and tau.
struct PageRow {
  std::string name;
  std::vector<std::vector<double>> numbers;
};

std::vector<double> numbers_in(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream stream(text);
  return {std::istream_iterator<double>(stream), {}};
}

std::vector<PageRow> rows_of_page() {
  std::istringstream page(content_of(std::filesystem::path(FLATDYN_SOURCE_DIR) / "docs" / "conventions.md"));
  const std::regex row(R"(^\| `(\w+)` \| ([-. \d,]+) \| ([-. \d,]+) \| ([-. \d,]+) \| ([-. \d,]+) \|$)");
  std::vector<PageRow> rows;
  std::smatch match;
  for (std::string line; std::getline(page, line);) {
    if (!std::regex_match(line, match, row)) continue;
    rows.push_back({match[1], {}});
    for (std::size_t k = 2; k < match.size(); ++k) rows.back().numbers.push_back(numbers_in(match[k]));
  }
  return rows;
}

// A program that prints the torques of every row.
std::string program_of(const std::vector<PageRow>& rows) {
  std::string includes = "#include <cstdio>\n", calls;
  for (const PageRow& row : rows) {
    includes += fmt::format("#include \"body_{}.hpp\"\n", row.name);
    calls += fmt::format(
        "  {{ const double q[] = {{{}}}, v[] = {{{}}}, a[] = {{{}}}; double tau[6];\n"
        "    body::{}::inverse_dynamics(q, v, a, tau); for (double x : tau) std::printf(\"%.12g \", x); }}\n",
        fmt::join(row.numbers[0], ", "), fmt::join(row.numbers[1], ", "), fmt::join(row.numbers[2], ", "), row.name);
  }
  return includes + "int main() {\n" + calls + "}\n";
}

// docs/conventions.md has one state in all conventions.
TEST(Conventions, AreAsThePageSays) {
  const std::vector<PageRow> rows = rows_of_page();
  ASSERT_EQ(rows.size(), 5u);
  const TemporaryFolder folder;
  ASSERT_EQ(generate(FLATDYN_PROGRAM, FLATDYN_SOURCE_DIR,
                     {"docs/examples/floating_body.toml", " --convention pose,pinocchio,mujoco,mixed,featherstone"},
                     folder.path()),
            "");
  write(folder.path() / "main.cpp", program_of(rows));
  const std::string text = output_of(folder.path(), "g++ -std=c++17 main.cpp -o main && ./main");
  const std::vector<double> found = numbers_in(text);
  ASSERT_EQ(found.size(), 6 * rows.size()) << text;
  constexpr double kPower = 96.387904;  // as the page says
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::vector<double>&v = rows[k].numbers[1], &tau = rows[k].numbers[3];
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[6 * k + i], tau.at(i), 1e-10) << rows[k].name << " " << i;
    EXPECT_NEAR(std::inner_product(v.begin(), v.end(), tau.begin(), 0.0), kPower, 1e-10) << rows[k].name;
  }
}

}  // namespace
}  // namespace flatdyn::testing
