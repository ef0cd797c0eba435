// SPDX-License-Identifier: GPL-2.0-or-later
// Exact proof that a Function equals its definition by the Lagrangian: both are evaluated at random points modulo
// 61-bit primes, without rounding or tolerance. A "no" is certain; a "yes" is wrong with the probability stated
// (Schwartz-Zippel), as long as the three primes do not all divide every coefficient of the difference.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "graph/function_name.hpp"
#include "robot/model/mechanism.hpp"
#include "truth/definition/definition.hpp"

namespace flatdyn {

struct ExactOptions {
  std::uint64_t seed = 1;
  int points = 2;  // per prime; there are three primes
  // Functions of large degree get up to as many, until failure_log2 is at most kEnoughLog2.
  int most_points = 0;
};

inline constexpr int kEnoughPoints = 8;

inline constexpr double kEnoughLog2 = -60;
// A bound above this one says too little to be called a proof: the degree is near the primes or beyond them.
inline constexpr double kWeakLog2 = -40;

struct ExactMismatch {
  std::string output;  // "B"; "positive" for conditions
  int entry = 0;       // index into Output::entries
  int row = 0, col = 0;
};

struct ExactResult {
  bool equal = false;
  int entries = 0;  // entries compared at each point
  int points = 0;   // random points in all
  int primes = 0;
  double degree_bound = 0;  // D: bound of the degree of any difference's numerator in the values drawn
  double failure_log2 = 0;  // log2 of the probability that a difference stays unseen: entries · (D/p)^points

  bool is_weak() const { return failure_log2 > kWeakLog2; }
  std::vector<ExactMismatch> mismatches;

  // The result in words: "49 entries equal at 6 points modulo 3 primes; degree at most 132; wrong with probability
  // below 2^-310".
  std::string summary() const;
};

// Compares every output entry with its definition for `mechanism`.
ExactResult prove_exactly(const Mechanism& mechanism, const Function& function, const Definition& definition,
                          const ExactOptions& options);

// Compares derivatives of a function, entry by entry, with that function over dual numbers. Those of wᵀ J, the
// contracted Hessian, are given `of` = wᵀ J.
ExactResult prove_derivatives(const Mechanism& mechanism, const Function& derivatives, const Function& of,
                              Derivative derivative, const ExactOptions& options);

// Compares two functions with the same outputs, entry by entry, conditions included; for example before and after a
// pass.
ExactResult prove_equal(const Function& a, const Function& b, const ExactOptions& options = {});

}  // namespace flatdyn
