// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/pace_interval.hpp"

#include <algorithm>
#include <cmath>

namespace flatdyn {

namespace {

// The smallest factor of u that counts: the lines of smaller ones would be infinite.
constexpr double kNoFactor = 1e-100;

}  // namespace

void PaceRows::clear() {
  above_.clear();
  below_.clear();
  x_ = {};
}

void PaceRows::add(double alpha, double beta, double gamma) {
  if (alpha > kNoFactor) {
    above_.push_back({gamma / alpha, -beta / alpha, alpha});
  } else if (alpha < -kNoFactor) {
    below_.push_back({gamma / alpha, -beta / alpha, -alpha});
  } else if (beta > 0) {
    x_.greatest = std::min(x_.greatest, gamma / beta);
  } else if (beta < 0) {
    x_.least = std::max(x_.least, gamma / beta);
  } else if (gamma < 0) {
    x_.greatest = -1;
  }
}

PaceRows::Bound PaceRows::lowest(const std::vector<Line>& lines, double x) {
  Bound bound{std::numeric_limits<double>::infinity(), {}};
  for (const Line& line : lines) {
    const double value = line.intercept + line.slope * x;
    if (value < bound.value) bound = {value, line};
  }
  return bound;
}

PaceRows::Bound PaceRows::highest(const std::vector<Line>& lines, double x) {
  Bound bound{-std::numeric_limits<double>::infinity(), {}};
  for (const Line& line : lines) {
    const double value = line.intercept + line.slope * x;
    if (value > bound.value) bound = {value, line};
  }
  return bound;
}

std::optional<double> PaceRows::zero(double x, const std::vector<Line>& above, const std::vector<Line>& below,
                                     bool rightmost, double other_end) const {
  constexpr int kMostSteps = 100;
  for (int step = 0; step < kMostSteps; ++step) {
    const Bound top = lowest(above, x), bottom = highest(below, x);
    if (top.value >= bottom.value) return x;
    const double slope = top.line.slope - bottom.line.slope;
    // The length can grow towards the other end only if its slope has the right sign.
    if (rightmost ? slope >= 0 : slope <= 0) return std::nullopt;
    const double next = (bottom.line.intercept - top.line.intercept) / slope;
    if (rightmost ? next < other_end : next > other_end) return std::nullopt;
    if (rightmost ? next >= x : next <= x) return x;  // rounding allows no closer value
    x = next;
  }
  return x;
}

std::optional<Interval> PaceRows::reachable(double delta, const Interval& next) const {
  std::vector<Line> above = above_, below = below_;
  above.push_back({next.greatest / (2 * delta), -1 / (2 * delta), 2 * delta});
  below.push_back({next.least / (2 * delta), -1 / (2 * delta), 2 * delta});
  if (x_.least > x_.greatest) return std::nullopt;
  const std::optional<double> greatest = zero(x_.greatest, above, below, true, x_.least);
  if (!greatest) return std::nullopt;
  const std::optional<double> least = zero(x_.least, above, below, false, *greatest);
  return Interval{std::min(least.value_or(*greatest), *greatest), *greatest};
}

double PaceRows::largest_u(double x, double delta, const Interval& next) const {
  const Bound top = lowest(above_, x), bottom = highest(below_, x);
  const double least = std::max(bottom.value, (next.least - x) / (2 * delta));
  const double u = std::min(top.value, (next.greatest - x) / (2 * delta));
  if (u >= least) return u;
  // This point is reached by rounding only. Of the two rows the one of small weight, whose u is inaccurate, gives way.
  return top.value < bottom.value && bottom.line.weight > top.line.weight ? bottom.value : u;
}

double PaceRows::nearest_u(double x, double wanted) const {
  return std::min(std::max(wanted, highest(below_, x).value), lowest(above_, x).value);
}

}  // namespace flatdyn
