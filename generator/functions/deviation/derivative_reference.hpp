// SPDX-License-Identifier: GPL-2.0-or-later
// The values that derivatives of a function must have, by differences of the function's own reference in 50 digits,
// along lines on one side of the state, so that signs are constant. Second derivatives are differences of the first
// ones as they are derived.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "functions/function_row.hpp"
#include "robot/model/states.hpp"
#include "truth/definition/derivative_places.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {

class DerivativeReference {
 public:
  // `derivatives`: "vjp:NAME", or another derivative of a function. The robot and the mechanism must outlive this
  // object.
  DerivativeReference(const Robot& robot, const Mechanism& mechanism, const SymbolValues& symbols,
                      const Function& derivatives);

  // The entries of all outputs, to 1e-35 of their magnitude.
  std::vector<Real50> exact(const StateOf<Real50>& state) const;
  // The magnitude of their terms. A turn by a small angle changes a term by at most its size times the angle; for what
  // is no angle, the difference that a unit of it makes is used. With smooth friction, derivatives by rates and symbols
  // may be larger by 1/speed. Where the function divides by pivots of B, an error of
  // B is magnified by the largest row of |B⁻¹| |B|.
  std::vector<double> magnitude(const State& state) const;

 private:
  // Entry `entry` of an argument, in the tangent space.
  struct Direction {
    InputKind kind;
    int entry;
  };
  using Values = std::vector<Real50>;

  // The state that has moved by `distance` along a direction.
  template <class S>
  void move(const Direction& direction, const S& distance, StateOf<S>& state) const;
  template <class S>
  void move_position(int k, const S& distance, StateOf<S>& state) const;
  template <class S>
  void move_along_loops(int independent, const S& distance, StateOf<S>& state) const;
  // The derivatives of all entries along directions with these weights.
  Values derivatives_along(const StateOf<Real50>& state, const Values& weights) const;
  Values derivatives_by(const StateOf<Real50>& state, std::size_t direction) const;
  Values values_at(const StateOf<Real50>& state, const Values& weights, const Real50& step) const;
  // By direction, those of the entries of J. `here`: those of the function at the state.
  std::vector<std::vector<double>> magnitudes(const State& state) const;
  std::vector<double> magnitude_along(const State& state, const std::vector<double>& here,
                                      const Direction& along) const;
  // That by an independent joint of closed loops, of what has this magnitude at a state.
  std::vector<double> magnitude_along_loops(const State& state, int independent,
                                            const std::function<std::vector<double>(const State&)>& magnitude) const;
  // How fast terms may change with a symbol that is a length of closed loops, relative to their magnitude.
  double growth_by_symbol(const State& state, int symbol) const;
  std::vector<double> weighted_magnitude(const State& state) const;
  State unit_away(const State& state, const Direction& direction) const;
  // A and B of a step, as they are computed by a reference of their own, instead of the columns by q, q̇ and τ.
  template <class T>
  void take_state_derivatives(const std::vector<T>& entries, std::vector<std::vector<T>>& columns) const;
  // The direction of a step's length.
  std::size_t length_direction() const;
  // The entries of matrices from their columns.
  template <class T>
  std::vector<T> in_order(const std::vector<std::vector<T>>& columns) const;
  double amplification_at(const State& state) const;
  bool is_angle(const Direction& direction) const;
  bool is_along_loops(const Direction& direction) const;

  const Robot& robot_;
  const Mechanism& mechanism_;
  SymbolValues symbols_;
  Function function_;  // that is differentiated, without its graph
  const FunctionRow& row_;
  Derivative derivative_;
  std::vector<DerivativePlace> places_;  // of the entries of matrices
  std::optional<Function> gradient_;     // of second derivatives: wᵀ J as it is derived
  std::unique_ptr<GraphEvaluator<Real50>> gradient_at_;
  std::vector<Direction> directions_;
  ReferenceFunction<Real50> exact_;
  ReferenceFunction<double> magnitude_;
  reference::Robot<Real50> exact_robot_;
  reference::Robot<double> rounded_;
  reference::Robot<double> steep_;  // whose viscous friction has the largest slopes of smooth friction as well
  ReferenceFunction<double> steep_magnitude_;
  Function state_derivatives_;             // of a step: the function that returns A and B, without its graph,
  ReferenceFunction<Real50> state_exact_;  // and its reference; empty: there is none
  ReferenceFunction<double> state_magnitude_;
  double steepness_ = 1;  // 1/speed of the smooth friction that changes fastest
};

}  // namespace flatdyn
