// SPDX-License-Identifier: GPL-2.0-or-later
// Linear programmes in x = ṡ² ≥ 0 and u = s̈ with objective x. At every x, the lines that bound u leave an interval of
// u whose length is concave in x. Newton's method finds the zeros of this length; since it is piecewise linear with few
// pieces, a few steps give them exactly.
#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace flatdyn {

// A closed interval.
struct Interval {
  double least = 0, greatest = std::numeric_limits<double>::infinity();
};

// The constraints α u + β x ≤ γ, one per added row.
class PaceRows {
 public:
  void clear();
  void add(double alpha, double beta, double gamma);

  // All x ≥ 0 for which a u satisfies the rows and next.least ≤ x + 2 Δ u ≤ next.greatest; nullopt if there are none.
  std::optional<Interval> reachable(double delta, const Interval& next) const;
  // The largest (or least) u at this x that ends within `next`; if rounding leaves none, the u that violates the rows
  // least.
  double largest_u(double x, double delta, const Interval& next) const;
  // The u that satisfies the rows at this x and is nearest to `wanted`.
  double nearest_u(double x, double wanted) const;

 private:
  // A bound u ≤ intercept + slope x, or ≥; weight: |α|.
  struct Line {
    double intercept, slope, weight;
  };
  struct Bound {
    double value = 0;
    Line line{};
  };
  static Bound lowest(const std::vector<Line>& lines, double x);
  static Bound highest(const std::vector<Line>& lines, double x);
  std::optional<double> zero(double x, const std::vector<Line>& above, const std::vector<Line>& below, bool rightmost,
                             double other_end) const;

  std::vector<Line> above_, below_;
  Interval x_;  // bounds of x by rows without u
};

}  // namespace flatdyn
