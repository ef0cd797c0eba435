// SPDX-License-Identifier: GPL-2.0-or-later
// Linear programmes in two variables, x = ṡ² ≥ 0 and u = s̈, whose objective is x: the lines that bound u leave at every
// x an interval of u, whose length is concave in x. Its zeros are found by Newton's method, which on so few straight
// pieces ends after a few steps, exactly.
#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace flatdyn {

struct Interval {
  double least = 0, greatest = std::numeric_limits<double>::infinity();
};

// α u + β x ≤ γ for each row that was added.
class PaceRows {
 public:
  void clear();
  void add(double alpha, double beta, double gamma);

  // All x ≥ 0 with a u for which the rows hold and next.least ≤ x + 2 Δ u ≤ next.greatest; nullopt if there is none.
  std::optional<Interval> reachable(double delta, const Interval& next) const;
  // Of the u at this x, the largest (or least) that ends within `next`; where rounding leaves none, the one that
  // violates the rows least.
  double largest_u(double x, double delta, const Interval& next) const;
  // The u of the rows at this x that is nearest to `wanted`.
  double nearest_u(double x, double wanted) const;

 private:
  // u ≤ intercept + slope x, or ≥; weight: |α|.
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
  Interval x_;  // from rows without u
};

}  // namespace flatdyn
