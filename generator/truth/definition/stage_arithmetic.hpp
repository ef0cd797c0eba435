// SPDX-License-Identifier: GPL-2.0-or-later
// Arithmetic of a field at another state of a motion, whose positions, rates and accelerations are values instead of
// inputs. Sines and cosines are those that a graph gets that computes the same positions.
#pragma once

#include <vector>

#include "graph/field_arithmetic.hpp"

namespace flatdyn {

template <class F>
class StageArithmetic {
 public:
  using Scalar = F;

  // `field` must outlive this object.
  // `scale`: positive; the sign of x is drawn for scale · x, as a Graph takes the sign of a multiple of a sum to be
  // that of the sum.
  StageArithmetic(const FieldArithmetic<F>& field, std::vector<F> q, std::vector<F> qd, std::vector<F> qdd = {},
                  const F& scale = F(1))
      : field_(field), q_(std::move(q)), qd_(std::move(qd)), qdd_(std::move(qdd)), scale_(scale) {}

  F constant(const Rational& value) const { return field_.constant(value); }
  F input(const Input& input) const {
    if (input.kind == InputKind::q) return q_[static_cast<std::size_t>(input.index)];
    if (input.kind == InputKind::qd) return qd_[static_cast<std::size_t>(input.index)];
    if (input.kind == InputKind::qdd) return qdd_.at(static_cast<std::size_t>(input.index));
    return field_.input(input);
  }
  F divide(const F& a, const F& b) const { return field_.divide(a, b); }
  F sin(const Graph& graph, NodeId angle, const F&) const { return point(graph, angle).s; }
  F cos(const Graph& graph, NodeId angle, const F&) const { return point(graph, angle).c; }
  F sign(const F& x) const { return field_.sign(scale_ * x); }
  F sqrt(const F& x) const { return field_.sqrt(x); }

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
  std::vector<F> q_, qd_, qdd_;
  F scale_;
};

}  // namespace flatdyn
