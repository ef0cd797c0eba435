// SPDX-License-Identifier: GPL-2.0-or-later
// The angles whose sines and cosines emitted functions ask for, by index: those of q, then multiples of them by which
// coupled joints turn.
#pragma once

#include <string>
#include <vector>

#include "emit/header_scope.hpp"
#include "graph/graph.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

std::vector<MultipleOfPosition> multiples_of_positions(const Mechanism& mechanism);

// Of the angle of node `id`, a sine or cosine. Throws std::logic_error if it is none of them: sums of angles are the
// derivation's own business.
int angle_index(const Graph& graph, NodeId id, const HeaderScope& scope);

// "q[0]", "Scalar(0.5) * q[0]".
std::string angle_text(int index, const HeaderScope& scope);

// What is written before their sines and cosines are asked for: the number of angles by its name, and the array that
// has them, "q" if there are no others.
std::string angle_count_name(const HeaderScope& scope);
std::string angle_array(const HeaderScope& scope);
// "detail::angles(q, angle);", and the function, which fills the array. Where there are other angles than those of q.
std::string angles_call(const HeaderScope& scope);
std::string angles_definition(const HeaderScope& scope);
// Lines that say which they are.
std::vector<std::string> angles_comment(const HeaderScope& scope);

}  // namespace flatdyn
