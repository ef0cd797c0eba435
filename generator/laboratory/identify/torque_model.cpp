// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/torque_model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/languages/emit.hpp"
#include "derivation/notation/number_text.hpp"
#include "functions/planning/make_functions.hpp"
#include "proof/verify/compiled.hpp"
#include "robot/input/common/content_hash.hpp"
#include "robot/input/csv/names.hpp"
#include "robot/model/floating_base.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kRegressor = 0;
constexpr std::size_t kJacobian = 1;

LoadedRobot with_mechanism(const LoadedRobot& model, Mechanism mechanism) {
  LoadedRobot changed = model;
  changed.mechanism = std::move(mechanism);
  return changed;
}

// Without gravity where it is part of the base's acceleration.
LoadedRobot as_derived(const LoadedRobot& model) {
  LoadedRobot derived = model;
  if (model.mechanism.floating_base) derived.mechanism.gravity = zero_vector();
  return derived;
}

// Regressors do not have them.
void refuse_base_joint(const Mechanism& mechanism) {
  if (!has_base_joint(mechanism)) return;
  throw Failure(FailureKind::unsupported,
                "measured motion: a floating base with armature or friction of its own is not supported",
                "a real base has neither: write <freejoint/>, or leave armature, viscous and coulomb out of [base]");
}

// Its laws are those that identification searches for.
void refuse_friction_by_rate(const Mechanism& mechanism) {
  const auto body = std::find_if(mechanism.bodies.begin(), mechanism.bodies.end(),
                                 [](const Body& each) { return each.dry.is_smooth() || !each.dry.is_linear(); });
  if (body == mechanism.bodies.end()) return;
  throw Failure(
      FailureKind::unsupported,
      fmt::format("measured motion: friction of joint \"{}\" that is not F_s sgn(qd) is not supported", body->joint),
      "leave out coulomb_speed, static and backward: identify --friction smooth estimates a speed");
}

std::vector<std::vector<int>> nonzero_columns(const Function& regressor) {
  const Output& y = regressor.outputs.front();
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(y.rows));
  for (int i = 0; i < y.rows; ++i) {
    for (int k = 0; k < y.cols; ++k) {
      const NodeId entry = y.entries[static_cast<std::size_t>(i * y.cols + k)];
      if (!regressor.graph.is_zero(entry)) columns[static_cast<std::size_t>(i)].push_back(k);
    }
  }
  return columns;
}

// The factors of the coordinates in the position of a body's joint.
Eigen::VectorXd coordinate_factors(const Mechanism& mechanism, int body, int coordinates) {
  Eigen::VectorXd factors = Eigen::VectorXd::Zero(coordinates);
  for (int k = 0; k < coordinates; ++k) {
    factors(k) = nearest_double(mechanism.rate_factor(body, mechanism.base_bodies() + k));
  }
  return factors;
}

}  // namespace

TorqueModel::TorqueModel(const LoadedRobot& model, ParameterSet set, Progress& progress)
    : model_(with_mechanism(model, with_parameter_set(model.mechanism, set))) {
  require_numbers(model.robot, "measured motion");
  refuse_base_joint(model.mechanism);
  refuse_friction_by_rate(model.mechanism);
  const LoadedRobot derived = as_derived(model_);
  base_ = base_parameters(derived.mechanism);
  for (const Number& value : base_values(model.mechanism, base_)) {
    file_values_.push_back(nearest_double(value));
  }
  const std::vector<Number> of_file = dynamic_parameters(model.mechanism);
  for (int i = 0; i < model.mechanism.size(); ++i) {
    file_rotors_.push_back(nearest_double(of_file[static_cast<std::size_t>(index_of(i, Parameter::Im))]));
  }
  PipelineOptions options;
  options.functions = {"base_regressor", "jacobian"};
  Diagnostics none;
  const std::vector<Function> functions = functions_of(make_functions(derived, options, progress, none));
  columns_ = nonzero_columns(functions[kRegressor]);
  const int n = static_cast<int>(mechanism().joints().size());
  stiffness_ = Eigen::MatrixXd::Zero(n, n);
  relaxed_ = Eigen::VectorXd::Zero(n);
  for (int i = 0; i < model.mechanism.body_count(); ++i) {
    const Body& body = model.mechanism.bodies[static_cast<std::size_t>(i)];
    if (vanishes(body.stiffness)) continue;
    const Eigen::VectorXd factors = coordinate_factors(model.mechanism, i, n);
    stiffness_ += nearest_double(body.stiffness) * factors * factors.transpose();
    relaxed_ += nearest_double(body.stiffness * body.spring_reference) * factors;
  }
  progress.step("compiling the regressor");
  compiled_ = std::make_unique<CompiledFunctions>(derived.mechanism, functions);
  fingerprint_ = content_hash({emit_header(derived.mechanism, functions, {})});
}

