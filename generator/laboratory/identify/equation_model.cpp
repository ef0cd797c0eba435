// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/equation_model.hpp"

#include <cmath>

namespace flatdyn {

double FrictionEntry::value(double rate) const {
  const double sign = static_cast<double>((rate > 0) - (rate < 0)), part = rate / speed;
  switch (law) {
    case Law::viscous:
      return factor * rate;
    case Law::coulomb:
      return factor * sign;
    case Law::asymmetry:
      return factor * std::abs(sign);
    case Law::stribeck:
      return factor * std::exp(-part * part) * sign;
    case Law::smooth:
      return factor * std::tanh(part);
    case Law::stribeck_slope:
      return factor * 2 * part * part / speed * std::exp(-part * part) * sign;
    case Law::smooth_slope:
      return -factor * part / speed / std::pow(std::cosh(part), 2);
  }
  return 0;
}

}  // namespace flatdyn
