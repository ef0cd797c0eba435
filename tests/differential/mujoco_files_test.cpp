// SPDX-License-Identifier: GPL-2.0-or-later
// Robots in MJCF as flatdyn reads them against MuJoCo itself, and code in its convention.
#include <cstdlib>
#include <iterator>
#include <sstream>

#include "support/mujoco_peer.hpp"

namespace flatdyn::mujoco_peer {
namespace {

constexpr double kCloseInDouble = 1e-11;  // for code that is emitted for double

// A program over a robot's header in MuJoCo's convention: per state it reads q, v and a, and prints B, bias, torques,
// and the accelerations by these torques.
constexpr const char* kOfStandardInput = R"(#include <cstdio>
#include "robot_mujoco.hpp"
constexpr int n = robot::velocity_count;
bool read(double* first, int count) {
  for (int k = 0; k < count; ++k) if (std::scanf("%lf", first + k) != 1) return false;
  return true;
}
void print(const double* first, int count) {
  for (int k = 0; k < count; ++k) std::printf("%.17g\n", first[k]);
}
int main() {
  double q[n + 1], v[n], a[n], B[n * n], bias[n], tau[n], again[n], next[n + 1], difference[n];
  while (read(q, n + 1) && read(v, n) && read(a, n)) {
    robot::mujoco::inertia_matrix(q, B);
    robot::mujoco::bias(q, v, bias);
    robot::mujoco::inverse_dynamics(q, v, a, tau);
    if (!robot::mujoco::forward_dynamics(q, v, tau, again)) return 1;
    print(B, n * n); print(bias, n); print(tau, n); print(again, n);
    robot::mujoco::integrate(q, v, 0.7, next);
    robot::mujoco::difference(q, next, difference);
    print(next, n + 1); print(difference, n);
  }
}
)";

// Emitted code in MuJoCo's convention, of a file and at states.
class MujocoConvention : public MujocoFiles {
 protected:
  // The numbers that the program prints, state by state.
  std::vector<double> printed(const fs::path& path, const nlohmann::json& states) {
    std::string input;
    for (const nlohmann::json& s : states) {
      for (const char* name : {"q", "qd", "qdd"}) {
        for (const double x : s[name].get<std::vector<double>>()) input += fmt::format("{} ", x);
      }
    }
    write_file(folder_.path() / "states", input);
    write_file(folder_.path() / "main.cpp", kOfStandardInput);
    const std::string command = fmt::format(
        "({} generate {} --snap 0 --convention mujoco --name robot --namespace robot -o . --functions inertia_matrix,"
        "bias,inverse_dynamics,forward_dynamics && g++ -std=c++17 -Wall -Wextra -Werror main.cpp -o main && ./main < "
        "states > numbers) > log 2>&1",
        shell_word(FLATDYN_PROGRAM), shell_word(path.string()));
    if (run_command(command, folder_.path()) != 0) ADD_FAILURE() << content_of_file(folder_.path() / "log");
    std::istringstream text(content_of_file(folder_.path() / "numbers"));
    return {std::istream_iterator<double>(text), {}};
  }

