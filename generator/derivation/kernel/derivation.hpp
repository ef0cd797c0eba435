// SPDX-License-Identifier: GPL-2.0-or-later
// The bridge from GiNaC to the Graph. A derivation works with GiNaC expressions over atomic symbols and names each
// scalar as soon as it is made: the expression is expanded, added to the Graph, and is from then on one symbol. So
// expressions stay small, GiNaC collects like terms of one scalar, and order and text are the Graph's alone.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "robot/model/number.hpp"

namespace flatdyn {

class Derivation {
 public:
  // The symbols of the robot become inputs of kind parameter, in this order.
  explicit Derivation(const std::vector<GiNaC::symbol>& parameters);

  Number input(InputKind kind, int index);

  // The scalar as one symbol (or unchanged if it is a number, a symbol or a symbol's negative). `name`: its name in the
  // emitted code.
  Number named(const Number& expression, const std::string& name);
  Vec3 named(const Vec3& expression, const std::string& name);            // name_x, name_y, name_z
  Mat3 named_symmetric(const Mat3& expression, const std::string& name);  // name_xx, name_xy, …

  Number sin(const Number& angle, const std::string& name);
  Number cos(const Number& angle, const std::string& name);
  Number sign(const Number& argument, const std::string& name);
  Number sqrt(const Number& argument, const std::string& name);
  Number tanh(const Number& argument, const std::string& name);
  Number quotient(const Number& numerator, const Number& denominator, const std::string& name);

  // The node that has the value of an expression.
  NodeId node(const Number& expression);

  Graph& graph() { return graph_; }

 private:
  struct Monomial {
    Rational coefficient = 1;
    std::vector<NodeId> factors;  // sorted, repeated for powers
  };

  Number symbol_of(NodeId id);
  Number name_node(NodeId id, const std::string& name);
  void import_foreign_factors(const Number& expanded);
  NodeId import_foreign(const Number& factor);
  Monomial monomial(const Number& term);
  void multiply_by(const Number& factor, Monomial& monomial) const;

  Graph graph_;
  // For lookups only, never iterated over, as its order is GiNaC's.
  std::map<Number, NodeId, GiNaC::ex_is_less> node_of_;
  std::map<NodeId, Number> symbol_of_;
};

}  // namespace flatdyn
