// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/regressor_references.hpp"

#include "truth/reference/regressor_by_columns.hpp"

namespace flatdyn::references {
namespace {

template <class S>
RegressorReference<S> regressor_of(const ReferenceModel<S>& model, RegressorColumns columns) {
  return {model.mechanism, model.robot, model.symbols, columns};
}

template <class S, RegressorColumns columns>
ReferenceFunction<S> matrix_of(const ReferenceModel<S>& model, const Function&) {
  return [Y = regressor_of(model, columns)](const StateOf<S>& state) { return row_by_row(Y.matrix(state)); };
}

template <RegressorColumns columns>
ReferenceFunction<double> magnitudes_of(const ReferenceModel<double>& model, const Function&) {
  return [Y = regressor_of(model, columns)](const State& state) { return row_by_row(magnitudes(Y, state)); };
}

template <RegressorColumns columns>
constexpr NumericReference matrix_with() {
  return {matrix_of<double, columns>, matrix_of<Real50, columns>, magnitudes_of<columns>, true};
}

template <class S>
ReferenceFunction<S> adaptive_matrix_of(const ReferenceModel<S>& model, const Function&) {
  return [Y = regressor_of(model, RegressorColumns::base)](const StateOf<S>& state) {
    return row_by_row(Y.adaptive_matrix(state));
  };
}

ReferenceFunction<double> adaptive_magnitudes_of(const ReferenceModel<double>& model, const Function&) {
  return [Y = regressor_of(model, RegressorColumns::base)](const State& state) {
    return row_by_row(adaptive_magnitudes(Y, state));
  };
}

template <class S>
ReferenceFunction<S> torques_of(const ReferenceModel<S>& model, const Function&) {
  return [Y = regressor_of(model, RegressorColumns::base)](const StateOf<S>& state) {
    return row_by_row(reference::VectorX<S>(Y.matrix(state) * vector_of(state.pi_b)));
  };
}

ReferenceFunction<double> torque_magnitudes_of(const ReferenceModel<double>& model, const Function&) {
  return [Y = regressor_of(model, RegressorColumns::base)](const State& state) {
    return row_by_row(reference::VectorX<double>(magnitudes(Y, state) * vector_of(state.pi_b).cwiseAbs()));
  };
}

template <class S>
ReferenceFunction<S> parameters_of(const ReferenceModel<S>& model, const Function&) {
  return [pi_b = base_values_of<S>(model.mechanism, model.symbols)](const StateOf<S>&) { return pi_b.values; };
}

ReferenceFunction<double> parameter_magnitudes_of(const ReferenceModel<double>& model, const Function&) {
  return [pi_b = base_values_of<double>(model.mechanism, model.symbols)](const State&) { return pi_b.magnitudes; };
}

template <class S>
ReferenceFunction<S> springs_of(const ReferenceModel<S>& model, const Function&) {
  return [Y = SpringRegressorReference<S>(model.mechanism, model.robot)](const StateOf<S>& state) {
    return row_by_row(Y.matrix(state));
  };
}

ReferenceFunction<double> spring_magnitudes_of(const ReferenceModel<double>& model, const Function&) {
  return [Y = SpringRegressorReference<double>(model.mechanism, model.robot)](const State& state) {
    return row_by_row(magnitudes(Y, state));
  };
}

}  // namespace

constinit const NumericReference regressor = matrix_with<RegressorColumns::all>();
constinit const NumericReference base_regressor = matrix_with<RegressorColumns::base>();
constinit const NumericReference base_parameters = {parameters_of<double>, parameters_of<Real50>,
                                                    parameter_magnitudes_of, true};
constinit const NumericReference inverse_dynamics_base = {torques_of<double>, torques_of<Real50>, torque_magnitudes_of,
                                                          true};
constinit const NumericReference adaptive_regressor = {adaptive_matrix_of<double>, adaptive_matrix_of<Real50>,
                                                       adaptive_magnitudes_of, true};
constinit const NumericReference spring_regressor = {springs_of<double>, springs_of<Real50>, spring_magnitudes_of,
                                                     true};

}  // namespace flatdyn::references
