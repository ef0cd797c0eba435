// SPDX-License-Identifier: GPL-2.0-or-later
// MJCF files as flatdyn reads them against MuJoCo itself, which runs in Node: inertia matrix, bias, torques at random
// states. MuJoCo's text is without the elements that --ignore leaves out here, and without meshes where masses are
// given.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <sstream>

#include "flatdyn/reference/newton_euler.hpp"
#include "input/reader.hpp"
#include "model/coupling.hpp"
#include "reference/reference_model.hpp"
#include "system/process.hpp"
#include "system/temporary_folder.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;
namespace ref = reference;
using Vector = ref::VectorX<double>;
using Matrix = ref::MatrixX<double>;

constexpr int kNotInstalled = 77;
constexpr double kClose = 1e-10;          // of the largest entry
constexpr double kCloseOnAxes = 1e-6;     // of meshes, which MuJoCo turns onto principal axes to some 1e-6 rad
constexpr double kCloseInDouble = 1e-11;  // for code that is emitted for double

struct MjcfFile {
  std::string name;
  std::vector<std::string> ignored = {};
  std::vector<std::string> held = {};
};

std::string without(const std::string& text, const std::string& pattern) {
  return std::regex_replace(text, std::regex(pattern), "");
}

// The text as MuJoCo reads it without the file's meshes and without what is ignored or held.
std::string for_mujoco(std::string text, const MjcfFile& file) {
  text = without(text, "<!--[^]*?-->");
  text = without(text, "<keyframe>[^]*?</keyframe>");
  text = without(text, "<asset>[^]*?</asset>");
  text = without(text, R"re(\bmaterial="[^"]*")re");
  text = without(text, R"(<geom\s[^>]*\bmesh=[^>]*/>)");
  for (const std::string& name : file.ignored) {
    text = without(text, fmt::format("<{}>[^]*?</{}>", name, name));
    text = without(text, fmt::format(R"(<\w+\s[^>]*\b{}=[^>]*/>)", name == "tendon" ? name : "no-such-name"));
    text = without(text, fmt::format(R"(\b{}="[^"]*")", name));
  }
  if (!file.held.empty()) {
    text = without(text, R"(<freejoint[^>]*/>)");
    text = without(text, R"(<joint\s[^>]*type="free"[^>]*/>)");
  }
  return text;
}

std::optional<Robot> read(const fs::path& path, const MjcfFile& file) {
  ReadOptions options;
  options.snap_tolerance = 0;
  options.ignored = file.ignored;
  for (const std::string& joint : file.held) options.scene.locked.push_back({joint});
  Diagnostics diagnostics;
  std::optional<Robot> robot = read_robot(path, options, diagnostics);
  for (const Diagnostic& found : diagnostics.all()) {
    if (found.severity == Severity::error) ADD_FAILURE() << to_string(found);
  }
  return robot;
}

// The robot's coordinates, and what they are for the joints of its tree.
struct Coordinates {
  Matrix factors;  // by joint and coordinate
  Vector offsets;
};

Coordinates coordinates_of(const Robot& robot, const ref::Robot<double>& numbers) {
  const Eigen::Index n = numbers.joint_count();
  Coordinates found{numbers.coupling.size() > 0 ? numbers.coupling : Matrix(Matrix::Identity(n, n)), Vector::Zero(n)};
  const std::vector<LinearPosition> positions = joint_positions(robot);
  Eigen::Index row = 0;
  for (const int j : moving_joints(robot)) {
    found.offsets[row++] = nearest_double(positions[static_cast<std::size_t>(j)].offset);
  }
  return found;
}

struct JointState {
  Vector q, qd, qdd;
};

std::vector<JointState> random_states(Eigen::Index n) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> draw(-1, 1);
  const auto vector = [&](double size) { return Vector(Vector::NullaryExpr(n, [&] { return size * draw(engine); })); };
  std::vector<JointState> states;
  for (int k = 0; k < 5; ++k) {
    const Vector q = vector(2), qd = vector(3), qdd = vector(5);
    states.push_back({q, qd, qdd});
  }
  return states;
}

// A state of a robot with a floating base: v and a in base axes, R from these to world axes.
struct FreeState {
  Vector q, v, a;
  ref::Vector3<double> position;
  Eigen::Quaterniond orientation;
  ref::Matrix3<double> R = orientation.toRotationMatrix();

  // ω × v, the part of the acceleration of the base's origin that is not in a.
  ref::Vector3<double> coriolis() const {
    return ref::Vector3<double>(v.segment<3>(3)).cross(ref::Vector3<double>(v.head<3>()));
  }

  // Position, quaternion (w, x, y, z), joints; velocity and acceleration of the origin in world axes.
  nlohmann::json in_mujoco() const {
    Vector pose(7 + q.size()), rates = v, accelerations = a;
    pose << position, orientation.w(), orientation.x(), orientation.y(), orientation.z(), q;
    rates.head<3>() = R * v.head<3>();
    accelerations.head<3>() = R * (a.head<3>() + coriolis());
    const auto list = [](const Vector& x) { return std::vector<double>(x.begin(), x.end()); };
    return {{"q", list(pose)}, {"qd", list(rates)}, {"qdd", list(accelerations)}};
  }
};

std::vector<FreeState> random_free_states(Eigen::Index n) {
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> draw(-1, 1);
  const auto vector = [&](Eigen::Index size, double largest) {
    return Vector(Vector::NullaryExpr(size, [&] { return largest * draw(engine); }));
  };
  std::vector<FreeState> states;
  for (int k = 0; k < 5; ++k) {
    const Vector q = vector(n - 6, 2), v = vector(n, 3), a = vector(n, 5), p = vector(3, 1), turn = vector(4, 1);
    states.push_back({q, v, a, p, Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]).normalized()});
  }
  return states;
}

