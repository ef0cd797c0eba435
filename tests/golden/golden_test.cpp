// SPDX-License-Identifier: GPL-2.0-or-later
// One test per line of generated/robots.txt. Each runs the program in a process of its own, so with its addresses
// randomised anew: output in GiNaC's order of terms would differ.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <set>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = FLATDYN_SOURCE_DIR;
const fs::path kGenerated = kSource / "generated";

std::vector<GoldenCase> cases() { return read_cases(kGenerated / "robots.txt"); }

bool is_in_c(const GoldenCase& golden) { return golden.options.find("--language c") != std::string::npos; }

std::string test_name(const ::testing::TestParamInfo<GoldenCase>& info) {
  std::string name = fs::path(info.param.robot).stem().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return is_in_c(info.param) ? name + "_in_c" : name;
}

class Golden : public ::testing::TestWithParam<GoldenCase> {};

TEST_P(Golden, HeaderIsAsCheckedIn) {
  const TemporaryFolder output;
  ASSERT_EQ(generate(FLATDYN_PROGRAM, kSource, GetParam(), output.path()), "");
  for (const std::string& difference : differences(kGenerated, output.path())) {
    ADD_FAILURE() << difference << "\n(if this change is meant: build the target `regenerate`)";
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Golden, ::testing::ValuesIn(cases()), test_name);

// No robot is left out silently, and no header is left from a robot that is gone.
TEST(GoldenTable, ListsEveryRobot) {
  std::set<std::string> listed, in_c;
  for (const GoldenCase& golden : cases()) {
    EXPECT_TRUE(fs::exists(kSource / golden.robot)) << golden.robot;
    const bool is_new = is_in_c(golden) ? in_c.insert(golden.robot).second : listed.insert(golden.robot).second;
    EXPECT_TRUE(is_new) << golden.robot << " is listed twice";
  }
  for (const auto& entry : fs::directory_iterator(kSource / "robots")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".urdf" && extension != ".toml") continue;
    const std::string robot = "robots/" + entry.path().filename().string();
    EXPECT_EQ(listed.count(robot), 1u) << robot << " is missing in generated/robots.txt";
  }
}

TEST(GoldenTable, HasOneHeaderPerRobot) {
  std::size_t headers = 0;
  for (const auto& entry : fs::directory_iterator(kGenerated)) {
    headers += entry.path().extension() == ".hpp" || entry.path().extension() == ".h" ? 1 : 0;
  }
  EXPECT_EQ(headers, cases().size());
}

TEST(GoldenTable, StaysUnderFiveMegabytes) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(kGenerated)) bytes += entry.file_size();
  EXPECT_LT(bytes, 5'000'000u);
}

std::vector<std::string> headers() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kGenerated)) {
    if (entry.path().extension() == ".hpp") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class GoldenHeader : public ::testing::TestWithParam<std::string> {};

// With every warning an error, by both compilers.
TEST_P(GoldenHeader, CompilesAlone) {
  for (const char* compiler : {"g++", "clang++"}) {
    const std::string command = fmt::format(
        "{} -std=c++17 -fsyntax-only -x c++ -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion "
        "-Wfloat-equal -Werror -fno-exceptions -fno-rtti '{}/{}.hpp'",
        compiler, kGenerated.string(), GetParam());
    EXPECT_EQ(std::system(command.c_str()), 0) << compiler;
  }
}

INSTANTIATE_TEST_SUITE_P(Generated, GoldenHeader, ::testing::ValuesIn(headers()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace flatdyn::testing
