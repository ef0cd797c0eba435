// SPDX-License-Identifier: GPL-2.0-or-later
// The classical Runge-Kutta method of fourth order (Hairer, Nørsett, Wanner: Solving Ordinary Differential Equations I,
// II.1), for the changes of positions c of step_chart.hpp and for q̇.
#pragma once

#include <array>
#include <vector>

#include "derivation/dynamics/step_stages.hpp"

namespace flatdyn {

struct RungeKutta {
  using Entries = StepChart::Entries;
  struct Stage {
    Entries change;                // c
    StepChart::Turns turns;        // E(σ)
    Entries rates;                 // q̇
    Entries rates_of_change;       // ċ
    std::vector<Entries> outputs;  // of the function of the stages; q̈ is the first one
  };
  static constexpr std::size_t kStages = 4;
  std::array<Stage, kStages> stages;

  // After the step.
  Entries change;
  StepChart::Turns turns;
  Entries rates;

  // The share of h that leads from the start to a stage, and that of the stage's derivatives in the result.
  static Rational part(std::size_t stage) { return Rational(stage == 0 ? 0 : stage == 3 ? 2 : 1, 2); }
  static Rational weight(std::size_t stage) { return Rational(stage == 0 || stage == 3 ? 1 : 2, 6); }
};

// Takes the function through its four stages.
RungeKutta runge_kutta(Stages& stages);

}  // namespace flatdyn
