// SPDX-License-Identifier: GPL-2.0-or-later
// Emitted code against Pinocchio, from the package that scripts/setup installs in build/peers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

// Functions that robots with any base have, those of a floating base, and those at contacts.
constexpr const char* kOfAnyBase =
    "inverse_dynamics,inverse_dynamics_tip_force,inertia_matrix,coriolis_matrix,gravity,bias,forward_dynamics,"
    "momentum,coriolis_transpose_qd,kinetic_energy,potential_energy,forward_kinematics,link_poses,jacobian,jacobian_"
    "dot_qd,"
    "frame_velocity,frame_acceleration,inverse_dynamics_derivatives,forward_dynamics_derivatives,regressor";
constexpr const char* kOfFloatingBase =
    ",inverse_dynamics_floating,centroidal_momentum_matrix,centroidal_bias,centre_of_mass,contact_inverse_dynamics";
constexpr const char* kSteps =
    ",step:semi_implicit_euler,step_derivatives:semi_implicit_euler,step:rk4,step:implicit_midpoint";
// Derivatives of steps that grow with the cube of the number of joints.
constexpr const char* kLongSteps = ",step_derivatives:rk4,step_derivatives:implicit_midpoint";
constexpr const char* kAtContacts = ",contact_jacobian,contact_bias,constrained_forward_dynamics,contact_impact";

// A tree with every type of joint, names out of alphabetical order, axes at any angle, and friction. A link is fixed.
constexpr const char* kTree = R"(<robot name="tree">
  <link name="ground"><inertial><origin xyz="0.02 0.03 -0.04" rpy="0.1 0.3 -0.2"/><mass value="3.5"/>
    <inertia ixx="0.05" iyy="0.07" izz="0.06" ixy="0.003" ixz="-0.004" iyz="0.002"/></inertial></link>
  <joint name="z_lift" type="prismatic"><parent link="ground"/><child link="carriage"/>
    <origin xyz="0.1 -0.2 0.3" rpy="0.3 -0.5 0.7"/><axis xyz="0.48 0.6 0.64"/>
    <limit lower="-2" upper="2" velocity="3" effort="50"/><dynamics damping="1.5" friction="0.7"/></joint>
  <link name="carriage"><inertial><origin xyz="0.03 -0.02 0.05" rpy="0.2 0.1 -0.3"/><mass value="2.5"/>
    <inertia ixx="0.02" iyy="0.03" izz="0.025" ixy="0.001" ixz="-0.002" iyz="0.003"/></inertial></link>
  <joint name="turn" type="continuous"><parent link="carriage"/><child link="plate"/>
    <origin xyz="0.2 0.1 -0.1" rpy="-0.4 0.2 0.9"/><axis xyz="-0.36 0.48 0.8"/>
    <limit velocity="3" effort="50"/><dynamics damping="0.3"/></joint>
  <link name="plate"><inertial><origin xyz="-0.04 0.06 0.01"/><mass value="1.2"/>
    <inertia ixx="0.012" iyy="0.009" izz="0.011" ixy="-0.001" ixz="0.0005" iyz="0.0008"/></inertial></link>
  <joint name="weld" type="fixed"><parent link="plate"/><child link="block"/>
    <origin xyz="0.05 0.02 -0.07" rpy="0.6 0.1 0.2"/></joint>
  <link name="block"><inertial><origin xyz="0.01 0.02 0.03" rpy="0.5 0 0.1"/><mass value="0.4"/>
    <inertia ixx="0.003" iyy="0.002" izz="0.0025" ixy="0.0002" ixz="0" iyz="-0.0001"/></inertial></link>
  <joint name="bend" type="revolute"><parent link="block"/><child link="hand"/>
    <origin xyz="0 0.15 0.05" rpy="0.1 1.1 -0.6"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" velocity="3" effort="50"/><dynamics friction="0.4"/></joint>
  <link name="hand"><inertial><origin xyz="0.02 0.01 0.12"/><mass value="0.8"/>
    <inertia ixx="0.006" iyy="0.005" izz="0.003" ixy="0.0004" ixz="-0.0003" iyz="0.0002"/></inertial></link>
  <joint name="a_side" type="revolute"><parent link="carriage"/><child link="arm"/>
    <origin xyz="-0.1 0.05 0.2" rpy="0 0.4 0"/><axis xyz="0.6 0 -0.8"/>
    <limit lower="-2" upper="2" velocity="3" effort="50"/><dynamics damping="0.2" friction="0.1"/></joint>
  <link name="arm"><inertial><origin xyz="0.15 -0.01 0.02" rpy="0 0 0.4"/><mass value="0.9"/>
    <inertia ixx="0.002" iyy="0.008" izz="0.007" ixy="0.0003" ixz="0.0002" iyz="-0.0004"/></inertial></link>
  <joint name="slide" type="prismatic"><parent link="arm"/><child link="finger"/>
    <origin xyz="0.3 0 0" rpy="0.2 0.3 0.4"/><axis xyz="1 0 0"/>
    <limit lower="-2" upper="2" velocity="3" effort="50"/></joint>
  <link name="finger"><inertial><origin xyz="0.05 0.01 -0.02"/><mass value="0.3"/>
    <inertia ixx="0.0005" iyy="0.0009" izz="0.0008" ixy="0.0001" ixz="0" iyz="0.00005"/></inertial></link>