std::vector<double> numbers_of(const Vector& v) { return {v.begin(), v.end()}; }

void expect_close(const Matrix& found, const Matrix& wanted, const char* what, double tolerance = kClose) {
  ASSERT_EQ(found.rows(), wanted.rows()) << what;
  const double size = wanted.cwiseAbs().maxCoeff();
  EXPECT_LE((found - wanted).cwiseAbs().maxCoeff(), tolerance * size) << what << ":\n"
                                                                      << found << "\nMuJoCo:\n"
                                                                      << wanted;
}

class MujocoFiles : public ::testing::TestWithParam<MjcfFile> {
 protected:
  nlohmann::json mujoco(const std::string& xml, const std::vector<JointState>& states, const Coordinates& c) {
    nlohmann::json all = nlohmann::json::array();
    for (const JointState& s : states) {
      all.push_back({{"q", numbers_of(c.factors * s.q + c.offsets)},
                     {"qd", numbers_of(c.factors * s.qd)},
                     {"qdd", numbers_of(c.factors * s.qdd)}});
    }
    return mujoco(xml, all);
  }

  // The values at states as MuJoCo has them; empty where it is not installed.
  nlohmann::json mujoco(const std::string& xml, const nlohmann::json& states) {
    const nlohmann::json input = {{"xml", xml}, {"files", files_}, {"states", states}};
    write_file(folder_.path() / "in.json", input.dump());
    const std::string script = std::string(FLATDYN_SOURCE_DIR) + "/tests/differential/mujoco_values.mjs";
    const int status = run_command("node " + shell_word(script) + " in.json out.json > log 2>&1", folder_.path());
    if (status == kNotInstalled || status == 127) return {};
    if (status != 0) throw std::runtime_error(content_of_file(folder_.path() / "log"));
    return nlohmann::json::parse(content_of_file(folder_.path() / "out.json"));
  }

  void compare(const fs::path& path, const MjcfFile& file) {
    compare(path, file, for_mujoco(content_of_file(path), file));
  }

  // xml: the text for MuJoCo.
  void compare(const fs::path& path, const MjcfFile& file, const std::string& xml) {
    std::optional<Robot> robot = read(path, file);
    ASSERT_TRUE(robot.has_value());
    if (robot->floating_base) return compare_floating(*robot, xml);
    const bool has_loops = !robot->loops.empty();
    robot->loops.clear();
    const ref::Robot<double> numbers = reference_robot<double>(*robot, {});
    const Coordinates c = coordinates_of(*robot, numbers);
    const std::vector<JointState> states = random_states(numbers.size());
    const nlohmann::json peer = mujoco(xml, states, c);
    if (peer.empty()) GTEST_SKIP() << "MuJoCo is not installed: npm install @mujoco/mujoco";
    expect_same(numbers, c, states, peer, has_loops);
  }

