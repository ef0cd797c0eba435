// SPDX-License-Identifier: GPL-2.0-or-later
// Generated code computes the right values under the flags that people compile with, or refuses to be compiled and
// names the flag: every form, by several compilers, for several processors. Values are compared with those of the same
// formulas in long double with the library's sines, up to rounding errors: bits may differ.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Two equal arms, so that limbs can be computed in lanes.
constexpr const char* kRobot = R"(
name = "arms"
gravity = [0, -9.81, 0]
[[link]]
name = "left_upper"
xyz = [0, 0.2, 0]
mass = 2
com = [0.2, 0.01, 0]
inertia = { xx = 0.01, yy = 0.03, zz = 0.04 }
inertia_about = "com"
[[link]]
name = "left_lower"
xyz = [0.4, 0, 0]
axis = [0, 1, 0]
mass = 1
com = [0.15, 0, 0.02]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02 }
inertia_about = "com"
[[link]]
name = "right_upper"
parent = "base"
xyz = [0, -0.2, 0]
mass = 2
com = [0.2, 0.01, 0]
inertia = { xx = 0.01, yy = 0.03, zz = 0.04 }
inertia_about = "com"
[[link]]
name = "right_lower"
xyz = [0.4, 0, 0]
axis = [0, 1, 0]
mass = 1
com = [0.15, 0, 0.02]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02 }
inertia_about = "com"
)";

// The states, and the results by state: tau, B, qdd.
constexpr const char* kStates = R"(
#pragma once
constexpr int n = 4, state_count = 40, width = n + n * n + n;
template <class T>
struct State {
  T q[n], qd[n], x[n];
};
template <class T>
State<T> state(int k) {
  static const double q[n] = {0.8, -2.5, 3.1, 0.02};
  State<T> s;
  const double turns = k < 30 ? 1.0 : 100.0;  // large angles, too
  for (int i = 0; i < n; ++i) {
    s.q[i] = T((q[i] + 0.37 * k * (i + 1)) * turns);
    s.qd[i] = T(0.3 * i - 0.5 + 0.01 * k);
    s.x[i] = T(1.1 - 0.4 * i + 0.02 * k);
  }
  return s;
}
template <class T, class ID, class B, class FD>
void compute(ID inverse, B inertia, FD forward, double* out) {
  for (int k = 0; k < state_count; ++k, out += width) {
    const State<T> s = state<T>(k);
    T y[width] = {};
    inverse(s.q, s.qd, s.x, y);
    inertia(s.q, y + n);
    if (!forward(s.q, s.qd, s.x, y + n + n * n)) y[width - 1] = T(1e9);
    for (int i = 0; i < width; ++i) out[i] = double(y[i]);
  }
}
#define COMPUTE(T, NS, out)                                 \
  compute<T>([](auto... a) { NS::inverse_dynamics<T>(a...); }, \
             [](auto... a) { NS::inertia_matrix<T>(a...); },   \
             [](auto... a) { return NS::forward_dynamics<T>(a...); }, out)
)";

// Forms of C++, compiled with the flags.
constexpr const char* kForm = R"(
#include "states.hpp"
#include "{0}/{1}"
void {0}_doubles(double* out) {{ COMPUTE(double, {0}, out); }}
void {0}_floats(double* out) {{ COMPUTE(float, {0}, out); }}
)";

