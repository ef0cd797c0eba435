// SPDX-License-Identifier: GPL-2.0-or-later
// Coefficients by number, so that passes compare them, their sizes and their ratios without arithmetic on fractions.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/hash_index.hpp"
#include "graph/mod_p.hpp"

namespace flatdyn {

// The exponent e of a coefficient that is not 0, |value| from 2^e to 2^(e + 1), within the range of double.
int exponent_of(const Rational& value);

// The exponent beyond which a pass makes no coefficient. Rotations that are rational leave residues of 1e-60 where a
// number should be 0, and what is divided by one of them is infinite in float.
inline constexpr int kLargestExponent = 90;

using CoefficientId = std::int32_t;
using RatioId = std::int32_t;

class CoefficientTable {
 public:
  CoefficientTable();

  // The number of a coefficient that is not 0.
  CoefficientId id(const Rational& value);
  const Rational& operator[](CoefficientId id) const { return entry(id).value; }

  bool is_unit(CoefficientId id) const { return entry(id).size == kOne; }                                   // ±1
  bool have_equal_sizes(CoefficientId a, CoefficientId b) const { return entry(a).size == entry(b).size; }  // |a| = |b|

  int exponent(CoefficientId id) const { return entry(id).exponent; }

  // The number of the ratio above / below: equal ratios have the same number.
  RatioId ratio(CoefficientId above, CoefficientId below);

  static constexpr CoefficientId kOne = 0;

 private:
  using Residue = ModP<kMersenne61>;

  struct Entry {
    Rational value;
    CoefficientId size = 0;  // the number of |value|
    int exponent = 0;
    Residue residue, inverse{};  // of value; both 0 if value has none that can be inverted
  };
  struct Pair {
    CoefficientId above, below;
    RatioId ratio;
  };
  struct Ratio {
    CoefficientId above, below;  // two coefficients that have it
  };

  const Entry& entry(CoefficientId id) const { return entries_[static_cast<std::size_t>(id)]; }
  CoefficientId add(const Rational& value);
  RatioId new_ratio(CoefficientId above, CoefficientId below);
  std::uint64_t fingerprint(CoefficientId above, CoefficientId below) const;
  bool has_ratio(RatioId ratio, CoefficientId above, CoefficientId below) const;

  std::vector<Entry> entries_;
  HashIndex index_;
  std::vector<Pair> pairs_;  // whose ratios have been asked for
  HashIndex pair_index_;
  std::vector<Ratio> ratios_;
  HashIndex ratio_index_;
};

}  // namespace flatdyn
