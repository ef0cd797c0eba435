// SPDX-License-Identifier: GPL-2.0-or-later
// The angles, by index, whose sines and cosines emitted functions need: the entries of q, then multiples of them by
// which coupled joints turn.
#pragma once

#include <string>
#include <vector>

#include "code/expression.hpp"
#include "code/lower/scope.hpp"
#include "code/statement.hpp"
#include "graph/graph.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The function that fills the array of angles, if there are others than those of q, before a language's prefix.
inline constexpr const char* kFunctionOfAngles = "angles";

// The arrays of sines and cosines.
using code::kCosines, code::kSines;

// The angles beyond those of q.
std::vector<MultipleOfPosition> multiples_of_positions(const Mechanism& mechanism);

// The index of the angle of node `id`, a sine or cosine. Throws std::logic_error if it is not one of these angles: the
// derivation must expand sums of angles.
int angle_index(const Graph& graph, NodeId id, const Scope& scope);

// The angle itself: q[0], 0.5 * q[0].
code::Expression angle_of_index(int index, const Scope& scope);

// The array that has the angles: "q" if there are no others.
std::string angle_array(const Scope& scope);

// The function that fills the array if there are others, and its arguments. If functions may have only so many lines,
// it comes last and calls those before it.
std::vector<code::Argument> arguments_of_angles(const Scope& scope);
std::vector<code::Part> parts_of_angles(const std::string& name, const Scope& scope);

// The name of the constant that is the number of angles.
std::string angle_count_name(const Scope& scope);

// The statements that make and fill the arrays of these sines and cosines. `function`: as the language names it.
code::Statements filling_sines(const std::set<int>& angles, const std::string& function, const Scope& scope);

}  // namespace flatdyn
