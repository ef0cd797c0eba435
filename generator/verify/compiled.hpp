// SPDX-License-Identifier: GPL-2.0-or-later
// The emitted text, compiled by the machine's compiler and called: what users run is what is checked.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/states.hpp"

namespace flatdyn {

// A plain C function `symbol` that calls the function of that namespace: its inputs as arrays, in order, behind them
// the parameters; all outputs one after the other in `out`; false where a condition of the function does not hold.
using PlainEntry = bool (*)(const double* const* in, double* out);
std::string plain_entry_text(const Mechanism& mechanism, const Function& function, const std::string& name_space,
                             const std::string& symbol);

// Entries of all outputs at a state, in order; not-a-number where the function returns false.
std::vector<double> called(PlainEntry entry, const Function& function, const State& state);

class CompiledFunctions {
 public:
  // Emits, writes to a temporary folder, compiles ($CXX or c++, contraction off) and loads. Throws Failure(io) if there
  // is no compiler, Failure(bug) if the text does not compile.
  CompiledFunctions(const Mechanism& mechanism, const std::vector<Function>& functions);
  ~CompiledFunctions();
  CompiledFunctions(const CompiledFunctions&) = delete;
  CompiledFunctions& operator=(const CompiledFunctions&) = delete;

  // Entries of all outputs of functions[index], in order; in double. Not-a-number where the function returns false.
  std::vector<double> call(std::size_t index, const State& state) const;
  // The same without a copy: the function's inputs in order, then the free symbols; false where it returns false.
  bool evaluate(std::size_t index, const double* const* in, double* out) const;

 private:
  class Library;
  std::unique_ptr<Library> library_;
  std::vector<Function> functions_;
};

}  // namespace flatdyn
