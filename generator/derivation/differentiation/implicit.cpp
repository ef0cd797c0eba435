// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/differentiation/implicit.hpp"

#include <algorithm>
#include <utility>

#include "derivation/differentiation/at_solution.hpp"
#include "derivation/differentiation/derivative_outputs.hpp"
#include "derivation/differentiation/differentiate.hpp"

namespace flatdyn {
namespace {

constexpr int kAxes = 3;

// A function of the derivatives of inverse dynamics, at the accelerations and with the multipliers -λ, over the graph
// of the solution.
class AtSolution {
 public:
  AtSolution(const ImplicitAcceleration& acceleration, const Function& of_torques)
      : acceleration_(acceleration), result_(acceleration.solution) {
    std::vector<NodeId> multipliers;
    for (const NodeId lambda : result_.outputs[1].entries) multipliers.push_back(result_.graph.scaled(-1, lambda));
    outputs_ = outputs_at(of_torques, result_.outputs[0].entries, multipliers, result_);
  }

  const std::vector<NodeId>* entries(const std::string& name) const {
    const auto found =
        std::find_if(outputs_.begin(), outputs_.end(), [&name](const Output& output) { return output.name == name; });
    return found == outputs_.end() ? nullptr : &found->entries;
  }

  // -λᵀ τ_kl, for k in a block no later than that of l.
  NodeId second(const TangentBlock& a, int k, const TangentBlock& b, int l) {
    return entry(name_of_second_derivatives(a, b), k, l, b.length);
  }

  // -((λᵀ B)_k) q̈_l.
  NodeId cross(const TangentBlock& a, int k, const TangentBlock& b, int l) {
    const TangentBlock* a_of_base = acceleration_.torques.tangents().find(InputKind::a);
    const TangentBlock& by = a_of_base != nullptr ? *a_of_base : *acceleration_.torques.tangents().find(InputKind::qdd);
    std::vector<Term> terms;
    for (int i = 0; i < by.length; ++i) {
      const NodeId rate = entry(name_of_second_derivatives(a, by), k, i, by.length);
      terms.push_back({1, result_.graph.product({rate, acceleration_rate(i, b, l)})});
    }
    return result_.graph.sum(std::move(terms));
  }

  Function& result() { return result_; }

 private:
  NodeId zero() { return result_.graph.constant(0); }

  NodeId entry(const std::string& name, int row, int col, int cols) {
    const std::vector<NodeId>* matrix = entries(name);
    return matrix == nullptr ? zero() : (*matrix)[static_cast<std::size_t>(row * cols + col)];
  }

  // The rate of q̈_i along direction l of an argument. Gravity seen from a floating base adds itself to the acceleration
  // of the base.
  NodeId acceleration_rate(int i, const TangentBlock& b, int l) {
    if (b.kind == InputKind::g_b) return result_.graph.constant(i < kAxes && i == l ? 1 : 0);
    const std::size_t matrix = b.kind == InputKind::q ? 2 : b.kind == InputKind::tau ? 4 : 3;
    return acceleration_.solution.outputs[matrix].entries[static_cast<std::size_t>(i * b.length + l)];
  }

  const ImplicitAcceleration& acceleration_;
  Function result_;
  std::vector<Output> outputs_;
};

}  // namespace

Function weighted_derivatives(const ImplicitAcceleration& acceleration) {
  const Differentiable& torques = acceleration.torques;
  AtSolution at(acceleration, torques.finished(vector_times_jacobian(torques.function(), torques.tangents())));
  std::vector<NodeId> derivatives;
  for (const TangentBlock& block : acceleration.tangents.blocks()) {
    const std::vector<NodeId>& entries =
        block.kind == InputKind::tau ? acceleration.solution.outputs[1].entries : *at.entries(name_of(block) + "_bar");
    derivatives.insert(derivatives.end(), entries.begin(), entries.end());
  }
  Function result = std::move(at.result());
  const Output qdd = result.outputs.front();
  result.outputs = gradient_outputs(derivatives, acceleration.tangents, "the entries of " + qdd.name);
  return result;
}

Function weighted_second_derivatives(const ImplicitAcceleration& acceleration) {
  const Differentiable& torques = acceleration.torques;
  AtSolution at(acceleration, torques.finished(contracted_hessian(torques.function(), torques.tangents())));
  Graph& graph = at.result().graph;
  const std::vector<TangentBlock>& blocks = acceleration.tangents.blocks();
  const auto count = static_cast<std::size_t>(acceleration.tangents.count());
  JacobianColumns columns(count, std::vector<NodeId>(count, graph.constant(0)));
  for (auto a = blocks.begin(); a != blocks.end(); ++a) {
    for (auto b = a; b != blocks.end(); ++b) {
      for (int k = 0; k < a->length; ++k) {
        for (int l = 0; l < b->length; ++l) {
          columns[static_cast<std::size_t>(b->first + l)][static_cast<std::size_t>(a->first + k)] =
              graph.sum({{1, at.second(*a, k, *b, l)}, {1, at.cross(*a, k, *b, l)}, {1, at.cross(*b, l, *a, k)}});
        }
      }
    }
  }
  Function result = std::move(at.result());
  result.outputs = hessian_outputs(result.graph, acceleration.tangents, {}, columns);
  return result;
}

}  // namespace flatdyn
