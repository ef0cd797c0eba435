// SPDX-License-Identifier: GPL-2.0-or-later
// The dry friction of a joint, which depends on its rate alone (DryFriction of robot/model/body.hpp), and its slope.
#pragma once

#include <string>
#include <vector>

#include "derivation/kernel/derivation.hpp"
#include "robot/model/body.hpp"

namespace flatdyn {

// coefficient · value, where the value is a function of the rate.
struct DryFrictionTerm {
  Number coefficient;
  const char* name;  // of the coefficient
  Number value;
};

// The terms of the friction. `label`: what ends the names of the joint's quantities.
std::vector<DryFrictionTerm> dry_friction_terms(Derivation& derivation, const Body& body, const Number& rate,
                                                const std::string& label);

// Their sum, with named coefficients.
Number dry_friction(Derivation& derivation, const Body& body, const Number& rate, const std::string& label);

// Its derivative by the rate; that of a sign is 0.
Number dry_friction_slope(Derivation& derivation, const Body& body, const Number& rate, const std::string& label);

// s - s_0: what multiplies F_s alone.
Number sliding_sign(Derivation& derivation, const Body& body, const Number& rate, const std::string& label);

}  // namespace flatdyn
