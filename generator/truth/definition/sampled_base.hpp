// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters computed a second time, by exact elimination of the regressor (7.79) sampled at random states of
// prime fields. No rank is decided by a tolerance. The row space of Y does not depend on the samples, so its reduced
// echelon form is that of K, number by number.
#pragma once

#include <cstdint>

#include "derivation/parameters/base_parameters.hpp"

namespace flatdyn {

struct SampledComparison {
  int rank = 0;        // the rank of the samples
  bool equal = false;  // the kept columns are those of `base`, and every entry of K is the same modulo three primes
};

// Compares `base` with samples of the model with the same parameters.
SampledComparison compare_with_samples(const Mechanism& mechanism, const BaseParameters& base, ParameterSet set,
                                       std::uint64_t seed = 1);

}  // namespace flatdyn
