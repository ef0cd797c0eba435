// SPDX-License-Identifier: GPL-2.0-or-later
// A Function as a list of instructions over doubles or long doubles, for evaluating it thousands of times inside
// flatdyn without a compiler. It takes about as long as an unoptimised build of the emitted code and uses the same
// formulas, but may differ from it in the last bits.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

inline constexpr std::size_t kInputKinds = static_cast<std::size_t>(InputKind::stored) + 1;

// The values of a function's inputs, by kind. A kind that it does not read may be empty.
template <class S>
class TapeInputsOf {
 public:
  std::span<const S>& operator[](InputKind kind) { return values_[static_cast<std::size_t>(kind)]; }
  std::span<const S> operator[](InputKind kind) const { return values_[static_cast<std::size_t>(kind)]; }

 private:
  std::array<std::span<const S>, kInputKinds> values_;
};

template <class S>
class TapeOf {
 public:
  explicit TapeOf(const Function& function);

  // The number of entries of all outputs.
  std::size_t results() const { return results_.size(); }
  std::size_t operations() const { return code_.size(); }

  // Evaluates the function and writes the entries of all outputs, one output after the other. Returns false if a value
  // that must be positive is not (B singular); the results are then invalid. Not thread-safe: the cells belong to the
  // tape.
  bool run(const TapeInputsOf<S>& given, std::span<S> results);

 private:
  enum class Code : std::uint8_t { add, subtract, multiply, add_multiple, divide, sin, cos, sign, sqrt, tanh };
  struct Instruction {
    Code code;
    std::uint32_t to, a, b, c;  // indices of cells; c for add_multiple only: to = a + b c
  };
  struct Load {
    Input from;
    std::uint32_t to;
  };
  template <class T>
  friend class TapeWriter;

  std::vector<Load> loads_;
  std::vector<Instruction> code_;
  std::vector<std::uint32_t> results_, positive_;
  std::vector<S> cells_;  // constants come first and are set already
};

extern template class TapeOf<double>;
extern template class TapeOf<long double>;

using TapeInputs = TapeInputsOf<double>;
using Tape = TapeOf<double>;

}  // namespace flatdyn
