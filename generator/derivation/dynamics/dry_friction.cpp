// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/dry_friction.hpp"

namespace flatdyn {
namespace {

// s: the sign of the rate, or its smooth form.
Number direction(Derivation& d, const Body& body, const Number& rate, const std::string& label) {
  const DryFriction& dry = body.dry;
  if (!dry.is_smooth()) return d.sign(rate, "sgn_" + label);
  return d.tanh((rate + dry.offset) / dry.speed, "sgn_" + label);
}

// 1/(1 + (ω/v_s)²), the share of what friction has more at rest.
Number stribeck_weight(Derivation& d, const Body& body, const Number& rate, const std::string& label) {
  const Number ratio = d.named(rate / body.dry.stribeck_speed, "r_" + label);
  return d.quotient(1, 1 + ratio * ratio, "w_" + label);
}

std::vector<DryFrictionTerm> without_zeros(std::vector<DryFrictionTerm> terms) {
  std::erase_if(terms, [](const DryFrictionTerm& term) { return vanishes(term.coefficient); });
  return terms;
}

Number sum_of(Derivation& d, const std::vector<DryFrictionTerm>& terms, const std::string& label) {
  Number sum = 0;
  for (const DryFrictionTerm& term : terms) sum += d.named(term.coefficient, term.name + label) * term.value;
  return sum;
}

// The derivative of s by the rate.
Number direction_slope(Derivation& d, const Body& body, const Number& s, const std::string& label) {
  if (!body.dry.is_smooth()) return 0;
  return d.named((1 - s * s) / body.dry.speed, "dsgn_" + label);
}

}  // namespace

std::vector<DryFrictionTerm> dry_friction_terms(Derivation& d, const Body& body, const Number& rate,
                                                const std::string& label) {
  const DryFriction& dry = body.dry;
  if (!body.has_dry_friction()) return {};
  const Number s = direction(d, body, rate, label);
  std::vector<DryFrictionTerm> terms = {{body.coulomb, "F_s", s - dry.at_rest}};
  if (dry.has_excess()) {
    terms.push_back({dry.excess, "F_e", d.named(stribeck_weight(d, body, rate, label) * s, "ws_" + label)});
  }
  terms.push_back({dry.asymmetry, "F_d", s * s});
  return without_zeros(std::move(terms));
}

Number dry_friction(Derivation& d, const Body& body, const Number& rate, const std::string& label) {
  return sum_of(d, dry_friction_terms(d, body, rate, label), label);
}

Number dry_friction_slope(Derivation& d, const Body& body, const Number& rate, const std::string& label) {
  const DryFriction& dry = body.dry;
  if (!body.has_dry_friction() || (!dry.is_smooth() && !dry.has_excess())) return 0;
  const Number s = direction(d, body, rate, label), ds = direction_slope(d, body, s, label);
  std::vector<DryFrictionTerm> terms = {{body.coulomb, "F_s", ds}, {dry.asymmetry, "F_d", 2 * s * ds}};
  if (dry.has_excess()) {
    const Number w = stribeck_weight(d, body, rate, label);
    const Number v_s = dry.stribeck_speed, dw = d.named(-2 * w * w * rate / (v_s * v_s), "dw_" + label);
    terms.push_back({dry.excess, "F_e", w * ds + dw * s});
  }
  return sum_of(d, without_zeros(std::move(terms)), label);
}

Number sliding_sign(Derivation& d, const Body& body, const Number& rate, const std::string& label) {
  return direction(d, body, rate, label) - body.dry.at_rest;
}

}  // namespace flatdyn
