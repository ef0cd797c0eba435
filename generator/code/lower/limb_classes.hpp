// SPDX-License-Identifier: GPL-2.0-or-later
// Nodes of limbs that are computed alike: the same operations on the corresponding values, up to signs and the sizes of
// coefficients. Such nodes, one of each limb, are a class.
#pragma once

#include <vector>

#include "code/lower/limbs.hpp"
#include "graph/function.hpp"

namespace flatdyn {

struct LimbClass {
  int set = 0;                  // of limbs
  std::vector<NodeId> members;  // by limb
  std::vector<int> signs;       // by limb: the member is this times the value that is computed; 1 for the first limb
  // By limb: the operands in the order of the first member's expression, with coefficients if the members are sums;
  // node -1: the constant. Empty for inputs, sines and cosines.
  std::vector<std::vector<Term>> operands;

  bool is_given() const { return operands.empty(); }
};

struct LimbClasses {
  std::vector<LimbClass> classes;
  std::vector<int> class_of;  // by node; -1: none
  std::vector<int> limb_of;   // by node of a class

  bool has(NodeId id) const { return class_of[static_cast<std::size_t>(id)] >= 0; }
  int of(NodeId id) const { return class_of[static_cast<std::size_t>(id)]; }
  int limb(NodeId id) const { return limb_of[static_cast<std::size_t>(id)]; }
};

// The classes of a function, operands before those that use them. The order of a sum's terms in its expression is part
// of what has to be alike, so that each limb's bits are those of its own expression.
LimbClasses limb_classes(const Function& function, const std::vector<Limbs>& sets);

// The classes without those that are left out, and without others that would save nothing then.
LimbClasses without(const LimbClasses& classes, const std::vector<bool>& left_out);

// Chooses the signs of the classes so that as many coefficients as possible are the same in all limbs: a limb that is
// the mirror image of another has the opposite signs in many places.
void choose_signs(const Graph& graph, LimbClasses& classes);

}  // namespace flatdyn
