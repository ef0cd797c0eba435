// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/closed_functions.hpp"

#include <algorithm>
#include <array>

#include "derivation/closed_form/closed_form.hpp"
#include "derivation/dynamics/dry_friction.hpp"
#include "derivation/kernel/derivation.hpp"
#include "derivation/notation/readable_sum.hpp"

namespace flatdyn {
namespace {

constexpr int kMostJoints = 3;
constexpr std::size_t kMostTerms = 200;

std::vector<GiNaC::symbol> parameters(const Mechanism& mechanism) {
  std::vector<GiNaC::symbol> result;
  result.reserve(mechanism.symbols.size());
  for (const FreeSymbol& symbol : mechanism.symbols) result.push_back(symbol.symbol);
  return result;
}

}  // namespace

// B, c_ijk and g of the closed form as scalars of one derivation.
class ClosedModel {
 public:
  explicit ClosedModel(const Mechanism& mechanism)
      : mechanism_(mechanism),
        form_(closed_form(mechanism)),
        names_(mechanism, form_),
        angles_(mechanism),
        derivation_(parameters(mechanism)) {}

  bool is_short() const { return terms_ <= kMostTerms; }
  Graph& graph() { return derivation_.graph(); }

  int n() const { return mechanism_.size(); }

  std::vector<NodeId> nodes(const std::vector<Number>& values) {
    std::vector<NodeId> result;
    for (const Number& value : values) result.push_back(derivation_.node(value));
    return result;
  }

  Number b(int i, int j) { return scalar(form_.B[at(i)][at(j)], label("b", {std::max(i, j), std::min(i, j)})); }
  Number gravity(int i) { return scalar(form_.g[at(i)], label("g", {i})); }
  // The Christoffel symbols, at [i][k (k + 1) / 2 + j], j <= k.
  std::vector<Number> christoffel_symbols() {
    std::vector<Number> values;
    for (int i = 0; i < n(); ++i) {
      for (int k = 0; k < n(); ++k) {
        for (int j = 0; j <= k; ++j) values.push_back(c(i, j, k));
      }
    }
    return values;
  }

  Number coriolis(int i, int j) {
    Number sum = 0;
    for (int k = 0; k < n(); ++k) sum += c(i, j, k) * qd(k);
    return sum;
  }

  Number inertial_torque(int i) {
    Number sum = 0;
    for (int j = 0; j < n(); ++j) sum += b(i, j) * derivation_.input(InputKind::qdd, j);
    return sum;
  }

  // Entry i of k (q - q_0), the torque against a spring.
  Number spring_torque(int i) {
    const Body& body = mechanism_.joint(i);  // coupled joints have no spring here
    if (vanishes(body.stiffness)) return 0;
    const Number q = derivation_.input(InputKind::q, mechanism_.position_of(i));
    return body.stiffness * derivation_.named(q - body.spring_reference, label("stretch", {i}));
  }

  // Entry i of C q̇ plus friction.
  Number velocity_torque(int i) {
    const Body& body = mechanism_.joint(i);  // coupled joints have no friction here
    Number sum = body.viscous * qd(i);
    for (const DryFrictionTerm& term : dry_friction_terms(derivation_, body, qd(i), std::to_string(i + 1))) {
      sum += term.coefficient * term.value;
    }
    for (int k = 0; k < n(); ++k) {
      for (int j = 0; j <= k; ++j) sum += (j == k ? 1 : 2) * c(i, j, k) * qd(j) * qd(k);
    }
    return sum;
  }

  Number kinetic_energy() {
    Number sum = 0;
    for (int i = 0; i < n(); ++i) {
      for (int j = 0; j <= i; ++j) sum += (i == j ? Number(1) / 2 : Number(1)) * b(i, j) * qd(i) * qd(j);
    }
    return sum;
  }

 private:
  Number c(int i, int j, int k) { return scalar(form_.christoffel(i, j, k), label("c", {i, j, k})); }
  Number qd(int i) { return derivation_.input(InputKind::qd, i); }

  // The expression as one scalar, written with the sines and cosines of sums of angles.
  Number scalar(const Number& expression, const std::string& name) {
    const ReadableSum sum = angles_.rewritten(names_.readable(expression));
    terms_ += sum.size();
    Number result = 0;
    for (const auto& [monomial, coefficient] : sum) {
      Number term = GiNaC::numeric(coefficient.str().c_str());
      for (const auto& [factor, exponent] : monomial) term *= GiNaC::pow(number(factor), exponent);
      result += term;
    }
    return derivation_.named(result, name);
  }