  void expect_same(const ref::Robot<double>& numbers, const Coordinates& c, const std::vector<JointState>& states,
                   const nlohmann::json& peer, bool has_loops) const {
    const Eigen::Index n = c.factors.rows();
    ASSERT_EQ(peer["n"].get<Eigen::Index>(), n);
    const Vector coulomb = vector_of(peer["coulomb"].get<std::vector<double>>());
    for (std::size_t k = 0; k < states.size(); ++k) {
      const JointState& s = states[k];
      const nlohmann::json& at = peer["states"][k];
      const auto entries = at["B"].get<std::vector<double>>();
      const Matrix B = Eigen::Map<const Matrix>(entries.data(), n, n);
      const Vector friction = coulomb.cwiseProduct((c.factors * s.qd).cwiseSign());
      const auto wanted = [&](const char* name) {
        return Vector(c.factors.transpose() * (vector_of(at[name].get<std::vector<double>>()) + friction));
      };
      expect_close(ref::inertia_matrix(numbers, s.q), c.factors.transpose() * B * c.factors, "B", tolerance_);
      expect_close(ref::bias(numbers, s.q, s.qd), wanted("bias"), "bias", tolerance_);
      expect_close(ref::inverse_dynamics(numbers, s.q, s.qd, s.qdd), wanted("tau"), "tau", tolerance_);
      if (has_loops) continue;  // they are open at these states
      EXPECT_LE(at["gap"].get<double>(), kClose);
    }
  }

  // MuJoCo's velocity of a free joint is that of the origin in world axes and the angular velocity in the body's axes.
  void compare_floating(const Robot& robot, const std::string& xml) {
    ref::Robot<double> numbers = reference_robot<double>(robot, {});
    const Eigen::Index n = numbers.size();
    const std::vector<FreeState> states = random_free_states(n);
    nlohmann::json all = nlohmann::json::array();
    for (const FreeState& s : states) all.push_back(s.in_mujoco());
    const nlohmann::json peer = mujoco(xml, all);
    if (peer.empty()) GTEST_SKIP() << "MuJoCo is not installed: npm install @mujoco/mujoco";
    ASSERT_EQ(peer["n"].get<Eigen::Index>(), n);
    const ref::Vector3<double> gravity = numbers.gravity;
    const Vector coulomb = vector_of(peer["coulomb"].get<std::vector<double>>());
    for (std::size_t k = 0; k < states.size(); ++k) {
      numbers.gravity = states[k].R.transpose() * gravity;
      expect_same_free(numbers, states[k], peer["states"][k], coulomb);
    }
  }

  static void expect_same_free(const ref::Robot<double>& numbers, const FreeState& s, const nlohmann::json& at,
                               const Vector& coulomb) {
    const Eigen::Index n = numbers.size();
    Matrix T = Matrix::Identity(n, n);
    T.topLeftCorner<3, 3>() = s.R;
    const auto entries = at["B"].get<std::vector<double>>();
    const Vector friction = coulomb.cwiseProduct(s.v.cwiseSign());
    const auto wanted = [&](const char* name) {
      return Vector(vector_of(at[name].get<std::vector<double>>()) + friction);
    };
    Vector still = Vector::Zero(n);  // MuJoCo's accelerations are zero
    still.head<3>() = -s.coriolis();
    expect_close(T * ref::inertia_matrix(numbers, s.q) * T.transpose(), Eigen::Map<const Matrix>(entries.data(), n, n),
                 "B");
    expect_close(T * ref::inverse_dynamics(numbers, s.q, s.v, still), wanted("bias"), "bias");
    expect_close(T * ref::inverse_dynamics(numbers, s.q, s.v, s.a), wanted("tau"), "tau");
  }

  // A file beside main.xml, for both.
  void add_file(const std::string& name, const std::string& bytes) {
    write_file(folder_.path() / name, bytes);
    files_[name] = std::vector<unsigned char>(bytes.begin(), bytes.end());
  }

  void compare_text(const std::string& xml, double tolerance = kClose) {
    tolerance_ = tolerance;
    write_file(folder_.path() / "main.xml", xml);
    compare(folder_.path() / "main.xml", {"main.xml"}, xml);
  }

  // Masses, centres and principal moments of bodies of one inertial each; the first body is the world.
  void compare_bodies(const std::string& xml) {
    write_file(folder_.path() / "main.xml", xml);
    const std::optional<Robot> robot = read(folder_.path() / "main.xml", {"main.xml"});
    ASSERT_TRUE(robot.has_value());
    const nlohmann::json peer = mujoco(xml, nlohmann::json::array());
    if (peer.empty()) GTEST_SKIP() << "MuJoCo is not installed: npm install @mujoco/mujoco";
    const ref::Robot<double> numbers = reference_robot<double>(*robot, {});
    ASSERT_EQ(numbers.links.size(), peer["bodies"].size());
    for (std::size_t k = 1; k < numbers.links.size(); ++k) {
      expect_same_inertia(numbers.links[k].inertials.at(0), peer["bodies"][k]);
    }
  }

