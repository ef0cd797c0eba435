// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/exact_root.hpp"

namespace flatdyn {

Number exact_root(const Number& a) {
  constexpr int kLargestPrime = 10000;
  if (!is_rational(a) || a.is_zero()) return GiNaC::sqrt(a);
  const auto& rational = GiNaC::ex_to<GiNaC::numeric>(a);
  // sqrt(n/d) = sqrt(n d)/d
  GiNaC::numeric rest = rational.numer() * rational.denom();
  Number root = Number(1) / rational.denom();
  for (int factor = 2; factor <= kLargestPrime && rest >= GiNaC::numeric(factor); ++factor) {
    const GiNaC::numeric prime(factor);  // a composite one no longer divides
    int power = 0;
    for (; GiNaC::irem(rest, prime).is_zero(); ++power) rest = GiNaC::iquo(rest, prime);
    root *= GiNaC::pow(prime, GiNaC::numeric(power / 2));
    if (power % 2 == 1) root *= GiNaC::sqrt(Number(prime));
  }
  return root * GiNaC::sqrt(Number(rest));
}

}  // namespace flatdyn
