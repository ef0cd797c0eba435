// SPDX-License-Identifier: GPL-2.0-or-later
// The model in closed form, by Lagrange, for people to read and as the definition for small robots. It has polynomials
// in s_i = sin q_i, c_i = cos q_i, d_i and the free symbols, expanded, with s_i² replaced by 1 - c_i², so that equal
// functions are equal expressions.
#pragma once

#include <vector>

#include "model/mechanism.hpp"

namespace flatdyn {

struct ClosedForm {
  std::vector<GiNaC::symbol> d;     // one per coordinate, for prismatic joints
  std::vector<GiNaC::symbol> c, s;  // one of each per angle: coordinates of revolute joints, and Mechanism::angles
  Rows B;                           // (7.32)
  Rows c_ijk;                       // [i][k (k + 1) / 2 + j], j <= k, (7.45)
  std::vector<Number> g;            // (7.39)

  int size() const { return static_cast<int>(g.size()); }
  const Number& christoffel(int i, int j, int k) const;
};

// The index of a joint as an index of vectors.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

// B, the Christoffel symbols and g of the mechanism, expanded.
ClosedForm closed_form(const Mechanism& mechanism);

// Replaces sin(x)² by 1 - cos(x)² everywhere and expands, for the joints' s_i and c_i and for angles that are free
// symbols.
Number reduced(const Number& expression, const ClosedForm& form);

}  // namespace flatdyn