  // B, bias, torques, accelerations and steps of the emitted code, with n entries of v, at random states.
  void expect_same_in_convention(const fs::path& path, Eigen::Index n) {
    nlohmann::json states = nlohmann::json::array();
    for (const FreeState& s : random_free_states(n)) states.push_back(s.in_mujoco(s.q));
    const nlohmann::json peer = mujoco(for_mujoco(content_of_file(path), {path.filename().string()}), states);
    if (peer.empty()) GTEST_SKIP() << "MuJoCo is not installed: npm install @mujoco/mujoco";
    const std::vector<double> numbers = printed(path, states);
    ASSERT_EQ(numbers.size(), states.size() * (n * n + 5 * n + 1));
    const Vector coulomb = vector_of(peer["coulomb"].get<std::vector<double>>());
    const double* next = numbers.data();
    const auto taken = [&next](Eigen::Index count) {
      next += count;
      return Vector(Eigen::Map<const Vector>(next - count, count));
    };
    for (std::size_t k = 0; k < states.size(); ++k) {
      const nlohmann::json& at = peer["states"][k];
      const auto wanted = [&at](const char* name) { return vector_of(at[name].get<std::vector<double>>()); };
      const auto state = [&](const char* name) { return vector_of(states[k][name].get<std::vector<double>>()); };
      const Vector friction = coulomb.cwiseProduct(state("qd").cwiseSign());
      expect_close(taken(n * n), wanted("B"), "B", kCloseInDouble);
      expect_close(taken(n), wanted("bias") + friction, "bias", kCloseInDouble);
      expect_close(taken(n), wanted("tau") + friction, "tau", kCloseInDouble);
      expect_close(taken(n), state("qdd"), "a", kCloseInDouble);
      expect_close(taken(n + 1), wanted("next"), "next", kCloseInDouble);
      expect_close(taken(n), wanted("difference"), "difference", kCloseInDouble);
    }
  }
};

TEST_F(MujocoConvention, IsThatOfMujoco) {
  const fs::path path = fs::path(FLATDYN_SOURCE_DIR) / ".." / "shared" / "robots" / "mjcf" / "go1.xml";
  if (!fs::exists(path)) GTEST_SKIP() << "no such file: " << path;
  expect_same_in_convention(path, 18);
}

constexpr const char* kJointOfBase = R"(<mujoco>
  <default><joint armature="0.7" damping="1.3" frictionloss="0.4"/></default>
  <worldbody><body name="trunk" pos="0 0 1"><joint name="root" type="free" armature="0.9"/>
    <inertial pos="0.1 -0.2 0.05" mass="2" fullinertia="0.1 0.2 0.25 0.01 -0.02 0.03"/>
    <body name="leg" pos="0.3 0.1 0"><joint name="hip" axis="0 1 0.2"/>
      <inertial pos="0.05 0 -0.2" mass="1" diaginertia="0.02 0.03 0.01"/>
      <body name="foot" pos="0 0 -0.4"><joint name="slide" type="slide" axis="1 0 1"/>
        <inertial pos="0 0.02 -0.1" mass="0.5" diaginertia="0.004 0.003 0.002"/></body></body></body></worldbody></mujoco>)";

// Armature, damping and friction of a free joint, as MuJoCo adds them to its six entries.
TEST_F(MujocoConvention, HasArmatureAndFrictionOfAFreeJoint) {
  write_file(folder_.path() / "trunk.xml", kJointOfBase);
  expect_same_in_convention(folder_.path() / "trunk.xml", 8);
}

class MujocoSharedFiles : public MujocoFiles {};