constexpr const char* kBatch = R"(
#include <vector>
#include "states.hpp"
#include "apart/apart.hpp"
#include "flatdyn/batch.hpp"
template <class T>
void compute_all(double* results) {
  std::vector<T> q(state_count * n), qd(q), x(q), tau(q), qdd(q), B(q.size() * n);
  for (int k = 0; k < state_count; ++k) {
    const State<T> s = state<T>(k);
    for (int i = 0; i < n; ++i) {
      q[i * state_count + k] = s.q[i];
      qd[i * state_count + k] = s.qd[i];
      x[i * state_count + k] = s.x[i];
    }
  }
  using namespace flatdyn;
  constexpr std::size_t count = state_count;
  const auto input = [](std::vector<T>& v) { return in<n>(v.data(), count); };
  for_each_state<T>(count, [](auto... a) { return apart::inverse_dynamics(a...); }, input(q), input(qd), input(x),
                    out<n>(tau.data(), count));
  for_each_state<T>(count, [](auto... a) { return apart::inertia_matrix(a...); }, input(q),
                    out<n * n>(B.data(), count));
  const bool all = for_each_state<T>(count, [](auto... a) { return apart::forward_dynamics(a...); }, input(q), input(qd),
                                     input(x), out<n>(qdd.data(), count));
  for (int k = 0; k < state_count; ++k) {
    for (int i = 0; i < n; ++i) *results++ = double(tau[i * state_count + k]);
    for (int i = 0; i < n * n; ++i) *results++ = double(B[i * state_count + k]);
    for (int i = 0; i < n; ++i) *results++ = all ? double(qdd[i * state_count + k]) : 1e9;
  }
}
void batch_doubles(double* results) { compute_all<double>(results); }
void batch_floats(double* results) { compute_all<float>(results); }
)";

// Compiled without the flags: calls C, and compares all forms with the formulas in long double.
constexpr const char* kMain = R"(
#include <cmath>
#include <cstddef>
#include <cstdio>
#include "states.hpp"
#include "apart/apart.hpp"
#include "c_doubles/c_doubles.h"
#include "c_floats/c_floats.h"
#ifdef WITH_LANES
#define LANES(T, NS)                                                                                                \
  extern "C" {                                                                                                      \
  void NS##_inverse_dynamics_batch(std::size_t, const T*, std::size_t, const T*, std::size_t, const T*, std::size_t, T*); \
  void NS##_inertia_matrix_batch(std::size_t, const T*, std::size_t, T*);                                            \
  void NS##_forward_dynamics_batch(std::size_t, const T*, std::size_t, const T*, std::size_t, const T*, std::size_t, T*); \
  }                                                                                                                 \
  void NS##_lanes(double* out) {                                                                                    \
    T q[state_count][n], qd[state_count][n], x[state_count][n], tau[state_count][n], B[state_count][n * n], qdd[state_count][n]; \
    for (int k = 0; k < state_count; ++k)                                                                           \
      for (int i = 0; i < n; ++i) q[k][i] = state<T>(k).q[i], qd[k][i] = state<T>(k).qd[i], x[k][i] = state<T>(k).x[i]; \
    NS##_inverse_dynamics_batch(state_count, *q, n, *qd, n, *x, n, *tau);                                           \
    NS##_inertia_matrix_batch(state_count, *q, n, *B);                                                              \
    NS##_forward_dynamics_batch(state_count, *q, n, *qd, n, *x, n, *qdd);                                           \
    for (int k = 0; k < state_count; ++k) {                                                                         \
      for (int i = 0; i < n; ++i) *out++ = tau[k][i];                                                               \
      for (int i = 0; i < n * n; ++i) *out++ = B[k][i];                                                             \
      for (int i = 0; i < n; ++i) *out++ = qdd[k][i];                                                               \
    }                                                                                                               \
  }
