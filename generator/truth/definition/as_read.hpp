// SPDX-License-Identifier: GPL-2.0-or-later
// Proof that the mechanism, which all functions are proven for, is the robot as read: fixed links and rotors are bodies
// of their own there, in frames and along axes as they are written. Merging, frames, rotors and residues snapped to
// zero are inside of it; reading is not.
//
// It has two parts, and neither shares code with what makes the mechanism.
//
// Number by number, in 100 digits. The transform from a written link to the next is affine in the cosine and sine of
// the joint between them, or in its displacement. It is computed as written, by Rodrigues' formula, and from the places
// of both links in the mechanism; three values decide that two such functions are the same. The quadratic form of a
// body's kinetic energy is summed up over its written links and rotors, each about its own centre of mass, and compared
// entry by entry. No probability is involved, except that free symbols have random values. Where the mechanism replaces
// an irrational number or a direction by a rational one of 44 digits, the two differ by that much: kAsReadTolerance
// bounds it.
//
// As a whole, in exact arithmetic modulo primes. Kinetic and potential energy are summed up over the written links and
// rotors, from derivatives of their poses, and compared with those of the Lagrangian. They differ where a residue
// below 1e-40 of a body's parameters was snapped to zero; then they are compared at one state in 100 digits, and the
// proof is the first part.
//
// The poses of all links and the two energies determine every function, so what is proven of the mechanism's functions
// holds for the robot as read.
#pragma once

#include <cstdint>
#include <string>

#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// The largest difference of a number, relative to the robot's lengths, a body's mass and the like.
inline constexpr double kAsReadTolerance = 1e-38;

struct AsReadResult {
  bool holds = false;
  std::string difference;  // the first one: "body of joint \"q2\": first moment"; empty if it holds
  int links = 0, rotors = 0;
  int numbers = 0;     // compared one by one
  double largest = 0;  // the largest relative difference of those
  // The comparison modulo primes.
  bool is_exact = false;
  int points = 0, primes = 0;
  double degree_bound = 0, failure_log2 = 0;  // as of ExactResult
  bool has_loops = false;                     // what closes them is not compared

  // The digits to which all numbers are equal, at most kMostDigits.
  static constexpr int kMostDigits = 90;
  int digits() const;
  // The result in words.
  std::string summary() const;
};

// `robot`: the one that `mechanism` was made from. The seed decides points of the fields and values of free symbols.
AsReadResult prove_as_read(const Robot& robot, const Mechanism& mechanism, std::uint64_t seed = 1);

}  // namespace flatdyn
