// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace flatdyn {
namespace {

// The quantile, interpolated linearly between neighbours.
double quantile(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

bool dominates(const Cost& a, const Cost& b) {
  return a.time <= b.time && a.error <= b.error && (a.time < b.time || a.error < b.error);
}

}  // namespace

Quartiles quartiles(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return {quantile(numbers, 0.25), quantile(numbers, 0.5), quantile(numbers, 0.75)};
}

std::vector<bool> pareto_front(const std::vector<Cost>& costs) {
  std::vector<bool> front;
  for (const Cost& cost : costs) {
    front.push_back(
        std::none_of(costs.begin(), costs.end(), [&](const Cost& other) { return dominates(other, cost); }));
  }
  return front;
}

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double a = std::log(x[k]), b = std::log(y[k]);
    sx += a;
    sy += b;
    sxx += a * a;
    sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace flatdyn
