// SPDX-License-Identifier: GPL-2.0-or-later
// One test per line of generated/robots.txt. Each runs the program in a separate process with newly randomised
// addresses, so output in GiNaC's order of terms would differ.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <set>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = FLATDYN_SOURCE_DIR;
const fs::path kGenerated = kSource / "generated";

std::vector<GoldenCase> cases() { return read_cases(kGenerated / "robots.txt"); }

// The form in which a robot is checked in beside its header: empty, "in_c", "in_rust", "as_pair".
std::string form_of(const GoldenCase& golden) {
  const auto has = [&golden](const char* option) { return golden.options.find(option) != std::string::npos; };
  return has("--language c") ? "in_c" : has("--language rust") ? "in_rust" : has("--form pair") ? "as_pair" : "";
}

std::string test_name(const ::testing::TestParamInfo<GoldenCase>& info) {
  std::string name = fs::path(info.param.robot).stem().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  const std::string form = form_of(info.param);
  return form.empty() ? name : name + "_" + form;
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

// No robot is left out silently, and no header remains from a robot that was removed.
TEST(GoldenTable, ListsEveryRobot) {
  std::map<std::string, std::set<std::string>> listed;  // by form
  for (const GoldenCase& golden : cases()) {
    EXPECT_TRUE(fs::exists(kSource / golden.robot)) << golden.robot;
    EXPECT_TRUE(listed[form_of(golden)].insert(golden.robot).second) << golden.robot << " is listed twice";
  }
  for (const auto& entry : fs::directory_iterator(kSource / "robots")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".urdf" && extension != ".toml") continue;
    const std::string robot = "robots/" + entry.path().filename().string();
    EXPECT_EQ(listed[""].count(robot), 1u) << robot << " is missing in generated/robots.txt";
  }
}

TEST(GoldenTable, HasOneHeaderPerRobot) {
  std::size_t headers = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kGenerated)) {
    const std::string kind = entry.path().extension().string();
    headers += kind == ".hpp" || kind == ".h" || kind == ".rs" ? 1 : 0;
  }
  EXPECT_EQ(headers, cases().size());
}

TEST(GoldenTable, StaysUnderFiveMegabytes) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kGenerated)) {
    bytes += entry.is_regular_file() ? entry.file_size() : 0;
  }
  EXPECT_LT(bytes, 5'000'000u);
}

std::vector<std::string> cpp_files() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kGenerated)) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".hpp" || kind == ".cpp") names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class GoldenCpp : public ::testing::TestWithParam<std::string> {};

// Compiled with every warning an error, by both compilers.
TEST_P(GoldenCpp, CompilesAlone) {
  for (const char* compiler : {"g++", "clang++"}) {
    const std::string command = fmt::format(
        "{} -std=c++17 -fsyntax-only -x c++ -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion "
        "-Wfloat-equal -Werror -fno-exceptions -fno-rtti '{}/{}'",
        compiler, kGenerated.string(), GetParam());
    EXPECT_EQ(std::system(command.c_str()), 0) << compiler;
  }
}

INSTANTIATE_TEST_SUITE_P(Generated, GoldenCpp, ::testing::ValuesIn(cpp_files()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

}  // namespace
}  // namespace flatdyn::testing
