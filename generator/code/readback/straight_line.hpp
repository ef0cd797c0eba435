// SPDX-License-Identifier: GPL-2.0-or-later
// A function as its text executes it: a sequence of operations, each rounded. Unlike a Graph, it has the order of
// evaluation: left-to-right sums, one product at a time, constants as printed.
#pragma once

#include <functional>
#include <map>
#include <tuple>
#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

enum class Step : std::uint8_t { constant, input, sine, cosine, negate, add, subtract, multiply, divide, sign, sqrt };

// One operation; its operands are earlier operations.
struct Operation {
  Step step = Step::constant;
  // Operands; negate, sign and sqrt have no b; sine and cosine have an angle if it is not an entry of q.
  int a = -1, b = -1;
  double value = 0;  // the value of a constant
  Input input{};     // an input; for sine and cosine the joint's position, by the index in arrays of sines

  // A product that is not rounded: a factor pair of the fused multiply-add that is the addition after it.
  bool is_exact = false;

  bool is_sine_or_cosine() const { return step == Step::sine || step == Step::cosine; }
  bool is_sum_or_product() const { return step == Step::add || step == Step::subtract || step == Step::multiply; }
};

class StraightLine {
 public:
  // Each of these returns the index of the operation. An operation that exists already is not added again: it has the
  // same value.
  int constant(double value);
  int input(Input input);
  int sine(int joint, int angle = -1);
  int cosine(int joint, int angle = -1);
  int negate(int a);
  int add(int a, int b);
  int subtract(int a, int b);
  int multiply(int a, int b);
  int fused(int a, int b, int c);  // a b + c, rounded once: an exact product, and an addition
  int divide(int a, int b);
  int sign(int a);
  int sqrt(int a);

  const Operation& operator[](int k) const { return operations_[static_cast<std::size_t>(k)]; }
  int size() const { return static_cast<int>(operations_.size()); }

  // Appends an operation without looking for an equal one.
  int append(const Operation& operation);

  std::vector<std::vector<int>> outputs;  // by output and entry; -1: the text does not write it
  std::vector<int> validity_conditions;   // values that must be positive

 private:
  using Key = std::tuple<Step, int, int, double, InputKind, int, bool>;

  int make(const Operation& operation);

  std::vector<Operation> operations_;
  std::map<Key, int> index_;
};

// The same operations, but each one that reads a constant selected by `is_unshared` has a copy of its own.
StraightLine with_constants_unshared(const StraightLine& lines, const std::function<bool(double)>& is_unshared);

// The graph of what the text computes: the outputs, conditions and scales of `like`, exactly. Throws Failure(bug) if
// there is no such graph: for a division by zero, or powers and constants that grow too large.
Function graph_of(const StraightLine& lines, const Function& like);

}  // namespace flatdyn
