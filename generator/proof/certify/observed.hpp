// SPDX-License-Identifier: GPL-2.0-or-later
// Observed errors: a function as its text executes it, compared with its graph in a wider type, at many states. Half of
// the states are random, and every second of these has all speeds and accelerations at their limits. The other half are
// searched: a quarter around the state at which the errors of each output should be largest on average, by the
// derivatives of the output by all results before it; a quarter are children of the states with the largest errors so
// far.
#pragma once

#include <vector>

#include "code/readback/straight_line.hpp"
#include "graph/function.hpp"
#include "proof/certify/rounding.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

struct ObservedOptions {
  int states = 1'000'000;
  unsigned seed = 1;
  double sine_error = 0;  // added to every sine and cosine, or subtracted, at random
};

// By operation in `of`: the largest absolute difference between its result in the format and the entry of the graph
// that it computes, within the limits of the joints. `exact`: the node of the graph for each. Computed in long double
// for the format double, in double for float. Sines and cosines are those of <cmath>, up to `sine_error`. The result is
// the same for the same seed on any number of cores.
std::vector<double> observed_errors(const Mechanism& mechanism, const StraightLine& lines, const std::vector<int>& of,
                                    const Function& function, const std::vector<NodeId>& exact,
                                    const RoundingFormat& format, const ObservedOptions& options);

}  // namespace flatdyn
