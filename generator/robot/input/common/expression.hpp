// SPDX-License-Identifier: GPL-2.0-or-later
// Exact expressions of robot files: "pi/2", "sqrt(2)/2", "l_1 - a_1", "2*m_p + 1e-3".
//   sum     := product { (+|-) product }
//   product := factor { (*|/) factor }
//   factor  := (+|-) factor | power
//   power   := primary [ ^ factor ]            the exponent is an integer
//   primary := decimal | pi | symbol | sqrt ( sum ) | ( sum )
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "robot/model/number.hpp"

namespace flatdyn {

// column: of the offending character in the text, from 1.
class ExpressionError : public std::invalid_argument {
 public:
  ExpressionError(const std::string& message, std::size_t column) : std::invalid_argument(message), column_(column) {}
  std::size_t column() const { return column_; }

 private:
  std::size_t column_;
};

// Gives the value of a name that is no constant or function; `column` is where it stands, from 1.
using SymbolLookup = std::function<Number(std::string_view name, std::size_t column)>;

// Throws ExpressionError. Nesting, length and size of the numbers are bounded, so that no text exhausts memory.
Number parse_expression(std::string_view text, const SymbolLookup& symbol);

}  // namespace flatdyn
