// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/differentiation/held.hpp"

#include <utility>

#include "derivation/differentiation/at_solution.hpp"
#include "derivation/differentiation/differentiate.hpp"

namespace flatdyn {
namespace {

constexpr int kDirectionsOfBase = 3;

std::size_t at(int row, int col, int cols) { return static_cast<std::size_t>(row * cols + col); }

// Jᵀ f and J a + b by positions and velocities, with a and f as they are: f is the argument weights.
Function contact_terms(const Mechanism& mechanism, const Function& contacts) {
  Function terms = contacts;
  const Output J = contacts.outputs[0], drift = contacts.outputs[1];
  Output force{.name = "f", .rows = J.cols, .entries = {}, .meaning = ""},
      acceleration{.name = "a", .rows = J.rows, .entries = {}, .meaning = ""};
  const InputKind a = with_base(InputKind::qdd, mechanism.has_quasi_velocities());
  Graph& graph = terms.graph;
  const auto product = [&](int row, int col, const Input& input) {
    return Term{1, graph.product({J.entries[at(row, col, J.cols)], graph.input(input)})};
  };
  for (int k = 0; k < J.cols; ++k) {
    std::vector<Term> sum;
    for (int i = 0; i < J.rows; ++i) sum.push_back(product(i, k, {InputKind::weights, i}));
    force.entries.push_back(graph.sum(std::move(sum)));
  }
  for (int i = 0; i < J.rows; ++i) {
    std::vector<Term> sum = {{1, drift.entries[static_cast<std::size_t>(i)]}};
    for (int k = 0; k < J.cols; ++k) sum.push_back(product(i, k, {a, k}));
    acceleration.entries.push_back(graph.sum(std::move(sum)));
  }
  terms.outputs = {force, acceleration};
  return terms;
}

class HeldColumns {
 public:
  HeldColumns(const Mechanism& mechanism, const HeldMotion& held)
      : mechanism_(mechanism),
        held_(held),
        function_(held.solution),
        n_(held.solution.outputs[0].rows),
        rows_(held.solution.outputs[1].rows) {
    const InputKind velocity = with_base(InputKind::qd, mechanism.has_quasi_velocities());
    const Function terms = contact_terms(mechanism, held.contacts);
    const Tangents of_terms(mechanism, {InputKind::q, velocity}, 0);
    torques_ = at_solution(held.torques);
    terms_ = at_solution(jacobian_matrices(terms, of_terms));
  }

  HeldDerivatives derivatives() {
    JacobianColumns columns;
    for (const TangentBlock& block : held_.tangents.blocks()) {
      for (int k = 0; k < block.length; ++k) columns.push_back(column(block.kind, k));
    }
    return {std::move(function_), std::move(columns)};
  }

 private:
  std::vector<Output> at_solution(const Function& function) {
    return outputs_at(function, held_.solution.outputs[0].entries, held_.solution.outputs[1].entries, function_);
  }

  std::vector<NodeId> column(InputKind kind, int k) {
    if (kind == InputKind::tau) return solved(unit(k), std::vector<NodeId>(count(rows_), zero()));
    if (kind == InputKind::g_b) return of_gravity(k);
    const bool is_position = kind == InputKind::q;
    if (mechanism_.is_of_base(k) && is_position) {
      return k < kDirectionsOfBase ? nothing() : of_turn(k - kDirectionsOfBase);
    }
    if (mechanism_.is_of_base(k) && k < kDirectionsOfBase) return of_linear_velocity(k);
    const std::size_t by = is_position ? 0 : 1;
    std::vector<NodeId> r, s;
    for (int i = 0; i < n_; ++i) {
      r.push_back(graph().sum({{-1, torques_[by].entries[at(i, k, n_)]}, {1, terms_[by].entries[at(i, k, n_)]}}));
    }
    for (int i = 0; i < rows_; ++i) s.push_back(terms_[2 + by].entries[at(i, k, n_)]);
    return solved(r, s);
  }

