// SPDX-License-Identifier: GPL-2.0-or-later
// Arithmetic of a field at another state of a motion, whose positions, rates and accelerations are values instead of
// inputs. Sines and cosines are those that a graph gets that computes the same positions.
#pragma once

#include <vector>

#include "graph/field_arithmetic.hpp"
#include "truth/definition/step_motion.hpp"

namespace flatdyn {

template <class F>
class StageArithmetic {
 public:
  using Scalar = F;

  // `field` must outlive this object.
  // `scale`: positive; the sign of x is drawn for scale · x, as a Graph takes the sign of a multiple of a sum to be
  // that of the sum.
  StageArithmetic(const FieldArithmetic<F>& field, PositionsOfStep<F> positions, std::vector<F> qd,
                  std::vector<F> qdd = {}, const F& scale = F(1))
      : field_(field), positions_(std::move(positions)), qd_(std::move(qd)), qdd_(std::move(qdd)), scale_(scale) {}

  F constant(const Rational& value) const { return field_.constant(value); }
  F input(const Input& input) const {
    const auto k = static_cast<std::size_t>(input.index);
    switch (argument_row(input.kind).in_state) {
      case InputKind::q:
        return positions_.q[k];
      case InputKind::g_b:
        return positions_.g_b[k];
      case InputKind::qd:
        return qd_[k];
      case InputKind::qdd:
        return qdd_.at(k);
      default:
        return field_.input(input);
    }
  }
  F divide(const F& a, const F& b) const { return field_.divide(a, b); }
  F sin(const Graph& graph, NodeId angle, const F&) const { return point(graph, angle).s; }
  F cos(const Graph& graph, NodeId angle, const F&) const { return point(graph, angle).c; }
  F sign(const F& x) const { return field_.sign(scale_ * x); }
  F sqrt(const F& x) const { return field_.sqrt(x); }
  F tanh(const F& x) const { return rational_tanh(field_, x); }

 private:
  using CirclePoint = typename FieldArithmetic<F>::CirclePoint;

  // The point of a sum of multiples of positions.
  CirclePoint point(const Graph& graph, NodeId angle) const {
    const Node& node = graph[angle];
    if (node.op == Op::input) return field_.point(input(node.input));
    CirclePoint total = field_.point(constant(node.value));
    for (const Term& term : node.terms) {
      const F position = input(graph[term.node].input);
      total = field_.add(total, field_.point_of_multiple(term.coefficient, position));
    }
    return total;
  }

  const FieldArithmetic<F>& field_;
  PositionsOfStep<F> positions_;
  std::vector<F> qd_, qdd_;
  F scale_;
};

}  // namespace flatdyn