</robot>)";

struct PeerContact {
  std::string link, position, type;
};

struct RobotForPinocchio {
  std::string name;
  bool floating = false;
  std::string tip;
  std::vector<PeerContact> contacts;
  bool has_long_steps = false;
};

void PrintTo(const RobotForPinocchio& robot, std::ostream* out) { *out << robot.name; }

// A function in Pinocchio's convention, how many arrays it takes and returns, and whether `condition` follows.
struct ConventionFunction {
  const char* name;
  int arrays;
  bool condition = false;
};

constexpr ConventionFunction kInConvention[] = {{"inverse_dynamics", 4},
                                                {"inverse_dynamics_tip_force", 5},
                                                {"inertia_matrix", 2},
                                                {"coriolis_matrix", 3},
                                                {"gravity", 2},
                                                {"bias", 3},
                                                {"forward_dynamics", 4},
                                                {"inverse_dynamics_derivatives", 5},
                                                {"forward_dynamics_derivatives", 6},
                                                {"forward_kinematics", 3},
                                                {"link_poses", 3},
                                                {"jacobian", 2},
                                                {"jacobian_dot_qd", 3},
                                                {"centroidal_momentum_matrix", 2},
                                                {"centroidal_bias", 3},
                                                {"centre_of_mass", 3},
                                                {"contact_jacobian", 3},
                                                {"contact_bias", 3},
                                                {"constrained_forward_dynamics", 5, true},
                                                {"contact_inverse_dynamics", 5, true},
                                                {"contact_impact", 4, true}};

std::string names_in_convention() {
  std::string names;
  for (const ConventionFunction& function : kInConvention) names += fmt::format("{},", function.name);
  names.pop_back();
  return names;
}

// The source of a library with these functions, and the steps of q, for ctypes.
std::string library_in_convention() {
  std::string text = "#include \"robot_pinocchio.hpp\"\nusing namespace robot;\nextern \"C\" {\n";
  for (const auto& [name, arrays, condition] : kInConvention) {
    std::string parameters = "double* x0", arguments = "x0";
    for (int k = 1; k < arrays; ++k) {
      parameters += fmt::format(", double* x{}", k);
      arguments += fmt::format(", x{}", k);
    }
    text += fmt::format("void {0}({1}) {{ double condition; (void)condition; (void)pinocchio::{0}({2}{3}); }}\n", name,
                        parameters, arguments, condition ? ", &condition" : "");
  }
  return text +
         "void integrate(double* q, double* v, double* next) { pinocchio::integrate(q, v, 0.3, next); }\n"
         "void difference(double* q, double* v, double* found) {\n"
         "  double next[velocity_count + 1];\n"
         "  pinocchio::integrate(q, v, 0.3, next);\n"
         "  pinocchio::difference(q, next, found);\n"
         "}\n}\n";
}

class Pinocchio : public ::testing::TestWithParam<RobotForPinocchio> {
 protected:
  void SetUp() override {
    if (!fs::exists(python_)) GTEST_SKIP() << "Pinocchio is not in build/peers: scripts/setup";
    write_file(folder_.path() / "tree.urdf", kTree);
    std::string scene;
    for (const PeerContact& contact : GetParam().contacts) {
      scene += fmt::format("[[contact]]\nlink = \"{}\"\nposition = [{}]\ntype = \"{}\"\n", contact.link,
                           contact.position, contact.type);
    }
    write_file(folder_.path() / "scene.toml", scene);
  }

  void run(const std::string& command) const {
    ASSERT_EQ(run_command(fmt::format("({}) >> log 2>&1", command), folder_.path()), 0)
        << command << "\n"
        << content_of_file(folder_.path() / "log");
  }