LANES(double, c_doubles)
LANES(float, c_floats)
#endif
#define C_FORM(T, NS)                                                                                              \
  void NS##_single(double* out) {                                                                                  \
    compute<T>([](auto... a) { NS##_inverse_dynamics(a...); }, [](auto... a) { NS##_inertia_matrix(a...); },       \
               [](auto... a) { return NS##_forward_dynamics(a...); }, out);                                        \
  }
C_FORM(double, c_doubles)
C_FORM(float, c_floats)

// The same formulas at the same states: those of double or of float.
template <class T>
void expected(double* out) {
  using Exact = long double;
  for (int k = 0; k < state_count; ++k, out += width) {
    const State<T> s = state<T>(k);
    Exact q[n], qd[n], x[n], y[width] = {};
    for (int i = 0; i < n; ++i) q[i] = s.q[i], qd[i] = s.qd[i], x[i] = s.x[i];
    apart::inverse_dynamics(q, qd, x, y);
    apart::inertia_matrix(q, y + n);
    apart::forward_dynamics(q, qd, x, y + n + n * n);
    for (int i = 0; i < width; ++i) out[i] = double(y[i]);
  }
}

// The largest difference, in parts of the largest entry, which counts angles' digits before the point.
template <class T>
void compare(const char* name, void (*form)(double*)) {
  static double right[state_count * width], results[state_count * width];
  expected<T>(right);
  form(results);
  double worst = 0;
  for (int k = 0; k < state_count; ++k) {
    double angle = 1;
    for (double q : state<double>(k).q) angle = std::fmax(angle, std::fabs(q));
    const int ends[] = {0, n, n + n * n, width};
    for (int part = 0; part < 3; ++part) {
      double size = 0;
      for (int i = ends[part]; i < ends[part + 1]; ++i) size = std::fmax(size, std::fabs(right[k * width + i]));
      for (int i = ends[part]; i < ends[part + 1]; ++i) {
        const double off = std::fabs(results[k * width + i] - right[k * width + i]) / (size * angle);
        if (!(off <= worst)) worst = off;
      }
    }
  }
  std::printf("%s %.3g %s\n", name, worst, worst < (sizeof(T) == 4 ? 1e-4 : 1e-13) ? "right" : "WRONG");
}
#define FORM(NS) void NS##_doubles(double*); void NS##_floats(double*);
#define COMPARE(NS) compare<double>(#NS, NS##_doubles); compare<float>(#NS "_floats", NS##_floats);
FORM(apart) FORM(pair) FORM(cuda) FORM(fused)
#ifdef WITH_LANES
FORM(limbs) FORM(batch)
#endif
int main() {
  compare<double>("c", c_doubles_single);
  compare<float>("c_floats", c_floats_single);
  COMPARE(apart) COMPARE(pair) COMPARE(cuda) COMPARE(fused)
#ifdef WITH_LANES
  compare<double>("c_lanes", c_doubles_lanes);
  compare<float>("c_lanes_floats", c_floats_lanes);
  COMPARE(limbs) COMPARE(batch)
#endif
}
)";

// A compiler, its flags, and how its programs are run.
struct Build {
  std::string c, cpp, flags, run;
  bool has_lanes = true;
};

class CompilerFlags : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<Scratch>();
    folder_->write("arms.toml", kRobot);
    folder_->write("states.hpp", kStates);
    folder_->write("main.cpp", kMain);
    folder_->write("batch.cpp", kBatch);
    generate("apart", "", "hpp");
    generate("pair", "--form pair --scalar double,float", "hpp");
    generate("cuda", "--language cuda", "cuh");
    generate("fused", "--fma", "hpp");
    generate("limbs", "--limbs lanes", "hpp");
    generate("c_doubles", "--python", "");
    generate("c_floats", "--python --scalar float", "");
  }
  static void TearDownTestSuite() { folder_.reset(); }

  // Everything is in a folder, and in a namespace, of the form's name.
  static void generate(const std::string& form, const std::string& options, const std::string& ending) {
    const Outcome outcome = run_flatdyn(
        fmt::format("generate '{0}' -q --functions inverse_dynamics,inertia_matrix,forward_dynamics --name {1} "
                    "--namespace {1} -o '{2}' {3}",
                    folder_->path("arms.toml"), form, folder_->path(form), options));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    if (!ending.empty()) folder_->write(form + ".cpp", fmt::format(kForm, form, form + "." + ending));
  }

  static std::string output_of(const std::string& command) {
    const std::string whole = fmt::format("cd '{}' && ({}) > log 2>&1", folder_->path(), command);
    return std::system(whole.c_str()) == 0 ? folder_->read("log") : "failed: " + command + "\n" + folder_->read("log");
  }

  static bool has(const std::string& program) {
    return std::system(fmt::format("command -v {} > /dev/null", program).c_str()) == 0;
  }

  // Compiles a program with these flags, and returns what it prints.
  static std::string answer_of(const Build& build) {
    std::string compile = "rm -f *.o main && ";
    const std::string headers = fmt::format("-I . -isystem '{}/runtime/include'", FLATDYN_SOURCE_DIR);
    for (const char* form : {"c_doubles", "c_floats"}) {
      compile += fmt::format("{0} -std=c99 {1} -c {2}/{2}.c -o {2}.o && ", build.c, build.flags, form);
      if (!build.has_lanes) continue;
      compile += fmt::format("{0} -std=c99 {1} -c {2}/{2}_batch.c -o {2}_batch.o && ", build.c, build.flags, form);
    }
    std::string forms = "apart pair cuda fused pair/pair";
    if (build.has_lanes) forms += " limbs batch";
    compile += fmt::format(
        "for each in {0}; do {1} -std=c++17 -w {2} {3} -c $each.cpp -o of_$(basename $each)_$(dirname $each | tr -d "
        "./).o "
        "|| exit 1; done && {1} -std=c++17 -O1 -w {3} {4} -c main.cpp -o main.o && {1} -static *.o {2} -o main && {5} "
        "./main",
        forms, build.cpp, build.flags, headers, build.has_lanes ? "-D WITH_LANES" : "", build.run);
    return output_of(compile);
  }

  static void expect_right(const Build& build) {
    const std::string answer = answer_of(build);
    EXPECT_THAT(answer, Not(HasSubstr("failed"))) << build.cpp << " " << build.flags;
    EXPECT_THAT(answer, Not(HasSubstr("WRONG"))) << build.cpp << " " << build.flags;
    std::size_t forms = 0;
    for (std::size_t at = 0; (at = answer.find(" right\n", at)) != std::string::npos; ++at) ++forms;
    EXPECT_EQ(forms, build.has_lanes ? 16U : 10U) << answer;
  }

  static inline std::unique_ptr<Scratch> folder_;
};

