// SPDX-License-Identifier: GPL-2.0-or-later
// rounding_is_as_written() of a generated header, built with flags that keep the certified rounding and with flags that
// do not, by g++ and by clang++.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

// In the order of the program's output.
struct Answer {
  bool in_double, in_float;

  bool operator==(const Answer&) const = default;
};

void PrintTo(const Answer& answer, std::ostream* out) { *out << answer.in_double << " " << answer.in_float; }

constexpr const char* kProgram =
    "#include \"planar_2r.hpp\"\n"
    "#include <cstdio>\n"
    "int main() {\n"
    "  const bool in_double = planar_2r::rounding_is_as_written();\n"
    "  const bool in_float = planar_2r::rounding_is_as_written<float>();\n"
    "  std::printf(\"%d %d\\n\", in_double, in_float);\n"
    "}\n";

Answer answer_of_build(const std::string& compiler, const std::string& flags) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "main.cpp") << kProgram;
  const std::string command = fmt::format(
      "cd '{0}' && ({1} -std=c++17 -I'{2}/generated' -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror "
      "{3} main.cpp -o main && ./main) > log 2>&1",
      folder.path().string(), compiler, FLATDYN_SOURCE_DIR, flags);
  EXPECT_EQ(std::system(command.c_str()), 0) << command << "\n" << content_of(folder.path() / "log");
  std::istringstream log(content_of(folder.path() / "log"));
  int in_double = -1, in_float = -1;
  log >> in_double >> in_float;
  EXPECT_TRUE(log);
  return {in_double == 1, in_float == 1};
}

class RoundingIsAsWritten : public ::testing::TestWithParam<const char*> {};

TEST_P(RoundingIsAsWritten, WithTheFlagsThatTheHeaderNames) {
  for (const char* flags : {"-O0 -ffp-contract=off", "-O2 -ffp-contract=off", "-O3 -march=native -ffp-contract=off"}) {
    EXPECT_EQ(answer_of_build(GetParam(), flags), (Answer{true, true})) << flags;
  }
}

TEST_P(RoundingIsAsWritten, NotWhereTheCompilerTakesLiberties) {
  for (const char* flags : {"-O2 -ffast-math", "-O0 -ffast-math", "-O2 -freciprocal-math",
                            "-O2 -fassociative-math -fno-signed-zeros -fno-trapping-math -fno-math-errno"}) {
    EXPECT_EQ(answer_of_build(GetParam(), flags), (Answer{false, false})) << flags;
  }
}

#ifdef __x86_64__
// The program runs on this machine only if it has such instructions.
TEST_P(RoundingIsAsWritten, NotWithFusedMultiplyAdds) {
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
  EXPECT_EQ(answer_of_build(GetParam(), "-O2 -mfma -ffp-contract=fast"), (Answer{false, false}));
  EXPECT_EQ(answer_of_build(GetParam(), "-O2 -mfma -ffp-contract=off"), (Answer{true, true}));
}

// clang++ has no x87 arithmetic on these machines.
TEST(RoundingIsAsWrittenByGcc, NotInTheRegistersOfTheX87) {
  EXPECT_EQ(answer_of_build("g++", "-O2 -mfpmath=387"), (Answer{false, false}));
  EXPECT_EQ(answer_of_build("g++", "-O0 -mfpmath=387"), (Answer{false, false}));
}

// Every result is stored, so it has the digits of a double but is rounded twice; for float that makes no difference.
TEST(RoundingIsAsWrittenByGcc, NotWhereResultsAreRoundedTwice) {
  EXPECT_FALSE(answer_of_build("g++", "-O0 -ffp-contract=off -mfpmath=387 -ffloat-store").in_double);
  EXPECT_FALSE(answer_of_build("g++", "-O2 -ffp-contract=off -mfpmath=387 -ffloat-store").in_double);
}

// The x87 is set to 24 digits, as some programs leave it: doubles are then floats.
TEST(RoundingIsAsWrittenByGcc, NotWithTooFewDigits) {
  EXPECT_FALSE(answer_of_build("g++", "-O2 -ffp-contract=off -mfpmath=387 -mpc32").in_double);
  EXPECT_FALSE(answer_of_build("g++", "-O2 -ffp-contract=off -mfpmath=387 -mpc32 -ffloat-store").in_double);
}
#endif

std::string name_of(const ::testing::TestParamInfo<const char*>& compiler) {
  return std::string(compiler.param) == "g++" ? "gcc" : "clang";
}

INSTANTIATE_TEST_SUITE_P(Compilers, RoundingIsAsWritten, ::testing::Values("g++", "clang++"), name_of);

}  // namespace
}  // namespace flatdyn::testing
