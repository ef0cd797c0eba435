// SPDX-License-Identifier: GPL-2.0-or-later
// Robots with a floating base against DART: the code that is emitted for them, in every convention, and the reference.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iterator>
#include <sstream>

#include "flatdyn/reference/newton_euler.hpp"
#include "functions/load/load_robot.hpp"
#include "support/dart_tree.hpp"
#include "support/mujoco_peer.hpp"
#include "support/names.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;
using mujoco_peer::FreeState;
using mujoco_peer::random_free_states;
using testing::DartTree;
using Vector = DartTree::Vector;
using Matrix = DartTree::Matrix;
using Vector3 = DartTree::Vector3;

// Differences allowed, of the largest entry: of what is added up, and of accelerations, which B's condition multiplies.
constexpr double kCloseToDart = 1e-14, kCloseSolutions = 1e-11;

// Functions of a robot at a state; `a` are the accelerations by the torques.
struct Values {
  Matrix B;
  Vector gravity, bias, tau, a;
};

double relative_difference(const Matrix& found, const Matrix& wanted) {
  return (found - wanted).cwiseAbs().maxCoeff() / wanted.cwiseAbs().maxCoeff();
}

void expect_same(const Values& found, const Values& dart, const std::string& where) {
  EXPECT_LE(relative_difference(found.B, dart.B), kCloseToDart) << "B, " << where;
  EXPECT_LE(relative_difference(found.gravity, dart.gravity), kCloseToDart) << "gravity, " << where;
  EXPECT_LE(relative_difference(found.bias, dart.bias), kCloseToDart) << "bias, " << where;
  EXPECT_LE(relative_difference(found.tau, dart.tau), kCloseToDart) << "tau, " << where;
  EXPECT_LE(relative_difference(found.a, dart.a), kCloseSolutions) << "a, " << where;
}

// The meaning of a convention's numbers (docs/conventions.md).
struct Meaning {
  const char* name;
  bool linear_in_world = false, angular_in_world = false, scalar_last = false, angular_first = false;
};

constexpr Meaning kMeanings[] = {{.name = "pose"},
                                 {.name = "pinocchio", .scalar_last = true},
                                 {.name = "mujoco", .linear_in_world = true},
                                 {.name = "mixed", .linear_in_world = true, .angular_in_world = true},
                                 {.name = "featherstone", .angular_first = true}};

// A state in a convention, and values of DART there.
class StateInConvention {
 public:
  StateInConvention(const Meaning& meaning, const FreeState& state)
      : meaning_(meaning), state_(state), drift_(Vector::Zero(state.v.size())) {
    const Eigen::Index n = state.v.size();
    T_.setIdentity(n, n);
    if (meaning.linear_in_world) T_.topLeftCorner<3, 3>() = state.R;
    if (meaning.angular_in_world) T_.block<3, 3>(3, 3) = state.R;
    if (meaning.angular_first) T_.topRows<3>().swap(T_.middleRows<3>(3));
    if (meaning.linear_in_world) drift_.head<3>() = state.R * state.coriolis();
  }

  Vector q() const {
    const Eigen::Quaterniond& turn = state_.orientation;
    Eigen::Vector4d quaternion(turn.w(), turn.x(), turn.y(), turn.z());
    if (meaning_.scalar_last) quaternion << turn.vec(), turn.w();
    Vector all(7 + state_.q.size());
    all << state_.position, quaternion, state_.q;
    return all;
  }
  Vector v() const { return T_ * state_.v; }
  Vector a() const { return T_ * state_.a + drift_; }

  // T is orthogonal, so it transforms forces, too.
  Values values(DartTree& dart) const {
    const Vector tau = dart.inverse_dynamics(state_.q, state_.v, state_.a);
    const Vector bias = meaning_.linear_in_world ? dart.inverse_dynamics(state_.q, state_.v, -T_.transpose() * drift_)
                                                 : dart.bias(state_.q, state_.v);
    return {T_ * dart.inertia_matrix(state_.q) * T_.transpose(), T_ * dart.gravity(state_.q), T_ * bias, T_ * tau,
            T_ * dart.forward_dynamics(state_.q, state_.v, tau) + drift_};
  }

 private:
  const Meaning& meaning_;
  const FreeState& state_;
  Matrix T_;      // from flatdyn's velocities to the convention's
  Vector drift_;  // what accelerations have beside T times flatdyn's
};

