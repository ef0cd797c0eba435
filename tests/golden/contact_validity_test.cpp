// SPDX-License-Identifier: GPL-2.0-or-later
// The promise of `true` in functions about contacts: a search climbs to the states with the largest errors, of a
// quadruped on four feet, a humanoid on two soles, and an arm on a free body. Errors in double are those beside long
// double, and in float those beside double. They are in parts of the largest of what a function adds up: accelerations
// with and without contacts, velocities before an impact, torques without contacts. Each error is in the norm in which
// joint k counts with the square root of b_kk.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>
#include <sstream>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

constexpr const char* kClimbingProgram = R"(
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>
#include "robot.hpp"

using namespace robot;
constexpr int n = velocity_count, joints = joint_count, rows = ROWS;

struct ClimbState {
  std::vector<double> x;  // q, g_b, v, tau or a
};

template <class T>
struct Inputs {
  T q[joints], g[3], v[n], u[n];
  explicit Inputs(const ClimbState& s) {
    const double* x = s.x.data();
    for (T& each : q) each = T(*x++);
    for (T& each : g) each = T(*x++);
    for (T& each : v) each = T(*x++);
    for (T& each : u) each = T(*x++);
  }
  template <class U>
  explicit Inputs(const Inputs<U>& of) {
    for (int k = 0; k < joints; ++k) q[k] = of.q[k];
    for (int k = 0; k < 3; ++k) g[k] = of.g[k];
    for (int k = 0; k < n; ++k) v[k] = of.v[k], u[k] = of.u[k];
  }
};

struct Error {
  double motion = 0, force = 0, condition = 0;
};

template <class T, class U>
double norm(const T* a, const U* b, const long double* weights, int count) {
  long double sum = 0;
  for (int k = 0; k < count; ++k) {
    const long double d = static_cast<long double>(a[k]) - (b ? static_cast<long double>(b[k]) : 0.0L);
    sum += d * d * (weights ? weights[k * (count + 1)] : 1.0L);
  }
  return double(std::sqrt(sum));
}

// The error of a function, T beside Exact; nothing if it returns false.
template <class T, class Exact>
bool error_of(int function, const ClimbState& state, Error& error) {
  const Inputs<T> in(state);
  const Inputs<Exact> ex(in);
  static long double B[n * n];
  T a[n], f[rows], c[1];
  Exact A[n], F[rows], C[1], none[n];
  {
    const Inputs<long double> wide(in);
    inertia_matrix(wide.q, B);
  }
  double size = 0;
  if (function == 0) {
    if (!constrained_forward_dynamics(in.q, in.g, in.v, in.u, a, f, c)) return false;
    if (!constrained_forward_dynamics(ex.q, ex.g, ex.v, ex.u, A, F, C)) return false;
    if (!forward_dynamics(ex.q, ex.g, ex.v, ex.u, none)) return false;
    size = norm<Exact, Exact>(none, nullptr, B, n);
  } else if (function == 1) {
    if (!contact_impact(in.q, in.v, a, f, c)) return false;
    if (!contact_impact(ex.q, ex.v, A, F, C)) return false;
    size = norm<Exact, Exact>(ex.v, nullptr, B, n);
  } else {
    if (!contact_inverse_dynamics(in.q, in.g, in.v, in.u, a, f, c)) return false;
    if (!contact_inverse_dynamics(ex.q, ex.g, ex.v, ex.u, A, F, C)) return false;
    inverse_dynamics(ex.q, ex.g, ex.v, ex.u, none);
    size = norm<Exact, Exact>(none, nullptr, nullptr, n);
  }
  const long double* const weights = function == 2 ? nullptr : B;
  size = std::fmax(size, norm<Exact, Exact>(A, nullptr, weights, n));
  error = {norm(a, A, weights, n) / size, norm(f, F, nullptr, rows) / norm<Exact, Exact>(F, nullptr, nullptr, rows),
           double(c[0])};
  return true;
}

// Climbs from random states to the largest error of accelerations or torques, and of forces; of states whose condition
// is at least `least`. Every eighth state is near a straight pose: all joints are near 0, or one of them.
template <class T, class Exact>
void climb(const char* name, int function, double least, unsigned seed, int steps) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::normal_distribution<double> normal;
  ClimbState best;
  double worst = 0, worst_of_forces = 0;
  int held = 0, tried = 0;
  for (int k = 0; k < steps; ++k) {
    ClimbState s;
    if (best.x.empty() || k % 4 == 0) {
      const double near = k % 8 == 0 ? std::pow(10, -2 - 6 * std::fabs(unit(engine))) : 1;
      const int only = int(joints * std::fabs(unit(engine)));
      for (int i = 0; i < joints; ++i) s.x.push_back((k % 16 == 0 || i == only ? near : 1) * unit(engine));
      for (int i = 0; i < 3; ++i) s.x.push_back(9.81 * unit(engine));
      for (int i = 0; i < 2 * n; ++i) s.x.push_back(unit(engine));
    } else {
      s = best;
      const double size = std::pow(10, -4 * std::fabs(unit(engine)));
      for (double& x : s.x)
        if (unit(engine) > 0.5) x += size * normal(engine) * (unit(engine) > 0 ? std::fabs(x) : 1);
      for (double& x : s.x) x = std::fmax(-10, std::fmin(10, x));
    }
    Error error;
    ++tried;
    if (!error_of<T, Exact>(function, s, error) || error.condition < least) continue;
    ++held;
    worst_of_forces = std::fmax(worst_of_forces, error.force);
    if (error.motion > worst) worst = error.motion, best = s;
  }
  std::printf("%s %d, condition >= %g: %.2g, forces %.2g, true at %.0f %%\n", name, function, least,
              worst, worst_of_forces,
              100.0 * held / tried);
}

