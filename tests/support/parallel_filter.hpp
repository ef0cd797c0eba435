// SPDX-License-Identifier: GPL-2.0-or-later
// Identification once more, as the literature does it (inverse dynamic model and parallel filter; Gautier 1997), and
// apart from generator/laboratory/identify/: a Butterworth filter forwards and backwards, central differences, a
// regressor whose columns are torques of the recursive Newton–Euler reference for unit parameters, and weighted least
// squares of smallest norm over all 13 parameters of every joint.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "derivation/parameters/parameters.hpp"
#include "functions/load/loaded_robot.hpp"
#include "truth/reference/reference_model.hpp"
#include "truth/reference/regressor_by_columns.hpp"

namespace flatdyn::testing {

// Positions and torques at even times, a row per sample and a column per joint.
struct SampledLog {
  double dt = 0;  // s
  Eigen::MatrixXd q, tau;
};

// A Butterworth low-pass filter of order 4, as two sections of order 2 by the bilinear transform.
class Butterworth {
 public:
  Butterworth(double cutoff, double dt) : margin_(std::lround(3 / (cutoff * dt))) {
    const double w = std::tan(std::numbers::pi * cutoff * dt);
    for (std::size_t k = 0; k < sections_.size(); ++k) {
      const double damping = 2 * std::sin(std::numbers::pi * (2 * static_cast<double>(k) + 1) / 8);
      const double a0 = 1 + damping * w + w * w;
      sections_[k] = {w * w / a0, 2 * (w * w - 1) / a0, (1 - damping * w + w * w) / a0};
    }
  }

  // Filters each column forwards and backwards. Signals are continued by reflection about their end points.
  void filter(Eigen::MatrixXd& columns) const {
    for (auto column : columns.colwise()) {
      const Eigen::Index n = column.size(), m = std::min(margin_, n - 1);
      Eigen::VectorXd padded(n + 2 * m);
      padded.segment(m, n) = column;
      for (Eigen::Index k = 1; k <= m; ++k) {
        padded[m - k] = 2 * column[0] - column[k];
        padded[m + n - 1 + k] = 2 * column[n - 1] - column[n - 1 - k];
      }
      for (int pass = 0; pass < 2; ++pass) {
        for (const Section& section : sections_) section.run(padded);
        padded.reverseInPlace();
      }
      column = padded.segment(m, n);
    }
  }

 private:
  struct Section {
    double b0, a1, a2;

    // Begins as if the first value had been there forever.
    void run(Eigen::VectorXd& x) const {
      double in1 = x[0], in2 = x[0], out1 = x[0], out2 = x[0];
      for (double& value : x) {
        const double in = value;
        value = b0 * (in + 2 * in1 + in2) - a1 * out1 - a2 * out2;
        in2 = in1;
        in1 = in;
        out2 = out1;
        out1 = value;
      }
    }
  };
  Eigen::Index margin_;
  std::array<Section, 2> sections_;
};

struct ParallelFilterOptions {
  double motion_band = 20, band = 10;  // Hz: of q, and of columns and torques
  double slow = 0.02;                  // rad/s; rows of a joint near a time at which it is slower are left out
  double clearance = 0.1;              // s, to such a time
  int stride = 4;                      // of columns other than friction, in samples
  int decimate = 8;                    // of rows, in strides
};

class ParallelFilter {
 public:
  ParallelFilter(const LoadedRobot& robot, const ParallelFilterOptions& options)
      : n_(robot.mechanism.size()),
        options_(options),
        regressor_(robot.mechanism, reference_robot<double>(robot.robot, {}), {}, RegressorColumns::all) {}

  Eigen::MatrixXd matrix(const Eigen::VectorXd& q, const Eigen::VectorXd& qd, const Eigen::VectorXd& qdd) const {
    const auto list = [](const Eigen::VectorXd& v) { return std::vector<double>(v.begin(), v.end()); };
    State state;
    state.q = list(q);
    state.qd = list(qd);
    state.qdd = list(qdd);
    return regressor_.matrix(state);
  }

  // All parameters, joint after joint as in `Parameter`.
  Eigen::VectorXd identified(const SampledLog& log) const {
    const std::vector<Equations> equations = filtered(log);
    Eigen::VectorXd weights(n_), pi;
    for (int i = 0; i < n_; ++i) weights[i] = 1 / equations[at(i)].tau.norm();
    for (int round = 0; round < 4; ++round) {
      pi = solved(equations, weights);
      for (int i = 0; i < n_; ++i) {
        const Equations& of_joint = equations[at(i)];
        const auto rows = static_cast<double>(of_joint.tau.size());
        weights[i] = std::sqrt(rows) / (of_joint.tau - of_joint.Y * pi).norm();
      }
    }
    return pi;
  }

 private:
  struct Equations {
    Eigen::MatrixXd Y;
    Eigen::VectorXd tau;
  };
  // Positions, speeds and accelerations by central differences of filtered positions.
  struct Motion {
    Eigen::MatrixXd q, qd, qdd;
  };

