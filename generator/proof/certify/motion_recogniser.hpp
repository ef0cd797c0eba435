// SPDX-License-Identifier: GPL-2.0-or-later
// Recognition of operations that compute the motion of a link, in whatever formulation: their exact result is a
// combination with constant coefficients of the entries of its ω, ω̇, p̈ and of products of rates. Derivatives of a
// joint's torque are recognised, too: they are combinations of the link's motion by that joint's acceleration alone, by
// which a force on the link acts on the joint.
//
// Whether a result is such a combination is decided in a prime field, at random points, with exact numbers instead of
// the text's literals; the coefficients come from a least-squares fit in double. The bound of the motion then bounds
// the result: see motion_bounds.hpp. Norms follow the operations and lose something at each; this bound does not.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "code/readback/straight_line.hpp"
#include "graph/rational.hpp"
#include "proof/certify/motion_bounds.hpp"

namespace flatdyn {

// By absolute value of a literal: the exact number that it represents, if that is known.
using ExactConstants = std::function<std::optional<Rational>(double)>;

class MotionRecogniser {
 public:
  // For a mechanism with prismatic, spherical or coupled joints, or loops, none are recognised. The base may float.
  MotionRecogniser(const Mechanism& mechanism, const InputLimits& limits, ExactConstants constants);
  ~MotionRecogniser();
  MotionRecogniser(const MotionRecogniser&) = delete;
  MotionRecogniser& operator=(const MotionRecogniser&) = delete;

  // Looks for motions among the operations that have been added since the last call. `joint`: the joint of whose torque
  // they are derivatives, if they are.
  void recognise(const StraightLine& lines, std::optional<int> joint);

  // The group of an operation; exact results of one group are combinations of the same entries. -1: none is known.
  int group(int operation) const;
  // The largest size of an exact result; infinite if nothing is known.
  double largest(int operation) const;
  // The largest length of rows · (exact results of operations of one group).
  double largest_length(const std::vector<int>& operations, const Eigen::MatrixXd& rows) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;  // empty: nothing is recognised
};

}  // namespace flatdyn
