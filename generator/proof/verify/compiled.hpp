// SPDX-License-Identifier: GPL-2.0-or-later
// The emitted text, compiled by the machine's compiler and called, so that the code checked is the code that users run.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "code/emit/emit_options.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

// A plain C function that calls a generated one. `in`: its inputs as arrays, in order, followed by the parameters.
// `out`: all outputs, one after the other. Returns false if a condition of the function does not hold.
using PlainEntry = bool (*)(const double* const* in, double* out);
std::string plain_entry_text(const Mechanism& mechanism, const Function& function, const std::string& name_space,
                             const std::string& symbol);

// The entries of all outputs at a state, in order; NaN if the function returns false.
std::vector<double> called(PlainEntry entry, const Function& function, const State& state);

class CompiledFunctions {
 public:
  // Emits the functions, writes them to a temporary folder, compiles them ($CXX or c++, contraction off) and loads the
  // result. Throws Failure(io) if there is no compiler, Failure(bug) if the text does not compile.
  CompiledFunctions(const Mechanism& mechanism, const std::vector<Function>& functions,
                    Sines sines = Sines::polynomials);
  ~CompiledFunctions();
  CompiledFunctions(const CompiledFunctions&) = delete;
  CompiledFunctions& operator=(const CompiledFunctions&) = delete;

  // The entries of all outputs of functions[index], in order, in double; NaN if the function returns false.
  std::vector<double> call(std::size_t index, const State& state) const;
  // The same without a copy. `in`: the function's inputs in order, then the free symbols. Returns false if the function
  // does.
  bool evaluate(std::size_t index, const double* const* in, double* out) const;

 private:
  class Library;
  std::unique_ptr<Library> library_;
  std::vector<Function> functions_;
};

}  // namespace flatdyn
