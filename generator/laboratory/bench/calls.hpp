// SPDX-License-Identifier: GPL-2.0-or-later
// The C++ text that calls a generated function in the benchmark's program.
#pragma once

#include <string>

#include "laboratory/bench/subject.hpp"

namespace flatdyn {

// The call "robot::gravity(x.q.of(k), out)" at state k of the inputs x; its results go to `out` from entry `first` on.
std::string single_call(const Mechanism& mechanism, const CalledFunction& called, const BenchVariant& variant,
                        std::size_t first = 0);

// The call "robot::at(x.q.of(k))", which makes the first stage at state k.
std::string at_call(const Mechanism& mechanism, const BenchVariant& variant);

// The argument of with(): "qd", or "v" with a floating base.
std::string velocity_argument(const Mechanism& mechanism);

// A call over SIMD lanes: a lambda's capture, parameters and body, and the arrays that it is applied to.
struct BatchCall {
  std::string capture;     // "", or "&x" for a robot with free symbols
  std::string parameters;  // "auto q, auto result"
  std::string call;
  std::string columns;  // entry by entry: those of the inputs x, and of the results in `out`, one after the other
  std::string tiles;    // tiles of the inputs x from state `first` on, then `results...`
  std::string entries;  // the stored entries of each result: "flatdyn::AllEntries<7>"
};

// The call of the function over SIMD lanes.
BatchCall batch_call(const Mechanism& mechanism, const CalledFunction& called, const BenchVariant& variant);

// The call of the function in the CUDA form at `states` states of the inputs x from state `first` on. Its results go to
// `out`, the rows of all states of each output, one output after the other; what it returns of each state to `valid`.
std::string kernel_call(const Mechanism& mechanism, const CalledFunction& called, const BenchVariant& variant);

// Whether the function has matrices with entries that packed outputs leave out.
bool can_be_packed(const Function& function);

// A C function around the call: "extern "C" RETURNS SYMBOL(PARAMETERS) { CALL; }".
struct PlainFunction {
  std::string returns, symbol, parameters, call;
};

std::string plain_symbol(const Function& function, const std::string& variant);
// The symbol of the called function as nm -C prints it: "robot::gravity<double, robot::PolynomialSinCos>",
// "robot::Motion<double>::bias". In CUDA the types of arrays follow, and it is the beginning of the name:
// "robot::kernels::gravity<double, ".
std::string template_symbol(const CalledFunction& called, const BenchVariant& variant);
PlainFunction plain_function(const Mechanism& mechanism, const CalledFunction& called, const BenchVariant& variant);

}  // namespace flatdyn
