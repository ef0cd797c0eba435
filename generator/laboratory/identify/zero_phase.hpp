// SPDX-License-Identifier: GPL-2.0-or-later
// Low-pass filtering and differentiation without phase: finite kernels, symmetric about the sample, so that a log of
// any length passes through a window of fixed length.
#pragma once

#include <vector>

namespace flatdyn {

// y(t_c) = Σ_k weights[order][k] x(t_c + (k - half) dt), k = 0 … 2 half: the signal below the band's edge (order 0) and
// its first and second derivatives.
//
// The kernel is a sinc at 1.5 times the band's edge, times Nuttall's window (four cosines, side lobes below -93 dB;
// Nuttall, 1981), differentiated in closed form. It passes what is slower than `band` with an error of 1e-4, damps what
// is faster than twice that to 1e-4, and is exact for parabolas.
struct ZeroPhaseKernel {
  int half = 0;
  std::vector<double> weights[3];

  int length() const { return 2 * half + 1; }
};

// band: the edge of the pass band, Hz; dt: the time between samples, s. Needs 3 band dt < 1.
ZeroPhaseKernel zero_phase_kernel(double band, double dt);
// The weights of the signal below the band's edge at the time t_c + ahead, |ahead| far below 1 / band.
std::vector<double> weights_ahead(double band, double dt, double ahead);
// Those of its first derivative.
std::vector<double> rate_weights_ahead(double band, double dt, double ahead);
// The half-length of such a kernel in samples, at most 1e9.
int zero_phase_half_window(double band, double dt);

}  // namespace flatdyn
