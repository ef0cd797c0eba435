// SPDX-License-Identifier: GPL-2.0-or-later
// Logs as people have them: positions with the steps of an encoder and noisy torques at 1 kHz, friction, joints that
// are held, and times in which the robot stands still.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn::testing {

// An arm of robots/ with friction and rotors that its file lacks.
struct PracticalArm {
  std::string file;
  std::vector<std::string> joints;
  std::vector<double> middle;  // rad
  std::vector<double> viscous, coulomb, armature;
  std::vector<double> noise;  // standard deviation of the torques, N m
  std::string settings{};     // lines at the top of the robot file

  // The arm with its friction and rotors.
  LoadedRobot truth() const {
    std::string text = fmt::format("robot = \"{}\"\n{}", (robots() / file).string(), settings);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      text += fmt::format("[[joint]]\nname = \"{}\"\nviscous = {}\ncoulomb = {}\narmature = {}\n", joints[i],
                          viscous[i], coulomb[i], armature[i]);
    }
    return loaded(text);
  }
  // The arm as its file has it.
  LoadedRobot plain() const { return loaded(fmt::format("robot = \"{}\"\n{}", (robots() / file).string(), settings)); }

 private:
  static std::filesystem::path robots() { return std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots"; }
  static LoadedRobot loaded(const std::string& text) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("flatdyn-practical-{}.toml", ::getpid());
    std::ofstream(path) << text;
    LoadedRobot robot = load_robot(path, {});
    std::filesystem::remove(path);
    return robot;
  }
};

inline PracticalArm practical_ur5() {
  return {
      "ur5.urdf",
      {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint"},
      {0, -1, 1, -0.5, 0.3, 0},
      {8, 8, 6, 2, 2, 1.5},
      {9, 9, 7, 2.5, 2.2, 1.8},
      {3, 3, 1.6, 0.35, 0.35, 0.2},
      {0.5, 0.5, 0.4, 0.1, 0.1, 0.1}};
}

inline PracticalArm practical_panda() {
  PracticalArm arm{"panda.urdf",
                   {},
                   {0, 0, 0, -1.6, 0, 1.8, 0.5},
                   {4, 4, 3, 3, 1, 1, 0.7},
                   {5, 5, 4, 4, 1.5, 1.5, 1},
                   {0.6, 0.6, 0.5, 0.5, 0.2, 0.2, 0.15},
                   {0.15, 0.15, 0.15, 0.15, 0.05, 0.05, 0.05},
                   "fixed = [\"panda_finger_joint1\", \"panda_finger_joint2\"]\n"};
  for (int i = 1; i <= 7; ++i) arm.joints.push_back(fmt::format("panda_joint{}", i));
  return arm;
}

struct PracticalOptions {
  double seconds = 20, rate = 1000;
  unsigned motion = 1;          // chooses the motion
  std::vector<int> held{};      // joints that stand still, counted from 0
  std::vector<double> scale{};  // of each joint's motion; empty: 1
  double fundamental = 0.1;     // Hz
  bool idles = false;           // whether the arm stands still for two of every six seconds
};

// How far a motion has come on its path, in seconds of the path, and its rates.
struct PathTime {
  double s = 0, ds = 1, dds = 0;

  static PathTime steady(double t) { return {t, 1, 0}; }
  // Four seconds from rest to rest over two seconds of the path, then two seconds at rest.
  static PathTime with_rests(double t) {
    constexpr double kPeriod = 6, kMoving = 4, kPath = 2;
    const double period = std::floor(t / kPeriod), u = std::min((t - kPeriod * period) / kMoving, 1.0);
    return {kPath * (period + u * u * u * (10 - 15 * u + 6 * u * u)), kPath * 30 * u * u * (1 - u) * (1 - u) / kMoving,
            kPath * 60 * u * (1 - u) * (1 - 2 * u) / (kMoving * kMoving)};
  }
};

// The motion and its torques without noise. While the arm rests, its friction is anything up to F_s.
inline std::vector<SimulatedSample> practical_motion(const PracticalArm& arm, const LoadedRobot& truth,
                                                     const PracticalOptions& options) {
  constexpr int kHarmonics = 5;
  constexpr double kAmplitude = 0.8;  // rad
  const auto n = static_cast<Eigen::Index>(arm.joints.size());
  const reference::Robot<double> robot = reference_robot<double>(truth.robot, {});
  Uniform draw(options.motion);
  Eigen::MatrixXd a(n, kHarmonics), b(n, kHarmonics);
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    a(k) = kAmplitude * draw() / static_cast<double>(k / n + 1);
    b(k) = kAmplitude * draw() / static_cast<double>(k / n + 1);
  }
  for (std::size_t i = 0; i < options.scale.size(); ++i) {
    a.row(static_cast<Eigen::Index>(i)) *= options.scale[i];
    b.row(static_cast<Eigen::Index>(i)) *= options.scale[i];
  }
  for (const int joint : options.held) a.row(joint).setZero();
  for (const int joint : options.held) b.row(joint).setZero();
  Eigen::VectorXd friction = Eigen::VectorXd::Zero(n);
  std::vector<SimulatedSample> samples;
  for (int k = 0; k < options.seconds * options.rate; ++k) {
    const double time = k / options.rate;
    const PathTime path = options.idles ? PathTime::with_rests(time) : PathTime::steady(time);
    SimulatedSample sample{time,
                           Eigen::Map<const Eigen::VectorXd>(arm.middle.data(), n),
                           Eigen::VectorXd::Zero(n),
                           Eigen::VectorXd::Zero(n),
                           {}};
    for (int l = 0; l < kHarmonics; ++l) {
      const double w = 2 * std::numbers::pi * options.fundamental * (l + 1), s = std::sin(w * path.s),
                   c = std::cos(w * path.s);
      const Eigen::VectorXd value = s * a.col(l) + c * b.col(l), rate = w * (c * a.col(l) - s * b.col(l));
      sample.q += value;
      sample.qd += path.ds * rate;
      sample.qdd += path.dds * rate - w * w * path.ds * path.ds * value;
    }
    sample.tau = reference::inverse_dynamics<double>(robot, sample.q, sample.qd, sample.qdd);
    if (path.ds != 0) {
      for (Eigen::Index i = 0; i < n; ++i) friction[i] = arm.coulomb[static_cast<std::size_t>(i)] * draw();
    } else {
      sample.tau += friction;
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

// Writes t, q and τ: q in steps of an encoder (0: exact), τ with `noise` times the arm's.
inline void write_practical_log(const std::filesystem::path& path, const PracticalArm& arm,
                                const std::vector<SimulatedSample>& samples, double step, double noise, unsigned seed) {
  Uniform draw(seed);
  std::string text = "t";
  const auto n = samples.front().q.size();
  for (const char* name : {"q", "tau"}) {
    for (Eigen::Index i = 1; i <= n; ++i) text += fmt::format(",{}{}", name, i);
  }
  auto out = std::back_inserter(text);
  for (const SimulatedSample& sample : samples) {
    fmt::format_to(out, "\n{:.4f}", sample.time);
    for (const double q : sample.q) {
      if (step > 0) {
        fmt::format_to(out, ",{:.7f}", step * std::round(q / step));
      } else {
        fmt::format_to(out, ",{}", q);
      }
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      const double sigma = noise * arm.noise[static_cast<std::size_t>(i)];
      fmt::format_to(out, ",{:.9g}", sample.tau[i] + sigma * draw.normal());
    }
  }
  std::ofstream(path) << text << "\n";
}

}  // namespace flatdyn::testing