  static void expect_same_inertia(const ref::Inertial<double>& found, const nlohmann::json& wanted) {
    expect_close(Vector::Constant(1, found.mass), Vector::Constant(1, wanted["mass"].get<double>()), "mass");
    expect_close(found.r_C, vector_of(wanted["com"].get<std::vector<double>>()), "centre");
    const Eigen::SelfAdjointEigenSolver<ref::Matrix3<double>> eigen(found.inertia);
    expect_close(eigen.eigenvalues(), vector_of(wanted["moments"].get<std::vector<double>>()), "moments");
  }

  TemporaryFolder folder_;
  double tolerance_ = kClose;
  nlohmann::json files_ = nlohmann::json::object();
};

TEST_F(MujocoFiles, CopiesStandWhereMujocoPutsThem) {
  compare_text(R"(<mujoco><default><joint damping=".3"/></default><worldbody>
    <body name="hub"><joint name="h" axis="1 0 1"/><geom size=".1"/>
      <replicate count="3" offset=".4 .1 0" euler="10 20 30" sep="-">
        <body name="a" pos="0 .5 0"><joint name="j" axis="0 1 0"/><geom type="box" size=".1 .2 .3"/>
          <body name="b" pos="0 0 .3"><joint name="k"/><geom size=".1" pos=".1 0 0"/></body></body>
      </replicate></body></worldbody>
    <actuator><motor joint="j" armature=".5" gear="2"/></actuator>
    <equality><joint joint1="k" joint2="j" polycoef="0 .5 0 0 0"/></equality></mujoco>)");
}

TEST_F(MujocoFiles, CopiesOfCopiesStandWhereMujocoPutsThem) {
  compare_text(R"(<mujoco><default><default class="q"><joint damping="4"/></default></default><worldbody>
    <body name="hub"><joint name="h" axis="1 0 0"/><geom size=".1"/><frame pos="0 0 .5">
      <replicate count="2" offset=".3 0 0" sep="-" childclass="q"><frame pos="0 0 .1">
        <replicate count="3" euler="0 0 40"><body name="a" pos="0 .5 0"><joint name="j" axis="0 1 0"/>
          <geom type="capsule" size=".1 .2" pos=".1 .2 0"/></body></replicate></frame>
        <geom name="g" size=".2"/></replicate></frame></body></worldbody></mujoco>)");
}

TEST_F(MujocoFiles, AttachedModelsMoveAsInMujoco) {
  add_file("arm.xml", R"(<mujoco model="arm"><default><joint damping="2" armature=".3"/>
    <default class="k"><joint armature=".5"/></default></default>
    <worldbody><geom size=".1"/><body name="base" childclass="k" pos="0 0 1"><geom size=".1" pos=".1 0 0"/>
      <joint name="j" axis="1 1 0"/><body name="tip" pos="1 0 0" euler="17 0 0"><geom type="box" size=".1 .2 .3"/>
        <joint name="i" axis="0 1 0"/></body></body></worldbody>
    <actuator><motor joint="j" armature=".1" gear="3"/></actuator>
    <equality><joint joint1="j" joint2="i"/></equality></mujoco>)");
  compare_text(R"(<mujoco><asset><model name="s" file="arm.xml"/></asset>
    <default><joint damping="7" frictionloss="3"/></default>
    <worldbody><body name="hub" euler="10 0 0"><joint name="h" axis="0 1 0"/><geom size=".1"/>
      <frame pos="0 0 .4" euler="0 20 0"><attach model="s" prefix="l_"/></frame>
      <attach model="s" body="tip" prefix="r_"/></body></worldbody></mujoco>)");
}

using MeshPoint = std::array<float, 3>;
using MeshTriangle = std::array<MeshPoint, 3>;

// An L of plates, whose centroid does not see all of its faces.
std::vector<MeshTriangle> bracket_of_plates() {
  const std::vector<std::array<float, 2>> outline = {{0, 0}, {3, 0}, {3, .25}, {.25, .25}, {.25, 4}, {0, 4}};
  const float thick = .5;
  const auto at = [&](std::size_t i, float z) { return MeshPoint{outline[i][0], outline[i][1], z}; };
  std::vector<MeshTriangle> triangles;
  for (const auto& [a, b, c] : std::vector<std::array<std::size_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}}) {
    triangles.push_back({at(a, thick), at(b, thick), at(c, thick)});
    triangles.push_back({at(a, 0), at(c, 0), at(b, 0)});
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t j = (i + 1) % outline.size();
    triangles.push_back({at(i, 0), at(j, 0), at(j, thick)});
    triangles.push_back({at(i, 0), at(j, thick), at(i, thick)});
  }
  return triangles;
}