// A program that reads q, v, a and tau of a state in each convention and prints values at all of them.
std::string program_of_conventions() {
  std::string text =
      "#include <cstdio>\n"
      "static bool read(double* first, int count) {\n"
      "  for (int k = 0; k < count; ++k) if (std::scanf(\"%lf\", first + k) != 1) return false;\n"
      "  return true;\n}\n"
      "static void print(const double* first, int count) {\n"
      "  for (int k = 0; k < count; ++k) std::printf(\"%.17g\\n\", first[k]);\n}\n";
  std::string calls;
  for (const Meaning& meaning : kMeanings) {
    text += fmt::format("#include \"robot_{}.hpp\"\n", meaning.name);
    calls += fmt::format(R"(
    if (!read(q, n + 1) || !read(v, n) || !read(a, n) || !read(tau, n)) return 0;
    robot::{0}::inertia_matrix(q, B);
    robot::{0}::gravity(q, g);
    robot::{0}::bias(q, v, bias);
    robot::{0}::inverse_dynamics(q, v, a, torques);
    if (!robot::{0}::forward_dynamics(q, v, tau, found)) return 1;
    print(B, n * n); print(g, n); print(bias, n); print(torques, n); print(found, n);
)",
                         meaning.name);
  }
  return text +
         "constexpr int n = robot::velocity_count;\n"
         "double q[n + 1], v[n], a[n], tau[n], B[n * n], g[n], bias[n], torques[n], found[n];\n"
         "int main() {\n  for (;;) {" +
         calls + "  }\n}\n";
}

// Robots in robots/ whose joints have neither friction nor rotors, with a floating base.
class Dart : public ::testing::TestWithParam<const char*> {
 protected:
  Dart() : path_(fs::path(FLATDYN_SOURCE_DIR) / "robots" / GetParam()) {
    LoadOptions options;
    options.read.floating_base = true;
    numbers_ = reference_robot<double>(load_robot(path_, options).robot, {});
    states_ = random_free_states(numbers_.size());
  }

  // The robot with the gravity of a state in base axes.
  reference::Robot<double> robot_at(const FreeState& state) const {
    reference::Robot<double> robot = numbers_;
    robot.gravity = state.R.transpose() * numbers_.gravity;
    return robot;
  }

  static Vector3 turn_of(const FreeState& state) {
    const Eigen::AngleAxisd turn(state.orientation);
    return turn.angle() * turn.axis();
  }

  // The numbers that the emitted code prints at the input.
  std::vector<double> printed(const std::string& input) const {
    const TemporaryFolder folder;
    write_file(folder.path() / "states", input);
    write_file(folder.path() / "main.cpp", program_of_conventions());
    const std::string command = fmt::format(
        "({} generate {} --base floating --convention pose,pinocchio,mujoco,mixed,featherstone --name robot "
        "--namespace robot "
        "-o . --functions inertia_matrix,gravity,bias,inverse_dynamics,forward_dynamics && "
        "g++ -std=c++17 main.cpp -o main && ./main < states > numbers) > log 2>&1",
        shell_word(FLATDYN_PROGRAM), shell_word(path_.string()));
    if (run_command(command, folder.path()) != 0) ADD_FAILURE() << content_of_file(folder.path() / "log");
    std::istringstream text(content_of_file(folder.path() / "numbers"));
    return {std::istream_iterator<double>(text), {}};
  }

  fs::path path_;
  reference::Robot<double> numbers_;
  std::vector<FreeState> states_;
};

TEST_P(Dart, AgreesWithTheReference) {
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const FreeState& state = states_[k];
    const reference::Robot<double> robot = robot_at(state);
    DartTree dart(robot, turn_of(state));
    const Vector tau = reference::inverse_dynamics(robot, state.q, state.v, state.a);
    const Values found = {reference::inertia_matrix(robot, state.q), reference::gravity(robot, state.q),
                          reference::bias(robot, state.q, state.v), tau,
                          reference::forward_dynamics(robot, state.q, state.v, tau)};
    expect_same(found, StateInConvention(kMeanings[0], state).values(dart), fmt::format("state {}", k));
  }
}

TEST_P(Dart, AgreesWithEmittedCodeInEveryConvention) {
  std::string input;
  std::vector<Values> wanted;
  for (const FreeState& state : states_) {
    const reference::Robot<double> robot = robot_at(state);
    DartTree dart(robot, turn_of(state));
    for (const Meaning& meaning : kMeanings) {
      const StateInConvention at(meaning, state);
      wanted.push_back(at.values(dart));
      for (const Vector& given : {at.q(), at.v(), at.a(), wanted.back().tau}) {
        for (const double x : given) input += fmt::format("{} ", x);
      }
    }
  }
  const std::vector<double> numbers = printed(input);
  const Eigen::Index n = numbers_.size();
  ASSERT_EQ(numbers.size(), wanted.size() * static_cast<std::size_t>(n * n + 4 * n));
  const double* next = numbers.data();
  const auto taken = [&](Eigen::Index columns) {
    next += n * columns;
    return Matrix(Eigen::Map<const Matrix>(next - n * columns, n, columns));
  };
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const Matrix B = taken(n);  // symmetric: rows or columns
    const Vector gravity = taken(1), bias = taken(1), tau = taken(1), a = taken(1);
    const std::size_t conventions = std::size(kMeanings);
    expect_same({B, gravity, bias, tau, a}, wanted[k],
                fmt::format("{}, state {}", kMeanings[k % conventions].name, k / conventions));
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Dart, ::testing::Values("quadruped12.urdf", "humanoid32.urdf"),
                         testing::name_of_text<const char*>);

}  // namespace
}  // namespace flatdyn