  static std::size_t at(Eigen::Index index) { return static_cast<std::size_t>(index); }

  Motion motion_of(const SampledLog& log) const {
    Motion motion{log.q, Eigen::MatrixXd::Zero(log.q.rows(), n_), Eigen::MatrixXd::Zero(log.q.rows(), n_)};
    Eigen::MatrixXd& q = motion.q;
    Butterworth(options_.motion_band, log.dt).filter(q);
    const Eigen::Index inner = q.rows() - 2;
    motion.qd.middleRows(1, inner) = (q.bottomRows(inner) - q.topRows(inner)) / (2 * log.dt);
    motion.qdd.middleRows(1, inner) =
        (q.bottomRows(inner) - 2 * q.middleRows(1, inner) + q.topRows(inner)) / (log.dt * log.dt);
    return motion;
  }

  // By joint: its equations at every stride.
  std::vector<Equations> unfiltered(const Motion& motion) const {
    std::vector<Equations> equations(at(n_));
    const Eigen::Index strides = (motion.q.rows() - 1) / options_.stride + 1;
    for (Equations& each : equations) each.Y.resize(strides, kParametersPerJoint * n_);
    for (Eigen::Index k = 0; k < strides; ++k) {
      const Eigen::Index sample = k * options_.stride;
      const Eigen::MatrixXd Y = matrix(motion.q.row(sample), motion.qd.row(sample), motion.qdd.row(sample));
      for (int i = 0; i < n_; ++i) equations[at(i)].Y.row(k) = Y.row(i);
    }
    return equations;
  }

  // By joint: every N-th of the filtered equations, but those near slow times.
  std::vector<Equations> filtered(const SampledLog& log) const {
    const Motion motion = motion_of(log);
    const Butterworth by_sample(options_.band, log.dt), by_stride(options_.band, log.dt * options_.stride);
    Eigen::MatrixXd tau = log.tau, viscous = motion.qd, coulomb = motion.qd.array().sign();
    for (Eigen::MatrixXd* each : {&tau, &viscous, &coulomb}) by_sample.filter(*each);
    std::vector<Equations> equations = unfiltered(motion);
    for (int i = 0; i < n_; ++i) {
      Equations& of_joint = equations[at(i)];
      by_stride.filter(of_joint.Y);
      const std::vector<Eigen::Index> strides = strides_used(motion.qd.col(i), log.dt);
      const Eigen::MatrixXd all = std::move(of_joint.Y);
      of_joint.Y.resize(static_cast<Eigen::Index>(strides.size()), all.cols());
      of_joint.tau.resize(of_joint.Y.rows());
      for (Eigen::Index row = 0; row < of_joint.tau.size(); ++row) {
        const Eigen::Index stride = strides[at(row)], sample = stride * options_.stride;
        of_joint.Y.row(row) = all.row(stride);
        of_joint.Y(row, index_of(i, Parameter::Fv)) = viscous(sample, i);
        of_joint.Y(row, index_of(i, Parameter::Fs)) = coulomb(sample, i);
        of_joint.tau[row] = tau(sample, i);
      }
    }
    return equations;
  }

  std::vector<Eigen::Index> strides_used(const Eigen::VectorXd& speed, double dt) const {
    const Eigen::Index clearance = std::lround(options_.clearance / dt);
    const Eigen::Index between = static_cast<Eigen::Index>(options_.stride) * options_.decimate;
    std::vector<Eigen::Index> strides;
    for (Eigen::Index sample = 0; sample < speed.size(); sample += between) {
      const Eigen::Index first = sample - clearance;
      if (first < 0 || sample + clearance >= speed.size()) continue;
      const double least = speed.segment(first, 2 * clearance + 1).cwiseAbs().minCoeff();
      if (least > options_.slow) strides.push_back(sample / options_.stride);
    }
    return strides;
  }

  // The least squares of smallest norm.
  Eigen::VectorXd solved(const std::vector<Equations>& equations, const Eigen::VectorXd& weights) const {
    Eigen::Index rows = 0;
    for (const Equations& each : equations) rows += each.tau.size();
    const Eigen::Index parameters = equations.front().Y.cols();
    Eigen::MatrixXd all(rows, parameters + 1);
    Eigen::Index first = 0;
    for (int i = 0; i < n_; ++i) {
      const Equations& each = equations[at(i)];
      auto block = all.middleRows(first, each.tau.size());
      block << weights[i] * each.Y, weights[i] * each.tau;
      first += each.tau.size();
    }
    const Eigen::MatrixXd R =
        Eigen::HouseholderQR<Eigen::MatrixXd>(all).matrixQR().topRows(parameters).triangularView<Eigen::Upper>();
    Eigen::BDCSVD<Eigen::MatrixXd> svd(R.leftCols(parameters), Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(1e-9);
    return svd.solve(R.col(parameters));
  }

  int n_;
  ParallelFilterOptions options_;
  RegressorReference<double> regressor_;
};

}  // namespace flatdyn::testing
