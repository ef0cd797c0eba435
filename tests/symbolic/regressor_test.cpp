// SPDX-License-Identifier: GPL-2.0-or-later
// The regressor of the two-link planar arm in symbols: (7.84) for the eight parameters of (7.83), and the five of
// Problem 7.4.
#include "derivation/parameters/regressor.hpp"

#include <gtest/gtest.h>

#include "derivation/parameters/base_parameters.hpp"
#include "functions/planning/formulations.hpp"
#include "graph/evaluate.hpp"
#include "symbolic/textbook_robots.hpp"

namespace flatdyn {
namespace {

// The values of a graph as expressions, with sines and cosines of joint angles as symbols.
class Expressions {
 public:
  using Scalar = Number;
  explicit Expressions(const Mechanism& mechanism) : mechanism_(mechanism) {
    for (int i = 0; i < mechanism.size(); ++i) {
      const std::string n = std::to_string(i + 1);
      for (auto* list : {&q, &qd, &qdd, &c, &s}) list->emplace_back("x" + n);
    }
  }

  Number constant(const Rational& value) const { return GiNaC::numeric(value.str().c_str()); }
  Number input(const Input& input) const {
    const auto k = static_cast<std::size_t>(input.index);
    switch (input.kind) {
      case InputKind::q:
        return q[k];
      case InputKind::qd:
        return qd[k];
      case InputKind::qdd:
        return qdd[k];
      case InputKind::parameter:
        return mechanism_.symbols[k].symbol;
      default:
        throw std::logic_error("no such input here");
    }
  }
  Number divide(const Number& a, const Number& b) const { return a / b; }
  Number sin(const Graph& graph, NodeId angle, const Number&) const { return s[joint(graph, angle)]; }
  Number cos(const Graph& graph, NodeId angle, const Number&) const { return c[joint(graph, angle)]; }
  Number sign(const Number& x) const { return GiNaC::csgn(x); }
  Number sqrt(const Number& x) const { return GiNaC::sqrt(x); }

  std::vector<GiNaC::symbol> q, qd, qdd, c, s;

 private:
  static std::size_t joint(const Graph& graph, NodeId angle) {
    return static_cast<std::size_t>(graph[angle].input.index);
  }
  const Mechanism& mechanism_;
};

class TwoLinkPlanarArm : public ::testing::Test {
 protected:
  Number value(const std::string& name) const { return testing::symbol(mechanism, name); }

  // Applies c² + s² = 1 for both joints.
  Number normal(const Number& e) const {
    return e.expand()
        .subs(GiNaC::lst{GiNaC::pow(x.s[0], 2) == 1 - GiNaC::pow(x.c[0], 2),
                         GiNaC::pow(x.s[1], 2) == 1 - GiNaC::pow(x.c[1], 2)})
        .expand();
  }

  // An entry of Y for a change of parameters given in the textbook's frame i, at the end of link i.
  Number entry(std::size_t row, int i, const InertialParameters& in_textbook_frame) const {
    const Number a = value("a_" + std::to_string(i + 1));
    const std::vector<Number> change = entries_of(transformed(in_textbook_frame, identity_matrix(), {a, 0, 0}));
    Number sum = 0;
    for (std::size_t k = 0; k < change.size(); ++k) sum += change[k] * y(row, index_of(i, static_cast<Parameter>(k)));
    return normal(sum);
  }
  Number y(std::size_t row, int column) const {
    return values[static_cast<std::size_t>(
        function.outputs[0].entries[row * 2 * kParametersPerJoint + static_cast<std::size_t>(column)])];
  }

