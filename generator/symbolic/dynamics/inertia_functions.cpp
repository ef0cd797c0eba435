// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/dynamics/inertia_functions.hpp"

#include "symbolic/dynamics/composite.hpp"
#include "symbolic/dynamics/derivatives.hpp"

namespace flatdyn {

namespace {

// Adds the contribution of closed loops: (A G)ᵀ B times the second derivatives of the joints' positions. `bench`: that
// of half the inertia.
void add_curvature(Workbench& bench, ChristoffelSymbols& symbols) {
  Rows B = inertia_matrix(bench.frames);
  for (std::vector<Number>& row : B) {
    for (Number& b : row) b *= 2;
  }
  const Rows GB = rows_at_coordinates(bench.mechanism, bench.derivation, B, "b");
  for (int k = 0; k < bench.size(); ++k) {
    for (int j = 0; j <= k; ++j) {
      const std::vector<Number> H = joint_curvature(bench.mechanism, bench.derivation, j, k);
      for (int i = 0; i < bench.size(); ++i) {
        Number sum = symbols[{i, j, k}];
        for (std::size_t r = 0; r < H.size(); ++r) sum += GB[static_cast<std::size_t>(i)][r] * H[r];
        symbols[{i, j, k}] = bench.derivation.named(sum, "c_l" + label(i) + "_" + label(j) + "_" + label(k));
      }
    }
  }
}

ChristoffelSymbols christoffel_at_coordinates(Workbench& bench) {
  ChristoffelSymbols symbols = at_coordinates(bench.mechanism, bench.derivation, christoffel_symbols(bench.frames));
  if (bench.mechanism.has_loops()) add_curvature(bench, symbols);
  return symbols;
}

Function finished_coriolis(Workbench& bench, const std::vector<NodeId>& entries) {
  return finished(bench, {matrix_output("C", bench.size(), bench.size(), entries,
                                        "c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric")});
}

}  // namespace

Function derive_inertia_matrix(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    std::vector<NodeId> entries;
    for (const std::vector<Number>& row : bench.inertia()) {
      for (const Number& b : row) entries.push_back(bench.node(b));
    }
    return finished(bench, {matrix_output("B", bench.size(), bench.size(), entries,
                                          "inertia matrix, symmetric, kg m^2 (kg for prismatic joints)")});
  });
}

Function derive_christoffel(const Mechanism& mechanism, const Choices& choices) {
  return derived(with_half_inertia(mechanism), choices, [](Workbench& bench) {
    const int n = bench.size(), columns = n * (n + 1) / 2;
    std::vector<NodeId> entries(static_cast<std::size_t>(n * columns), bench.node(0));
    for (const auto& [key, value] : christoffel_at_coordinates(bench)) {
      const auto [i, j, k] = key;
      entries[static_cast<std::size_t>(i * columns + k * (k + 1) / 2 + j)] = bench.node(value);
    }
    return finished(bench,
                    {{"c", Layout::christoffel, n, columns, entries, "Christoffel symbols c_ijk = c_ikj, j <= k"}});
  });
}

Function derive_coriolis_from_christoffel(const Mechanism& mechanism, const Choices& choices) {
  return derived(with_half_inertia(mechanism), choices, [](Workbench& bench) {
    const auto n = static_cast<std::size_t>(bench.size());
    const std::vector<Number> qd = bench.all(InputKind::qd);
    Rows C(n, std::vector<Number>(n, 0));
    for (const auto& [key, c] : christoffel_at_coordinates(bench)) {
      const auto i = static_cast<std::size_t>(key[0]), j = static_cast<std::size_t>(key[1]),
                 k = static_cast<std::size_t>(key[2]);
      C[i][j] += c * qd[k];
      if (j != k) C[i][k] += c * qd[j];
    }
    return finished_coriolis(bench, bench.nodes(C));
  });
}

// C q̇ is a quadratic form in q̇ with the coefficients c_ijk = c_ikj, so C is half its derivative.
std::optional<Function> derive_coriolis_from_momenta(const Mechanism& mechanism, const Choices& choices) {
  if (mechanism.has_loops()) return std::nullopt;
  return derived(with_half_inertia(mechanism), choices, [](Workbench& bench) {
    const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_drift(), zero_vector(), false};
    const Rows C = torque_derivatives(bench.frames, motion).dqd;
    return finished_coriolis(bench,
                             bench.nodes(at_coordinates(bench.mechanism, bench.derivation, C, Shape::general, "C")));
  });
}

}  // namespace flatdyn
