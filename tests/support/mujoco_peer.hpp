// SPDX-License-Identifier: GPL-2.0-or-later
// MJCF texts as flatdyn reads them against MuJoCo itself, which runs in Node: inertia matrix, bias, torques at random
// states. MuJoCo's text is without the elements that --ignore leaves out here, and without meshes where masses are
// given.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"
#include "flatdyn/reference/newton_euler.hpp"
#include "robot/input/reader.hpp"
#include "robot/model/coupling.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn::mujoco_peer {

namespace fs = std::filesystem;
namespace ref = reference;
using Vector = ref::VectorX<double>;
using Matrix = ref::MatrixX<double>;

inline constexpr int kNotInstalled = 77;
inline constexpr double kClose = 1e-10;     // of the largest entry
inline constexpr double kPrincipal = 1e-6;  // of the largest moment: off-diagonal entries along MuJoCo's principal axes

struct MjcfFile {
  std::string name;
  std::vector<std::string> ignored = {};
  std::vector<std::string> held = {};
};

inline std::string without(const std::string& text, const std::string& pattern) {
  return std::regex_replace(text, std::regex(pattern), "");
}

// The text as MuJoCo reads it without the file's meshes and without what is ignored or held.
inline std::string for_mujoco(std::string text, const MjcfFile& file) {
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

inline std::optional<Robot> read_mjcf_file(const fs::path& path, const MjcfFile& file) {
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

// The robot's coordinates, and what they are for the joints of its tree, without tendons, which are the last ones here
// and no joints in MuJoCo.
struct Coordinates {
  Matrix factors;  // by joint and coordinate
  Vector offsets;
};

inline Coordinates coordinates_of(const Robot& robot, const ref::Robot<double>& numbers) {
  const Eigen::Index n = numbers.joint_count();
  Coordinates found{numbers.coupling.size() > 0 ? numbers.coupling : Matrix(Matrix::Identity(n, n)), Vector::Zero(n)};
  const std::vector<LinearPosition> positions = joint_positions(robot);
  Eigen::Index row = 0;
  for (const int j : moving_joints(robot)) {
    found.offsets[row++] = nearest_double(positions[static_cast<std::size_t>(j)].offset);
  }
  const auto tendons =
      std::count_if(robot.joints.begin(), robot.joints.end(), [](const Joint& joint) { return joint.is_tendon; });
  found.factors.conservativeResize(n - tendons, Eigen::NoChange);
  found.offsets.conservativeResize(n - tendons);
  return found;
}

// The rates of a floating base and of the joints of its tree, by those of the base and the coordinates.
inline Matrix rates_of(const ref::Robot<double>& numbers, const Coordinates& c) {
  if (numbers.coupling.size() == 0) return Matrix::Identity(numbers.size(), numbers.size());
  return ref::rate_coupling(numbers).topRows(numbers.base_size() + c.factors.rows());
}

// Positions as MuJoCo has them: a spherical joint's three numbers, which are a turn here, become a unit quaternion.
inline Vector with_quaternions(const ref::Robot<double>& numbers, const Vector& q) {
  Vector result(0);
  const auto append = [&result](const Vector& entries) {
    result.conservativeResize(result.size() + entries.size());
    result.tail(entries.size()) = entries;
  };
  for (const ref::Joint<double>& joint : numbers.joints) {
    if (joint.index < 0 || joint.index - numbers.base_size() >= q.size()) continue;
    const Vector own = q.segment(joint.index - numbers.base_size(), joint.size());
    if (joint.type == ref::JointType::spherical) append(Eigen::Vector4d(1, own[0], own[1], own[2]).normalized());
    if (joint.type != ref::JointType::spherical) append(own);
  }
  return result;
}

// The robot with its spherical joints turned as `with_quaternions` says, and q with zeros for them.
inline Vector turned_by(ref::Robot<double>& numbers, const Vector& q) {
  if (!ref::has_spherical_joints(numbers)) return q;
  Vector positions = with_quaternions(numbers, q);
  ref::take_orientations(numbers, positions);
  return positions;
}

struct JointState {
  Vector q, qd, qdd;
};

inline std::vector<JointState> random_states(Eigen::Index n) {
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
  nlohmann::json in_mujoco(const Coordinates& c, const ref::Robot<double>& numbers) const {
    const Matrix A = rates_of(numbers, c);
    return in_mujoco(with_quaternions(numbers, c.factors * q + c.offsets), A * v, A * a);
  }
  nlohmann::json in_mujoco(const Vector& positions) const { return in_mujoco(positions, v, a); }
  nlohmann::json in_mujoco(const Vector& positions, Vector rates, Vector accelerations) const {
    Vector pose(7 + positions.size());
    pose << position, orientation.w(), orientation.x(), orientation.y(), orientation.z(), positions;
    rates.head<3>() = R * v.head<3>();
    accelerations.head<3>() = R * (a.head<3>() + coriolis());
    const auto list = [](const Vector& x) { return std::vector<double>(x.begin(), x.end()); };
    return {{"q", list(pose)}, {"qd", list(rates)}, {"qdd", list(accelerations)}};
  }
};

inline std::vector<FreeState> random_free_states(Eigen::Index n) {
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

inline std::vector<double> numbers_of(const Vector& v) { return {v.begin(), v.end()}; }

inline void expect_close(const Matrix& found, const Matrix& wanted, const char* what, double tolerance = kClose) {
  ASSERT_EQ(found.rows(), wanted.rows()) << what;
  const double size = wanted.cwiseAbs().maxCoeff();
  EXPECT_LE((found - wanted).cwiseAbs().maxCoeff(), tolerance * size) << what << ":\n"
                                                                      << found << "\nMuJoCo:\n"
                                                                      << wanted;
}

class MujocoFiles : public ::testing::TestWithParam<MjcfFile> {
 protected:
  nlohmann::json mujoco(const std::string& xml, const std::vector<JointState>& states, const Coordinates& c,
                        const ref::Robot<double>& numbers) {
    nlohmann::json all = nlohmann::json::array();
    for (const JointState& s : states) {
      const Vector q = c.factors * s.q + c.offsets;
      all.push_back({{"q", numbers_of(ref::has_spherical_joints(numbers) ? with_quaternions(numbers, q) : q)},
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

  // The bodies' tensors with their own moments, but along MuJoCo's principal axes.
  void take_axes(const nlohmann::json& bodies, ref::Robot<double>& numbers) const {
    for (std::size_t k = 1; k < numbers.links.size(); ++k) {
      ref::Inertial<double>& inertial = numbers.links[k].inertials.at(0);
      const auto q = bodies[k]["axes"].get<std::vector<double>>();
      const ref::Matrix3<double> axes = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
      const ref::Matrix3<double> along = axes.transpose() * inertial.inertia * axes;
      const double largest = inertial.inertia.cwiseAbs().maxCoeff();
      for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
        EXPECT_LE(std::abs(along(i, j)), kPrincipal * largest);
      }
      const Eigen::SelfAdjointEigenSolver<ref::Matrix3<double>> eigen(inertial.inertia);
      ref::Vector3<double> moments = eigen.eigenvalues().reverse();  // MuJoCo's come in decreasing order
      inertial.inertia = axes * moments.asDiagonal() * axes.transpose();
    }
  }

  // xml: the text for MuJoCo.
  void compare(const fs::path& path, const MjcfFile& file, const std::string& xml) {
    std::optional<Robot> robot = read_mjcf_file(path, file);
    ASSERT_TRUE(robot.has_value());
    if (robot->floating_base) return compare_floating(*robot, xml);
    const bool has_loops = !robot->loops.empty();
    robot->loops.clear();
    ref::Robot<double> numbers = reference_robot<double>(*robot, {});
    const Coordinates c = coordinates_of(*robot, numbers);
    const std::vector<JointState> states = random_states(numbers.size());
    const nlohmann::json peer = mujoco(xml, states, c, numbers);
    if (peer.empty()) GTEST_SKIP() << "MuJoCo is not installed: npm install @mujoco/mujoco";
    if (along_its_axes_) take_axes(peer["bodies"], numbers);
    expect_same(numbers, c, states, peer, has_loops);
  }

  void expect_same(ref::Robot<double> numbers, const Coordinates& c, const std::vector<JointState>& states,
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
      const Vector q = turned_by(numbers, s.q);
      expect_close(ref::inertia_matrix(numbers, q), c.factors.transpose() * B * c.factors, "B");
      expect_close(ref::bias(numbers, q, s.qd), wanted("bias"), "bias");
      expect_close(ref::inverse_dynamics(numbers, q, s.qd, s.qdd), wanted("tau"), "tau");
      if (has_loops) continue;  // they are open at these states
      EXPECT_LE(at["gap"].get<double>(), kClose);
    }
  }

  // MuJoCo's velocity of a free joint is that of the origin in world axes and the angular velocity in the body's axes.
  void compare_floating(const Robot& robot, const std::string& xml) {
    ref::Robot<double> numbers = reference_robot<double>(robot, {});
    const Coordinates c = coordinates_of(robot, numbers);
    const std::vector<FreeState> states = random_free_states(numbers.size());
    nlohmann::json all = nlohmann::json::array();
    for (const FreeState& s : states) all.push_back(s.in_mujoco(c, numbers));
    const nlohmann::json peer = mujoco(xml, all);
    if (peer.empty()) GTEST_SKIP() << "MuJoCo is not installed: npm install @mujoco/mujoco";
    ASSERT_EQ(peer["n"].get<Eigen::Index>(), numbers.base_size() + c.factors.rows());
    const ref::Vector3<double> gravity = numbers.gravity;
    const Vector coulomb = vector_of(peer["coulomb"].get<std::vector<double>>());
    for (std::size_t k = 0; k < states.size(); ++k) {
      numbers.gravity = states[k].R.transpose() * gravity;
      expect_same_free(numbers, c, states[k], peer["states"][k], coulomb);
    }
  }

  static void expect_same_free(ref::Robot<double> numbers, const Coordinates& c, const FreeState& s,
                               const nlohmann::json& at, const Vector& coulomb) {
    const Eigen::Index n = numbers.size();
    const Vector q = turned_by(numbers, s.q);
    Matrix T = Matrix::Identity(n, n);
    T.topLeftCorner<3, 3>() = s.R;
    const Matrix A = rates_of(numbers, c);
    const auto entries = at["B"].get<std::vector<double>>();
    const Matrix B = Eigen::Map<const Matrix>(entries.data(), A.rows(), A.rows());
    const Vector friction = coulomb.cwiseProduct((A * s.v).cwiseSign());
    const auto wanted = [&](const char* name) {
      return Vector(A.transpose() * (vector_of(at[name].get<std::vector<double>>()) + friction));
    };
    Vector still = Vector::Zero(n);  // MuJoCo's accelerations are zero
    still.head<3>() = -s.coriolis();
    expect_close(T * ref::inertia_matrix(numbers, q) * T.transpose(), A.transpose() * B * A, "B");
    expect_close(T * ref::inverse_dynamics(numbers, q, s.v, still), wanted("bias"), "bias");
    expect_close(T * ref::inverse_dynamics(numbers, q, s.v, s.a), wanted("tau"), "tau");
  }

  // A file beside main.xml, for both.
  void add_file(const std::string& name, const std::string& bytes) {
    write_file(folder_.path() / name, bytes);
    files_[name] = std::vector<unsigned char>(bytes.begin(), bytes.end());
  }

  void compare_text(const std::string& xml) {
    write_file(folder_.path() / "main.xml", xml);
    compare(folder_.path() / "main.xml", {"main.xml"}, xml);
  }

  // Masses, centres and principal moments of bodies of one inertial each; the first body is the world.
  void compare_bodies(const std::string& xml) {
    write_file(folder_.path() / "main.xml", xml);
    const std::optional<Robot> robot = read_mjcf_file(folder_.path() / "main.xml", {"main.xml"});
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
  // Whether bodies have MuJoCo's principal axes. It turns them by angles of which it loses digits below 1e-7 rad, and
  // ends where the next turn's cosine is 1 to about 1e-13.
  bool along_its_axes_ = false;
  nlohmann::json files_ = nlohmann::json::object();
};

}  // namespace flatdyn::mujoco_peer
