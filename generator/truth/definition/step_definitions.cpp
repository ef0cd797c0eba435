// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/step_definitions.hpp"

#include "truth/definition/acceleration_derivatives.hpp"
#include "truth/definition/elimination_over_field.hpp"
#include "truth/definition/rules.hpp"
#include "truth/definition/stage_arithmetic.hpp"

namespace flatdyn::definitions {
namespace {

template <class Point>
typename Point::F step_length(const Point& at) {
  return at.arithmetic.input({InputKind::h, 0});
}

// A step of semi-implicit Euler adds h² q̈ to q + h q̇, and h q̈ to q̇.
template <class Point>
typename Point::Values before_accelerating(const Point& at, const Output& output) {
  const auto rates = at.qd();
  if (output.quantity == OutputQuantity::joint_rate) return rates;
  auto positions = at.drawn(InputKind::q);
  for (std::size_t k = 0; k < rates.size(); ++k) positions[k] += step_length(at) * rates[k];
  return positions;
}

template <class Point>
typename Point::F factor_of_acceleration(const Point& at, const Output& output) {
  const auto h = step_length(at);
  return output.quantity == OutputQuantity::joint_rate ? h : h * h;
}

// The same of A and B: rows of positions, then of rates.
template <class Point>
Matrix<typename Point::F> own_less_drift(const Point& at, const Output& output) {
  using F = typename Point::F;
  const int n = at.mechanism.size();
  Matrix<F> own(output.cols, at.own(output));
  if (output.cols == n) return own;  // B
  for (int k = 0; k < n; ++k) {
    own(k, k) += -F(1);
    own(k, n + k) += -step_length(at);
    own(n + k, n + k) += -F(1);
  }
  return own;
}

// Both halves of a matrix multiplied by the inertia matrix from the left.
template <class Point>
auto times_inertia(Point& at, const Matrix<typename Point::F>& matrix) {
  const int n = at.mechanism.size();
  Matrix<typename Point::F> result(2 * n, matrix.cols());
  const auto& inertia = at.lagrangian.inertia();
  for (int i = 0; i < 2 * n; ++i) {
    const int first = i < n ? 0 : n;
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < matrix.cols(); ++k) result(i, k) += inertia(i - first, j) * matrix(first + j, k);
    }
  }
  return result.entries();
}

// h B⁻¹, as the function has it.
template <class Point>
Matrix<typename Point::F> own_inverse(const Point& at) {
  using F = typename Point::F;
  const int n = at.mechanism.size();
  const Matrix<F> own(n, at.own(at.function.outputs.back()));
  Matrix<F> inverse(n, n);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) inverse(i, k) = own(n + i, k) / step_length(at);
  }
  return inverse;
}

template <class Point>
auto semi_implicit_derivatives(Point& at, const Output& output) {
  using F = typename Point::F;
  const int n = at.mechanism.size();
  const F h = step_length(at);
  const auto inverse = own_inverse(at);
  Matrix<F> result(2 * n, output.cols);
  const auto put = [&](OutputQuantity quantity, int column) {
    const Matrix<F> of_acceleration(n, acceleration_derivatives(at, quantity, inverse));
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        result(i, column + k) = h * h * of_acceleration(i, k);
        result(n + i, column + k) = h * of_acceleration(i, k);
      }
    }
  };
  if (output.cols == n) {
    put(OutputQuantity::acceleration_per_torque, 0);
  } else {
    put(OutputQuantity::acceleration_per_position, 0);
    put(OutputQuantity::acceleration_per_rate, n);
  }
  return result.entries();
}

// q̈ at a state with positions q and rates q̇.
template <class Point>
typename Point::Values accelerations_at(const Point& at, const typename Point::Values& q,
                                        const typename Point::Values& qd) {
  using F = typename Point::F;
  StageArithmetic<F> stage(at.arithmetic, q, qd);
  const std::vector<F> none;
  DefinitionPoint<StageArithmetic<F>> there(at.mechanism, at.function, stage, none);
  return solution(there.lagrangian.inertia(), there.net_torques());
}

