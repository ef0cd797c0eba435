// SPDX-License-Identifier: GPL-2.0-or-later
// Tables whose last column has combinations of parameters, which may be long.
#pragma once

#include <string>
#include <vector>

#include "derivation/notation/combination_text.hpp"

namespace flatdyn {

// The width of tables and text: the lines are comments in robot files, too.
inline constexpr std::size_t kReportWidth = 118;

// A row: base parameter k with its other cells, which stand before the combination. Further parameters have a meaning
// instead of a combination.
struct CombinationRow {
  int k = 0;
  std::vector<std::string> cells;
  std::string meaning{};
};

// The aligned table, in which long combinations have several lines.
std::string combination_table(const std::vector<std::string>& heading, const std::vector<CombinationRow>& rows,
                              const Combinations& combinations);

// Lines below such a table: on the frames of the combinations, and on the names of base parameters where combinations
// do not explain them.
std::string note_on_frames(const Mechanism& mechanism, ParameterFrames frames);
std::string note_on_names(const Mechanism& mechanism, ParameterFrames frames);

// The frames in JSON: "file", "canonical".
const char* name_of(ParameterFrames frames);

}  // namespace flatdyn
