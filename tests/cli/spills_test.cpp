// SPDX-License-Identifier: GPL-2.0-or-later
// Register spills of the emitted text on a Cortex-M4, whose floating-point unit has 32 registers: with the statements
// in flatdyn's order and in another, as one function and in stages. `ctest -R Spills -V` prints them.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

#include "base/system/process.hpp"
#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* kFunctions = "inverse_dynamics,inertia_matrix,gravity";
constexpr const char* kPlain = "-std=c99 -O2 -ffp-contract=off -ffunction-sections -fdata-sections -fstack-usage";

// The Panda's folder for a Cortex-M4, and the spills in its report.
class Spills : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* program : {"arm-none-eabi-gcc", "arm-none-eabi-g++", "make"}) {
      const std::string command = fmt::format("command -v {} > /dev/null", program);
      if (std::system(command.c_str()) != 0) GTEST_SKIP() << program << " is not installed: scripts/setup";
    }
    generate(fmt::format("--firmware cortex-m4 --functions {}", kFunctions));
  }

  void generate(const std::string& options) const {
    const Outcome outcome =
        run_flatdyn(fmt::format("generate robots/panda.urdf -q {} -o '{}'", options, folder_.path()));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }

  // The spills by function, named as in the object file.
  std::map<std::string, int> spills(const std::string& command) const {
    const std::string all = fmt::format("cd '{}' && rm -f panda.o && ({}) > log 2>&1", folder_.path(), command);
    EXPECT_EQ(std::system(all.c_str()), 0) << folder_.read("log");
    std::map<std::string, int> found;
    std::istringstream lines(folder_.read("log"));
    std::string name;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      int bytes = 0, rodata = 0, stack = 0, spilt = 0;
      if (words >> name >> bytes >> rodata >> stack >> spilt) found[name] = spilt;
    }
    return found;
  }

  static bool has_compiler_of_the_page() {
    return std::system("arm-none-eabi-gcc --version | grep -q '12\\.2\\.'") == 0;
  }

  static std::string docs_page() { return content_of_file(FLATDYN_SOURCE_DIR "/docs/firmware.md"); }

  std::map<std::string, int> spills_in_c(const std::string& options) const {
    return spills(fmt::format("make size CFLAGS='$(TARGET) {} {}'", kPlain, options));
  }

  Scratch folder_;
};

// Sorts a function's statements by the length of the longest path from its inputs, instead of depth-first from its
// outputs.
std::string level_by_level(const std::string& body) {
  struct Ordered {
    int level;
    std::string text;
  };
  std::vector<Ordered> statements;
  std::map<std::string, int> levels;  // by variable
  std::istringstream stream(body);
  for (std::string text; std::getline(stream, text, ';');) {
    if (text.find('=') == std::string::npos) continue;
    const std::regex word("[A-Za-z_]\\w*"), defined("(\\w+) = ");
    int level = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at) {
      const auto known = levels.find(at->str());
      if (known != levels.end()) level = std::max(level, known->second + 1);
    }
    const bool is_variable = text.find("const float") != std::string::npos;
    for (std::sregex_iterator at(text.begin(), text.end(), defined), end; is_variable && at != end; ++at) {
      levels[(*at)[1]] = level;
    }
    statements.push_back({level, text + ";"});
  }
  std::stable_sort(statements.begin(), statements.end(),
                   [](const Ordered& a, const Ordered& b) { return a.level < b.level; });
  std::string ordered;
  for (const Ordered& statement : statements) ordered += statement.text;
  return ordered;
}

std::string reordered(std::string source) {
  for (const char* function : {"inverse_dynamics", "inertia_matrix", "gravity"}) {
    const std::size_t begin = source.find("{\n", source.find(fmt::format("void panda_{}_given(", function))) + 1;
    const std::size_t end = source.find("\n}\n", begin);
    source.replace(begin, end - begin, level_by_level(source.substr(begin, end - begin)));
  }
  return source;
}

