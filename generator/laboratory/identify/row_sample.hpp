// SPDX-License-Identifier: GPL-2.0-or-later
// Some rows of a log, weighted by its noise, with which other readings of the log can be tried quickly. Each cost is
// the least Σ ((Y_i π - τ_i) / σ_i)² over all parameters π; of a sound log it is near count().
#pragma once

#include <functional>
#include <optional>

#include "laboratory/identify/fit_quality.hpp"
#include "laboratory/identify/torque_model.hpp"

namespace flatdyn {

class RowSample {
 public:
  RowSample(const TorqueModel& model, const Measurement& measurement, const std::vector<JointFit>& fits);

  double cost(Eigen::VectorXd* parameters = nullptr) const;
  const std::vector<double>& weights() const { return weights_; }  // by joint, 1/σ_i²
  double count() const;
  // Torques of joint i that are `gain` times the right ones; noise is not part of the gain.
  double cost_with_gain(int joint, double gain, Eigen::VectorXd* parameters = nullptr) const;
  double cost_with_exchanged_torques(int joint, int other) const;
  // The force on a floating base, and its moment, with the other sign.
  double cost_with_reaction() const;
  // All columns of two joints exchanged: positions and torques. Joints are counted from 0, without a floating base.
  double cost_with_exchanged_joints(int joint, int other) const;
  // Torques of joint i with a constant added, which is found, N m or N.
  double cost_with_torque_offset(int joint, double& offset) const;
  // Torques of all joints that are late by a time, which is found, s. Rows for which the log has no torques at that
  // time count like the others.
  double cost_with_delay(double& delay) const { return cost_with_delay(delay, 0, model_.joints()); }
  // The same of joint i alone.
  double cost_with_delay_of(int joint, double& delay) const { return cost_with_delay(delay, joint, joint + 1); }
  // q, q̇ and q̈ of the joints changed alike by a linear map.
  using JointMap = std::function<void(Eigen::Ref<Eigen::VectorXd> of_joints)>;
  double cost_with_positions(const JointMap& change) const;
  double cost_with_offset(int joint, double offset) const;
  // The base's entries of q̇ and q̈ changed, (0, ω) and (f, ω̇).
  double cost_with_base(const std::function<void(Eigen::VectorXd& qd, Eigen::VectorXd& qdd)>& change) const;

  struct Instant {
    Eigen::VectorXd q, qd, qdd, tau;
    Eigen::VectorXd tau_rate;  // dτ/dt
    Eigen::MatrixXd Y;         // n × all parameters, filtered
    std::vector<bool> used{};  // by joint
  };
  const std::vector<Instant>& instants() const { return instants_; }
  // The least cost with other rows, one matrix (n × columns) per instant.
  double cost_of(const std::vector<Eigen::MatrixXd>& Y, Eigen::VectorXd* parameters = nullptr) const;
  // With further columns behind those there are, n × any number.
  double cost_with_more(const std::function<Eigen::MatrixXd(const Instant&)>& columns) const;

 private:
  // Normal equations of one joint or of several: |Y π - τ|², weighted.
  struct Normal {
    Eigen::MatrixXd H;
    Eigen::VectorXd h;
    double s = 0;
    void add(const Eigen::RowVectorXd& row, double tau, double weight);
  };
  // The torques of one row of the log, and their rates.
  struct Reading {
    int log = 0;
    long index = 0;
    double time = 0;
    Eigen::VectorXd tau, rate;
  };
  // The torques at another time, from the readings on both sides; none where there is one on one side alone.
  std::optional<Reading> reading_at(std::size_t place, double time) const;
  // With torques that are late of the joints `first` up to `end`.
  double cost_with_delay(double& delay, int first, int end) const;
  static double least(const Normal& normal, Eigen::VectorXd* solution = nullptr);
  Normal joint_normal(int joint, int torques_of) const;
  Normal sum_without(int joint, int other = -1) const;
  std::vector<Eigen::MatrixXd> changed_rows(const std::function<void(Instant&)>& change, const JointMap& map) const;
  // The cost of rows whose torques are those of the joints `of`.
  double cost_of(const std::vector<Eigen::MatrixXd>& Y, const std::vector<int>& of,
                 Eigen::VectorXd* parameters = nullptr) const;

  const TorqueModel& model_;
  int parameters_;  // with those behind π_b
  std::vector<Instant> instants_;
  std::size_t step_ = 1;           // instants_ are every step_-th row of
  std::vector<Reading> readings_;  // in the order of logs and times
  std::vector<double> weights_;    // 1/σ_i²
  std::vector<Normal> normals_;    // by joint
};

}  // namespace flatdyn