constexpr const char* kReassociates = "-O2 -fassociative-math -fno-signed-zeros -fno-trapping-math";
constexpr const char* kUnsafe = "-O2 -funsafe-math-optimizations";
constexpr const char* kFastest = "-Ofast -fno-finite-math-only";

TEST_F(CompilerFlags, ThatReorderSumsChangeLastPlacesOnly) {
  expect_right({"gcc", "g++", kFastest, ""});
  expect_right({"clang", "clang++", kUnsafe, ""});
}

// Each of these is a set of flags that people compile with. Vectors in C do not compile for the x87, whose constants
// have more digits.
TEST_F(CompilerFlags, OfGccChangeLastPlacesOnly) {
  for (const char* flags : {"-O0",
                            "-Og",
                            "-O1",
                            "-O2",
                            "-O3",
                            "-Os",
                            "-O2 -ffp-contract=off",
                            kUnsafe,
                            kReassociates,
                            kFastest,
                            "-O1 -funsafe-math-optimizations",
                            "-Os -ffast-math -fno-finite-math-only",
                            "-O2 -freciprocal-math",
                            "-O2 -fno-signed-zeros -fno-math-errno -fno-trapping-math",
                            "-O2 -frounding-math -fsignaling-nans",
                            "-O3 -funsafe-math-optimizations -funroll-all-loops -fno-tree-vectorize",
                            "-Ofast -fno-finite-math-only -fno-inline",
                            "-Ofast -fno-finite-math-only -flto",
                            "-O2 -mfpmath=387",
                            "-O3 -mfpmath=387 -funsafe-math-optimizations",
                            "-O0 -mfpmath=387",
                            "-O2 -mfpmath=387 -ffloat-store",
                            "-O2 -mfpmath=sse,387",
                            "-O2 -fexcess-precision=fast -mfpmath=387",
                            "-O2 -fwrapv -fno-strict-aliasing",
                            "-O2 -fno-builtin",
                            "-O2 -mpc64 -mfpmath=387"}) {
    const bool has_vectors = std::string(flags).find("387") == std::string::npos;
    expect_right({"gcc", "g++", flags, "", has_vectors});
  }
}

TEST_F(CompilerFlags, OfClangChangeLastPlacesOnly) {
  for (const char* flags :
       {"-O0", "-O1", "-O2", "-O3", "-Os", "-Oz", kUnsafe, kReassociates, kFastest, "-O1 -funsafe-math-optimizations",
        "-O2 -freciprocal-math", "-O2 -ffp-contract=fast", "-O2 -ffp-model=strict", "-O2 -fno-honor-infinities",
        "-O2 -fno-signed-zeros", "-O2 -fdenormal-fp-math=positive-zero",
        "-Ofast -fno-finite-math-only -fno-slp-vectorize"}) {
    expect_right({"clang", "clang++", flags, ""});
  }
}

