// SPDX-License-Identifier: GPL-2.0-or-later
// Where the joints are for coordinates as an Arithmetic draws them: so sines and cosines are those of any Graph.
#pragma once

#include <vector>

#include "model/lagrangian.hpp"

namespace flatdyn {

template <class Arithmetic, class F = typename Arithmetic::Scalar>
JointPoint<F> joint_point(const Mechanism& mechanism, const Arithmetic& arithmetic, int i) {
  Graph graph;  // of the joint's angle
  std::vector<Term> terms;
  F value = F(0);
  const auto add = [&](int k, const Rational& factor) {
    const Input input{InputKind::q, k};
    value += arithmetic.constant(factor) * arithmetic.input(input);
    terms.push_back({factor, graph.input(input)});
  };
  if (!mechanism.is_coupled()) add(i, 1);
  for (int k = 0; k < mechanism.size() && mechanism.is_coupled(); ++k) {
    const Number& factor = mechanism.coupling[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
    if (!vanishes(factor)) add(k, to_rational(factor));
  }
  JointPoint<F> point;
  if (mechanism.bodies[static_cast<std::size_t>(i)].prismatic) {
    point.d = value;
    return point;
  }
  const NodeId angle = graph.sum(terms);
  point.c = arithmetic.cos(graph, angle, value);
  point.s = arithmetic.sin(graph, angle, value);
  return point;
}

// Of every body's joint.
template <class Arithmetic, class F = typename Arithmetic::Scalar>
std::vector<JointPoint<F>> joint_points(const Mechanism& mechanism, const Arithmetic& arithmetic) {
  std::vector<JointPoint<F>> points;
  for (int i = 0; i < mechanism.body_count(); ++i) points.push_back(joint_point(mechanism, arithmetic, i));
  return points;
}

}  // namespace flatdyn
