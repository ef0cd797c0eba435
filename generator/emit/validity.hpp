// SPDX-License-Identifier: GPL-2.0-or-later
// The statements by which a function says whether its result is valid: every pivot is positive, and every entry that it
// has written is a finite number. NaN compares false, and & does not branch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/expression.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// The variable that holds the verdict.
inline constexpr const char* kValid = "valid";

// A value that must be positive, beside its scale if rounding may cancel it.
struct CheckedPivot {
  NodeId value = 0;
  std::optional<NodeId> scale;
};

// The conditions of the function that do not hold by themselves.
std::vector<CheckedPivot> pivots_to_check(const Function& function);

class ValidityText {
 public:
  ValidityText(const ExpressionPrinter& printer, const Dialect& dialect) : printer_(printer), dialect_(dialect) {}

  // The value that must be positive: "D_1", or the excess of "b_1_1 + Scalar(0.015625) * D_1" over "b_1_1", which is 0
  // if D_1 is lost beside b_1_1.
  std::string checked(const CheckedPivot& pivot) const;

  // All checks, from the definition of `valid` to its return. `output_names`: the arrays that hold the outputs.
  std::string statements(const Function& function, const std::vector<std::string>& output_names) const;

  // The same for a function in parts, which have stored what must be positive in an array of this name and length.
  std::string statements_of_parts(const Function& function, const std::vector<std::string>& output_names,
                                  const std::string& pivots, std::size_t length) const;

 private:
  std::string defined_as(const std::string& first) const;
  std::string finite(const Function& function, const std::vector<std::string>& output_names) const;
  std::string finite_run(const std::string& output, std::size_t first, std::size_t end) const;

  const ExpressionPrinter& printer_;
  const Dialect& dialect_;
};

}  // namespace flatdyn
