// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of a known robot: sums of sines, with torques by the recursive reference.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

#include "flatdyn/reference/newton_euler.hpp"
#include "functions/load/loaded_robot.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn::testing {

struct SimulatedSample {
  double time = 0;
  Eigen::VectorXd q, qd, qdd, tau;
};

struct SimulationOptions {
  int samples = 1000;
  double rate = 100;         // Hz
  double fundamental = 0.1;  // Hz; five harmonics
  double noise = 0;          // standard deviation of τ, N m or N
  unsigned seed = 1;
  bool moving = true;     // if false, only the first joint moves
  bool standing = false;  // if true, every sample is a pose in which the robot stands still
  double amplitude = 1;
  std::vector<double> around{};  // for closed loops: all of q, about which the independent joints move
};

// Draws numbers uniform in [-1, 1], the same on every machine.
class Uniform {
 public:
  explicit Uniform(unsigned seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_()) / static_cast<double>(std::mt19937::max()) * 2 - 1; }
  // A normal number of variance 1.
  double normal() {
    constexpr double kLeast = 1e-12;
    const double u = std::max(std::abs((*this)()), kLeast);
    return std::sqrt(-2 * std::log(u)) * std::cos(std::numbers::pi * (*this)());
  }

 private:
  std::mt19937 engine_;
};

// The positions of all joints for those of the independent ones, near the previous positions.
inline Eigen::VectorXd closed(const reference::Robot<double>& robot, const Eigen::VectorXd& independent,
                              Eigen::VectorXd before) {
  if (robot.loops.empty()) return independent;
  for (std::size_t i = 0; i < robot.independent.size(); ++i) {
    before[robot.independent[i]] = independent[static_cast<Eigen::Index>(i)];
  }
  if (!reference::close_loops(robot, before, 1e-14))
    throw Failure(FailureKind::bug, "the loops cannot be closed there");
  return before;
}

inline std::vector<SimulatedSample> simulated(const LoadedRobot& model, const SimulationOptions& options) {
  constexpr int kHarmonics = 5;
  const int n = model.mechanism.size();
  const reference::Robot<double> robot = reference_robot<double>(model.robot, {});
  Uniform draw(options.seed);
  Eigen::MatrixXd a(n, kHarmonics), b(n, kHarmonics);
  Eigen::VectorXd offset(n);
  for (int i = 0; i < n; ++i) {
    offset(i) = draw() / 2;
    if (!options.around.empty()) offset(i) = options.around[static_cast<std::size_t>(model.mechanism.position_of(i))];
    for (int l = 0; l < kHarmonics; ++l) {
      a(i, l) = options.moving || i == 0 ? options.amplitude * draw() / (l + 1) : 0;
      b(i, l) = options.moving || i == 0 ? options.amplitude * draw() / (l + 1) : 0;
    }
  }
  Eigen::VectorXd near =
      Eigen::Map<const Eigen::VectorXd>(options.around.data(), static_cast<Eigen::Index>(options.around.size()));
  std::vector<SimulatedSample> samples;
  for (int k = 0; k < options.samples; ++k) {
    SimulatedSample sample{k / options.rate, offset, Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n), {}};
    for (int l = 0; l < kHarmonics; ++l) {
      const double w = 2 * std::numbers::pi * options.fundamental * (l + 1);
      const double s = std::sin(w * sample.time), c = std::cos(w * sample.time);
      sample.q += s * a.col(l) + c * b.col(l);
      sample.qd += w * (c * a.col(l) - s * b.col(l));
      sample.qdd -= w * w * (s * a.col(l) + c * b.col(l));
    }
    if (options.standing) {
      sample.qd.setZero();
      sample.qdd.setZero();
    }
    sample.q = near = closed(robot, sample.q, near);
    sample.tau = reference::inverse_dynamics<double>(robot, sample.q, sample.qd, sample.qdd);
    for (int i = 0; i < n; ++i) sample.tau(i) += options.noise * draw.normal();
    samples.push_back(std::move(sample));
  }
  return samples;
}

enum class LogDerivatives { both, rates, none };

inline void write_log(const std::filesystem::path& path, const std::vector<SimulatedSample>& samples,
                      LogDerivatives derivatives = LogDerivatives::both) {
  std::ofstream file(path);
  const auto names = [&](const char* stem, Eigen::Index n) {
    for (Eigen::Index i = 1; i <= n; ++i) file << fmt::format(",{}{}", stem, i);
  };
  const auto numbers = [&](const Eigen::VectorXd& v) {
    for (const double value : v) file << fmt::format(",{}", value);
  };
  file << "t";
  const Eigen::Index n = samples.front().tau.size();
  names("q", samples.front().q.size());
  names("tau", n);
  if (derivatives != LogDerivatives::none) names("qd", n);
  if (derivatives == LogDerivatives::both) names("qdd", n);
  file << "\n";
  for (const SimulatedSample& sample : samples) {
    file << fmt::format("{}", sample.time);
    numbers(sample.q);
    numbers(sample.tau);
    if (derivatives != LogDerivatives::none) numbers(sample.qd);
    if (derivatives == LogDerivatives::both) numbers(sample.qdd);
    file << "\n";
  }
}

}  // namespace flatdyn::testing
