// SPDX-License-Identifier: GPL-2.0-or-later
// The angles, by index, whose sines and cosines emitted functions need: the entries of q, then multiples of them by
// which coupled joints turn.
#pragma once

#include <string>
#include <vector>

#include "emit/header_scope.hpp"
#include "graph/graph.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// The angles beyond those of q.
std::vector<MultipleOfPosition> multiples_of_positions(const Mechanism& mechanism);

// The index of the angle of node `id`, a sine or cosine. Throws std::logic_error if it is not one of these angles: the
// derivation must expand sums of angles.
int angle_index(const Graph& graph, NodeId id, const HeaderScope& scope);

// The angle in emitted code: "q[0]", "Scalar(0.5) * q[0]".
std::string angle_text(int index, const HeaderScope& scope);

// The name of the number of angles, and the name of the array that has them: "q" if there are no others.
std::string angle_count_name(const HeaderScope& scope);
std::string angle_array(const HeaderScope& scope);
// The call "detail::angles(q, angle);", and the definition of the function, which fills the array. Needed only if there
// are angles beside the entries of q.
std::string angles_call(const HeaderScope& scope);
std::string angles_definition(const HeaderScope& scope);
// Lines of comment that list these angles.
std::vector<std::string> angles_comment(const HeaderScope& scope);

}  // namespace flatdyn
