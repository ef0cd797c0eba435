// SPDX-License-Identifier: GPL-2.0-or-later
// The filter between a log and the equations (inverse dynamic model and parallel decimation; Gautier 1997). Positions
// pass a wide filter, which makes q, q̇ and q̈; Y is evaluated with them; then the columns of Y and the measured torques
// pass the same narrow filter, and every N-th row is used. What is smoothed in τ, such as the step of dry friction
// where a speed changes sign, is smoothed in Y alike.
#pragma once

#include <compare>

namespace flatdyn {

struct SampleFilter {
  static constexpr double kMotionsPerBand = 12;  // how often Y is evaluated in a period of the band, at least

  double dt = 0;     // median time between samples of the log, s
  double band = 0;   // edge of the pass band of Y and τ, Hz; 0: no filter
  int decimate = 1;  // the equations of every N-th sample are used

  // The edge of the pass band of q, q̇ and q̈, Hz: twice `band`, so that what passes the narrow filter is whole.
  double motion_band() const;
  // Y is evaluated at every stride()-th sample, a divisor of `decimate`: at kMotionsPerBand bands or more. Friction,
  // which jumps, is evaluated at every sample.
  int stride() const;
  // A joint rests if it is slow for half a period of the band: this many strides. 0 without a filter.
  int rest_strides() const;
  // A joint stands still if its position stays the same for this many strides, five periods of the band; as samples.
  int standing_strides() const;
  int standing_samples() const { return standing_strides() * stride(); }
  // The number of samples that are needed on either side of one that is used.
  int half_window() const;
  // The parts of half_window(): samples that q, q̇, q̈ need, and strides that Y and τ need.
  int motion_half_window() const;
  int row_half_window() const;

  auto operator<=>(const SampleFilter&) const = default;
};

}  // namespace flatdyn
