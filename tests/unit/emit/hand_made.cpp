// SPDX-License-Identifier: GPL-2.0-or-later
#include "unit/emit/hand_made.hpp"

#include "graph/arithmetic.hpp"

namespace flatdyn::testing {

namespace {

// b_11 = 3.5 + 1.2 c_2, b_12 = 0.8 + 0.6 c_2, b_22 = 0.8
std::vector<NodeId> inertia_entries(Builder& b) {
  const NodeId c_2 = b.graph.cos(b.q(1));
  const NodeId b_11 = b.named(b.plus({b.number("7/2"), b.scaled("6/5", c_2)}), "b_11");
  const NodeId b_12 = b.named(b.plus({b.number("4/5"), b.scaled("3/5", c_2)}), "b_12");
  return {b_11, b_12, b_12, b.number("4/5")};
}

double value_of_input(const Input& input) {
  switch (input.kind) {
    case InputKind::q:
      return 0.3 + input.index;
    case InputKind::qd:
      return -0.7 + input.index;
    case InputKind::qdd:
      return 0.2 + input.index;
    case InputKind::tau:
      return 1.5 - input.index;
    default:
      return 1.25;
  }
}

}  // namespace

NodeId Builder::plus(const std::vector<NodeId>& nodes) {
  std::vector<Term> terms;
  for (NodeId node : nodes) terms.push_back({1, node});
  return graph.sum(terms);
}

NodeId Builder::named(NodeId id, const char* name) {
  graph.set_name(id, name);
  return id;
}

Mechanism two_link_mechanism(const std::vector<std::string>& symbols) {
  Mechanism mechanism;
  mechanism.name = "two-link arm";
  mechanism.bodies.resize(2);
  mechanism.bodies[0].joint = "shoulder";
  mechanism.bodies[0].link = "upper_arm";
  mechanism.bodies[0].limits.lower = Value{-GiNaC::Pi / 2, {}};
  mechanism.bodies[0].limits.upper = Value{exact_decimal("2.8973"), {}};
  mechanism.bodies[0].limits.effort = Value{87, {}};
  mechanism.bodies[1].joint = "double";
  mechanism.bodies[1].link = "forearm";
  mechanism.bodies[1].parent = 0;
  mechanism.bodies[1].continuous = true;
  mechanism.gravity = {0, 0, exact_decimal("-9.81")};
  mechanism.tip.link = "forearm";
  mechanism.merged = {"cover"};
  for (const std::string& name : symbols) mechanism.symbols.push_back({GiNaC::symbol(name), name, {}});
  return mechanism;
}

Function two_link_inertia_matrix() {
  Builder b;
  const std::vector<NodeId> entries = inertia_entries(b);
  const NodeId zero = b.number("0");
  Function function{.name = "inertia_matrix",
                    .summary = "Joint-space inertia matrix",
                    .equation = "(7.32)",
                    .inputs = {InputKind::q},
                    .graph = {},
                    .outputs = {{"B", Layout::matrix, 2, 2, entries, "inertia matrix, kg m^2"},
                                {"D", Layout::matrix, 2, 2, {entries[0], zero, zero, entries[3]}, "its diagonal"}},
                    .validity_conditions = {}};
  function.graph = b.graph;
  return function;
}

Function two_link_inverse_dynamics() {
  Builder b;
  const std::vector<NodeId> B = inertia_entries(b);
  const NodeId h = b.named(b.scaled("-3/5", b.graph.sin(b.q(1))), "h");
  const NodeId c_1 = b.graph.cos(b.q(0)), c_2 = b.graph.cos(b.q(1)), s_1 = b.graph.sin(b.q(0)),
               s_2 = b.graph.sin(b.q(1));
  const NodeId c_12 = b.plus({b.times({c_1, c_2}), b.scaled("-1", b.times({s_1, s_2}))});
  const NodeId g_2 = b.named(b.scaled("2943/500", c_12), "g_2");
  const NodeId g_1 = b.plus({b.scaled("981/50", c_1), g_2});
  const NodeId qd_1 = b.qd(0), qd_2 = b.qd(1);
  const NodeId friction = b.scaled("1/20", b.graph.sign(qd_1));
  const NodeId tau_1 = b.plus({b.times({B[0], b.qdd(0)}), b.times({B[1], b.qdd(1)}),
                               b.scaled("2", b.times({h, qd_1, qd_2})), b.times({h, qd_2, qd_2}), g_1, friction});
  const NodeId tau_2 =
      b.plus({b.times({B[2], b.qdd(0)}), b.times({B[3], b.qdd(1)}), b.scaled("-1", b.times({h, qd_1, qd_1})), g_2});
  Function function{.name = "inverse_dynamics",
                    .summary = "Joint torques of a motion, without contact",
                    .equation = "(7.42)",
                    .inputs = {InputKind::q, InputKind::qd, InputKind::qdd},
                    .graph = {},
                    .outputs = {{"tau", Layout::vector, 2, 1, {tau_1, tau_2}, "joint torques, N m"}},
                    .validity_conditions = {}};
  function.graph = b.graph;
  return function;
}

Function two_link_kinetic_energy() {
  Builder b;
  const std::vector<NodeId> B = inertia_entries(b);
  const NodeId qd_1 = b.qd(0), qd_2 = b.qd(1);
  const NodeId energy = b.plus({b.scaled("1/2", b.times({B[0], qd_1, qd_1})), b.times({B[1], qd_1, qd_2}),
                                b.scaled("1/2", b.times({B[3], qd_2, qd_2}))});
  Function function{.name = "kinetic_energy",
                    .summary = "Kinetic energy",
                    .equation = "(7.31)",
                    .inputs = {InputKind::q, InputKind::qd},
                    .graph = {},
                    .outputs = {{"T", Layout::scalar, 1, 1, {energy}, "kinetic energy, J"}},
                    .validity_conditions = {}};
  function.graph = b.graph;
  return function;
}

Function two_link_forward_dynamics() {
  Builder b;
  const std::vector<NodeId> B = inertia_entries(b);
  const NodeId l = b.named(b.graph.quotient(B[1], B[3]), "qdd");  // has the output's name on purpose
  const NodeId pivot = b.named(b.plus({B[0], b.scaled("-1", b.times({l, B[1]}))}), "sin");
  const NodeId qdd_1 = b.graph.quotient(b.plus({b.tau(0), b.scaled("-1", b.times({l, b.tau(1)}))}), pivot);
  const NodeId qdd_2 = b.graph.quotient(b.plus({b.tau(1), b.scaled("-1", b.times({B[1], qdd_1}))}), B[3]);
  Function function{.name = "forward_dynamics",
                    .summary = "Joint accelerations of given torques",
                    .equation = "(7.115)",
                    .inputs = {InputKind::q, InputKind::qd, InputKind::tau},
                    .graph = {},
                    .outputs = {{"qdd", Layout::vector, 2, 1, {qdd_1, qdd_2}, "joint accelerations"}},
                    .validity_conditions = {pivot, B[3]}};
  function.graph = b.graph;
  return function;
}

Function pendulum_gravity() {
  Builder b;
  const NodeId g_1 = b.times({b.parameter(0), b.scaled("981/100", b.graph.sin(b.q(0)))});
  Function function{.name = "gravity",
                    .summary = "Gravity torques",
                    .equation = "(7.39)",
                    .inputs = {InputKind::q},
                    .graph = {},
                    .outputs = {{"g", Layout::vector, 2, 1, {g_1, b.number("0")}, "gravity torques, N m"}},
                    .validity_conditions = {}};
  function.graph = b.graph;
  return function;
}

std::vector<double> values_of(const Function& function) {
  RealArithmetic<double> arithmetic(value_of_input);
  const std::vector<double> nodes = evaluate(function, arithmetic);
  std::vector<double> values;
  for (const Output& output : function.outputs) {
    for (NodeId entry : output.entries) values.push_back(nodes[static_cast<std::size_t>(entry)]);
  }
  return values;
}

}  // namespace flatdyn::testing
