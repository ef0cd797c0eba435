// SPDX-License-Identifier: GPL-2.0-or-later
// Functions that return bool, called where their result means nothing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

constexpr const char* kStrict = "-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror";

// Writes a robot file and the code that the program makes of it.
void generate_from(const TemporaryFolder& folder, const std::string& robot, const std::string& options,
                   const std::string& function = "forward_dynamics") {
  write(folder.path() / "arm.toml", robot);
  const std::string printed = output_of(
      folder.path(), fmt::format("{} generate arm.toml --functions {} {} -o .", FLATDYN_PROGRAM, function, options));
  ASSERT_EQ(printed.rfind("failed", 0), std::string::npos) << printed;
}

// A mass at the end of two links that have none: B is singular where both are in line.
constexpr const char* kPointMass = R"(
name = "arm"
gravity = [0, 0, 0]
[[link]]
[[link]]
xyz = [0.7, 0, 0]
rpy = [0, 0, 0.7]
mass = 2.3
com = [0.4, 0, 0]
)";

// Counts the states at which the function returns true although an acceleration is off by more than a quarter of the
// larger one: a pivot that just counts has errors of some 1/32 of it. Half of the states are within 1e-7 rad of the
// singularity. The exact accelerations are those of a point mass: det B = (m a_1 a_2 sin)², which loses no digits.
constexpr const char* kPointMassProgram = R"(
#include <cmath>
#include <cstdio>
#include <random>
#include "arm.hpp"

template <class Scalar>
int wrong_ones(double width) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> turn(-3.14159, 3.14159), near(-width, width), rate(-1, 1);
  int wrong = 0;
  for (int k = 0; k < 100000; ++k) {
    const Scalar q[2] = {Scalar(turn(engine)), Scalar(k % 2 == 0 ? turn(engine) : near(engine) - 0.7)};
    const Scalar qd[2] = {Scalar(rate(engine)), Scalar(rate(engine))}, tau[2] = {Scalar(rate(engine)), Scalar(rate(engine))};
    Scalar qdd[2];
    if (!arm::forward_dynamics(q, qd, tau, qdd)) continue;
    const long double m = 2.3L, a = 0.7L, b = 0.4L, angle = static_cast<long double>(q[1]) + 0.7L;
    const long double s = std::sin(angle), c = std::cos(angle), first = qd[0], both = first + qd[1];
    const long double r1 = tau[0] + m * a * b * s * (both * both - first * first), r2 = tau[1] - m * a * b * s * first * first;
    const long double b11 = m * (a * a + b * b + 2 * a * b * c), b12 = m * b * (b + a * c), b22 = m * b * b;
    const long double det = m * m * a * a * b * b * s * s;
    const long double exact[2] = {(b22 * r1 - b12 * r2) / det, (b11 * r2 - b12 * r1) / det};
    const long double size = std::fmax(std::fabs(exact[0]), std::fabs(exact[1]));
    for (int i = 0; i < 2; ++i) wrong += std::fabs(qdd[i] - exact[i]) > 0.25L * size;
  }
  return wrong;
}

int main() { std::printf("%d %d\n", wrong_ones<double>(1e-7), wrong_ones<float>(1e-3)); }
)";

TEST(Validity, IsFalseNearARareSingularity) {
  const TemporaryFolder folder;
  generate_from(folder, kPointMass, "");
  write(folder.path() / "main.cpp", kPointMassProgram);
  EXPECT_EQ(output_of(folder.path(), "g++ -std=c++17 -O2 -Wall -Werror main.cpp -o main && ./main"), "0 0\n");
}

// A slider-crank in which the slider drives: singular where crank and rod are in line.
constexpr const char* kSliderCrank = R"(
name = "arm"
[[link]]
name = "crank"
joint = "a"
mass = 1
com = [0.07, 0, 0]
[[link]]
name = "rod"
joint = "b"
xyz = [0.15, 0, 0]
mass = 1
com = [0.15, 0, 0]
[[link]]
name = "slider"
joint = "x"
type = "prismatic"
parent = "base"
axis = [1, 0, 0]
mass = 1
[[loop]]
links = ["rod", "slider"]
from = [0.3, 0, 0]
dependent = ["a", "b"]
[assembly]
a = 0.3
b = -0.45
x = 0.44
)";

// Counts the positions, down to 1e-8 rad from the singularity, at which the rates of the joints are there in float, and
// those at which they are off by more than 2 %.
constexpr const char* kSliderCrankProgram = R"(
#include <cmath>
#include <cstdio>
#include <random>
#include "arm.hpp"

int main() {
  std::mt19937 engine(1);
  std::uniform_real_distribution<float> turn(-3.14159f, 3.14159f), exponent(-8.0f, 0.0f);
  int held = 0, wrong = 0;
  for (int k = 0; k < 100000; ++k) {
    const float q[3] = {turn(engine), std::pow(10.0f, exponent(engine)), 0.44f};
    const double exact_q[3] = {q[0], q[1], q[2]};
    const float qd[1] = {1}, qdd[1] = {0};
    const double exact_qd[1] = {1}, exact_qdd[1] = {0};
    float rates[3], accelerations[3];
    double exact[3], exact_accelerations[3];
    if (!arm::loop_motion(q, qd, qdd, rates, accelerations)) continue;
    ++held;
    if (!arm::loop_motion(exact_q, exact_qd, exact_qdd, exact, exact_accelerations)) continue;
    for (int i = 0; i < 3; ++i) wrong += std::fabs(rates[i] - exact[i]) > 0.02 * std::hypot(exact[0], exact[1]);
  }
  std::printf("%d %d\n", held > 40000, wrong);
}
)";

