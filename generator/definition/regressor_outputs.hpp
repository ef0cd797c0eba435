// SPDX-License-Identifier: GPL-2.0-or-later
// The values by definition of the functions that are linear in the parameters, at one point of a field. A base
// regressor is right if Y_b K is Y: its columns, which are among those of Y, and K are then right, too.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "definition/joint_signs.hpp"
#include "definition/lagrangian_regressor.hpp"
#include "model/joint_points.hpp"
#include "symbolic/parameters/base_parameters.hpp"

namespace flatdyn {

inline bool is_regressor(const std::string& function) {
  return function == "regressor" || function == "base_regressor" || function == "inverse_dynamics_base" ||
         function == "adaptive_regressor" || function == "base_parameters";
}

template <class Arithmetic>
class RegressorOutputs {
 public:
  using F = typename Arithmetic::Scalar;
  using Values = std::vector<F>;

  RegressorOutputs(const Mechanism& mechanism, const MechanismOver<F>& field, const std::string& function,
                   Arithmetic& arithmetic, const std::vector<JointPoint<F>>& q)
      : function_(function),
        arithmetic_(arithmetic),
        number_(mechanism.symbols, arithmetic),
        mechanism_(mechanism),
        lagrangian_(field, q),
        given_(parameters_in(mechanism, ParameterSet::given)) {
    if (function != "regressor") base_ = base_parameters(mechanism);
    for (const Number& parameter : dynamic_parameters(mechanism)) parameters_.push_back(number_(parameter));
  }

  // The function's own values in the form in which they are compared: Y_b K for a base regressor, Y_b π_b for base
  // parameters, both with the terms that vanish only where the loops are closed.
  Values found(const Values& values) const {
    if (function_ == "base_parameters") return with_hidden_torques(torques(values));
    if (function_ != "base_regressor" && function_ != "adaptive_regressor") return values;
    const std::size_t b = base_.columns.size();
    Values product;
    for (std::size_t i = 0; i < static_cast<std::size_t>(lagrangian_.size()); ++i) {
      Values row(given_.size(), F(0));
      for (std::size_t k = 0; k < b; ++k) {
        for (const auto& [index, coefficient] : base_.combination[k]) {
          row[static_cast<std::size_t>(index)] += values[i * b + k] * number_(coefficient);
        }
      }
      add_hidden(static_cast<int>(i), row);
      product.insert(product.end(), row.begin(), row.end());
    }
    return product;
  }

  // The values by the definition, to which found() must be equal.
  Values entries() const {
    if (function_ == "regressor") return actual().entries();
    if (function_ == "base_regressor") return given_columns(actual());
    if (function_ == "inverse_dynamics_base") return torques(base_inputs());
    if (function_ == "base_parameters") return times(actual(), parameters_);
    return given_columns(adaptive());
  }

 private:
  Matrix<F> adaptive() const {
    return lagrangian_.adaptive(drawn(InputKind::qd), drawn(InputKind::qd_r), drawn(InputKind::qdd_r),
                                signs(InputKind::qd_r));
  }

  F product(const ParameterForm& form, const std::function<F(int)>& factor) const {
    F sum(0);
    for (const auto& [index, coefficient] : form) sum += number_(coefficient) * factor(index);
    return sum;
  }

  // Adds row i of Σ (Y shift) share.
  void add_hidden(int i, Values& row) const {
    if (base_.shifts.empty()) return;
    const Matrix<F> Y = function_ == "adaptive_regressor" ? adaptive() : actual();
    for (const LoopShift& loop : base_.shifts) {
      const F moved = product(loop.shift, [&](int index) { return Y(i, index); });
      for (const auto& [index, coefficient] : loop.share) {
        row[static_cast<std::size_t>(index)] += moved * number_(coefficient);
      }
    }
  }

  Values with_hidden_torques(Values tau) const {
    const Matrix<F> Y = actual();
    for (const LoopShift& loop : base_.shifts) {
      const F hidden = product(loop.share, [&](int index) { return parameters_[static_cast<std::size_t>(index)]; });
      for (int i = 0; i < Y.rows(); ++i) {
        tau[static_cast<std::size_t>(i)] += product(loop.shift, [&](int index) { return Y(i, index); }) * hidden;
      }
    }
    return tau;
  }

  Values drawn(InputKind kind) const {
    Values result;
    for (int i = 0; i < lagrangian_.size(); ++i) result.push_back(arithmetic_.input({kind, i}));
    return result;
  }

  Values signs(InputKind kind) const { return joint_signs(mechanism_, arithmetic_, kind); }

  Matrix<F> actual() const {
    return lagrangian_.regressor(drawn(InputKind::qd), drawn(InputKind::qdd), signs(InputKind::qd));
  }

  // Y with the columns zero of parameters that the model does not have, as in Y_b K.
  Values given_columns(const Matrix<F>& Y) const {
    Values entries;
    for (int i = 0; i < Y.rows(); ++i) {
      for (int k = 0; k < Y.cols(); ++k) entries.push_back(given_[static_cast<std::size_t>(k)] ? Y(i, k) : F(0));
    }
    return entries;
  }

  Values base_inputs() const {
    Values values;
    for (int k = 0; k < base_.size(); ++k) values.push_back(arithmetic_.input({InputKind::pi_b, k}));
    return values;
  }

  // The torques Y_b π_b.
  Values torques(const Values& base_values) const {
    const Matrix<F> Y = actual();
    Values tau(static_cast<std::size_t>(Y.rows()), F(0));
    for (std::size_t k = 0; k < base_values.size(); ++k) {
      for (int i = 0; i < Y.rows(); ++i) tau[static_cast<std::size_t>(i)] += Y(i, base_.columns[k]) * base_values[k];
    }
    return tau;
  }

  const std::string& function_;
  Arithmetic& arithmetic_;
  NumberMap<Arithmetic> number_;
  const Mechanism& mechanism_;
  LagrangianRegressor<F> lagrangian_;
  std::vector<bool> given_;
  BaseParameters base_;
  Values parameters_;  // π
};

}  // namespace flatdyn