// GCC reorders instructions itself, so the order of the text matters little; it must not cost anything.
TEST_F(Spills, AreNoMoreThanInAnotherOrder) {
  const std::string source = folder_.read("panda.c");
  std::map<std::string, std::vector<int>> rows, rows_of_other;  // by options, in the order of the page
  for (const char* options : {"", "-fno-schedule-insns"}) {
    folder_.write("panda.c", source);
    const std::map<std::string, int> emitted = spills_in_c(options);
    folder_.write("panda.c", reordered(source));
    const std::map<std::string, int> other = spills_in_c(options);
    int sum = 0, sum_of_other = 0;
    for (const char* function : {"inverse_dynamics", "inertia_matrix", "gravity"}) {
      const std::string name = fmt::format("panda_{}_given", function);
      fmt::print("-O2 {}, {}: {} spills, level by level {}\n", options, name, emitted.at(name), other.at(name));
      rows[options].push_back(emitted.at(name));
      rows_of_other[options].push_back(other.at(name));
      sum += emitted.at(name);
      sum_of_other += other.at(name);
    }
    EXPECT_GT(sum, 0);
    EXPECT_LE(sum, 1.1 * sum_of_other) << options;
  }
  if (!has_compiler_of_the_page()) return;
  EXPECT_THAT(docs_page(), HasSubstr(fmt::format("inputs | {} |\n", fmt::join(rows_of_other[""], " | "))));
  EXPECT_THAT(docs_page(), HasSubstr(fmt::format("outputs | {} |\n", fmt::join(rows[""], " | "))));
  std::vector<std::string> pairs;
  for (std::size_t k = 0; k < 3; ++k) {
    pairs.push_back(
        fmt::format("{}, {}", rows_of_other["-fno-schedule-insns"].at(k), rows["-fno-schedule-insns"].at(k)));
  }
  EXPECT_THAT(docs_page(), HasSubstr(fmt::format("`-fno-schedule-insns` | {} |\n", fmt::join(pairs, " | "))));
}

// The values that stages pass on are in their structs. The C++ library for this processor is a separate package, of
// which the code needs little.
TEST_F(Spills, AreFewerInStages) {
  generate(fmt::format("--form pair --scalar float --functions {0} --stages {0}", kFunctions));
  folder_.write("cmath",
                "extern \"C\" { float sinf(float); float cosf(float); }\n"
                "namespace std {\ninline float sin(float x) { return sinf(x); }\n"
                "inline float cos(float x) { return cosf(x); }\n}\n");
  const std::map<std::string, int> found = spills(
      "arm-none-eabi-g++ -I. -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -std=c++17 -O2 "
      "-ffp-contract=off -ffunction-sections -fstack-usage -c panda.cpp -o panda.o && sh ./report");
  // The sum over all functions whose mangled name has these parts.
  const auto of = [&found](const std::string& first, const std::string& second) {
    int sum = 0;
    for (const auto& [name, spilt] : found) {
      const std::size_t at = name.find(first);
      if (at != std::string::npos && name.find(second, at + first.size()) != std::string::npos) sum += spilt;
    }
    return sum;
  };
  const std::string own = "PolynomialSinCos", stage = "ConfigurationIfE";
  const int whole = of("inverse_dynamicsIf", own), staged = of(stage, "4with") + of("MotionIfE", "inverse_dynamics");
  const int whole_matrix = of("inertia_matrixIf", own), staged_matrix = of(stage, "inertia_matrix");
  fmt::print("inverse_dynamics: {} spills, with() and inverse_dynamics() {}\n", whole, staged);
  fmt::print("inertia_matrix: {} spills, of a Configuration {}; at() {}\n", whole_matrix, staged_matrix,
             of("2atIf", own));
  EXPECT_GT(whole, 0);
  EXPECT_LT(staged, whole);
  EXPECT_LE(staged_matrix, whole_matrix);
  if (!has_compiler_of_the_page()) return;
  EXPECT_THAT(docs_page(), HasSubstr(fmt::format("of the member | {} instead of {} | {} instead of {} | 0 |\n", staged,
                                                 whole, staged_matrix, whole_matrix)));
}

}  // namespace
}  // namespace flatdyn::testing
