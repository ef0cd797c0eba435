// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/torque_change.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "symbolic/functions.hpp"
#include "verify/values.hpp"

namespace flatdyn {
namespace {

double value_or(const std::optional<Value>& limit, double otherwise) {
  return limit ? nearest_double(limit->number) : otherwise;
}

class LimitedStates {
 public:
  LimitedStates(const Mechanism& mechanism, bool at_rest) : mechanism_(mechanism), at_rest_(at_rest) {}

  State next() {
    constexpr double kTurn = 3.2;  // where a joint turns without limit
    const std::size_t n = mechanism_.bodies.size();
    State state;
    state.q.resize(n);
    state.qd.resize(n);
    state.qdd.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Limits& limits = mechanism_.bodies[i].limits;
      const double lower = value_or(limits.lower, -kTurn), upper = value_or(limits.upper, kTurn);
      state.q[i] = lower + (upper - lower) * (uniform_(engine_) + 1) / 2;
      state.qd[i] = at_rest_ ? 0 : drawn() * value_or(limits.velocity, 0);
      state.qdd[i] = drawn() * value_or(limits.acceleration, 0);
    }
    at_corner_ = !at_corner_;
    return state;
  }

 private:
  double drawn() {
    const double x = uniform_(engine_);
    return at_corner_ ? std::copysign(1.0, x) : x;
  }

  const Mechanism& mechanism_;
  bool at_rest_, at_corner_ = false;
  std::mt19937_64 engine_{1};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

}  // namespace

std::vector<double> largest_torque_change(const Mechanism& a, const Mechanism& b, bool at_rest, int states) {
  const Function of_a = derive_function(a, "inverse_dynamics"), of_b = derive_function(b, "inverse_dynamics");
  GraphEvaluator<double> tau_a(of_a), tau_b(of_b);
  LimitedStates within(a, at_rest);
  std::vector<double> largest(a.bodies.size(), 0);
  for (int k = 0; k < states; ++k) {
    const State state = within.next();
    const std::vector<double> x = *tau_a(state), y = *tau_b(state);
    for (std::size_t i = 0; i < largest.size(); ++i) largest[i] = std::max(largest[i], std::abs(x[i] - y[i]));
  }
  return largest;
}

}  // namespace flatdyn