// x + factor ẋ.
template <class Values, class F>
Values moved(Values x, const F& factor, const Values& rate) {
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += factor * rate[k];
  return x;
}

// (a + 2 b + 2 c + d) / 6.
template <class Values>
Values mean(const Values& a, const Values& b, const Values& c, const Values& d) {
  using F = typename Values::value_type;
  Values result;
  for (std::size_t k = 0; k < a.size(); ++k) {
    result.push_back((a[k] + F(2) * b[k] + F(2) * c[k] + d[k]) / F(6));
  }
  return result;
}

template <class Point>
typename Point::Values after_runge_kutta(const Point& at, const Output& output) {
  using F = typename Point::F;
  const F h = step_length(at), half = h / F(2);
  const auto q = at.drawn(InputKind::q), qd = at.qd();
  const auto a = accelerations_at(at, q, qd);
  const auto rate_b = moved(qd, half, a), b = accelerations_at(at, moved(q, half, qd), rate_b);
  const auto rate_c = moved(qd, half, b), c = accelerations_at(at, moved(q, half, rate_b), rate_c);
  const auto rate_d = moved(qd, h, c), d = accelerations_at(at, moved(q, h, rate_c), rate_d);
  return output.quantity == OutputQuantity::joint_rate ? moved(qd, h, mean(a, b, c, d))
                                                       : moved(q, h, mean(qd, rate_b, rate_c, rate_d));
}

// A stage of a step: q̈ there, and how it changes with the state before the step and with τ, n × 3n.
template <class F>
struct StageOfStep {
  std::vector<F> acceleration;
  Matrix<F> derivatives;
};

// a + factor b.
template <class F>
Matrix<F> moved(Matrix<F> a, const F& factor, const Matrix<F>& b) {
  for (int i = 0; i < a.rows(); ++i) {
    for (int k = 0; k < a.cols(); ++k) a(i, k) += factor * b(i, k);
  }
  return a;
}

// The same from positions and rates, and their derivatives.
template <class Point, class F = typename Point::F>
StageOfStep<F> stage_at(const Point& at, const std::vector<F>& q, const std::vector<F>& qd, const Matrix<F>& dq,
                        const Matrix<F>& dqd, const Matrix<F>& dtau) {
  const int n = at.mechanism.size();
  StageArithmetic<F> arithmetic(at.arithmetic, q, qd);
  const std::vector<F> none;
  DefinitionPoint<StageArithmetic<F>> there(at.mechanism, at.function, arithmetic, none);
  const Matrix<F> inertia = there.lagrangian.inertia();
  StageOfStep<F> stage{solution(inertia, there.net_torques()), {}};
  const Matrix<F> by_q(n, torque_derivatives_by_position(there, stage.acceleration));
  const Matrix<F> by_qd(n, torque_derivatives_by_rate(there));
  const Matrix<F> change = moved(moved(dtau, -F(1), times(by_q, dq)), -F(1), times(by_qd, dqd));
  stage.derivatives = solution(inertia, change);
  return stage;
}

// The blocks of an n × 3n matrix that are the identity, by q, q̇ and τ.
template <class F>
Matrix<F> unit_block(int n, int block) {
  Matrix<F> result(n, 3 * n);
  for (int k = 0; k < n; ++k) result(k, block * n + k) = F(1);
  return result;
}

