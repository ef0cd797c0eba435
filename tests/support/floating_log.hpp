// SPDX-License-Identifier: GPL-2.0-or-later
// Logs of a known robot whose base floats and is carried about, or is fixed: sums of sines for the base's position, for
// roll, pitch and yaw of it and of spherical joints, and for other joints, with torques and the base's force by the
// recursive reference.
#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <functional>

#include "flatdyn/reference/newton_euler.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn::testing {

struct FloatingSample {
  double time = 0;
  Eigen::VectorXd q, v, a, tau{};  // v, a and tau: six entries of a floating base first
  Eigen::Vector3d place{}, g_b{};  // world axes; base axes
  Eigen::Quaterniond turn{};
};

struct FloatingLogOptions {
  int samples = 4000;
  double rate = 500;         // Hz
  double fundamental = 0.3;  // Hz; three harmonics
  unsigned seed = 1;
};

// A sum of sines with its derivatives.
class SumOfSines {
 public:
  SumOfSines(Uniform& draw, double size, double fundamental) : fundamental_(fundamental) {
    for (double& each : a_) each = size * draw();
    for (double& each : b_) each = size * draw();
  }
  // The value, and its first and second derivatives.
  Eigen::Vector3d at(double t) const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int l = 0; l < kHarmonics; ++l) {
      const double w = 2 * std::numbers::pi * fundamental_ * (l + 1), s = std::sin(w * t), c = std::cos(w * t);
      result += Eigen::Vector3d(a_[l] * s + b_[l] * c, w * (a_[l] * c - b_[l] * s), -w * w * (a_[l] * s + b_[l] * c)) /
                (l + 1);
    }
    return result;
  }

 private:
  static constexpr int kHarmonics = 3;
  double a_[kHarmonics], b_[kHarmonics], fundamental_;
};

// Angular velocity and its derivative in base axes, of roll, pitch and yaw (about x, then y, then z, of axes that turn
// backwards) with their rates and accelerations, row by row.
struct Turning {
  Eigen::Quaterniond turn;
  Eigen::Vector3d velocity, acceleration;
};

inline Turning turning(const Eigen::Matrix3d& angles) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  const double roll = angles(0, 0), pitch = angles(1, 0), roll_rate = angles(0, 1), pitch_rate = angles(1, 1);
  const double sr = std::sin(roll), cr = std::cos(roll), sp = std::sin(pitch), cp = std::cos(pitch);
  Eigen::Matrix3d E, E_rate;
  E << 1, 0, -sp, 0, cr, sr * cp, 0, -sr, cr * cp;
  E_rate << 0, 0, -cp * pitch_rate, 0, -sr * roll_rate, cr * cp * roll_rate - sr * sp * pitch_rate, 0, -cr * roll_rate,
      -sr * cp * roll_rate - cr * sp * pitch_rate;
  return {AngleAxisd(angles(2, 0), Vector3d::UnitZ()) * AngleAxisd(pitch, Vector3d::UnitY()) *
              AngleAxisd(roll, Vector3d::UnitX()),
          E * angles.col(1), E * angles.col(2) + E_rate * angles.col(1)};
}

// Three of the sums from `first` on, row by row.
inline Eigen::Matrix3d three_at(const std::vector<SumOfSines>& sums, int first, double t) {
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i) result.row(i) = sums[static_cast<std::size_t>(first + i)].at(t).transpose();
  return result;
}

inline void move_base(FloatingSample& sample, const std::vector<SumOfSines>& sums, const Eigen::Vector3d& gravity) {
  const Eigen::Matrix3d place = three_at(sums, 0, sample.time);
  const Turning turned = turning(three_at(sums, 3, sample.time));
  const Eigen::Quaterniond back = turned.turn.conjugate();
  sample.place = place.col(0);
  sample.turn = turned.turn;
  sample.g_b = back * gravity;
  const Eigen::Vector3d v = back * place.col(1);
  sample.v.head(6) << v, turned.velocity;
  sample.a.head(6) << back * place.col(2) - turned.velocity.cross(v), turned.acceleration;
}