// In base axes, where Coulomb friction along the axes of the world is left out.
TEST_F(MujocoSharedFiles, MoveWithArmatureAndDampingOfAFreeJointAsInMujoco) {
  compare_text(without(kJointOfBase, R"re(\bfrictionloss="[^"]*")re"));
}

// Springs, dampers and armature of fixed tendons, with what an actuator adds, and springs of which MuJoCo finds the
// length at rest. `root`: a joint of the first body.
std::string hand_with_tendons(const std::string& root) {
  return "<mujoco><worldbody><body name=\"palm\" pos=\"0 0 1\">" + root +
         R"(<inertial pos="0.1 -0.2 0.05" mass="2" fullinertia="0.1 0.2 0.25 0.01 -0.02 0.03"/>
    <body name="proximal" pos="0.3 0.1 0"><joint name="mcp" axis="0 1 0.2" ref="20" springref="30" stiffness="0.5"/>
      <inertial pos="0.05 0 -0.2" mass="1" diaginertia="0.02 0.03 0.01"/>
      <body name="distal" pos="0 0 -0.4"><joint name="pip" axis="0 1 0" springref="-15"/>
        <inertial pos="0 0.02 -0.1" mass="0.5" diaginertia="0.004 0.003 0.002"/></body></body>
    <body name="thumb" pos="0 0.3 0.1"><joint name="slide" type="slide" axis="1 0 1" ref="0.2" springref="0.1"/>
      <inertial pos="0 0.02 -0.1" mass="0.5" diaginertia="0.004 0.003 0.002"/></body></body></worldbody>
  <tendon><fixed name="flexor" stiffness="30" springlength="0.4" damping="2.5" armature="0.3">
      <joint joint="mcp" coef="0.8"/><joint joint="pip" coef="-1.5"/></fixed>
    <fixed name="mixed" stiffness="70" damping="0.2"><joint joint="pip" coef="2"/><joint joint="slide" coef="3"/></fixed>
    <fixed name="driven"><joint joint="mcp" coef="1"/><joint joint="pip" coef="0.5"/></fixed></tendon>
  <actuator><motor tendon="driven" gear="6" armature="0.01" damping="0.02"/></actuator></mujoco>)";
}

TEST_F(MujocoSharedFiles, TendonsPullAsInMujoco) {
  compare_text(hand_with_tendons(R"(<joint name="root" axis="1 0 0"/>)"));
  compare_text(hand_with_tendons("<freejoint/>"));
}

// The positions that are reached hold MuJoCo's equalities.
TEST_F(MujocoSharedFiles, TendonsCoupleAsInMujoco) {
  for (const char* equality : {R"(<tendon tendon1="flexor" polycoef="0.3"/>)",
                               R"(<tendon tendon1="flexor" tendon2="mixed" polycoef="-0.2 0.7 0 0 0"/>)"}) {
    std::string text = hand_with_tendons(R"(<joint name="root" axis="1 0 0"/>)");
    text.insert(text.find("<actuator>"), std::string("<equality>") + equality + "</equality>");
    compare_text(text);
  }
}

// Real files lie beside the checkout, in ../shared/robots/mjcf.
TEST_P(MujocoSharedFiles, MoveAsInMujoco) {
  const fs::path path = fs::path(FLATDYN_SOURCE_DIR) / ".." / "shared" / "robots" / "mjcf" / GetParam().name;
  if (!fs::exists(path)) GTEST_SKIP() << "no such file: " << path;
  compare(path, GetParam());
}

std::string name_of(const ::testing::TestParamInfo<MjcfFile>& info) {
  std::string name = fs::path(info.param.name).stem().string();
  for (const std::string& each : info.param.ignored) name += "_without_" + each;
  for (const std::string& each : info.param.held) name += "_held_" + each;
  return name;
}

INSTANTIATE_TEST_SUITE_P(Files, MujocoSharedFiles,
                         ::testing::Values(MjcfFile{"ur5e.xml"}, MjcfFile{"panda_nohand.xml"}, MjcfFile{"iiwa14.xml"},
                                           MjcfFile{"gym_hopper.xml"}, MjcfFile{"gym_pusher_v5.xml"},
                                           MjcfFile{"panda.xml"}, MjcfFile{"shadow_right_hand.xml"},
                                           MjcfFile{"gym_half_cheetah.xml"}, MjcfFile{"2f85.xml", {"mesh"}},
                                           MjcfFile{"go1.xml", {}, {"trunk_joint"}},
                                           MjcfFile{"anymal_c.xml", {}, {"base_joint"}},
                                           MjcfFile{"g1_29dof.xml", {}, {"floating_base_joint"}},
                                           MjcfFile{"gym_humanoid.xml", {}, {"root"}}, MjcfFile{"go1.xml"},
                                           MjcfFile{"anymal_c.xml"}, MjcfFile{"g1_29dof.xml"},
                                           MjcfFile{"gym_humanoid.xml"}),
                         name_of);

}  // namespace
}  // namespace flatdyn::mujoco_peer
