// SPDX-License-Identifier: GPL-2.0-or-later
// A function as its text executes it: one operation after the other, each rounded. A Graph says what is computed; this
// also says how: left-to-right sums, one product at a time, constants as the text has them.
#pragma once

#include <functional>
#include <map>
#include <tuple>
#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

enum class Step : std::uint8_t { constant, input, sine, cosine, negate, add, subtract, multiply, divide, sign, sqrt };

// The k-th operation; its operands are operations before it.
struct Operation {
  Step step = Step::constant;
  int a = -1, b = -1;  // operands; negate, sign and sqrt have no b; sine and cosine an angle if it is no entry of q
  double value = 0;    // of a constant
  Input input{};       // of input; of sine and cosine the joint's position, by the index in arrays of sines

  bool is_sine_or_cosine() const { return step == Step::sine || step == Step::cosine; }
  bool is_sum_or_product() const { return step == Step::add || step == Step::subtract || step == Step::multiply; }
};

class StraightLine {
 public:
  // Each returns the index of the operation. One that is there already is not made twice: it has the same value.
  int constant(double value);
  int input(Input input);
  int sine(int joint, int angle = -1);
  int cosine(int joint, int angle = -1);
  int negate(int a);
  int add(int a, int b);
  int subtract(int a, int b);
  int multiply(int a, int b);
  int divide(int a, int b);
  int sign(int a);
  int sqrt(int a);

  const Operation& operator[](int k) const { return operations_[static_cast<std::size_t>(k)]; }
  int size() const { return static_cast<int>(operations_.size()); }

  // As it is, without looking for one that is the same.
  int append(const Operation& operation);

  std::vector<std::vector<int>> outputs;  // by output and entry; -1: the text does not write it
  std::vector<int> validity_conditions;   // what must be > 0

 private:
  using Key = std::tuple<Step, int, int, double, InputKind, int>;

  int make(const Operation& operation);

  std::vector<Operation> operations_;
  std::map<Key, int> index_;
};

// The same, with constants of such values made anew for each operation that reads them.
StraightLine with_constants_apart(const StraightLine& lines, const std::function<bool(double)>& is_apart);

// What it computes: the outputs and conditions of `like`, exactly. Throws Failure(bug) where that is none: a division
// by zero, or powers and constants that grow beyond measure.
Function graph_of(const StraightLine& lines, const Function& like);

}  // namespace flatdyn