inline void move_joints(FloatingSample& sample, const std::vector<SumOfSines>& sums, const Mechanism& mechanism) {
  for (int i = mechanism.base_bodies(); i < mechanism.size(); ++i) {
    const Eigen::Vector3d joint = sums[static_cast<std::size_t>(i)].at(sample.time);
    sample.q[mechanism.position_of(i)] = joint[0];
    sample.v[i] = joint[1];
    sample.a[i] = joint[2];
  }
  for (const int first : mechanism.spherical) {
    const Turning turned = turning(three_at(sums, first, sample.time));
    const Eigen::Quaterniond& turn = turned.turn;
    sample.q.segment(mechanism.quaternion_of(first), 4) << turn.w(), turn.x(), turn.y(), turn.z();
    sample.v.segment(first, 3) = turned.velocity;
    sample.a.segment(first, 3) = turned.acceleration;
  }
}

// The torques of a sample, with the force on a floating base, by the recursive reference.
inline Eigen::VectorXd torques_of(reference::Robot<double> robot, const FloatingSample& sample) {
  Eigen::VectorXd positions = sample.q;
  if (robot.floating_base) robot.gravity = sample.g_b;
  reference::take_orientations(robot, positions);
  return reference::inverse_dynamics<double>(robot, positions, sample.v, sample.a);
}

inline std::vector<FloatingSample> floating_motion(const LoadedRobot& model, const FloatingLogOptions& options) {
  constexpr double kOfPlace = 0.15, kOfAngle = 0.25, kOfJoint = 0.5;
  Uniform draw(options.seed);
  const Mechanism& mechanism = model.mechanism;
  const reference::Robot<double> robot = reference_robot<double>(model.robot, {});
  std::vector<SumOfSines> sums;
  for (int k = 0; k < mechanism.size(); ++k) {
    const bool is_of_base = mechanism.is_of_base(k);
    sums.emplace_back(draw, is_of_base && k < 3 ? kOfPlace : is_of_base ? kOfAngle : kOfJoint, options.fundamental);
  }
  std::vector<FloatingSample> samples;
  for (int k = 0; k < options.samples; ++k) {
    FloatingSample sample{k / options.rate, Eigen::VectorXd(mechanism.position_count()),
                          Eigen::VectorXd(mechanism.size()), Eigen::VectorXd(mechanism.size())};
    if (mechanism.floating_base) move_base(sample, sums, robot.gravity);
    move_joints(sample, sums, mechanism);
    sample.tau = torques_of(robot, sample);
    samples.push_back(std::move(sample));
  }
  return samples;
}

// The columns that tell the base's motion.
enum class BaseColumns { imu, pose, pose_with_twist, twist_with_derivatives };

struct FloatingLogNoise {
  double q = 0, tau = 0, force = 0, accelerometer = 0, gyroscope = 0, place = 0, quaternion = 0;  // standard deviations
  unsigned seed = 7;
};

struct FloatingLogForm {
  BaseColumns base = BaseColumns::imu;
  bool has_force = true, has_rates = false, has_accelerations = false;
  // The measurement unit's frame in the base's.
  Eigen::Quaterniond imu_axes = Eigen::Quaterniond::Identity();
  Eigen::Vector3d imu_place = Eigen::Vector3d::Zero();
  FloatingLogNoise noise{};
  // The force and moment in the columns fx to mz, six numbers by sample; none: no such columns.
  std::function<Eigen::VectorXd(const FloatingSample&)> wrench{};
};

class FloatingLogWriter {
 public:
  FloatingLogWriter(const FloatingLogForm& form, const Mechanism& mechanism)
      : form_(form), mechanism_(mechanism), draw_(form.noise.seed) {}

  void write(const std::filesystem::path& path, const std::vector<FloatingSample>& samples) {
    std::ofstream file(path);
    file << heading();
    bool flipped = false;  // -q is the same turn as q, and some programs change the sign now and then
    for (const FloatingSample& each : samples) {
      text_ = fmt::format("{}", each.time);
      flipped = each.time > samples[samples.size() / 2].time;
      row(each, flipped);
      file << text_ << "\n";
    }
  }

