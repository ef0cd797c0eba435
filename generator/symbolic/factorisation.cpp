// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/factorisation.hpp"

#include <fmt/format.h>

#include "diagnostics/diagnostics.hpp"

namespace flatdyn {

Solution solve_factorised(Frames& frames, std::vector<std::vector<Number>> B, std::vector<Number> b) {
  Derivation& d = frames.derivation();
  const auto n = b.size();
  const auto parent = [&](std::size_t i) { return frames.mechanism().bodies[i].parent; };
  const auto index = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<Number> inverse(n);
  for (std::size_t k = n; k-- > 0;) {
    const std::string row = label(static_cast<int>(k));
    if (vanishes(B[k][k])) {
      throw Failure(ExitCode::unsupported,
                    fmt::format("forward_dynamics: B(q) is singular, because joint \"{}\" moves no inertia",
                                frames.mechanism().bodies[k].joint),
                    "give the links that it moves their inertia, or its motor a rotor");
    }
    inverse[k] = d.quotient(1, B[k][k], "d_" + row);
    for (int i = parent(k); i >= 0; i = parent(index(i))) {
      const Number l = d.named(B[k][index(i)] * inverse[k], "l_" + row + "_" + label(i));
      for (int j = i; j >= 0; j = parent(index(j))) {
        B[index(i)][index(j)] =
            d.named(B[index(i)][index(j)] - l * B[k][index(j)], "b_" + row + "_" + label(i) + "_" + label(j));
      }
      B[k][index(i)] = l;
    }
  }
  Solution solution;
  for (std::size_t k = 0; k < n; ++k) solution.pivots.push_back(B[k][k]);
  for (std::size_t k = n; k-- > 0;) {  // Lᵀ y = b
    for (int i = parent(k); i >= 0; i = parent(index(i))) {
      b[index(i)] = d.named(b[index(i)] - B[k][index(i)] * b[k], "y_" + label(static_cast<int>(k)) + "_" + label(i));
    }
  }
  for (std::size_t k = 0; k < n; ++k) {  // L x = D⁻¹ y
    Number x = inverse[k] * b[k];
    for (int i = parent(k); i >= 0; i = parent(index(i))) x -= B[k][index(i)] * solution.x[index(i)];
    solution.x.push_back(d.named(x, "qdd_" + label(static_cast<int>(k))));
  }
  return solution;
}

}  // namespace flatdyn
