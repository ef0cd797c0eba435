// SPDX-License-Identifier: GPL-2.0-or-later
// rounding_is_as_written() of generated code, built with flags that keep the certified rounding and with flags that do
// not, by g++ and by clang++.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "functions/planning/make_functions.hpp"
#include "golden/golden.hpp"
#include "support/emitted_forms.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

// In the order of the program's output.
struct Answer {
  bool in_double, in_float;

  bool operator==(const Answer&) const = default;
};

void PrintTo(const Answer& answer, std::ostream* out) { *out << answer.in_double << " " << answer.in_float; }

constexpr const char* kRoundingProgram =
    "#include \"planar_2r.hpp\"\n"
    "#include <cstdio>\n"
    "int main() {\n"
    "  const bool in_double = planar_2r::rounding_is_as_written();\n"
    "  const bool in_float = planar_2r::rounding_is_as_written<float>();\n"
    "  std::printf(\"%d %d\\n\", in_double, in_float);\n"
    "}\n";

Answer answer_of_build(const std::string& compiler, const std::string& flags) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "main.cpp") << kRoundingProgram;
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
  for (const char* flags :
       {"-O2 -freciprocal-math", "-O2 -fassociative-math -fno-signed-zeros -fno-trapping-math -fno-math-errno"}) {
    EXPECT_EQ(answer_of_build(GetParam(), flags), (Answer{false, false})) << flags;
  }
}

