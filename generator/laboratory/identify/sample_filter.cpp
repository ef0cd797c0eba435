// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/sample_filter.hpp"

#include <algorithm>
#include <cmath>

#include "laboratory/identify/zero_phase.hpp"

namespace flatdyn {

double SampleFilter::motion_band() const {
  constexpr double kWider = 2, kWidest = 0.3;  // of the band; of the sampling rate
  return std::max(band, std::min(kWider * band, kWidest / dt));
}

int SampleFilter::stride() const {
  const double widest = band > 0 ? 1 / (kMotionsPerBand * band * dt) : 1;
  for (int stride = std::min(decimate, static_cast<int>(widest)); stride > 1; --stride) {
    if (decimate % stride == 0) return stride;
  }
  return 1;
}

int SampleFilter::rest_strides() const {
  return band > 0 ? static_cast<int>(std::ceil(1 / (2 * band * dt * stride()))) : 0;
}

int SampleFilter::standing_strides() const {
  constexpr double kPeriods = 5;
  return band > 0 ? static_cast<int>(std::ceil(kPeriods / (band * dt * stride()))) : 0;
}

int SampleFilter::motion_half_window() const { return band > 0 ? zero_phase_half_window(motion_band(), dt) : 0; }

int SampleFilter::row_half_window() const {
  if (band == 0) return 0;
  const int samples = zero_phase_half_window(band, dt);
  return (samples + stride() - 1) / stride();
}

int SampleFilter::half_window() const { return motion_half_window() + (rest_strides() + row_half_window()) * stride(); }

}  // namespace flatdyn
