// SPDX-License-Identifier: GPL-2.0-or-later
// Pinocchio's algorithms as a library with a plain interface, compiled once for all robots.
#include "library.hpp"

#include "algorithms.hpp"

namespace pinocchio_peer {

struct Called {
  Algorithms<double> algorithms;
  const Function<double>& function;
};

Called* called(const char* mechanism, const char* function) {
  return new Called{Algorithms<double>(read_mechanism(mechanism)), function_named<double>(function)};
}

void call(Called& of, const double* x, double* y) { (of.algorithms.*of.function.run)(x, y); }

}  // namespace pinocchio_peer
