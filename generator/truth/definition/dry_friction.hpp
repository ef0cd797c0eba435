// SPDX-License-Identifier: GPL-2.0-or-later
// The dry friction of a joint by its definition, over any field and over dual numbers.
#pragma once

#include "robot/model/field_mechanism.hpp"

namespace flatdyn {

// s at a rate, where its value is given. Over dual numbers it changes with the rate: ds/dω = (1 - s²)/v_0 if it is
// smooth, 0 if it is a sign.
template <class F, class S>
S moving_sign(const FieldBody<F>&, const S&, const S& sign) {
  return sign;
}
template <class F, class S>
Dual<S> moving_sign(const FieldBody<F>& body, const Dual<S>& rate, const Dual<S>& sign) {
  if (!body.dry.is_smooth) return sign;
  const Dual<S> slope = (Dual<S>(1) - sign * sign) / Dual<S>(body.dry.speed);
  return {sign.value, slope.value * rate.derivative};
}

// F_s (s - s_0) + E s/(1 + (ω/v_s)²) + D s².
template <class F, class S>
S dry_friction(const FieldBody<F>& body, const S& rate, const S& value_of_sign) {
  const FieldDryFriction<F>& dry = body.dry;
  const S s = moving_sign(body, rate, value_of_sign);
  S torque = S(body.coulomb) * (s - S(dry.at_rest)) + S(dry.asymmetry) * s * s;
  if (!dry.has_excess) return torque;
  const S ratio = rate / S(dry.stribeck_speed);
  return torque + S(dry.excess) * s / (S(1) + ratio * ratio);
}

// Its derivative by the rate.
template <class F>
F dry_friction_slope(const FieldBody<F>& body, const F& rate, const F& sign) {
  return dry_friction(body, Dual<F>(rate, F(1)), Dual<F>(sign)).derivative;
}

}  // namespace flatdyn
