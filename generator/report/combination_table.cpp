// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/combination_table.hpp"

#include <algorithm>

#include "base/diagnostics/table.hpp"
#include "base/diagnostics/wrap.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kNarrowestCombination = 50;

// The width that the cells of `rows` leave for combinations.
std::size_t width_left(const std::vector<std::vector<std::string>>& rows) {
  std::size_t used = 0;
  for (std::size_t column = 0; column < rows.front().size(); ++column) {
    std::size_t widest = 0;
    for (const auto& row : rows) widest = std::max(widest, text_width(row[column]));
    used += widest + 2;
  }
  return std::max(kReportWidth - std::min(used, kReportWidth), kNarrowestCombination);
}

}  // namespace

std::string combination_table(const std::vector<std::string>& heading, const std::vector<CombinationRow>& rows,
                              const Combinations& combinations) {
  std::vector<std::vector<std::string>> cells = {heading};
  for (const CombinationRow& row : rows) cells.push_back(row.cells);
  const std::size_t width = width_left(cells);
  cells.resize(1);
  cells.front().emplace_back("combination");
  for (const CombinationRow& row : rows) {
    add_row(cells, row.cells, row.meaning.empty() ? combinations.lines(row.k, width) : std::vector{row.meaning});
  }
  return aligned_table(cells);
}

std::string note_on_frames(const Mechanism& mechanism, ParameterFrames frames) {
  return wrapped("combinations are of parameters in " + frames_text(mechanism, frames) + "\n", kReportWidth);
}

std::string note_on_names(const Mechanism& mechanism, ParameterFrames frames) {
  if (!has_names_of_file(mechanism, frames)) return "";
  return "base parameters are named by the parameters in canonical frames that they keep (--frames canonical)\n";
}

const char* name_of(ParameterFrames frames) { return frames == ParameterFrames::file ? "file" : "canonical"; }

}  // namespace flatdyn
