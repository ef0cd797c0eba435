// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <optional>
#include <utility>

#include "derivation/notation/readable_sum.hpp"

namespace flatdyn {
namespace {

using Angle = std::vector<int>;

struct Amplitudes {
  Rational cosine = 0, sine = 0;
};

// A sum Σ a cos x + b sin x; the first coefficient of each angle x is positive.
using Harmonics = std::map<Angle, Amplitudes>;

Angle combined(const Angle& a, const Angle& b, int sign) {
  Angle result = a;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] += sign * b[i];
  return result;
}

bool is_zero_angle(const Angle& a) {
  return std::all_of(a.begin(), a.end(), [](int k) { return k == 0; });
}

void add(Harmonics& sum, Angle angle, const Rational& cosine, Rational sine) {
  const auto first = std::find_if(angle.begin(), angle.end(), [](int k) { return k != 0; });
  if (first != angle.end() && *first < 0) {
    for (int& k : angle) k = -k;
    sine = -sine;
  }
  Amplitudes& own = sum[angle];
  own.cosine += cosine;
  if (first != angle.end()) own.sine += sine;
}

// Multiplies by a factor; products become sums: cos x cos a = (cos(x-a) + cos(x+a))/2, and so on.
Harmonics multiplied(const Harmonics& sum, const Factor& factor) {
  Harmonics result;
  const Rational half(1, 2);
  for (const auto& [x, amplitude] : sum) {
    const Rational a = half * amplitude.cosine, b = half * amplitude.sine;
    const Angle more = combined(x, factor.angle, 1), less = combined(x, factor.angle, -1);
    if (factor.kind == FactorKind::cosine) {
      add(result, more, a, b);
      add(result, less, a, b);
    } else {
      add(result, more, -b, a);
      add(result, less, b, -a);
    }
  }
  return result;
}

// Whether the angle is a plain sum, as in c_12 or s_3: every coefficient is 0 or 1.
bool is_plain(const Angle& a) {
  return std::all_of(a.begin(), a.end(), [](int k) { return k == 0 || k == 1; });
}

std::optional<Angle> halved(const Angle& a) {
  Angle result = a;
  for (int& k : result) {
    if (k % 2 != 0) return std::nullopt;
    k /= 2;
  }
  const auto first = std::find_if(result.begin(), result.end(), [](int k) { return k != 0; });
  if (first != result.end() && *first < 0) {
    for (int& k : result) k = -k;
  }
  return result;
}

Monomial product_of(const Factor& a, const Factor& b) {
  Monomial result;
  for (const Factor& factor : {a, b}) {
    if (!is_zero_angle(factor.angle)) ++result[factor];
  }
  return result;
}

struct Wave {
  Angle angle;
  Rational amplitude;
  bool is_sine;
};

// Two waves of the same amplitude as one product of two plain functions: cos x + cos y = 2 cos u cos v with u =
// (x+y)/2, v = (x-y)/2. Nothing if x and y are both plain themselves.
std::optional<std::pair<Monomial, Rational>> joined(const Wave& x, const Wave& y) {
  if (x.is_sine != y.is_sine || (is_plain(x.angle) && is_plain(y.angle))) return std::nullopt;
  const bool same = x.amplitude == y.amplitude;
  if (!same && x.amplitude != -y.amplitude) return std::nullopt;
  const auto u = halved(combined(x.angle, y.angle, 1)), v = halved(combined(x.angle, y.angle, -1));
  if (!u || !v || !is_plain(*u) || !is_plain(*v)) return std::nullopt;
  const Angle half_difference = combined(x.angle, y.angle, -1);
  const auto first = std::find_if(half_difference.begin(), half_difference.end(), [](int k) { return k != 0; });
  const int sign_v = first != half_difference.end() && *first < 0 ? -1 : 1;
  const Rational twice = 2 * x.amplitude;
  const auto factor = [](bool sine, const Angle& angle) {
    return Factor{sine ? FactorKind::sine : FactorKind::cosine, 0, angle};
  };
  if (!x.is_sine && same) return {{product_of(factor(false, *u), factor(false, *v)), twice}};
  if (!x.is_sine) return {{product_of(factor(true, *u), factor(true, *v)), Rational(-twice * sign_v)}};
  if (same) return {{product_of(factor(true, *u), factor(false, *v)), twice}};
  return {{product_of(factor(false, *u), factor(true, *v)), Rational(twice * sign_v)}};
}

// The sum of waves, with pairs joined greedily in order.
ReadableSum with_pairs_joined(const Harmonics& sum) {
  std::vector<Wave> waves;
  for (const auto& [angle, amplitude] : sum) {
    if (amplitude.cosine != 0) waves.push_back({angle, amplitude.cosine, false});
    if (amplitude.sine != 0) waves.push_back({angle, amplitude.sine, true});
  }
  ReadableSum result;
  std::vector<bool> used(waves.size(), false);
  for (std::size_t i = 0; i < waves.size(); ++i) {
    for (std::size_t j = i + 1; j < waves.size() && !used[i]; ++j) {
      if (used[j]) continue;
      if (const auto pair = joined(waves[i], waves[j])) {
        result[pair->first] += pair->second;
        used[i] = used[j] = true;
      }
    }
    if (used[i]) continue;
    Monomial single;
    if (!is_zero_angle(waves[i].angle)) {
      single[{waves[i].is_sine ? FactorKind::sine : FactorKind::cosine, 0, waves[i].angle}] = 1;
    }
    result[single] += waves[i].amplitude;
  }
  std::erase_if(result, [](const auto& term) { return term.second == 0; });
  return result;
}

Harmonics harmonics(const ReadableSum& sum, int angles) {
  Harmonics total;
  for (const auto& [monomial, coefficient] : sum) {
    Harmonics product;
    product[Angle(static_cast<std::size_t>(angles), 0)].cosine = coefficient;
    for (const auto& [factor, exponent] : monomial) {
      for (int k = 0; k < exponent; ++k) product = multiplied(product, factor);
    }
    for (const auto& [angle, amplitude] : product) add(total, angle, amplitude.cosine, amplitude.sine);
  }
  return total;
}

bool belongs(const Factor& factor, const std::vector<int>& group) {
  if (!factor.is_trigonometric()) return false;
  return std::any_of(group.begin(), group.end(),
                     [&](int joint) { return factor.angle[static_cast<std::size_t>(joint)] != 0; });
}

Monomial times(Monomial a, const Monomial& b) {
  for (const auto& [factor, exponent] : b) a[factor] += exponent;
  return a;
}

}  // namespace

