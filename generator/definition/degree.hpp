// SPDX-License-Identifier: GPL-2.0-or-later
// How large a degree can be, for the Schwartz-Zippel bound: a polynomial of degree D that is not zero vanishes at a
// random point of GF(p) with probability at most D/p. Degrees are upper bounds; they are doubles, as an elimination
// can double them at each step.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "graph/function.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// Degree of a polynomial: a semiring that takes the place of a field.
class Degree {
 public:
  Degree() = default;                                         // of zero
  explicit Degree(int constant) : is_zero_(constant == 0) {}  // of a constant
  static Degree of(double degree);

  double value() const { return degree_; }

  Degree& operator+=(const Degree& b);
  Degree operator-() const { return *this; }
  friend Degree operator+(Degree a, const Degree& b) { return a += b; }
  friend Degree operator-(Degree a, const Degree& b) { return a += b; }
  friend Degree operator*(const Degree& a, const Degree& b) {
    if (a.is_zero_ || b.is_zero_) return {};
    return of(a.degree_ + b.degree_);
  }
  // A denominator counts as a factor: with all terms of a sum over their common denominator, no degree is more than
  // twice of what it is so.
  friend Degree operator/(const Degree& a, const Degree& b) { return a * b; }

 private:
  bool is_zero_ = true;
  double degree_ = 0;
};

// What is drawn counts 1: joint coordinates (cosine, sine, d), rates, accelerations, torques, parameters, signs.
// A reciprocal of parameters counts as drawn, too; the degree of what it is the reciprocal of is in `reciprocals`.
struct MechanismDegrees {
  double degree = 0;       // of the Lagrangian's values, the largest
  double reciprocals = 0;  // sum over all reciprocals
};
MechanismDegrees lagrangian_degrees(const Mechanism& mechanism);

// The same for the regressors, whatever their name, and for what they are multiplied by to be compared: π_b and K.
MechanismDegrees regressor_degrees(const Mechanism& mechanism);

// Of the values of all roots over their common denominator.
struct FunctionDegrees {
  double numerator = 0, denominator = 0;
};
FunctionDegrees function_degrees(const Function& function);

// How many times more points a difference may vanish at, because of square roots: 1 if the function takes none.
double root_factor(const Function& function);

// How many values are drawn for angles, at most: each cosine and sine is a quotient by 1 + t².
double drawn_angles(const Function& function, const Mechanism& mechanism);

}  // namespace flatdyn
