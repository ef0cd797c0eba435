// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/stress/program.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/system/process.hpp"
#include "code/emit/page.hpp"
#include "code/languages/emit.hpp"
#include "code/lower/arguments.hpp"
#include "laboratory/bench/calls.hpp"
#include "laboratory/bench/sources.hpp"
#include "laboratory/bench/toolchain.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;

// Flags that round as everywhere: the machine's registers, no contraction. Little optimisation is enough and compiles
// fast.
constexpr const char* kFlags = "-std=c++17 -O1 -march=native -ffp-contract=off";

bool is_wanted(const BenchVariant& variant, const std::vector<std::string>& wanted) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), variant.name) != wanted.end();
}

std::string symbol_of(std::size_t function, const BenchVariant& variant) {
  std::string name = fmt::format("stress_{}_{}", function, variant.name);
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

data variant_row(const Mechanism& mechanism, const Function& function, std::size_t k, const BenchVariant& variant) {
  const CalledFunction called = whole_function(function, variant);
  data row;
  row["symbol"] = symbol_of(k, variant);
  row["scalar"] = std::string(variant.scalar);
  row["entries"] = std::to_string(entry_count(function));
  if (variant.call_mode == CallMode::batch) {
    const BatchCall call = batch_call(mechanism, called, variant);
    row["batch"] = true;
    row["capture"] = call.capture;
    row["parameters"] = call.parameters;
    row["call"] = call.call;
    row["columns"] = call.columns;
  } else if (variant.call_mode == CallMode::kernel) {
    row["kernel"] = true;
    row["call"] = kernel_call(mechanism, called, variant);
  } else {
    row["single"] = true;
    row["call"] = single_call(mechanism, called, variant);
  }
  return row;
}

// The arguments of a call, in the order of kStateKinds.
data argument_rows(const State& like, bool quasi_velocities) {
  data rows(data::type::list);
  std::size_t place = 0;
  for (const InputKind kind : kStateKinds) {
    data row;
    row["name"] =
        kind == InputKind::parameter ? "parameters" : input_argument(with_base(kind, quasi_velocities), 0).name;
    row["length"] = std::to_string(like.of(kind).size());
    row["place"] = std::to_string(place++);
    rows << row;
  }
  return rows;
}

}  // namespace

std::vector<BenchVariant> stress_variants() {
  std::vector<BenchVariant> variants;
  for (const BenchVariant& variant : bench_variants()) {
    const bool is_whole =
        variant.call_mode != CallMode::staged && !variant.is_packed && !variant.has_lanes && !variant.is_native;
    if (is_whole && *variant.budget == '\0') variants.push_back(variant);
  }
  return variants;
}

StressProgram::StressProgram(const Mechanism& mechanism, const std::vector<Function>& functions, const State& like,
                             const std::vector<std::string>& wanted)
    : has_xsimd_(find_toolchain().has_xsimd), calls_(functions.size()) {
  data rows(data::type::list);
  bool has_kernels = false;
  for (std::size_t k = 0; k < functions.size(); ++k) {
    for (const BenchVariant& variant : stress_variants()) {
      if (!is_wanted(variant, wanted) || !is_made(variant, functions[k], has_xsimd_)) continue;
      has_kernels = has_kernels || variant.call_mode == CallMode::kernel;
      rows << variant_row(mechanism, functions[k], k, variant);
      calls_[k].push_back({variant});
    }
  }
  data page;
  page["positions"] = std::to_string(mechanism.position_count());
  page["arguments"] = argument_rows(like, mechanism.has_quasi_velocities());
  page["calls"] = data(rows);
  page["kernels?"] = has_kernels;
  page["headers"] = list_of(has_xsimd_ ? std::vector<std::string>{"flatdyn/batch.hpp", "flatdyn/trigonometry.hpp"}
                                       : std::vector<std::string>{});
  EmitOptions emit;
  emit.name_space = kBenchNamespace;
  write_file(folder_.path() / "robot.hpp", emit_header(mechanism, functions, emit));
  emit.name_space = kFusedNamespace;
  emit.fuses = true;
  write_file(folder_.path() / kFusedHeader, emit_header(mechanism, functions, emit));
  if (has_kernels) write_file(folder_.path() / kKernelsHeader, kernels_header(mechanism, functions));
  for (const templates::Header& header : templates::headers) {
    const std::filesystem::path path = folder_.path() / header.path;
    std::filesystem::create_directories(path.parent_path());
    write_file(path, header.text);
  }
  write_file(folder_.path() / "stress.cpp", rendered(templates::stress_cpp, page));
  library_ = std::make_unique<SharedLibrary>(folder_.path(), "stress", std::string(kFlags) + " -I.");
  for (std::size_t k = 0; k < functions.size(); ++k) {
    for (StressCall& call : calls_[k]) {
      call.entry = reinterpret_cast<decltype(call.entry)>(library_->symbol(symbol_of(k, call.variant)));
    }
  }
}

std::vector<StressCall> StressProgram::calls(std::size_t k, const std::string& scalar) const {
  std::vector<StressCall> calls;
  for (const StressCall& call : calls_[k]) {
    if (call.variant.scalar == scalar) calls.push_back(call);
  }
  return calls;
}

bool evaluate(const StressCall& call, const State& state, std::vector<double>& out) {
  const double* in[std::size(kStateKinds)];
  std::size_t place = 0;
  for (const InputKind kind : kStateKinds) in[place++] = state.of(kind).data();
  return call.entry(in, out.data());
}

}  // namespace flatdyn