  // P r - Q s, then -Qᵀ r - Λ s.
  std::vector<NodeId> solved(const std::vector<NodeId>& r, const std::vector<NodeId>& s) {
    std::vector<NodeId> result;
    for (int i = 0; i < n_; ++i) {
      std::vector<Term> sum;
      for (int j = 0; j < n_; ++j) sum.push_back({1, graph().product({P(i, j), r[count(j)]})});
      for (int j = 0; j < rows_; ++j) sum.push_back({-1, graph().product({Q(i, j), s[count(j)]})});
      result.push_back(graph().sum(std::move(sum)));
    }
    for (int i = 0; i < rows_; ++i) {
      std::vector<Term> sum;
      for (int j = 0; j < n_; ++j) sum.push_back({-1, graph().product({Q(j, i), r[count(j)]})});
      for (int j = 0; j < rows_; ++j) sum.push_back({-1, graph().product({Lambda(i, j), s[count(j)]})});
      result.push_back(graph().sum(std::move(sum)));
    }
    return result;
  }

  // Gravity along axis k of the base adds itself to the base's acceleration, which the contacts then stop.
  std::vector<NodeId> of_gravity(int k) {
    std::vector<NodeId> s;
    for (const Contact& contact : mechanism_.contacts) {
      for (int i = 0; i < contact.rows(); ++i) s.push_back(graph().constant(i == k ? 1 : 0));
    }
    std::vector<NodeId> result = solved(std::vector<NodeId>(count(n_), zero()), s);
    result[count(k)] = graph().sum({{1, result[count(k)]}}, 1);
    return result;
  }

  // A turn about axis k changes g_b by g_b × e_k.
  std::vector<NodeId> of_turn(int k) {
    if (!mechanism_.has_base_gravity()) return nothing();
    return of_cross(InputKind::g_b, 0, k, [this](int axis) { return of_gravity(axis); });
  }

  // v changes the acceleration of the base's origin v̇ + ω × v by ω × e_k, which v̇ takes back.
  std::vector<NodeId> of_linear_velocity(int k) {
    return of_cross(InputKind::v, kDirectionsOfBase, k, [this](int axis) {
      std::vector<NodeId> result = nothing();
      result[count(axis)] = graph().constant(-1);
      return result;
    });
  }

  // Σ over axes of (x × e_k) times the columns, x being three entries of an argument.
  template <class OfAxis>
  std::vector<NodeId> of_cross(InputKind kind, int first, int k, OfAxis of_axis) {
    const int up = (k + 1) % kDirectionsOfBase, down = (k + 2) % kDirectionsOfBase;
    const NodeId x_up = graph().input({kind, first + up}), x_down = graph().input({kind, first + down});
    const std::vector<NodeId> by_up = of_axis(up), by_down = of_axis(down);
    std::vector<NodeId> result;
    for (std::size_t i = 0; i < by_up.size(); ++i) {
      result.push_back(
          graph().sum({{1, graph().product({x_down, by_up[i]})}, {-1, graph().product({x_up, by_down[i]})}}));
    }
    return result;
  }

  std::vector<NodeId> unit(int k) {
    std::vector<NodeId> result(count(n_), zero());
    result[count(k)] = graph().constant(1);
    return result;
  }
  std::vector<NodeId> nothing() { return std::vector<NodeId>(count(n_ + rows_), zero()); }

  NodeId P(int i, int j) const { return held_.solution.outputs[2].entries[at(i, j, n_)]; }
  NodeId Q(int i, int j) const { return held_.solution.outputs[3].entries[at(i, j, rows_)]; }
  NodeId Lambda(int i, int j) const { return held_.solution.outputs[4].entries[at(i, j, rows_)]; }
  Graph& graph() { return function_.graph; }
  NodeId zero() { return graph().constant(0); }
  static std::size_t count(int k) { return static_cast<std::size_t>(k); }

  const Mechanism& mechanism_;
  const HeldMotion& held_;
  Function function_;
  int n_, rows_;
  std::vector<Output> torques_, terms_;
};

}  // namespace

HeldDerivatives held_derivatives(const Mechanism& mechanism, const HeldMotion& held) {
  return HeldColumns(mechanism, held).derivatives();
}

}  // namespace flatdyn
