// SPDX-License-Identifier: GPL-2.0-or-later
// The first part of as_read.hpp: number by number.
#pragma once

#include <string>

#include "truth/definition/written_numbers.hpp"

namespace flatdyn {

// Keeps the first difference that is too large, and the largest one.
class Differences {
 public:
  // `scale`: what the difference is relative to; if it is 0, there may be none.
  void compare(const std::string& subject, const Digits100& found, const Digits100& expected, const Digits100& scale);
  void require(bool holds, const std::string& subject) {
    if (!holds && first_.empty()) first_ = subject;
  }

  const std::string& first() const { return first_; }
  int numbers() const { return numbers_; }
  double largest() const { return largest_; }

 private:
  std::string first_;
  int numbers_ = 0;
  double largest_ = 0;
};

// Values of inputs, free symbols among them: numbers between a half and one and a half.
RealArithmetic<Digits100> drawn_reals(std::uint64_t seed);

// The numbers of the mechanism that are not those of the robot. `mechanism`: without loops. The seed decides
// the values of free symbols.
Differences compare_numbers(const Robot& robot, const Mechanism& mechanism, std::uint64_t seed);

}  // namespace flatdyn
