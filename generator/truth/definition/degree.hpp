// SPDX-License-Identifier: GPL-2.0-or-later
// Bounds of the degrees of functions for the Schwartz-Zippel bound: a polynomial of degree D that is not zero vanishes
// at a random point of GF(p) with probability at most D/p. Degrees are upper bounds; they are doubles, as an
// elimination can double them at each step.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The degree of a polynomial, as a semiring that takes the place of a field.
class Degree {
 public:
  Degree() = default;                                         // the degree of zero
  explicit Degree(int constant) : is_zero_(constant == 0) {}  // the degree of a constant
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
  // twice this one.
  friend Degree operator/(const Degree& a, const Degree& b) { return a * b; }

 private:
  bool is_zero_ = true;
  double degree_ = 0;
};

// The degrees of the definition. A drawn value counts 1: joint coordinates (cosine, sine, d), rates, accelerations,
// torques, parameters, signs. A reciprocal of parameters counts as drawn, too; the degree of its denominator is in
// `reciprocals`.
struct MechanismDegrees {
  double degree = 0;       // the largest of the Lagrangian's values
  double reciprocals = 0;  // sum over the denominators of all reciprocals
};
// The degrees of the Lagrangian's values.
MechanismDegrees lagrangian_degrees(const Mechanism& mechanism);

// The degree in the values drawn of the difference between the energies of the robot as read and of the Lagrangian
// (truth/definition/as_read.hpp). `mechanism`: without loops.
double energy_degree(const Robot& robot, const Mechanism& mechanism);

// The degree in the values drawn, t for each angle: a term of degree d in c and s has the common denominator Π (1 +
// t²)^d.
double in_drawn_values(double degree, double angles, double reciprocals);

// The degrees of the regressors, whatever their name, and of the factors by which they are multiplied for comparison:
// π_b and K.
MechanismDegrees regressor_degrees(const Mechanism& mechanism);

// The degrees of all roots' values over their common denominator.
struct FunctionDegrees {
  double numerator = 0, denominator = 0;
};
FunctionDegrees function_degrees(const Function& function);

// The factor by which square roots raise the number of points where a difference may vanish: 1 if the function has
// none.
double root_factor(const Function& function);

// The largest number of values drawn for angles: each cosine and sine is a quotient by 1 + t².
double drawn_angles(const Function& function, const Mechanism& mechanism);

}  // namespace flatdyn
