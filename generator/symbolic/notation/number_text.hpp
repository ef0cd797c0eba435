// SPDX-License-Identifier: GPL-2.0-or-later
// The constants of one robot as people write them, in an order that is the same in every run.
#pragma once

#include <string>

#include "symbolic/notation/pretty.hpp"

namespace flatdyn {

class NumberText {
 public:
  explicit NumberText(const Mechanism& mechanism, int digits = 6) : names_(mechanism, no_motion_), digits_(digits) {}

  // "0.333", "pi/2", "m_l1 l_1^2 + I_l1": to so many digits if it is no short decimal.
  std::string operator()(const Number& number) const;
  // "(0, -g, 0)"
  std::string operator()(const Vec3& vector) const;

 private:
  ClosedForm no_motion_;  // constants have neither sines nor coordinates of joints
  Names names_;
  int digits_;
};

// The text of a number without free symbols. 17 digits or more: the shortest text of the nearest double.
std::string plain_number_text(const Number& number, int digits = 6);

// Of a rational factor: "2/3" where no short decimal says the same.
std::string factor_text(const Number& factor);

}  // namespace flatdyn