TorqueModel::~TorqueModel() = default;

std::string TorqueModel::name_of(int equation) const {
  const std::string of_base = base_name_of(CsvQuantity::tau, equation, mechanism());
  return of_base.empty() ? mechanism().joint(equation).joint : of_base;
}

std::string TorqueModel::parameter_name_of(int k) const {
  return parameter_name(base_.columns[static_cast<std::size_t>(k)], first_joint());
}

const Body& TorqueModel::body_of_parameter(int k) const {
  return mechanism().bodies[static_cast<std::size_t>(joint_of(base_.columns[static_cast<std::size_t>(k)]))];
}

std::vector<int> TorqueModel::first_of_joint() const {
  std::vector<int> first;
  for (int i = 0; i < equations(); ++i) {
    const int part = mechanism().joint(i).spherical;
    first.push_back(i < first_joint() ? 0 : i - std::max(0, part - 1));
  }
  return first;
}

std::string TorqueModel::subject_of(int equation) const {
  constexpr int kDirections = 3;
  if (equation >= first_joint()) return fmt::format("joint \"{}\"", mechanism().joint(equation).joint);
  return fmt::format("the base's {} {}", equation < kDirections ? "force along" : "moment about",
                     "xyz"[equation % kDirections]);
}

void TorqueModel::regressor(const double* q, const double* qd, const double* qdd, double* y) const {
  const double* const in[] = {q, qd, qdd};
  compiled_->evaluate(kRegressor, in, y);
}

void TorqueModel::add_springs(const double* q, double* tau) const {
  if (stiffness_.isZero(0)) return;
  Eigen::VectorXd positions(relaxed_.size());
  for (int i = 0; i < joints(); ++i) positions(i) = q[mechanism().position_of(first_joint() + i)];
  Eigen::Map<Eigen::VectorXd>(tau + first_joint(), positions.size()) += stiffness_ * positions - relaxed_;
}

std::vector<Eigen::MatrixXd> TorqueModel::acceleration_rows(const double* q) const {
  using RowByRow = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const int n = equations();
  RowByRow y(n, parameters()), at_rest(n, parameters());
  const std::vector<double> still(static_cast<std::size_t>(n), 0);
  regressor(q, still.data(), still.data(), at_rest.data());
  std::vector<Eigen::MatrixXd> rows;
  for (int j = 0; j < n; ++j) {
    std::vector<double> qdd = still;
    qdd[static_cast<std::size_t>(j)] = 1;
    regressor(q, still.data(), qdd.data(), y.data());
    rows.emplace_back(y - at_rest);
  }
  return rows;
}

void TorqueModel::tip_torque(const double* q, const double* h_e, double* tau) const {
  constexpr int kWrench = 6;
  const int n = equations();
  std::vector<double> jacobian(static_cast<std::size_t>(kWrench * n));
  const double* const in[] = {q};
  compiled_->evaluate(kJacobian, in, jacobian.data());
  for (int i = 0; i < n; ++i) {
    tau[i] = 0;
    for (int k = 0; k < kWrench; ++k) tau[i] += jacobian[static_cast<std::size_t>(k * n + i)] * h_e[k];
  }
}

}  // namespace flatdyn