 private:
  std::string heading() const {
    std::string text = "t";
    const auto names = [&](std::initializer_list<const char*> all) {
      for (const char* each : all) text += fmt::format(",{}", each);
    };
    const auto of_joints = [&](const char* stem) {
      for (const Body& body : mechanism_.joints()) text += fmt::format(",{}_{}", stem, body.joint);
    };
    for (int k = 0; k < mechanism_.position_count(); ++k) text += ",q_" + mechanism_.position_name(k);
    of_joints("tau");
    if (form_.has_rates) of_joints("qd");
    if (form_.has_accelerations) of_joints("qdd");
    if (form_.wrench) names({"fx", "fy", "fz", "mx", "my", "mz"});
    if (!mechanism_.floating_base) return text + "\n";
    if (form_.has_force) names({"base_fx", "base_fy", "base_fz", "base_nx", "base_ny", "base_nz"});
    if (form_.base == BaseColumns::imu) names({"imu_ax", "imu_ay", "imu_az", "imu_wx", "imu_wy", "imu_wz"});
    if (has_pose()) names({"base_x", "base_y", "base_z", "base_qw", "base_qx", "base_qy", "base_qz"});
    if (has_twist()) names({"base_vx", "base_vy", "base_vz", "base_wx", "base_wy", "base_wz"});
    if (form_.base == BaseColumns::twist_with_derivatives) {
      names({"base_dvx", "base_dvy", "base_dvz", "base_dwx", "base_dwy", "base_dwz", "base_gx", "base_gy", "base_gz"});
    }
    return text + "\n";
  }
  bool has_pose() const { return form_.base == BaseColumns::pose || form_.base == BaseColumns::pose_with_twist; }
  bool has_twist() const {
    return form_.base == BaseColumns::pose_with_twist || form_.base == BaseColumns::twist_with_derivatives;
  }

  template <class Vector>
  void put(const Vector& numbers, double noise = 0) {
    for (const double each : numbers) text_ += fmt::format(",{}", noise > 0 ? each + noise * draw_.normal() : each);
  }

  void row(const FloatingSample& each, bool flipped) {
    const auto n = static_cast<Eigen::Index>(mechanism_.joints().size());
    const FloatingLogNoise& noise = form_.noise;
    put(each.q, noise.q);
    put(Eigen::VectorXd(each.tau.tail(n)), noise.tau);
    if (form_.has_rates) put(Eigen::VectorXd(each.v.tail(n)));
    if (form_.has_accelerations) put(Eigen::VectorXd(each.a.tail(n)));
    if (form_.wrench) put(form_.wrench(each));
    if (!mechanism_.floating_base) return;
    if (form_.has_force) put(Eigen::VectorXd(each.tau.head(6)), noise.force);
    const Eigen::Vector3d v = each.v.head(3), w = each.v.segment(3, 3), dw = each.a.segment(3, 3);
    if (form_.base == BaseColumns::imu) {
      const Eigen::Vector3d &r = form_.imu_place, force = each.a.head(3) + w.cross(v) - each.g_b;
      put(Eigen::Vector3d(form_.imu_axes.conjugate() * (force + dw.cross(r) + w.cross(w.cross(r)))),
          noise.accelerometer);
      put(Eigen::Vector3d(form_.imu_axes.conjugate() * w), noise.gyroscope);
    }
    if (has_pose()) {
      const Eigen::Quaterniond& turn = each.turn;
      put(each.place, noise.place);
      put(Eigen::Vector4d((flipped ? -1 : 1) * Eigen::Vector4d(turn.w(), turn.x(), turn.y(), turn.z())),
          noise.quaternion);
    }
    if (has_twist()) put(Eigen::VectorXd(each.v.head(6)));
    if (form_.base == BaseColumns::twist_with_derivatives) {
      put(Eigen::VectorXd(each.a.head(6)));
      put(each.g_b);
    }
  }

  FloatingLogForm form_;
  const Mechanism& mechanism_;
  Uniform draw_;
  std::string text_;
};

}  // namespace flatdyn::testing