TEST(Validity, IsFalseNearASingularLoopInFloat) {
  const TemporaryFolder folder;
  generate_from(folder, kSliderCrank, "", "loop_motion");
  write(folder.path() / "main.cpp", kSliderCrankProgram);
  EXPECT_EQ(output_of(folder.path(), "g++ -std=c++17 -O2 -Wall -Werror main.cpp -o main && ./main"), "1 0\n");
}

constexpr const char* kSoundArm = R"(
name = "arm"
[[link]]
mass = 1
com = [0.3, 0, 0]
inertia_about = "com"
inertia = { xx = 1, yy = 1, zz = 1 }
[[link]]
xyz = [0.7, 0, 0]
mass = 2.3
com = [0.4, 0, 0]
inertia_about = "com"
inertia = { xx = 1, yy = 1, zz = 1 }
)";

// The states: a sound one, then each input not a number, infinite, or so large that something overflows.
constexpr const char* kArmStates = R"(
static const double nan_ = NAN, inf = INFINITY;
static const double states[8][6] = {{1, 2, 3, 4, 5, 6},      {1, 2, 3, 4, nan_, 6}, {1, 2, 3, 4, 5, -inf},
                                    {1, 2, nan_, 4, 5, 6},   {1, 2, 3, inf, 5, 6},  {1, 2, 1e200, 4, 5, 6},
                                    {1, nan_, 3, 4, 5, 6},   {1, inf, 3, 4, 5, 6}};
)";

constexpr const char* kOnlyTheFirst = "1 0 0 0 0 0 0 0 ";

TEST(Validity, IsFalseForWhatIsNotFiniteInCpp) {
  const TemporaryFolder folder;
  generate_from(folder, kSoundArm, "");
  write(folder.path() / "main.cpp", std::string("#include <cmath>\n#include <cstdio>\n#include \"arm.hpp\"\n") +
                                        kArmStates +
                                        R"(
template <class Scalar>
void print() {
  for (const auto& state : states) {
    Scalar x[6], qdd[2];
    for (int k = 0; k < 6; ++k) x[k] = static_cast<Scalar>(state[k]);
    std::printf("%d ", arm::forward_dynamics(x, x + 2, x + 4, qdd));
  }
}

int main() {
  print<double>();
  print<float>();
}
)");
  EXPECT_EQ(output_of(folder.path(), fmt::format("g++ -std=c++17 {} main.cpp -o main && ./main", kStrict)),
            std::string(kOnlyTheFirst) + kOnlyTheFirst);
}

// A batch has not-a-numbers for the states that a call refuses.
TEST(Validity, IsFalseForWhatIsNotFiniteInCAndABatchSaysItByState) {
  const TemporaryFolder folder;
  generate_from(folder, kSoundArm, "--python");
  write(folder.path() / "main.c", std::string("#include <math.h>\n#include <stdio.h>\n#include \"arm.h\"\n") +
                                      kArmStates +
                                      R"(
// The function behind the Python module's batches.
void arm_forward_dynamics_batch(size_t count, const double* q, size_t q_step, const double* qd, size_t qd_step,
                                const double* tau, size_t tau_step, double* qdd);

int main(void) {
  double q[16], qd[16], tau[16], qdd[16];
  for (int s = 0; s < 8; ++s) {
    double one[2];
    printf("%d ", arm_forward_dynamics(states[s], states[s] + 2, states[s] + 4, one));
    for (int i = 0; i < 2; ++i) {
      q[2 * s + i] = states[s][i];
      qd[2 * s + i] = states[s][2 + i];
      tau[2 * s + i] = states[s][4 + i];
    }
  }
  arm_forward_dynamics_batch(8, q, 2, qd, 2, tau, 2, qdd);
  for (int s = 0; s < 8; ++s) printf("%d ", isfinite(qdd[2 * s]) && isfinite(qdd[2 * s + 1]));
}
)");
  EXPECT_EQ(output_of(folder.path(), fmt::format("gcc {} main.c arm.c arm_batch.c -lm -o main && ./main", kStrict)),
            std::string(kOnlyTheFirst) + kOnlyTheFirst);
}

TEST(Validity, IsFalseForWhatIsNotFiniteInJavascript) {
  if (std::system("node --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no node";
  const TemporaryFolder folder;
  generate_from(folder, kSoundArm, "--language javascript");
  std::string states = kArmStates;
  for (const auto& [from, to] :
       {std::pair("static const double nan_ = NAN, inf = INFINITY;\n", "const nan_ = NaN, inf = Infinity;\n"),
        {"static const double states[8][6] = {{", "const states = [["},
        {"}};", "]];"}}) {
    states.replace(states.find(from), std::string(from).size(), to);
  }
  for (std::size_t at = 0; (at = states.find_first_of("{}", at)) != std::string::npos;) {
    states[at] = states[at] == '{' ? '[' : ']';
  }
  write(folder.path() / "main.mjs", "import * as arm from './arm.mjs';\n" + states + R"(
let text = '';
for (const s of states) {
  text += `${Number(arm.forward_dynamics(s.slice(0, 2), s.slice(2, 4), s.slice(4), new Float64Array(2)))} `;
}
process.stdout.write(text);
)");
  EXPECT_EQ(output_of(folder.path(), "cp arm.js arm.mjs && node main.mjs"), kOnlyTheFirst);
}

}  // namespace
}  // namespace flatdyn::testing
