// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/variants.hpp"

#include "graph/count.hpp"

namespace flatdyn {

const std::vector<BenchVariant>& bench_variants() {
  static const std::vector<BenchVariant> table = {
      {"double", "double", false, Trigonometry::library},
      {"double-together", "double", false, Trigonometry::together},
      {"double-given", "double", false, Trigonometry::given},
      {"float", "float", false, Trigonometry::library},
      {"float-together", "float", false, Trigonometry::together},
      {"float-given", "float", false, Trigonometry::given},
      {"batch-double", "double", true, Trigonometry::library},
      {"batch-double-given", "double", true, Trigonometry::given},
      {"batch-float", "float", true, Trigonometry::library},
      {"batch-float-given", "float", true, Trigonometry::given},
  };
  return table;
}

bool needs_xsimd(const BenchVariant& variant) {
  return variant.batch || variant.trigonometry == Trigonometry::together;
}

bool is_made(const BenchVariant& variant, const Function& function, bool has_xsimd) {
  const bool has_angles = count_operations(function).trigonometric > 0;
  return (has_xsimd || !needs_xsimd(variant)) && (has_angles || variant.trigonometry == Trigonometry::library);
}

}  // namespace flatdyn
