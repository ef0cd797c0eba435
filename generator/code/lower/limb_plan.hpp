// SPDX-License-Identifier: GPL-2.0-or-later
// The statements of a function whose limbs are computed together, a limb in each lane of a vector.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "code/lower/limb_classes.hpp"
#include "code/lower/schedule.hpp"

namespace flatdyn {

// A vector that is put together from a number of each limb: multiples of nodes; node -1: the coefficient itself.
struct Gathered {
  int set = 0;
  std::vector<Term> numbers;  // by limb

  bool operator==(const Gathered&) const = default;
};

struct LimbStep {
  enum class Kind { scalar, stored, limbs, gathered, taken } kind;
  // scalar: the node that becomes a variable; taken: the member of a class that is taken out of its vector;
  // stored: the number of a statement; limbs: of a class; gathered: of LimbPlan::gathered
  int index = 0;
};

// The gathered vectors that stand for operands and coefficients of the first limb's expressions in those of all: by the
// node whose expression it is and the operand (-1: the constant), the number of the vector.
using GatheredOperands = std::map<std::pair<NodeId, NodeId>, int>;

struct LimbPlan {
  LimbClasses classes;
  std::vector<bool> is_vector;  // by class: whether it becomes a variable
  std::vector<int> given;       // inputs, sines and cosines of limbs that are read into vectors: classes
  std::vector<bool> is_read;    // by node: inputs, sines and cosines that are read into scalars
  std::vector<Gathered> gathered;
  GatheredOperands operands, coefficients;
  std::vector<LimbStep> steps;
  long saved = 0;  // operations that are not done, less the numbers that are moved between lanes
};

// The plan for a schedule whose variables it completes; nullopt where nothing is saved.
std::optional<LimbPlan> limb_plan(const Function& function, const std::vector<Limbs>& sets, Schedule& schedule);

// The node without the negations that are written where it is used, and their sign.
Term without_negations(const Graph& graph, NodeId id);

}  // namespace flatdyn
