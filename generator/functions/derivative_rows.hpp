// SPDX-License-Identifier: GPL-2.0-or-later
// The rows of derivatives, one of each kind for every function that has arguments.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "functions/function_row.hpp"

namespace flatdyn {

// Rows with names such as "vjp:FUNCTION", made from the rows of functions, which must outlive them.
class DerivativeRows {
 public:
  explicit DerivativeRows(const std::vector<FunctionRow>& rows);

  // The row of a derivative of this function; null if there is none.
  const FunctionRow* find(Derivative derivative, const std::string& stem) const;

 private:
  const char* kept(std::string text);
  std::vector<OutputRow> outputs_of(const FunctionRow& of, Derivative derivative);
  FunctionRow row_of(const FunctionRow& of, Derivative derivative);

  std::deque<std::string> texts_;  // which rows point into
  std::vector<FunctionRow> rows_;
};

}  // namespace flatdyn
