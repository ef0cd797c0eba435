// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/graph_evaluator.hpp"

#include "graph/arithmetic.hpp"

namespace flatdyn {
namespace {

// RealArithmetic that converts each constant of a graph only once, looked up by its node.
template <class S>
class CachedArithmetic : public RealArithmetic<S> {
 public:
  CachedArithmetic(const StateOf<S>& state, std::unordered_map<const Rational*, S>& constants)
      : RealArithmetic<S>(
            [&state](const Input& input) { return state.of(input.kind)[static_cast<std::size_t>(input.index)]; }),
        constants_(constants) {}

  S constant(const Rational& value) const {
    const auto found = constants_.find(&value);
    return found != constants_.end() ? found->second : constants_.emplace(&value, to_real<S>(value)).first->second;
  }

 private:
  std::unordered_map<const Rational*, S>& constants_;
};

}  // namespace

template <class S>
std::optional<std::vector<S>> GraphEvaluator<S>::operator()(const StateOf<S>& state) {
  CachedArithmetic<S> arithmetic(state, constants_);
  const std::vector<S> all = evaluate(function_, arithmetic);
  const auto value = [&all](NodeId id) { return all[static_cast<std::size_t>(id)]; };
  const S significance = to_real<S>(kPivotSignificance);
  for (std::size_t k = 0; k < function_.validity_conditions.size(); ++k) {
    S condition = value(function_.validity_conditions[k]);
    if (k < function_.pivot_scales.size()) {
      const S scale = value(function_.pivot_scales[k]), increased = scale + significance * condition;
      condition = increased - scale;
    }
    if (!(condition > 0)) return std::nullopt;
  }
  std::vector<S> result;
  for (const Output& output : function_.outputs) {
    for (const NodeId id : output.entries) result.push_back(value(id));
  }
  return result;
}

template class GraphEvaluator<double>;
template class GraphEvaluator<Real50>;

}  // namespace flatdyn
