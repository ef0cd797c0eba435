// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/tip_torque.hpp"

namespace flatdyn {

double tip_torque(std::span<const double> J, std::span<const double> h_e, std::size_t joint) {
  const std::size_t n = J.size() / 6;
  double torque = 0;
  for (std::size_t row = 0; row < h_e.size(); ++row) torque += J[row * n + joint] * h_e[row];
  return torque;
}

}  // namespace flatdyn
