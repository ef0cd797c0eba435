// SPDX-License-Identifier: GPL-2.0-or-later
// Which operations compute the motion of a link, whatever way they go: exactly, a combination with constant
// coefficients of the entries of its ω, ω̇, p̈, and of products of rates; or, of derivatives of a torque, of what the
// acceleration of that joint alone does to the link, which is how a force on the link turns the joint.
//
// That it is one is decided in a prime field, at random points, with exact numbers in the place of the text's literals;
// the coefficients come from a least-squares fit in double. The motion being known, so is how large it can be: see
// motion_bounds.hpp. Norms follow the operations and lose at each; this does not.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "certify/motion_bounds.hpp"
#include "graph/rational.hpp"
#include "readback/straight_line.hpp"

namespace flatdyn {

// Of a literal's size: the exact number that it stands for, if that is one.
using ExactConstants = std::function<std::optional<Rational>(double)>;

class Motions {
 public:
  // Of a mechanism with prismatic or coupled joints, or loops, none are recognised.
  Motions(const Mechanism& mechanism, const InputLimits& limits, ExactConstants constants);
  ~Motions();
  Motions(const Motions&) = delete;
  Motions& operator=(const Motions&) = delete;

  // Those among the operations that have been added since the last time; if a joint is given, they are derivatives of
  // its torque.
  void recognise(const StraightLine& lines, std::optional<int> joint);

  // Exact results of a group are combinations of the same entries. -1: none, for all that is known.
  int group(int operation) const;
  // Of an exact result: its largest size. Infinite if nothing is known.
  double largest(int operation) const;
  // Of rows · (exact results of operations of one group): the largest length.
  double largest_length(const std::vector<int>& operations, const Eigen::MatrixXd& rows) const;

 private:
  class Recogniser;
  std::unique_ptr<Recogniser> recogniser_;  // none: nothing is recognised
};

}  // namespace flatdyn
