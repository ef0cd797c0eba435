// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/dynamics_definitions.hpp"

#include <algorithm>

#include "truth/definition/elimination_over_field.hpp"
#include "truth/definition/rules.hpp"

namespace flatdyn::definitions {
namespace {

template <class F>
std::vector<F> added(std::vector<F> a, const std::vector<F>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

// The Christoffel symbols in the order of Layout::christoffel.
template <class Point>
auto christoffel_symbols(Point& point) {
  typename Point::Values result;
  const int n = point.mechanism.size();
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      for (int j = 0; j <= k; ++j) result.push_back(point.lagrangian.christoffel(i, j, k));
    }
  }
  return result;
}

// Mᵀ x.
template <class F>
std::vector<F> times_transposed(const Matrix<F>& M, const std::vector<F>& x) {
  std::vector<F> result(static_cast<std::size_t>(M.cols()), F(0));
  for (int i = 0; i < M.rows(); ++i) {
    for (int j = 0; j < M.cols(); ++j) result[static_cast<std::size_t>(j)] += M(i, j) * x[static_cast<std::size_t>(i)];
  }
  return result;
}

// The acceleration of a floating base on which no force acts, and the torques of the joints, from those of the first
// six of Lagrange's equations; forces on the base are zero.
template <class Point, class F = typename Point::F>
auto dynamics_of_free_base(Point& at, const Output& output) {
  constexpr int kOfBase = 6;
  const Matrix<F>& B = at.lagrangian.inertia();
  std::vector<F> a = at.qdd(), tau = at.bias(), needed;
  Matrix<F> of_base(kOfBase, kOfBase);
  std::fill_n(a.begin(), kOfBase, F(0));
  const std::vector<F> of_joints = times(B, a);
  for (int i = 0; i < kOfBase; ++i) {
    const auto row = static_cast<std::size_t>(i);
    needed.push_back(-(tau[row] + of_joints[row]));
    for (int k = 0; k < kOfBase; ++k) of_base(i, k) = B(i, k);
  }
  const std::vector<F> a_b = solution(of_base, needed);
  if (output.name == "a_base") return a_b;
  std::copy(a_b.begin(), a_b.end(), a.begin());
  tau = added(tau, times(B, a));
  std::fill_n(tau.begin(), kOfBase, F(0));
  return tau;
}

}  // namespace

constinit const Definition inverse_dynamics = defined_as([](auto& at, const Output&) { return at.inverse_dynamics(); });

constinit const Definition inverse_dynamics_tip_force = defined_as([](auto& at, const Output&) {
  return added(at.inverse_dynamics(), at.lagrangian.tip_torques(at.drawn(InputKind::h_e, 6)));
});

constinit const Definition inertia_matrix =
    defined_as([](auto& at, const Output&) { return at.lagrangian.inertia().entries(); });

constinit const Definition christoffel = defined_as([](auto& at, const Output&) { return christoffel_symbols(at); });

constinit const Definition coriolis_matrix =
    defined_as([](auto& at, const Output&) { return at.coriolis_matrix().entries(); });

constinit const Definition gravity = defined_as([](auto& at, const Output&) { return at.lagrangian.gravity(); });

namespace {

// By coordinate, c s: the share of its torque that the drive loses.
template <class Point>
typename Point::Values lost_shares(Point& at) {
  typename Point::Values shares = at.signs();
  for (std::size_t k = 0; k < shares.size(); ++k) shares[k] = at.lagrangian.mechanism().bodies[k].dry.load * shares[k];
  return shares;
}

}  // namespace

constinit const Definition drive_torque = defined_as([](auto& at, const Output&) {
  auto tau = at.drawn(InputKind::tau);
  const auto shares = lost_shares(at);
  for (std::size_t k = 0; k < tau.size(); ++k) tau[k] += shares[k] * at.arithmetic.sign(tau[k]) * tau[k];
  return tau;
});

// It undoes drive_torque. The signs of τ_d and τ are the same.
constinit const Definition torque_from_drive = defined_as([](auto& at, const Output&) {
  using F = typename std::decay_t<decltype(at)>::F;
  auto tau = at.drawn(InputKind::tau);
  const auto shares = lost_shares(at);
  for (std::size_t k = 0; k < tau.size(); ++k) {
    const F lost = shares[k] * at.arithmetic.sign(tau[k]) * tau[k];
    tau[k] = (tau[k] + -lost) / (F(1) + -(shares[k] * shares[k]));
  }
  return tau;
});

constinit const Definition bias = defined_as([](auto& at, const Output&) { return at.bias(); });

// B q̈ is compared with τ - n, without denominators; single accelerations are compared with B⁻¹ (τ - n).
constinit const Definition forward_dynamics = {
    .expected = rules([](auto& at, const Output& output) {
      if (output.left_out.empty()) return at.net_torques();
      return solution(at.lagrangian.inertia(), at.net_torques());
    }),
    .found = rules([](auto& at, const Output& output) {
      const auto own = at.own(output);
      return output.left_out.empty() ? times(at.lagrangian.inertia(), own) : own;
    }),
    // Numerator and denominator of B⁻¹ (τ - n) have n factors of B or of its multipliers.
    .degree_factor = [](const Mechanism& mechanism,
                        const Function& function) { return is_whole(function) ? 1.0 : 2.0 * mechanism.size(); },
};

// Numerator and denominator have six factors of B each, and one more in the torques.
constinit const Definition inverse_dynamics_floating = {
    rules([](auto& at, const Output& output) { return dynamics_of_free_base(at, output); }), kOwnValues,
    [](const Mechanism&, const Function&) { return 14.0; }};

constinit const Definition momentum =
    defined_as([](auto& at, const Output&) { return times(at.lagrangian.inertia(), at.qd()); });

constinit const Definition coriolis_transpose_qd =
    defined_as([](auto& at, const Output&) { return times_transposed(at.coriolis_matrix(), at.qd()); });

constinit const Definition kinetic_energy = defined_as([](auto& at, const Output&) {
  return typename std::decay_t<decltype(at)>::Values{at.lagrangian.kinetic_energy(at.qd())};
});

constinit const Definition potential_energy = defined_as([](auto& at, const Output&) {
  return typename std::decay_t<decltype(at)>::Values{at.lagrangian.potential_energy()};
});

}  // namespace flatdyn::definitions
