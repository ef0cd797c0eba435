// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/variants.hpp"

namespace flatdyn {

const std::vector<BenchVariant>& bench_variants() {
  static const std::vector<BenchVariant> table = {
      {"double", "double", false},
      {"float", "float", false},
      {"batch double", "double", true},
      {"batch float", "float", true},
  };
  return table;
}

}  // namespace flatdyn
