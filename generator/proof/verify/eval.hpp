// SPDX-License-Identifier: GPL-2.0-or-later
// A function's values along a table of states, for users to compare with their own logs.
#pragma once

#include "graph/function.hpp"
#include "robot/input/csv/table.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

struct EvalOptions {
  bool reference = false;  // by the recursive Newton–Euler reference instead of the emitted code's graph
  // Significant digits, up to 50; 17: in double, as the shortest text that reads back as the same value.
  int digits = 17;
};

// Columns are those of docs/csv.md, and free symbols by their names. Columns that the function does not read are
// copied, and named in a note. The result is the table with the output's columns appended, matrices row by row and in
// full: tau_1, B_1_2, c_1_2_3. Missing or unreadable input is reported to `diagnostics`; the result is then empty.
CsvTable evaluate_table(const Robot& robot, const Mechanism& mechanism, const Function& function,
                        const CsvTable& states, const std::string& file, const EvalOptions& options,
                        Diagnostics& diagnostics);

std::string to_text(const CsvTable& table);

}  // namespace flatdyn
