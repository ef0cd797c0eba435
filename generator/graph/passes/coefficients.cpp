// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/coefficients.hpp"

#include <algorithm>
#include <cmath>

namespace flatdyn {
namespace {

std::size_t as_index(std::int32_t number) { return static_cast<std::size_t>(number); }

}  // namespace

int exponent_of(const Rational& value) {
  constexpr int kOfDouble = 1023;
  return std::clamp(std::ilogb(value.truncated()), -kOfDouble, kOfDouble);
}

CoefficientTable::CoefficientTable() {
  id(1);
  new_ratio(kOne, kOne);  // ratio 0
}

CoefficientId CoefficientTable::id(const Rational& value) {
  const auto next = static_cast<CoefficientId>(entries_.size());
  const CoefficientId found = index_.find_or_add(mixed_bits(value.hash()), next,
                                                 [&](CoefficientId k) { return entries_[as_index(k)].value == value; });
  return found == next ? add(value) : found;
}

CoefficientId CoefficientTable::add(const Rational& value) {
  const auto added = static_cast<CoefficientId>(entries_.size());
  Entry entry{value, added, exponent_of(value), Residue(0), Residue(0)};
  const Residue above(value.numerator_modulo(kMersenne61)), below(value.denominator_modulo(kMersenne61));
  if (above != Residue(0) && below != Residue(0)) {
    entry.residue = Residue::from(value);
    entry.inverse = entry.residue == Residue(1) ? entry.residue : entry.residue.inverse();
  }
  entries_.push_back(entry);
  if (value < 0) {
    const CoefficientId size = id(-value);
    entries_[as_index(added)].size = size;
  }
  return added;
}

RatioId CoefficientTable::ratio(CoefficientId above, CoefficientId below) {
  if (above == below) return 0;
  const auto next = static_cast<std::int32_t>(pairs_.size());
  const std::int32_t found = pair_index_.find_or_add(mixed_bits(pair_key(above, below)), next, [&](std::int32_t k) {
    return pairs_[as_index(k)].above == above && pairs_[as_index(k)].below == below;
  });
  if (found == next) pairs_.push_back({above, below, new_ratio(above, below)});
  return pairs_[as_index(found)].ratio;
}

RatioId CoefficientTable::new_ratio(CoefficientId above, CoefficientId below) {
  const auto next = static_cast<RatioId>(ratios_.size());
  const RatioId found = ratio_index_.find_or_add(mixed_bits(fingerprint(above, below)), next,
                                                 [&](RatioId k) { return has_ratio(k, above, below); });
  if (found == next) ratios_.push_back({above, below});
  return found;
}

// The ratio modulo a prime, or 0 if it cannot be computed.
std::uint64_t CoefficientTable::fingerprint(CoefficientId above, CoefficientId below) const {
  const Residue inverse = entry(below).inverse;
  if (entry(above).residue != Residue(0) && inverse != Residue(0)) return (entry(above).residue * inverse).value();
  const Rational ratio = (*this)[above] / (*this)[below];
  const Residue divisor(ratio.denominator_modulo(kMersenne61));
  return divisor == Residue(0) ? 0 : Residue::from(ratio).value();
}

// Compares fractions by their products crosswise, as that needs no common divisors.
bool CoefficientTable::has_ratio(RatioId ratio, CoefficientId above, CoefficientId below) const {
  const Rational &a = (*this)[above], &b = (*this)[below];
  const Rational &c = (*this)[ratios_[as_index(ratio)].above], &d = (*this)[ratios_[as_index(ratio)].below];
  return numerator(a) * denominator(b) * (denominator(c) * numerator(d)) ==
         denominator(a) * numerator(b) * (numerator(c) * denominator(d));
}

}  // namespace flatdyn
