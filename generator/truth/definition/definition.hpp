// SPDX-License-Identifier: GPL-2.0-or-later
// The definition of a function: the rule by which its outputs are computed from Lagrange's equations at one point of a
// prime field, where nothing is rounded.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/function.hpp"
#include "graph/mod_p.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

template <class Arithmetic>
class DefinitionPoint;

// The entries of an output, over GF(P).
template <std::uint64_t P>
using Rule = std::vector<ModP<P>> (*)(DefinitionPoint<ModPArithmetic<P>>&, const Output&);

// One rule over each of the three fields that proofs use.
struct Rules {
  Rule<kMersenne61> a;
  Rule<kPrime61b> b;
  Rule<kPrime61c> c;

  template <std::uint64_t P>
  Rule<P> over() const {
    if constexpr (P == kMersenne61) return a;
    if constexpr (P == kPrime61b) return b;
    if constexpr (P == kPrime61c) return c;
  }
};

struct Definition {
  Rules expected;  // the values by the definition
  // The function's own values in the form in which they are compared, for example multiplied by B, so that they have no
  // denominators.
  Rules found;
  // The degree of the comparison relative to the Lagrangian's (see truth/definition/degree.hpp).
  double (*degree_factor)(const Mechanism&, const Function&);
  bool is_over_parameters = false;  // whether the comparison is linear in the parameters, as that of a regressor
  // Whether the function's own values are compared as they are, with expected ones in which they have no part: then
  // the degrees of both add.
  bool is_apart = false;
};

}  // namespace flatdyn
