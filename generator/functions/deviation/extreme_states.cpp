// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/deviation/extreme_states.hpp"

#include <random>

namespace flatdyn {
namespace {

constexpr double kHalfTurn = 3.141592653589793;
constexpr double kLeast = 5e-324, kDenormal = 1e-310, kDenormalInFloat = 1e-40;

const std::vector<double> kAngles = {
    0,    kHalfTurn / 2, -kHalfTurn / 2, kHalfTurn, -1.5 * kHalfTurn, 2000 * kHalfTurn, kDenormal,
    1e-9, -0.7,          1000.1,         99999.9,   100000.1,         12345678.9,       -1e8,
    1e8};
const std::vector<double> kSlides = {0, 1e-9, -0.3, 1, -1, 100};
const std::vector<double> kRates = {0,     kLeast, -kDenormal, kDenormalInFloat, 1e-160, 1e-20, 0.1, -1, 1000,
                                    -1000, 1e6,    -1e6};

class Choice {
 public:
  explicit Choice(unsigned seed) : engine_(seed) {}
  double operator()(const std::vector<double>& of) { return of[engine_() % of.size()]; }

 private:
  std::mt19937_64 engine_;
};

State uniform_state(const Mechanism& mechanism, double q, double rate) {
  const auto n = static_cast<std::size_t>(mechanism.size());
  State state;
  state.q.assign(static_cast<std::size_t>(mechanism.position_count()), q);
  turn_spherical_joints(mechanism, q, state);
  for (std::vector<double>* rates : {&state.qd, &state.qdd, &state.tau, &state.qd_r, &state.qdd_r, &state.qd_end}) {
    rates->assign(n, rate);
  }
  state.h_e.assign(state.h_e.size(), rate);
  if (mechanism.floating_base) state.g_b = {0, 0, -9.81};
  return state;
}

}  // namespace

std::vector<State> extreme_states(const Mechanism& mechanism, int count, unsigned seed) {
  std::vector<State> states = {uniform_state(mechanism, 0, 0), uniform_state(mechanism, kDenormal, kLeast),
                               uniform_state(mechanism, 1e8, 1e6)};
  Choice choice(seed);
  while (states.size() < static_cast<std::size_t>(count)) {
    State state = uniform_state(mechanism, 0, 0);
    for (std::size_t i = 0; i < state.q.size(); ++i) {
      state.q[i] = choice(mechanism.joint_at(static_cast<int>(i)).prismatic ? kSlides : kAngles);
    }
    if (mechanism.has_spherical_joints()) turn_spherical_joints(mechanism, choice(kAngles), state);
    for (std::vector<double>* rates :
         {&state.qd, &state.qdd, &state.tau, &state.h_e, &state.qd_r, &state.qdd_r, &state.qd_end}) {
      for (double& rate : *rates) rate = choice(kRates);
    }
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace flatdyn