  std::string robot() const {
    const fs::path inside = fs::path(FLATDYN_SOURCE_DIR) / "robots" / (GetParam().name + ".urdf");
    return shell_word((fs::exists(inside) ? inside : folder_.path() / "tree.urdf").string());
  }

  void generate(const std::string& options, const std::string& functions) const {
    const auto& [name, floating, tip, contacts, has_long_steps] = GetParam();
    run(
        fmt::format("{} generate {} {} -q --snap 0 --base {} --tip {} --scene scene.toml -o . --name robot --namespace "
                    "robot --functions {}",
                    shell_word(FLATDYN_PROGRAM), robot(), options, floating ? "floating" : "fixed", tip, functions));
  }

  // Compares with Pinocchio, and prints the largest differences.
  void compare(const std::string& options) const {
    std::string described = fmt::format("{} --tip {}", options, GetParam().tip);
    if (GetParam().floating) described += " --floating";
    for (const auto& [link, position, type] : GetParam().contacts) {
      described += fmt::format(" --contact {}", shell_word(fmt::format("{}:{}:{}", link, position, type)));
    }
    const fs::path script = fs::path(FLATDYN_SOURCE_DIR) / "tests" / "differential" / "pinocchio_peer.py";
    run(fmt::format("{} -B {} {} {}", shell_word(python_.string()), shell_word(script.string()), described, robot()));
    fmt::print("{}", content_of_file(folder_.path() / "log"));
  }

  const fs::path python_ = fs::path(FLATDYN_SOURCE_DIR) / "build" / "peers" / "bin" / "python";
  const TemporaryFolder folder_;
};

TEST_P(Pinocchio, AgreesWithEmittedCode) {
  std::string functions = std::string(kOfAnyBase) + ",external_torque:" + GetParam().tip;
  functions += kSteps;
  if (GetParam().floating) functions += kOfFloatingBase;
  if (GetParam().has_long_steps) functions += kLongSteps;
  if (!GetParam().contacts.empty()) functions += kAtContacts;
  ASSERT_NO_FATAL_FAILURE(generate("--python", functions));
  ASSERT_NO_FATAL_FAILURE(
      run("cc -std=c99 -O0 -ffp-contract=off -shared -fPIC robot.c robot_batch.c -o librobot.so -lm"));
  compare("--module robot");
}

class PinocchioConvention : public Pinocchio {};

TEST_P(PinocchioConvention, IsThatOfPinocchio) {
  ASSERT_NO_FATAL_FAILURE(generate("--convention pinocchio", names_in_convention()));
  write_file(folder_.path() / "library.cpp", library_in_convention());
  ASSERT_NO_FATAL_FAILURE(run("c++ -std=c++17 -O0 -ffp-contract=off -shared -fPIC library.cpp -o libconvention.so"));
  compare(fmt::format("--convention ./libconvention.so --functions {},integrate,difference", names_in_convention()));
}

const std::vector<RobotForPinocchio> kFixedRobots = {
    {"tree", false, "finger", {{"hand", "0.1,0,0.2", "point"}}, true},
    {"panda", false, "panda_hand", {{"panda_hand", "0.01,-0.02,0.1", "surface"}}, true},
    {"ur5", false, "wrist_3_link", {{"wrist_3_link", "0,0,0", "point"}}, true}};

const std::vector<RobotForPinocchio> kFloatingRobots = {
    {"tree", true, "finger", {{"hand", "0.1,0,0.2", "surface"}, {"finger", "0.02,0.01,0", "point"}}, true},
    {"quadruped12",
     true,
     "FL_FOOT",
     {{"FL_FOOT", "0,0,0", "point"},
      {"FR_FOOT", "0.01,0,-0.02", "point"},
      {"HL_FOOT", "0,0,0", "point"},
      {"HR_FOOT", "0,0,0", "point"}}},
    {"humanoid32",
     true,
     "L_ANKLE_P_S",
     {{"L_ANKLE_P_S", "0.03,0,-0.05", "surface"}, {"R_ANKLE_P_S", "0.03,0,-0.05", "surface"}}}};

std::string name_for_pinocchio(const ::testing::TestParamInfo<RobotForPinocchio>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(Fixed, Pinocchio, ::testing::ValuesIn(kFixedRobots), name_for_pinocchio);
INSTANTIATE_TEST_SUITE_P(Floating, Pinocchio, ::testing::ValuesIn(kFloatingRobots), name_for_pinocchio);
INSTANTIATE_TEST_SUITE_P(Floating, PinocchioConvention, ::testing::ValuesIn(kFloatingRobots), name_for_pinocchio);

}  // namespace
}  // namespace flatdyn
