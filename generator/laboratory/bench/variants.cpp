// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/variants.hpp"

#include "laboratory/bench/toolchain.hpp"

namespace flatdyn {

const std::vector<BenchVariant>& bench_variants() {
  static const std::vector<BenchVariant> table = {
      {"double", "double", CallMode::single, SinCosSource::own},
      {"double-native", "double", CallMode::single, SinCosSource::own, "", false, false, false, true},
      {"double-library", "double", CallMode::single, SinCosSource::library},
      {"double-together", "double", CallMode::single, SinCosSource::together},
      {"double-given", "double", CallMode::single, SinCosSource::given},
      {"double-staged", "double", CallMode::staged, SinCosSource::own},
      {"double-fma", "double", CallMode::single, SinCosSource::own, "", false, true},
      {"double-fma-given", "double", CallMode::single, SinCosSource::given, "", false, true},
      {"double-limbs", "double", CallMode::single, SinCosSource::own, "", false, false, true},
      {"double-limbs-given", "double", CallMode::single, SinCosSource::given, "", false, false, true},
      {"double-0.01%", "double", CallMode::single, SinCosSource::own, "0.01%"},
      {"double-0.1%", "double", CallMode::single, SinCosSource::own, "0.1%"},
      {"double-1%", "double", CallMode::single, SinCosSource::own, "1%"},
      {"float", "float", CallMode::single, SinCosSource::own},
      {"float-library", "float", CallMode::single, SinCosSource::library},
      {"float-together", "float", CallMode::single, SinCosSource::together},
      {"float-given", "float", CallMode::single, SinCosSource::given},
      {"float-fma", "float", CallMode::single, SinCosSource::own, "", false, true},
      {"float-staged", "float", CallMode::staged, SinCosSource::own},
      {"batch-double", "double", CallMode::batch, SinCosSource::own},
      {"batch-double-given", "double", CallMode::batch, SinCosSource::given},
      {"batch-double-fma", "double", CallMode::batch, SinCosSource::own, "", false, true},
      {"batch-double-packed", "double", CallMode::batch, SinCosSource::own, "", true},
      {"batch-float", "float", CallMode::batch, SinCosSource::own},
      {"batch-float-given", "float", CallMode::batch, SinCosSource::given},
      {"batch-float-packed", "float", CallMode::batch, SinCosSource::own, "", true},
      {"batch-float-0.01%", "float", CallMode::batch, SinCosSource::own, "0.01%"},
      {"batch-float-0.1%", "float", CallMode::batch, SinCosSource::own, "0.1%"},
      {"batch-float-1%", "float", CallMode::batch, SinCosSource::own, "1%"},
      {"cuda-double", "double", CallMode::kernel, SinCosSource::own},
      {"cuda-float", "float", CallMode::kernel, SinCosSource::own},
  };
  return table;
}

bool needs_xsimd(const BenchVariant& variant) {
  return variant.call_mode == CallMode::batch || variant.trigonometry == SinCosSource::together;
}

bool has_plain_bits(const BenchVariant& variant) {
  const bool is_plain = variant.call_mode == CallMode::single || variant.call_mode == CallMode::kernel;
  const bool is_changed = *variant.budget != '\0' || variant.fuses || variant.has_lanes;
  return is_plain && !is_changed && variant.trigonometry == SinCosSource::own;
}

bool is_whole_call(const BenchVariant& variant) {
  return variant.trigonometry != SinCosSource::given && variant.call_mode != CallMode::staged;
}

namespace {

// The given sines are those of the entries of q, so a function of other angles cannot use them.
bool asks_for_other_angles(const Graph& graph) {
  for (NodeId id = 0; id < graph.size(); ++id) {
    const bool is_asked = graph[id].op == Op::sin || graph[id].op == Op::cos;
    if (is_asked && (is_of_computed_angle(graph, id) || angle_of(graph, id).coefficient != 1)) return true;
  }
  return false;
}

}  // namespace

bool has_angles(const Function& function) {
  const std::vector<bool> alive = reachable_from(function.graph, roots(function));
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    const Op op = function.graph[id].op;
    const bool is_asked = op == Op::sin || op == Op::cos;
    if (alive[static_cast<std::size_t>(id)] && is_asked && !is_of_computed_angle(function.graph, id)) return true;
  }
  return false;
}

bool is_made(const BenchVariant& variant, const Function& function, bool has_xsimd) {
  if (variant.is_native && *kTuning == '\0') return false;
  if (variant.trigonometry == SinCosSource::given && asks_for_other_angles(function.graph)) return false;
  return (has_xsimd || !needs_xsimd(variant)) && (has_angles(function) || variant.trigonometry == SinCosSource::own);
}

}  // namespace flatdyn