AngleRewriter::AngleRewriter(const Mechanism& mechanism)
    : angles_(joint_count(mechanism) + static_cast<int>(mechanism.angles.size())) {
  std::vector<std::size_t> group_of(mechanism.bodies.size());
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    if (body.parent >= 0 && is_zero(body.alpha.s)) {
      group_of[i] = group_of[static_cast<std::size_t>(body.parent)];
    } else {
      group_of[i] = groups_.size();
      groups_.emplace_back();
    }
  }
  const std::vector<int> joints = joints_of_entries(mechanism);
  for (int k = mechanism.base_bodies(); k < mechanism.size(); ++k) {
    const Body& body = mechanism.joint(k);
    if (body.prismatic || body.spherical > 0) continue;
    // Angles of coupled joints may be sums of any coordinates, whatever the axes.
    groups_[mechanism.is_coupled() ? 0 : group_of[at(k)]].push_back(joints[at(k)]);
  }
  for (int k = joint_count(mechanism); k < angles_; ++k) groups_[0].push_back(k);
  std::erase_if(groups_, [](const std::vector<int>& group) { return group.empty(); });
}

ReadableSum AngleRewriter::rewritten(ReadableSum sum) const {
  for (const std::vector<int>& group : groups_) {
    std::map<Monomial, ReadableSum> by_context;  // other factors → polynomial in the group's sines and cosines
    for (const auto& [monomial, coefficient] : sum) {
      Monomial context, own;
      for (const auto& power : monomial) (belongs(power.first, group) ? own : context).insert(power);
      by_context[context][own] += coefficient;
    }
    ReadableSum next;
    for (const auto& [context, own] : by_context) {
      const ReadableSum shorter = with_pairs_joined(harmonics(own, angles_));
      for (const auto& [monomial, coefficient] : shorter.size() < own.size() ? shorter : own) {
        next[times(context, monomial)] += coefficient;
      }
    }
    sum = std::move(next);
  }
  return sum;
}

}  // namespace flatdyn
