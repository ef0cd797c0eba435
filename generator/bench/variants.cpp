// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/variants.hpp"

#include "graph/count.hpp"

namespace flatdyn {

const std::vector<BenchVariant>& bench_variants() {
  static const std::vector<BenchVariant> table = {
      {"double", "double", Calling::single, Trigonometry::library},
      {"double-together", "double", Calling::single, Trigonometry::together},
      {"double-given", "double", Calling::single, Trigonometry::given},
      {"double-staged", "double", Calling::staged, Trigonometry::library},
      {"double-0.01%", "double", Calling::single, Trigonometry::library, "0.01%"},
      {"double-0.1%", "double", Calling::single, Trigonometry::library, "0.1%"},
      {"double-1%", "double", Calling::single, Trigonometry::library, "1%"},
      {"float", "float", Calling::single, Trigonometry::library},
      {"float-together", "float", Calling::single, Trigonometry::together},
      {"float-given", "float", Calling::single, Trigonometry::given},
      {"float-staged", "float", Calling::staged, Trigonometry::library},
      {"batch-double", "double", Calling::batch, Trigonometry::library},
      {"batch-double-given", "double", Calling::batch, Trigonometry::given},
      {"batch-float", "float", Calling::batch, Trigonometry::library},
      {"batch-float-given", "float", Calling::batch, Trigonometry::given},
      {"batch-float-0.01%", "float", Calling::batch, Trigonometry::library, "0.01%"},
      {"batch-float-0.1%", "float", Calling::batch, Trigonometry::library, "0.1%"},
      {"batch-float-1%", "float", Calling::batch, Trigonometry::library, "1%"},
  };
  return table;
}

bool needs_xsimd(const BenchVariant& variant) {
  return variant.calling == Calling::batch || variant.trigonometry == Trigonometry::together;
}

bool is_whole_call(const BenchVariant& variant) {
  return variant.trigonometry != Trigonometry::given && variant.calling != Calling::staged;
}

namespace {

// The given sines are those of the entries of q, so a function of multiples cannot use them.
bool asks_for_multiples(const Graph& graph) {
  for (NodeId id = 0; id < graph.size(); ++id) {
    const bool is_asked = graph[id].op == Op::sin || graph[id].op == Op::cos;
    if (is_asked && angle_of(graph, id).coefficient != 1) return true;
  }
  return false;
}

}  // namespace

bool is_made(const BenchVariant& variant, const Function& function, bool has_xsimd) {
  const bool has_angles = count_operations(function).trigonometric > 0;
  if (variant.trigonometry == Trigonometry::given && asks_for_multiples(function.graph)) return false;
  return (has_xsimd || !needs_xsimd(variant)) && (has_angles || variant.trigonometry == Trigonometry::library);
}

}  // namespace flatdyn
