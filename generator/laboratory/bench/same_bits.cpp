// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/same_bits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

bool are_same(double a, double b) { return std::memcmp(&a, &b, sizeof(a)) == 0 || (std::isnan(a) && std::isnan(b)); }

}  // namespace

void check_same_bits(const std::string& function, const VariantResult& a, const VariantResult& b) {
  bool are_all = a.holds == b.holds && a.values.size() == b.values.size();
  for (std::size_t k = 0; are_all && a.holds && k < a.values.size(); ++k) are_all = are_same(a.values[k], b.values[k]);
  if (are_all) return;
  throw Failure(FailureKind::bug, fmt::format("{}: {} computes other bits than {}", function, b.variant, a.variant));
}

}  // namespace flatdyn
