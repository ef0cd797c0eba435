// SPDX-License-Identifier: GPL-2.0-or-later
// The entries of an output that a scene asks for: "tau", "tau[0..2]", "B[shoulder][elbow]".
#pragma once

#include <string>
#include <vector>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Indices into Output::entries of one output, and that output's index.
struct EntrySelection {
  std::size_t output = 0;
  std::vector<std::size_t> entries;
};

// Parses `text`: NAME, NAME[i], NAME[i][j] or NAME[i][j][k]. An index is a number from 0, a joint's name where joints
// are counted, or a range FIRST..LAST of these; omitted indices mean all. Throws Failure(input) with a hint.
EntrySelection selected_entries(const Function& function, const Mechanism& mechanism, const std::string& text);

// The entries of an output that are computed, in the same form: "tau[0..2], tau[5]"; "B[0..2][0..3], B[3][1]".
std::string written_entries(const Output& output);

}  // namespace flatdyn
