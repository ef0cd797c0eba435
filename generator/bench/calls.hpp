// SPDX-License-Identifier: GPL-2.0-or-later
// C++ text of the calls of one generated function in the benchmark's program.
#pragma once

#include <string>

#include "bench/variants.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

inline constexpr const char* kBenchNamespace = "robot";

// Entries of all outputs.
std::size_t entry_count(const Function& function);

// "robot::gravity(x.q.of(k), out)": state k of the inputs x, results to `out`.
std::string single_call(const Mechanism& mechanism, const Function& function, const BenchVariant& variant);

// The function over SIMD lanes: a lambda's capture, parameters and body, and the arrays that it is applied to.
struct BatchCall {
  std::string capture;     // "", or "&x" for a robot with free symbols
  std::string parameters;  // "auto q, auto result"
  std::string call;
  std::string columns;
};

BatchCall batch_call(const Mechanism& mechanism, const Function& function, const BenchVariant& variant);

// A C function of its own: "extern "C" RETURNS SYMBOL(PARAMETERS) { CALL; }".
struct PlainFunction {
  std::string returns, symbol, parameters, call;
};

std::string plain_symbol(const Function& function, const std::string& variant);
// "robot::gravity<double, robot::LibrarySinCos>": what it calls, as nm -C names it.
std::string template_symbol(const Function& function, const BenchVariant& variant);
PlainFunction plain_function(const Mechanism& mechanism, const Function& function, const BenchVariant& variant);

}  // namespace flatdyn
