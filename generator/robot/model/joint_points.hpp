// SPDX-License-Identifier: GPL-2.0-or-later
// Positions of the joints for coordinates that an Arithmetic draws, so that sines and cosines are the same as in any
// Graph.
#pragma once

#include <vector>

#include "graph/evaluate.hpp"
#include "robot/model/body_poses.hpp"

namespace flatdyn {

// The position, rate or acceleration of body i's joint as a sum: the inputs of this kind with their factors.
inline NodeId joint_sum(const Mechanism& mechanism, InputKind kind, int i, Graph& graph) {
  if (!mechanism.is_coupled()) return graph.input({kind, kind == InputKind::q ? mechanism.position_of(i) : i});
  std::vector<Term> terms;
  const auto row = static_cast<std::size_t>(i);
  const std::vector<Number> factors = kind == InputKind::q ? mechanism.coupling[row] : mechanism.rate_coupling()[row];
  int k = 0;
  for (const Number& factor : factors) {
    if (!vanishes(factor)) terms.push_back({to_rational(factor), graph.input({kind, k})});
    ++k;
  }
  return graph.sum(terms);
}

// The values of nodes of a graph whose inputs the arithmetic knows.
template <class Arithmetic>
std::vector<typename Arithmetic::Scalar> values_of(Graph graph, const std::vector<NodeId>& nodes,
                                                   Arithmetic& arithmetic) {
  Function function;
  function.graph = std::move(graph);
  function.outputs.push_back({"", Layout::vector, static_cast<int>(nodes.size()), 1, nodes, ""});
  const auto all = evaluate(function, arithmetic);
  std::vector<typename Arithmetic::Scalar> values;
  for (const NodeId node : nodes) values.push_back(all[static_cast<std::size_t>(node)]);
  return values;
}

// The position of body i's joint; zero for coordinates around the present pose.
template <class Arithmetic, class F = typename Arithmetic::Scalar>
JointPoint<F> joint_point(const Mechanism& mechanism, Arithmetic& arithmetic, int i) {
  JointPoint<F> point;
  if (mechanism.is_around_pose(i)) return point;
  Graph graph;
  const NodeId position = joint_sum(mechanism, InputKind::q, i, graph);
  if (mechanism.bodies[static_cast<std::size_t>(i)].prismatic) {
    point.d = values_of(std::move(graph), {position}, arithmetic)[0];
    return point;
  }
  const NodeId c = graph.cos(position), s = graph.sin(position);
  std::vector<NodeId> nodes = {c, s};
  if (!vanishes(mechanism.bodies[static_cast<std::size_t>(i)].stiffness)) nodes.push_back(position);
  const std::vector<F> values = values_of(std::move(graph), nodes, arithmetic);
  point.c = values[0];
  point.s = values[1];
  if (values.size() > 2) point.d = values[2];
  return point;
}

// The positions of all bodies' joints.
template <class Arithmetic, class F = typename Arithmetic::Scalar>
std::vector<JointPoint<F>> joint_points(const Mechanism& mechanism, Arithmetic& arithmetic) {
  std::vector<JointPoint<F>> points;
  for (int i = 0; i < mechanism.body_count(); ++i) points.push_back(joint_point(mechanism, arithmetic, i));
  return points;
}

}  // namespace flatdyn
