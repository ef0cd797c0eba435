// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/runge_kutta.hpp"

namespace flatdyn {
namespace {

// q̇ and c after the step. For joints, h (q̇_1 + 2 q̇_2 + 2 q̇_3 + q̇_4) / 6 is h (q̇ + h (q̈_1 + q̈_2 + q̈_3) / 6).
void add_result(Stages& stages, RungeKutta& step) {
  Graph& graph = stages.graph();
  const NodeId h = stages.step_length(), h_6 = graph.scaled(Rational(1, 6), h);
  const auto qdd = [&step](std::size_t stage, std::size_t k) { return step.stages[stage].outputs[0][k]; };
  const auto rate = [&step](std::size_t stage, std::size_t k) { return step.stages[stage].rates_of_change[k]; };
  for (std::size_t k = 0; k < step.stages[0].rates.size(); ++k) {
    const NodeId qd = step.stages[0].rates[k];
    const NodeId first_three = graph.sum({{1, qdd(0, k)}, {1, qdd(1, k)}, {1, qdd(2, k)}});
    const NodeId all = graph.sum({{1, first_three}, {1, qdd(1, k)}, {1, qdd(2, k)}, {1, qdd(3, k)}});
    step.rates.push_back(graph.sum({{1, qd}, {1, graph.product({h_6, all})}}));
    if (stages.chart().is_rate(k)) {
      const NodeId mean_rate = graph.sum({{1, qd}, {1, graph.product({h_6, first_three})}});
      step.change.push_back(graph.product({h, mean_rate}));
    } else {
      const NodeId sum = graph.sum({{1, rate(0, k)}, {2, rate(1, k)}, {2, rate(2, k)}, {1, rate(3, k)}});
      step.change.push_back(graph.product({h_6, sum}));
    }
  }
  step.turns = stages.chart().turns(step.change);
}

}  // namespace

RungeKutta runge_kutta(Stages& stages) {
  const StepChart& chart = stages.chart();
  const StepChart::Entries qd = chart.arguments(InputKind::qd);
  const StepChart::Entries unchanged(qd.size(), stages.graph().constant(0));
  RungeKutta step;
  const StepChart::Turns none = chart.turns(unchanged);
  step.stages[0] = {unchanged, none, qd, chart.rates(unchanged, none, qd), stages.outputs_at(chart.start(), qd)};
  for (std::size_t k = 1; k < RungeKutta::kStages; ++k) {
    const RungeKutta::Stage& before = step.stages[k - 1];
    RungeKutta::Stage& here = step.stages[k];
    const Rational part = RungeKutta::part(k);
    here.rates = stages.rates_after(qd, part, before.outputs[0]);
    here.change = stages.along(part, before.rates_of_change);
    here.turns = chart.turns(here.change);
    here.outputs = stages.outputs_at(stages.positions_after(here.change, here.turns), here.rates);
    here.rates_of_change = chart.rates(here.change, here.turns, here.rates);
  }
  add_result(stages, step);
  return step;
}

}  // namespace flatdyn
