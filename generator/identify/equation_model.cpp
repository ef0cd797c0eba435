// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/equation_model.hpp"

#include <cmath>

namespace flatdyn {

double FrictionEntry::value(double rate) const {
  const double sign = static_cast<double>((rate > 0) - (rate < 0)), part = rate / speed;
  switch (law) {
    case Law::viscous:
      return rate;
    case Law::coulomb:
      return sign;
    case Law::asymmetry:
      return std::abs(sign);
    case Law::stribeck:
      return std::exp(-part * part) * sign;
    case Law::smooth:
      return std::tanh(part);
  }
  return 0;
}

}  // namespace flatdyn
