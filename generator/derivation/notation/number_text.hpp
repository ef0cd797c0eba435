// SPDX-License-Identifier: GPL-2.0-or-later
// The constants of one robot as text, in an order that is the same in every run.
#pragma once

#include <string>

#include "derivation/notation/sum_formatter.hpp"

namespace flatdyn {

class NumberText {
 public:
  explicit NumberText(const Mechanism& mechanism, int digits = 6) : names_(mechanism, no_motion_), digits_(digits) {}

  // The text of a number: "0.333", "pi/2", "m_l1 l_1^2 + I_l1"; rounded to the number of digits if it is not a short
  // decimal.
  std::string operator()(const Number& number) const;
  // The text of a vector: "(0, -g, 0)".
  std::string operator()(const Vec3& vector) const;

 private:
  ClosedForm no_motion_;  // constants contain neither sines nor coordinates of joints
  FactorNames names_;
  int digits_;
};

// The text of a number without free symbols. With 17 digits or more it is the shortest text of the nearest double.
std::string plain_number_text(const Number& number, int digits = 6);

// The text of a number without free symbols in full: "0.425", "2/3", "pi/2". A number that is too long for that is
// rounded to 17 digits, "0.47942553860420301...".
std::string exact_number_text(const Number& number);

}  // namespace flatdyn