// The checks of finite results would be left out.
TEST_P(RoundingIsAsWritten, DoesNotCompileWithFastMath) {
  const TemporaryFolder folder;
  write(folder.path() / "main.cpp", kRoundingProgram);
  write(folder.path() / "main.c", "#include \"planar_2r.c\"\n");
  for (const char* flag : {"-ffast-math", "-ffinite-math-only"}) {
    for (const char* file : {"main.cpp", "main.c"}) {
      const bool is_c = std::string(file) == "main.c";
      const std::string printed =
          output_of(folder.path(), fmt::format("{} {} {} -I'{}/generated' -fsyntax-only {}",
                                               is_c ? (GetParam()[0] == 'g' ? "gcc" : "clang") : GetParam(),
                                               is_c ? "-std=c99" : "-std=c++17", flag, FLATDYN_SOURCE_DIR, file));
      EXPECT_NE(printed.find("add -fno-finite-math-only"), std::string::npos) << flag << " " << printed;
    }
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

TEST(RoundingIsAsWrittenByGcc, NotWhereTheCompilerMayChooseTheX87) {
  EXPECT_EQ(answer_of_build("g++", "-O2 -mfpmath=sse,387"), (Answer{false, false}));
}

// The processor flushes tiny numbers to zero in the thread that has asked for it, and in no other.
TEST(RoundingIsAsWrittenByGcc, IsAnsweredForTheCallingThread) {
  const TemporaryFolder folder;
  write(folder.path() / "main.cpp", R"(
#include <immintrin.h>
#include <cstdio>
#include <thread>
#include "planar_2r.hpp"
int main() {
  std::thread([] {
    _mm_setcsr(_mm_getcsr() | 0x8000);
    std::printf("%d", planar_2r::rounding_is_as_written());
  }).join();
  std::printf("%d", planar_2r::rounding_is_as_written());
}
)");
  EXPECT_EQ(
      output_of(folder.path(), fmt::format("g++ -std=c++17 -O2 -pthread -I'{}/generated' main.cpp -o main && ./main",
                                           FLATDYN_SOURCE_DIR)),
      "01");
}

// Each file has its own copy of the functions, whichever is linked first.
TEST(RoundingIsAsWrittenByGcc, IsAnsweredForTheCallingFile) {
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
  const TemporaryFolder folder;
  write(folder.path() / "fused.cpp",
        "#include \"planar_2r.hpp\"\nbool fused() { return planar_2r::rounding_is_as_written(); }\n");
  write(folder.path() / "main.cpp",
        "#include <cstdio>\n#include \"planar_2r.hpp\"\nbool fused();\n"
        "int main() { std::printf(\"%d%d\", fused(), planar_2r::rounding_is_as_written()); }\n");
  for (const char* order : {"fused.o main.o", "main.o fused.o"}) {
    EXPECT_EQ(output_of(folder.path(),
                        fmt::format(
                            "g++ -std=c++17 -O2 -fno-inline -mfma -ffp-contract=fast -I'{0}/generated' -c fused.cpp && "
                            "g++ -std=c++17 -O2 -fno-inline -ffp-contract=off -I'{0}/generated' -c main.cpp && "
                            "g++ {1} -o main && ./main",
                            FLATDYN_SOURCE_DIR, order)),
              "01")
        << order;
  }
}

// g++ 12 makes a product with a sum and a difference one operation of a register, -ffp-contract=off or not.
TEST(RoundingIsAsWrittenByGcc, WithFusedMultiplyAddsIfVectorsAreLeftOut) {
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
  const TemporaryFolder folder;
  write(folder.path() / "main.cpp",
        "#include <cstdio>\n#include \"ur5.hpp\"\n"
        "int main() { std::printf(\"%d%d\", ur5::rounding_is_as_written(), ur5::rounding_is_as_written<float>()); }\n");
  EXPECT_EQ(output_of(folder.path(), fmt::format("g++ -std=c++17 -O2 -mfma -ffp-contract=off -fno-tree-slp-vectorize "
                                                 "-I'{}/generated' main.cpp -o main && ./main",
                                                 FLATDYN_SOURCE_DIR)),
            "11");
}

// Text with fused multiply-adds is executed as written where the processor has them; elsewhere it is another one.
TEST_P(RoundingIsAsWritten, WithFusedMultiplyAddsOfTheText) {
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
  const TemporaryFolder folder;
  EmitOptions options;
  options.fuses = true;
  const LoadedRobot model = model_of("ur5.urdf");
  PipelineOptions pipeline;
  pipeline.functions = {"inverse_dynamics", "forward_dynamics"};
  Progress quiet(true);
  Diagnostics left_out;
  const std::vector<Function> functions = functions_of(make_functions(model, pipeline, quiet, left_out));
  write(folder.path() / "ur5.hpp", emit_header(model.mechanism, functions, options));
  options.language = "c";
  const HeaderAndSource in_c = emit_c(model.mechanism, functions, options);
  write(folder.path() / "ur5.h", in_c.header);
  write(folder.path() / "ur5.c", in_c.source);
  write(folder.path() / "main.cpp",
        "#include <cstdio>\n#include \"ur5.hpp\"\n#include \"ur5.h\"\n"
        "int main() { std::printf(\"%d%d%d\", ur5::rounding_is_as_written(), ur5::rounding_is_as_written<float>(), "
        "ur5_rounding_is_as_written()); }\n");
  const bool is_gcc = GetParam()[0] == 'g';
  const auto answer = [&](const std::string& flags) {
    const std::string all = "-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wundef -Werror -ffp-contract=off " + flags;
    return output_of(folder.path(), fmt::format("{0} -std=c99 {1} -c ur5.c && {2} -std=c++17 {1} main.cpp ur5.o -o "
                                                "main && ./main",
                                                is_gcc ? "gcc" : "clang", all, GetParam()));
  };
  EXPECT_EQ(answer(is_gcc ? "-O2 -mfma -fno-tree-slp-vectorize" : "-O2 -mfma"), "111");
  EXPECT_EQ(answer("-O0 -mfma"), "111");
  EXPECT_EQ(answer("-O2"), "000");
}

// A scalar that converts to double, in the global namespace, where argument-dependent lookup finds the library's fma:
// its derivatives must not be lost. The derivative of gravity's first entry by q_1 is a difference quotient.
TEST(FusedMultiplyAdds, KeepTheDerivativesOfScalarsThatConvertToDouble) {
  const TemporaryFolder folder;
  EmitOptions options;
  options.fuses = true;
  const LoadedRobot model = model_of("planar_2r_example_7_2.toml");
  PipelineOptions pipeline;
  pipeline.functions = {"gravity"};
  Progress quiet(true);
  Diagnostics left_out;
  write(folder.path() / "arm.hpp",
        emit_header(model.mechanism, functions_of(make_functions(model, pipeline, quiet, left_out)), options));
  write(folder.path() / "main.cpp", R"(
#include <cmath>
#include <cstdio>
#include "arm.hpp"
struct Dual {
  double x = 0, dx = 0;
  Dual() = default;
  explicit Dual(double value, double derivative = 0) : x(value), dx(derivative) {}
  operator double() const { return x; }
};
Dual operator+(Dual a, Dual b) { return Dual(a.x + b.x, a.dx + b.dx); }
Dual operator-(Dual a, Dual b) { return Dual(a.x - b.x, a.dx - b.dx); }
Dual operator-(Dual a) { return Dual(-a.x, -a.dx); }
Dual operator*(Dual a, Dual b) { return Dual(a.x * b.x, a.x * b.dx + a.dx * b.x); }
Dual sin(Dual a) { return Dual(std::sin(a.x), std::cos(a.x) * a.dx); }
Dual cos(Dual a) { return Dual(std::cos(a.x), -std::sin(a.x) * a.dx); }
int main() {
  using namespace planar_2r_example_7_2;
  const double h = 1e-6, before[2] = {0.3 - h, 0.7}, after[2] = {0.3 + h, 0.7};
  double g_before[2], g_after[2];
  gravity(before, g_before);
  gravity(after, g_after);
  const Dual q[2] = {Dual(0.3, 1), Dual(0.7)};
  Dual g[2];
  gravity(q, g);
  std::printf("%d", std::fabs(g[0].dx - (g_after[0] - g_before[0]) / (2 * h)) < 1e-4 && std::fabs(g[0].dx) > 1);
}
)");
  EXPECT_NE(content_of(folder.path() / "arm.hpp").find("= fma("), std::string::npos);
  EXPECT_EQ(output_of(folder.path(), "g++ -std=c++17 -O1 main.cpp -o main && ./main"), "1");
}

// Adapters are shared by no two files, either.
TEST(RoundingIsAsWrittenByClang, IsAnsweredForFunctionsOfEigen) {
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
  const TemporaryFolder folder;
  const std::string body =
      "  Eigen::Matrix<double, 7, 1> q;\n  q << 0.1, 0.2, 0.3, -1, 0.5, 0.6, 0.7;\n  int differ = 0;\n"
      "  for (int k = 0; k < 100; ++k) {\n    q *= 1.01;\n    double B[49];\n    panda::inertia_matrix(q.data(), B);\n"
      "    const auto C = flatdyn::eigen<panda::functions::inertia_matrix>(q);\n"
      "    for (int i = 0; i < 49; ++i) differ += std::memcmp(B + i, &C(i / 7, i % 7), sizeof(double)) != 0;\n  }\n"
      "  return differ;\n}\n";
  const std::string head =
      "#include <cstdio>\n#include <cstring>\n#include \"panda.hpp\"\n#include \"flatdyn/eigen.hpp\"\n";
  write(folder.path() / "fused.cpp", head + "int fused() {\n" + body);
  write(folder.path() / "main.cpp",
        head + "int fused();\nstatic int here() {\n" + body +
            "int main() { fused(); std::printf(\"%d %d\", panda::rounding_is_as_written(), here()); }\n");
  const std::string compile =
      fmt::format("clang++ -std=c++17 -O2 -I'{0}/generated' -I'{0}/runtime/include' -isystem /usr/include/eigen3 ",
                  FLATDYN_SOURCE_DIR);
  EXPECT_EQ(output_of(folder.path(), compile + "-mfma -ffp-contract=fast -c fused.cpp && " + compile +
                                         "-ffp-contract=off -c main.cpp && clang++ fused.o main.o -o main && ./main"),
            "1 0");
}

// Sines of vectors that are up to four units in the last place off are not those of the code, which has its own. Where
// it asks the library, they are found out.
TEST(RoundingIsAsWrittenByClang, NotWithFastSinesOfTheLibrary) {
  const TemporaryFolder folder;
  EmitOptions options;
  options.language = "c";
  const LoadedRobot model = model_of("planar_2r.toml");
  PipelineOptions pipeline;
  pipeline.functions = {"gravity"};
  Progress quiet(true);
  Diagnostics left_out;
  const std::vector<Function> functions = functions_of(make_functions(model, pipeline, quiet, left_out));
  const auto answer = [&](Sines sines, const std::string& flags) {
    options.sines = sines;
    const HeaderAndSource text = emit_c(model.mechanism, functions, options);
    write(folder.path() / "planar_2r.h", text.header);
    write(folder.path() / "planar_2r.c", text.source);
    write(folder.path() / "main.c",
          "#include <stdio.h>\n#include \"planar_2r.h\"\n"
          "int main(void) { printf(\"%d\", planar_2r_rounding_is_as_written()); }\n");
    return output_of(folder.path(), fmt::format("clang -std=c99 -O2 -ffp-contract=off -fno-math-errno {} main.c "
                                                "planar_2r.c -lmvec -lm -o main && ./main",
                                                flags));
  };
  for (const Sines sines : {Sines::polynomials, Sines::library}) EXPECT_EQ(answer(sines, ""), "1");
  EXPECT_EQ(answer(Sines::polynomials, "-fveclib=libmvec"), "1");
  EXPECT_EQ(answer(Sines::library, "-fveclib=libmvec"), "0");
}

// These leave out checks of results, and keep no signs of zeros.
TEST(RoundingIsAsWrittenByClang, NotWithoutNotANumbersOrSignsOfZeros) {
  for (const char* flag : {"-fno-honor-nans", "-fno-signed-zeros"}) {
    EXPECT_EQ(answer_of_build("clang++", fmt::format("-O2 -ffp-contract=off {}", flag)), (Answer{false, false}))
        << flag;
  }
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