int main() {
  for (int function = 0; function < 3; ++function) {
    for (double least : {0.0, 0.01, 0.1}) {
      climb<double, long double>("double", function, least, 1, STEPS);
      climb<float, double>("float", function, least, 1, STEPS);
    }
  }
}
)";

struct Standing {
  const char *name, *robot, *scene;
  int rows, steps;
};

void PrintTo(const Standing& standing, std::ostream* out) { *out << standing.name; }

class ContactValidity : public ::testing::TestWithParam<Standing> {};

// Lines are "float 0, condition >= 0.01: 0.0072, forces 0.0053, true at 98 %".
TEST_P(ContactValidity, PromisesAFewHundredths) {
  const Standing& of = GetParam();
  const TemporaryFolder folder;
  const std::string robot =
      of.robot[0] == '\n' ? "robot.toml" : fmt::format("{}/robots/{}", FLATDYN_SOURCE_DIR, of.robot);
  if (of.robot[0] == '\n') write(folder.path() / "robot.toml", of.robot);
  write(folder.path() / "scene.toml", of.scene);
  write(folder.path() / "main.cpp", kClimbingProgram);
  const std::string printed = output_of(
      folder.path(),
      fmt::format(
          "'{}' generate '{}' -q --base floating --scene scene.toml --name robot --namespace robot -o . --functions "
          "inertia_matrix,inverse_dynamics,forward_dynamics,constrained_forward_dynamics,contact_impact,"
          "contact_inverse_dynamics && g++ -std=c++17 -O1 -ffp-contract=off -D ROWS={} -D STEPS={} main.cpp -o main "
          "&& ./main",
          FLATDYN_PROGRAM, robot, of.rows, of.steps));
  ASSERT_EQ(printed.rfind("failed", 0), std::string::npos) << printed;
  std::istringstream lines(printed);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    double motion = 1, forces = 1, least = 0;
    const std::string behind = line.substr(line.find(">= "));
    ASSERT_EQ(std::sscanf(behind.c_str(), ">= %lf: %lf, forces %lf", &least, &motion, &forces), 3) << line;
    EXPECT_LT(motion, 0.1) << line;
    EXPECT_LT(forces, 0.1) << line;
  }
  EXPECT_EQ(count, 18) << printed;
  std::cout << printed;
}

constexpr const char* kArm = R"(
name = "arm2"
[base]
name = "body"
motion = "floating"
mass = 5
com = [0.01, 0, 0]
inertia = { xx = 0.1, yy = 0.1, zz = 0.2 }
inertia_about = "com"
[[link]]
name = "upper"
xyz = [0.1, 0, 0]
axis = [0, 0, 1]
mass = 1
com = [0.2, 0, 0]
inertia = { xx = 0.001, yy = 0.02, zz = 0.02 }
inertia_about = "com"
[[link]]
name = "middle"
xyz = [0.4, 0, 0]
axis = [0, 1, 0]
mass = 1
com = [0.2, 0, 0]
inertia = { xx = 0.001, yy = 0.02, zz = 0.02 }
inertia_about = "com"
[[link]]
name = "lower"
xyz = [0.4, 0, 0]
axis = [0, 1, 0]
mass = 1
com = [0.15, 0, 0]
inertia = { xx = 0.001, yy = 0.01, zz = 0.01 }
inertia_about = "com"
)";

constexpr const char* kOfArm = R"(
[[contact]]
link = "body"
position = [-0.1, 0, 0]
[[contact]]
link = "upper"
position = [0.3, 0, 0]
[[contact]]
link = "lower"
position = [0.3, 0, 0]
)";

constexpr const char* kFeet = R"(
[[contact]]
link = "FL_FOOT"
[[contact]]
link = "FR_FOOT"
[[contact]]
link = "HL_FOOT"
[[contact]]
link = "HR_FOOT"
)";

constexpr const char* kSoles = R"(
[[contact]]
link = "R_ANKLE_P_S"
type = "surface"
[[contact]]
link = "L_ANKLE_P_S"
type = "surface"
)";

INSTANTIATE_TEST_SUITE_P(Robots, ContactValidity,
                         ::testing::Values(Standing{"arm", kArm, kOfArm, 9, 5000},
                                           Standing{"quadruped12", "quadruped12.urdf", kFeet, 12, 20000},
                                           Standing{"humanoid32", "humanoid32.urdf", kSoles, 12, 20000}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace flatdyn::testing