std::string binary_stl(const std::vector<MeshTriangle>& triangles) {
  std::string bytes(80, ' ');
  const auto add = [&bytes](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
  add(static_cast<std::uint32_t>(triangles.size()));
  for (const MeshTriangle& triangle : triangles) {
    add(MeshPoint{});
    add(triangle);
    add(std::uint16_t{0});
  }
  return bytes;
}

constexpr const char* kPyramid = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf -3 -2 -1\n";
constexpr const char* kOpenPyramid = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\n";
constexpr const char* kPrism =  // whose quadrilaterals are not plane
    "o prism\nv 0 0 0\nv 0 0 3\nv 0 2 0\nv 0 2 3.5\nv 1 0 0\nv 1 0 3\nv 1 2 0\nv 1.25 2 3\n"
    "f 1 2 4 3\nf 5/1 7/1 8/1 6/1\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";

TEST_F(MujocoFiles, MeshesHaveMujocosInertia) {
  add_file("bracket.stl", binary_stl(bracket_of_plates()));
  add_file("pyramid.obj", kPyramid);
  add_file("open.obj", kOpenPyramid);
  add_file("prism.obj", kPrism);
  std::string meshes, bodies;
  int k = 0;
  for (const char* mesh : {R"(file="bracket.stl")", R"(file="bracket.stl" inertia="exact")", R"(file="pyramid.obj")",
                           R"(file="pyramid.obj" inertia="exact" scale="1 -2 3")",
                           R"(file="pyramid.obj" refpos="1 2 3" refquat="1 0 0 .5" scale="2 2 2")",
                           R"(file="pyramid.obj" refpos="1 2 3" scale="2 -3 .1")", R"(file="open.obj")",
                           R"(file="open.obj" inertia="exact")", R"(file="prism.obj")", R"(file="prism.obj" class="c")",
                           R"(vertex="0 0 0  1 0 0  0 1 0  0 0 1" face="0 2 1  0 1 3  0 3 2  1 2 3")"}) {
    meshes += fmt::format(R"(<mesh name="m{}" {}/>)", ++k, mesh);
    bodies += fmt::format(
        R"(<body><joint axis="1 2 3"/><geom type="mesh" mesh="m{}" pos=".1 0 0" euler="0 0 30"/></body>)", k);
  }
  const std::string xml =
      "<mujoco><default><default class=\"c\"><mesh scale=\"1 2 3\" inertia=\"exact\"/></default>"
      "</default><asset>" +
      meshes + "</asset><worldbody>" + bodies + "</worldbody></mujoco>";
  compare_bodies(xml);
  compare_text(xml, kCloseOnAxes);
}

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
};

TEST_F(MujocoConvention, IsThatOfMujoco) {
  const fs::path path = fs::path(FLATDYN_SOURCE_DIR) / ".." / "shared" / "robots" / "mjcf" / "go1.xml";
  if (!fs::exists(path)) GTEST_SKIP() << "no such file: " << path;
  constexpr Eigen::Index n = 18;
  nlohmann::json states = nlohmann::json::array();
  for (const FreeState& s : random_free_states(n)) states.push_back(s.in_mujoco());
  const nlohmann::json peer = mujoco(for_mujoco(content_of_file(path), {"go1.xml"}), states);
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

class MujocoSharedFiles : public MujocoFiles {};

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

INSTANTIATE_TEST_SUITE_P(
    Files, MujocoSharedFiles,
    ::testing::Values(MjcfFile{"ur5e.xml"}, MjcfFile{"panda_nohand.xml"}, MjcfFile{"iiwa14.xml"},
                      MjcfFile{"gym_hopper.xml"}, MjcfFile{"gym_pusher_v5.xml"}, MjcfFile{"panda.xml", {"tendon"}},
                      MjcfFile{"shadow_right_hand.xml", {"tendon"}}, MjcfFile{"gym_half_cheetah.xml"},
                      MjcfFile{"2f85.xml", {"tendon", "mesh"}}, MjcfFile{"go1.xml", {}, {"trunk_joint"}},
                      MjcfFile{"anymal_c.xml", {}, {"base_joint"}},
                      MjcfFile{"g1_29dof.xml", {}, {"floating_base_joint"}}, MjcfFile{"gym_humanoid.xml", {}, {"root"}},
                      MjcfFile{"go1.xml"}, MjcfFile{"anymal_c.xml"}, MjcfFile{"g1_29dof.xml"},
                      MjcfFile{"gym_humanoid.xml"}),
    name_of);

}  // namespace
}  // namespace flatdyn
