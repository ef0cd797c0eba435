// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/angles.hpp"

#include <algorithm>

namespace flatdyn {
namespace {

std::size_t at_index(int i) { return static_cast<std::size_t>(i); }

Number absolute_factor(const Number& factor) { return GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(factor)); }

// Whether the sine of this multiple follows from the addition theorems: up to twice the angle, by three
// multiplications. A larger multiple would lose that many units in the last place; asking for its own sine loses none.
bool is_small_whole(const Number& factor) {
  constexpr int kMostTurns = 2;
  return factor.info(GiNaC::info_flags::integer) && GiNaC::ex_to<GiNaC::numeric>(absolute_factor(factor)) <= kMostTurns;
}

std::size_t place_of(const std::vector<CoordinateMultiple>& angles, int position, const Number& factor) {
  const auto is_same = [&](const CoordinateMultiple& angle) {
    return angle.position == position && angle.factor.is_equal(absolute_factor(factor));
  };
  return static_cast<std::size_t>(std::find_if(angles.begin(), angles.end(), is_same) - angles.begin());
}

}  // namespace

std::vector<CoordinateMultiple> further_angles(const Mechanism& mechanism) {
  std::vector<CoordinateMultiple> angles;
  for (std::size_t i = 0; i < mechanism.coupling.size(); ++i) {
    if (mechanism.bodies[i].prismatic) continue;
    for (int k = 0; k < mechanism.position_count(); ++k) {
      const Number& factor = mechanism.coupling[i][at_index(k)];
      const bool is_known = is_small_whole(factor) || place_of(angles, k, factor) < angles.size();
      if (!is_known) angles.push_back({k, absolute_factor(factor)});
    }
  }
  return angles;
}

double largest_angle_factor(const Mechanism& mechanism) {
  double largest = 1;
  for (const CoordinateMultiple& angle : mechanism.angles) largest = std::max(largest, nearest_double(angle.factor));
  return largest;
}

std::vector<Number> angle_factors(const Mechanism& mechanism, int i) {
  std::vector<Number> turns(at_index(mechanism.angle_count()), 0);
  const std::vector<Number>& factors = mechanism.coupling[at_index(i)];
  for (std::size_t k = 0; k < factors.size(); ++k) {
    if (is_small_whole(factors[k])) {
      turns[k] = factors[k];
    } else {
      const std::size_t angle = place_of(mechanism.angles, static_cast<int>(k), factors[k]);
      turns[factors.size() + angle] = GiNaC::ex_to<GiNaC::numeric>(factors[k]).is_negative() ? -1 : 1;
    }
  }
  return turns;
}

}  // namespace flatdyn