// The derivatives of the state after a step of the Runge-Kutta method, along with the method itself.
template <class Point>
typename Point::Values runge_kutta_derivatives(const Point& at, const Output& output) {
  using F = typename Point::F;
  const int n = at.mechanism.size();
  const F h = step_length(at), half = h / F(2), sixth = h / F(6), two(2);
  const auto q = at.drawn(InputKind::q), qd = at.qd();
  const Matrix<F> dq = unit_block<F>(n, 0), dqd = unit_block<F>(n, 1), dtau = unit_block<F>(n, 2);
  const auto a = stage_at(at, q, qd, dq, dqd, dtau);
  const auto rate_b = moved(qd, half, a.acceleration);
  const Matrix<F> drate_b = moved(dqd, half, a.derivatives);
  const auto b = stage_at(at, moved(q, half, qd), rate_b, moved(dq, half, dqd), drate_b, dtau);
  const auto rate_c = moved(qd, half, b.acceleration);
  const Matrix<F> drate_c = moved(dqd, half, b.derivatives);
  const auto c = stage_at(at, moved(q, half, rate_b), rate_c, moved(dq, half, drate_b), drate_c, dtau);
  const auto rate_d = moved(qd, h, c.acceleration);
  const Matrix<F> drate_d = moved(dqd, h, c.derivatives);
  const auto d = stage_at(at, moved(q, h, rate_c), rate_d, moved(dq, h, drate_c), drate_d, dtau);
  const auto after = [&](const Matrix<F>& x, const Matrix<F>& k1, const Matrix<F>& k2, const Matrix<F>& k3,
                         const Matrix<F>& k4) {
    return moved(moved(moved(moved(x, sixth, k1), two * sixth, k2), two * sixth, k3), sixth, k4);
  };
  const Matrix<F> positions = after(dq, dqd, drate_b, drate_c, drate_d),
                  rates = after(dqd, a.derivatives, b.derivatives, c.derivatives, d.derivatives);
  std::vector<F> result;
  const int first = output.cols == n ? 2 * n : 0;
  for (const Matrix<F>* rows : {&positions, &rates}) {
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < output.cols; ++k) result.push_back((*rows)(i, first + k));
    }
  }
  return result;
}

// Numerator and denominator of each stage have n factors of B, and contain those of the stage before.
double degree_of_four_stages(const Mechanism& mechanism) {
  double factor = 1;
  for (int stage = 0; stage < 4; ++stage) factor = 2 + 4.0 * mechanism.size() * factor;
  return factor;
}

}  // namespace

constinit const Definition runge_kutta_step = {
    .expected = rules([](auto& at, const Output& output) { return after_runge_kutta(at, output); }),
    .found = kOwnValues,
    .degree_factor = [](const Mechanism& mechanism, const Function&) { return degree_of_four_stages(mechanism); },
};

constinit const Definition runge_kutta_step_derivatives = {
    .expected = rules([](auto& at, const Output& output) { return runge_kutta_derivatives(at, output); }),
    .found = kOwnValues,
    .degree_factor = [](const Mechanism& mechanism, const Function&) { return 5.0 * degree_of_four_stages(mechanism); },
};

// Compared without denominators; single entries as they are.
constinit const Definition semi_implicit_step = {
    .expected = rules([](auto& at, const Output& output) {
      auto torques = at.net_torques();
      for (auto& torque : torques) torque = factor_of_acceleration(at, output) * torque;
      return output.left_out.empty() ? torques : solution(at.lagrangian.inertia(), torques);
    }),
    .found = rules([](auto& at, const Output& output) {
      auto own = at.own(output);
      const auto before = before_accelerating(at, output);
      for (std::size_t k = 0; k < own.size(); ++k) own[k] += -before[k];
      return output.left_out.empty() ? times(at.lagrangian.inertia(), own) : own;
    }),
    .degree_factor = [](const Mechanism& mechanism,
                        const Function& function) { return 2 + (is_whole(function) ? 1.0 : 2.0 * mechanism.size()); },
};

constinit const Definition semi_implicit_step_derivatives = {
    .expected = rules([](auto& at, const Output& output) { return semi_implicit_derivatives(at, output); }),
    .found = rules([](auto& at, const Output& output) { return times_inertia(at, own_less_drift(at, output)); }),
    .degree_factor = [](const Mechanism&, const Function&) { return 4.0; },
};

}  // namespace flatdyn::definitions