  Number number(const Factor& factor) {
    if (factor.kind == FactorKind::coordinate) return derivation_.input(InputKind::q, factor.index);
    if (!factor.is_trigonometric()) return names_.expression(factor);
    const CosineSine of_sum = cosine_sine(factor.angle);
    return factor.kind == FactorKind::cosine ? of_sum.cosine : of_sum.sine;
  }

  struct CosineSine {
    Number cosine = 1, sine = 0;
  };

  // The cosine and sine of Σ angle_i q_i from those of the joints: rounding q_1 + q_2 instead would lose digits in
  // proportion to the turns of the joints.
  CosineSine cosine_sine(const std::vector<int>& angle) {
    CosineSine sum;
    std::string joints;
    for (int i = 0; i < n(); ++i) {
      const Number q = derivation_.input(InputKind::q, i);
      const int turns = std::abs(angle[at(i)]);
      const Number sign = angle[at(i)] < 0 ? -1 : 1;
      for (int k = 0; k < turns; ++k) {
        joints += (angle[at(i)] < 0 ? "m" : "") + std::to_string(i + 1);
        const Number c = derivation_.cos(q, label("c", {i})), s = sign * derivation_.sin(q, label("s", {i}));
        sum = {derivation_.named(sum.cosine * c - sum.sine * s, "c_" + joints),
               derivation_.named(sum.sine * c + sum.cosine * s, "s_" + joints)};
      }
    }
    return sum;
  }

  static std::string label(const std::string& stem, std::initializer_list<int> indices) {
    std::string text = stem;
    for (const int i : indices) text += "_" + std::to_string(i + 1);
    return text;
  }

  const Mechanism& mechanism_;
  ClosedForm form_;
  FactorNames names_;
  AngleRewriter angles_;
  Derivation derivation_;
  std::size_t terms_ = 0;
};

namespace {

template <class Entry>
std::vector<Number> square(int n, const Entry& entry) {
  std::vector<Number> values;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) values.push_back(entry(i, j));
  }
  return values;
}

template <class Torque>
std::vector<Number> per_joint(int n, const Torque& torque) {
  std::vector<Number> values;
  for (int i = 0; i < n; ++i) values.push_back(torque(i));
  return values;
}

// Whether a joint that follows others has friction or a spring, which the closed form does not support.
bool has_coupled_forces(const Mechanism& mechanism) {
  return mechanism.is_coupled() && std::any_of(mechanism.bodies.begin(), mechanism.bodies.end(), [](const Body& body) {
           return !vanishes(body.viscous) || body.has_dry_friction() || !vanishes(body.stiffness);
         });
}

}  // namespace

std::vector<Number> closed_inertia_matrix(ClosedModel& model) {
  return square(model.n(), [&model](int i, int j) { return model.b(i, j); });
}

std::vector<Number> closed_christoffel(ClosedModel& model) { return model.christoffel_symbols(); }

std::vector<Number> closed_coriolis_matrix(ClosedModel& model) {
  return square(model.n(), [&model](int i, int j) { return model.coriolis(i, j); });
}

std::vector<Number> closed_gravity(ClosedModel& model) {
  return per_joint(model.n(), [&model](int i) { return model.gravity(i); });
}

std::vector<Number> closed_bias(ClosedModel& model) {
  return per_joint(model.n(), [&model](int i) {
    Number torque = model.gravity(i);
    torque += model.velocity_torque(i);
    torque += model.spring_torque(i);
    return torque;
  });
}

std::vector<Number> closed_inverse_dynamics(ClosedModel& model) {
  return per_joint(model.n(), [&model](int i) {
    Number torque = model.gravity(i);
    torque += model.velocity_torque(i);
    torque += model.spring_torque(i);
    torque += model.inertial_torque(i);
    return torque;
  });
}

std::vector<Number> closed_kinetic_energy(ClosedModel& model) { return {model.kinetic_energy()}; }

std::optional<Function> closed_variant(const Mechanism& mechanism, const Function& recursive, ClosedEntries entries) {
  const bool is_coupled =
      mechanism.has_longer_positions() || !mechanism.angles.empty() || has_coupled_forces(mechanism);
  if (entries == nullptr || mechanism.size() > kMostJoints || is_coupled) return std::nullopt;
  ClosedModel model(mechanism);
  Function closed = recursive;
  closed.outputs.at(0).entries = model.nodes(entries(model));
  if (!model.is_short()) return std::nullopt;
  closed.graph = std::move(model.graph());
  closed.formulation = "closed form";
  return closed;
}

}  // namespace flatdyn