  const Mechanism mechanism = make_mechanism(testing::two_link_planar());
  const Function function = derive_function(mechanism, "regressor");
  Expressions x{mechanism};
  const std::vector<Number> values = evaluate(function, x);
};

TEST_F(TwoLinkPlanarArm, HasTheRegressorOfTheTextbook) {
  const Number a1 = value("a_1"), a2 = value("a_2"), g = value("g"), k1 = value("k_r1"), k2 = value("k_r2");
  const Number c1 = x.c[0], s1 = x.s[0], c2 = x.c[1], s2 = x.s[1], c12 = c1 * c2 - s1 * s2;
  const Number d1 = x.qd[0], d2 = x.qd[1], dd1 = x.qdd[0], dd2 = x.qdd[1];
  const InertialParameters m = single_parameter(Parameter::m), ml = single_parameter(Parameter::mlx),
                           I = single_parameter(Parameter::Izz);
  const Rows found = {{entry(0, 0, m), entry(0, 0, ml), entry(0, 0, I), y(0, index_of(0, Parameter::Im)),
                       entry(0, 1, m), entry(0, 1, ml), entry(0, 1, I), y(0, index_of(1, Parameter::Im))},
                      {entry(1, 0, m), entry(1, 0, ml), entry(1, 0, I), y(1, index_of(0, Parameter::Im)),
                       entry(1, 1, m), entry(1, 1, ml), entry(1, 1, I), y(1, index_of(1, Parameter::Im))}};
  const Rows textbook = {
      // (7.84)
      {a1 * a1 * dd1 + a1 * g * c1, 2 * a1 * dd1 + g * c1, dd1, k1 * k1 * dd1,
       (a1 * a1 + 2 * a1 * a2 * c2 + a2 * a2) * dd1 + (a1 * a2 * c2 + a2 * a2) * dd2 - 2 * a1 * a2 * s2 * d1 * d2 -
           a1 * a2 * s2 * d2 * d2 + a1 * g * c1 + a2 * g * c12,
       (2 * a1 * c2 + 2 * a2) * dd1 + (a1 * c2 + 2 * a2) * dd2 - 2 * a1 * s2 * d1 * d2 - a1 * s2 * d2 * d2 + g * c12,
       dd1 + dd2, k2 * dd2},
      {0, 0, 0, 0, (a1 * a2 * c2 + a2 * a2) * dd1 + a2 * a2 * dd2 + a1 * a2 * s2 * d1 * d1 + a2 * g * c12,
       (a1 * c2 + 2 * a2) * dd1 + 2 * a2 * dd2 + a1 * s2 * d1 * d1 + g * c12, dd1 + dd2, k2 * dd1 + k2 * k2 * dd2}};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_TRUE(normal(found[i][k] - textbook[i][k]).is_zero())
          << "y_" << i + 1 << k + 1 << " is " << normal(found[i][k]) << ", not " << textbook[i][k];
    }
  }
}

TEST_F(TwoLinkPlanarArm, HasTheEightParametersOfTheTextbook) {
  const Number a1 = value("a_1"), l1 = value("l_1"), ml1 = value("m_l1"), mm2 = value("m_m2");
  const Vec3 back = {-a1, 0, 0};  // from the joint's frame to the end of the link
  const InertialParameters link = transformed(mechanism.bodies[0].inertia, identity_matrix(), back);
  EXPECT_TRUE(vanishes(link.mass - (ml1 + mm2)));
  EXPECT_TRUE(vanishes(link.first_moment[0] - ml1 * (l1 - a1)));
  EXPECT_TRUE(vanishes(link.inertia[2][2] - (value("I_l1") + ml1 * GiNaC::pow(l1 - a1, 2) + value("I_m2"))));
  const std::vector<Number> pi = dynamic_parameters(mechanism);
  EXPECT_TRUE(pi[static_cast<std::size_t>(index_of(0, Parameter::Im))].is_equal(value("I_m1")));
  EXPECT_TRUE(pi[static_cast<std::size_t>(index_of(1, Parameter::Im))].is_equal(value("I_m2")));
}

// Problem 7.4, about the joints' axes.
TEST_F(TwoLinkPlanarArm, HasFiveBaseParameters) {
  const BaseParameters base = base_parameters(mechanism, ParameterSet::nonzero);
  const Number a1 = value("a_1"), k1 = value("k_r1");
  const auto at = [](int i, Parameter p) { return index_of(i, p); };
  using enum Parameter;
  const std::vector<ParameterForm> expected = {{{at(0, mlx), 1}, {at(1, m), a1}},
                                               {{at(0, Izz), 1}, {at(0, Im), k1 * k1}, {at(1, m), a1 * a1}},
                                               {{at(1, mlx), 1}},
                                               {{at(1, Izz), 1}},
                                               {{at(1, Im), 1}}};
  ASSERT_EQ(base.combination.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    ASSERT_EQ(base.combination[k].size(), expected[k].size()) << k;
    for (const auto& [index, coefficient] : expected[k]) {
      ASSERT_TRUE(base.combination[k].contains(index)) << parameter_name(index);
      EXPECT_TRUE(vanishes(base.combination[k].at(index) - coefficient)) << parameter_name(index);
    }
  }
}

}  // namespace
}  // namespace flatdyn
