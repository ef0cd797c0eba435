// SPDX-License-Identifier: GPL-2.0-or-later
// A two-link planar arm, with its mechanism's data and functions written by hand, so that emission is tested alone.
#pragma once

#include <vector>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn::testing {

// A shorthand for building a Graph.
class Builder {
 public:
  NodeId q(int i) { return graph.input({InputKind::q, i}); }
  NodeId qd(int i) { return graph.input({InputKind::qd, i}); }
  NodeId qdd(int i) { return graph.input({InputKind::qdd, i}); }
  NodeId tau(int i) { return graph.input({InputKind::tau, i}); }
  NodeId parameter(int i) { return graph.input({InputKind::parameter, i}); }
  NodeId number(const char* exact) { return graph.constant(Rational(exact)); }
  NodeId times(std::vector<NodeId> factors) { return graph.product(std::move(factors)); }
  NodeId scaled(const char* exact, NodeId node) { return graph.scaled(Rational(exact), node); }
  NodeId plus(const std::vector<NodeId>& nodes);
  NodeId named(NodeId id, const char* name);

  Graph graph;
};

// A mechanism with revolute joints "shoulder" (with limits) and "double" (a C++ keyword, without limits); `symbols` are
// its free symbols.
Mechanism two_link_mechanism(const std::vector<std::string>& symbols = {});

Function two_link_inertia_matrix();
Function two_link_inverse_dynamics();  // with Coulomb friction: uses sign
Function two_link_kinetic_energy();    // returns its value
Function two_link_forward_dynamics();  // returns bool; output named like a local
Function pendulum_gravity();           // reads the parameter "m1"

// The values of all output entries in order at q_i = 0.3 + i, qd_i = -0.7 + i, qdd_i = 0.2 + i, tau_i = 1.5 - i, and
// every parameter 1.25.
std::vector<double> values_of(const Function& function);

}  // namespace flatdyn::testing
