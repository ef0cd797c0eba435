// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/inertia_functions.hpp"

#include "derivation/dynamics/composite.hpp"
#include "derivation/dynamics/derivatives.hpp"

namespace flatdyn {

namespace {

// (A G)ᵀ B, from the context of half the inertia.
Rows momenta_at_coordinates(DerivationContext& context) {
  Rows B = inertia_matrix(context.frames);
  for (std::vector<Number>& row : B) {
    for (Number& b : row) b *= 2;
  }
  return rows_at_coordinates(context.mechanism, context.derivation, B, "b");
}

// Adds the contribution of closed loops: (A G)ᵀ B times the second derivatives of the joints' positions. `context`:
// that of half the inertia.
void add_curvature(DerivationContext& context, ChristoffelSymbols& symbols) {
  const Rows GB = momenta_at_coordinates(context);
  for (int k = 0; k < context.size(); ++k) {
    for (int j = 0; j <= k; ++j) {
      const std::vector<Number> H = joint_curvature(context.mechanism, context.derivation, j, k);
      for (int i = 0; i < context.size(); ++i) {
        Number sum = symbols[{i, j, k}];
        for (std::size_t r = 0; r < H.size(); ++r) sum += GB[static_cast<std::size_t>(i)][r] * H[r];
        symbols[{i, j, k}] = context.derivation.named(sum, "c_l" + label(i) + "_" + label(j) + "_" + label(k));
      }
    }
  }
}

ChristoffelSymbols christoffel_at_coordinates(DerivationContext& context) {
  ChristoffelSymbols symbols =
      at_coordinates(context.mechanism, context.derivation, christoffel_symbols(context.frames));
  if (context.mechanism.has_loops()) add_curvature(context, symbols);
  return symbols;
}

Function finished_coriolis(DerivationContext& context, const std::vector<NodeId>& entries) {
  const std::string others = context.mechanism.has_springs() ? "gravity, friction and springs" : "gravity and friction";
  const std::string meaning = context.mechanism.has_quasi_velocities()
                                  ? "dB/dt - 2 C is skew-symmetric, and C v is the bias without " + others
                                  : "c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric";
  return finished(context, {matrix_output("C", context.size(), context.size(), entries, meaning)});
}

// Adds the contribution of closed loops: (A G)ᵀ B d(A G)/dt, so that Ḃ - 2 C stays skew-symmetric. `context`: that of
// half the inertia.
void add_motion_rate(DerivationContext& context, Rows& C) {
  const Rows GB = momenta_at_coordinates(context), rate = joint_motion_rate(context.mechanism, context.derivation);
  for (std::size_t i = 0; i < C.size(); ++i) {
    for (std::size_t k = 0; k < C.size(); ++k) {
      for (std::size_t r = 0; r < rate.size(); ++r) C[i][k] += GB[i][r] * rate[r][k];
    }
  }
}

// C q̇ is a quadratic form in q̇ with the coefficients c_ijk = c_ikj, so C is half its derivative. With a floating base
// or spherical joints, the same fields of accelerations give the C of the connection whose torsion is that of their
// velocities.
Function coriolis_from_momenta(const Mechanism& mechanism, const Choices& choices) {
  return derived(with_half_inertia(mechanism), choices, [](DerivationContext& context) {
    const Motion motion{context.joint_motion(InputKind::qd), context.joint_drift(), zero_vector(), false};
    const Rows of_joints = torque_derivatives(context.frames, motion, BaseColumns::coriolis).dqd;
    Rows C = at_coordinates(context.mechanism, context.derivation, of_joints, Shape::general, "C");
    if (context.mechanism.has_loops()) add_motion_rate(context, C);
    return finished_coriolis(context, context.nodes(C));
  });
}

}  // namespace

Function derive_inertia_matrix(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    std::vector<NodeId> entries;
    for (const std::vector<Number>& row : context.inertia()) {
      for (const Number& b : row) entries.push_back(context.node(b));
    }
    return finished(context, {matrix_output("B", context.size(), context.size(), entries,
                                            "inertia matrix, symmetric, kg m^2 (kg for prismatic joints)")});
  });
}

Function derive_christoffel(const Mechanism& mechanism, const Choices& choices) {
  return derived(with_half_inertia(mechanism), choices, [](DerivationContext& context) {
    const int n = context.size(), columns = n * (n + 1) / 2;
    std::vector<NodeId> entries(static_cast<std::size_t>(n * columns), context.node(0));
    for (const auto& [key, value] : christoffel_at_coordinates(context)) {
      const auto [i, j, k] = key;
      entries[static_cast<std::size_t>(i * columns + k * (k + 1) / 2 + j)] = context.node(value);
    }
    return finished(context,
                    {{"c", Layout::christoffel, n, columns, entries, "Christoffel symbols c_ijk = c_ikj, j <= k"}});
  });
}

Function derive_coriolis_from_christoffel(const Mechanism& mechanism, const Choices& choices) {
  if (mechanism.has_quasi_velocities()) return coriolis_from_momenta(mechanism, choices);
  return derived(with_half_inertia(mechanism), choices, [](DerivationContext& context) {
    const auto n = static_cast<std::size_t>(context.size());
    const std::vector<Number> qd = context.all(InputKind::qd);
    Rows C(n, std::vector<Number>(n, 0));
    for (const auto& [key, c] : christoffel_at_coordinates(context)) {
      const auto i = static_cast<std::size_t>(key[0]), j = static_cast<std::size_t>(key[1]),
                 k = static_cast<std::size_t>(key[2]);
      C[i][j] += c * qd[k];
      if (j != k) C[i][k] += c * qd[j];
    }
    return finished_coriolis(context, context.nodes(C));
  });
}

std::optional<Function> derive_coriolis_from_momenta(const Mechanism& mechanism, const Choices& choices) {
  if (mechanism.has_loops() || mechanism.has_quasi_velocities()) return std::nullopt;
  return coriolis_from_momenta(mechanism, choices);
}

}  // namespace flatdyn