#ifdef __x86_64__
TEST_F(CompilerFlags, OfWiderRegistersChangeLastPlacesOnly) {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) GTEST_SKIP() << "this machine has no AVX2";
  for (const char* flags :
       {"-O3 -mavx2 -mfma", "-O3 -mavx2 -mfma -ffp-contract=fast", "-O2 -mavx",
        "-Ofast -fno-finite-math-only -mavx2 -mfma", "-O3 -march=native -funsafe-math-optimizations"}) {
    expect_right({"gcc", "g++", flags, ""});
    expect_right({"clang", "clang++", flags, ""});
  }
}

// The x87 keeps 64 digits in its registers, whatever the type.
TEST_F(CompilerFlags, OfTheX87ChangeLastPlacesOnly) {
  if (!has("i686-linux-gnu-g++")) GTEST_SKIP() << "not installed: scripts/setup all";
  for (const char* flags : {"-O2", "-O0", "-O3 -march=i686", kFastest, kReassociates, "-O2 -ffloat-store",
                            "-O2 -fexcess-precision=standard", "-O2 -msse2 -mfpmath=sse"}) {
    const std::string of_cpp = std::string(flags).find("standard") == std::string::npos ? flags : "-O2";
    expect_right({"i686-linux-gnu-gcc", "i686-linux-gnu-g++", of_cpp, "", false});
  }
}
#endif

TEST_F(CompilerFlags, OfAnotherProcessorChangeLastPlacesOnly) {
  if (!has("aarch64-linux-gnu-g++") || !has("qemu-aarch64")) GTEST_SKIP() << "not installed: scripts/setup all";
  for (const char* flags : {"-O2", "-O3", kFastest, kReassociates, kUnsafe}) {
    expect_right({"aarch64-linux-gnu-gcc", "aarch64-linux-gnu-g++", flags, "qemu-aarch64", false});
  }
}

// Results cannot be checked without infinities and NaN, and constants are doubles.
TEST_F(CompilerFlags, AreRefusedByNameWhereTheyBreakTheCode) {
  const auto refusal = [](const std::string& compiler, const std::string& flags, const std::string& file) {
    return output_of(fmt::format("{} {} -I . -isystem '{}/runtime/include' -fsyntax-only {}", compiler, flags,
                                 FLATDYN_SOURCE_DIR, file));
  };
  for (const char* file : {"apart.cpp", "pair/pair.cpp", "cuda.cpp", "limbs.cpp"}) {
    EXPECT_THAT(refusal("g++ -std=c++17", "-ffast-math", file), HasSubstr("add -fno-finite-math-only")) << file;
  }
  for (const char* file : {"c_doubles/c_doubles.c", "c_floats/c_floats.c", "c_doubles/c_doubles_batch.c"}) {
    EXPECT_THAT(refusal("gcc -std=c99", "-ffast-math", file), HasSubstr("add -fno-finite-math-only")) << file;
  }
  for (const char* flags : {"-ffast-math", "-Ofast", "-ffinite-math-only"}) {
    for (const char* compiler : {"gcc -std=c99", "clang -std=c99"}) {
      EXPECT_THAT(refusal(compiler, flags, "c_doubles/c_doubles.c"), HasSubstr("add -fno-finite-math-only"))
          << compiler << flags;
    }
  }
  for (const char* file : {"apart.cpp", "pair/pair.cpp", "cuda.cpp"}) {
    EXPECT_THAT(refusal("g++ -std=c++17", "-fsingle-precision-constant", file),
                HasSubstr("compile this without -fsingle-precision-constant"));
  }
  EXPECT_THAT(refusal("gcc -std=c99", "-fsingle-precision-constant", "c_doubles/c_doubles.c"),
              HasSubstr("has_double_constants"));
  EXPECT_EQ(refusal("gcc -std=c99", "-fsingle-precision-constant", "c_floats/c_floats.c"), "");
}

}  // namespace
}  // namespace flatdyn::testing
