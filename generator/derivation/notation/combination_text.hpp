// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters as people write them: "I1zz + k_r1^2 Im1 + a_1^2 m2", "Izz(forearm) + 0.180625 m(wrist)".
#pragma once

#include <string>
#include <vector>

#include "derivation/parameters/file_parameters.hpp"

namespace flatdyn {

// The significant digits of numbers that people read.
inline constexpr int kShortDigits = 6;

// A coefficient in a fixed order that does not depend on GiNaC's: "a_1^2", "(2 a_1 + a_2)"; numbers exactly: "0.425",
// "1/3".
std::string coefficient_text(const Number& coefficient);

// The multiple of a parameter that a combination has.
struct CombinationTerm {
  std::string name;
  Number coefficient;
};

// The base parameters as combinations of the parameters of `set`. In canonical frames the kept parameter comes first,
// the others in the order of π. In those of the file, parameters come in the order of file_parameters(); where these
// are the canonical ones, both are the same.
class Combinations {
 public:
  Combinations(const Mechanism& mechanism, const BaseParameters& base, ParameterFrames frames,
               ParameterSet set = ParameterSet::given);

  const std::vector<CombinationTerm>& terms(int k) const { return terms_[static_cast<std::size_t>(k)]; }
  // Base parameter k as a sum, with numbers to `digits` significant digits.
  std::string text(int k, int digits = kShortDigits) const;
  // The same text in lines of at most `width` characters, as far as single summands are not longer; each line but the
  // first begins with a sign.
  std::vector<std::string> lines(int k, std::size_t width) const;

 private:
  std::vector<std::vector<CombinationTerm>> terms_;
};

// The frames of the parameters and the meaning of their names, as the end of a sentence: "the link frames of the robot
// file: m(L) is …".
std::string frames_text(const Mechanism& mechanism, ParameterFrames frames);

}  // namespace flatdyn
