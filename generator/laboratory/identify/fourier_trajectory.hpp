// SPDX-License-Identifier: GPL-2.0-or-later
// Periodic motions for identification: per joint a finite Fourier series (Swevers, Ganseman, Tükel, De Schutter and Van
// Brussel, 1997) and a quintic polynomial that makes it start and end at rest (Park, 2006). With ω = 2π / duration
//   q_i(t) = q_i0 + Σ_l [a_il / (ωl) sin(ωlt) − b_il / (ωl) cos(ωlt)] + polynomial,
// and at t = 0 and t = duration q_i = q_i0, q̇_i = 0, q̈_i = 0.
#pragma once

#include <vector>

namespace flatdyn {

// A coordinate and its first two derivatives: rad, rad/s, rad/s² or m, m/s, m/s².
struct Deflection {
  double q = 0, qd = 0, qdd = 0;
};

// sin(ωlt) / (ωl) and −cos(ωlt) / (ωl), each with its polynomial. The polynomial is linear in the coefficients, so the
// sum of such terms is the trajectory.
Deflection sine_term(double duration, int l, double t);
Deflection cosine_term(double duration, int l, double t);

// The coefficients of one joint, l = 1, 2, …: amplitudes of speed, rad/s or m/s.
struct FourierSeries {
  std::vector<double> a, b;
};

struct FourierMotion {
  std::vector<double> q, qd, qdd;
};

class FourierTrajectory {
 public:
  // duration: s; rest: the rest positions, one per joint; series: one per joint.
  FourierTrajectory(double duration, std::vector<double> rest, std::vector<FourierSeries> series);

  double duration() const { return duration_; }
  int joints() const { return static_cast<int>(rest_.size()); }
  const std::vector<FourierSeries>& series() const { return series_; }
  // The motion at time t in s, 0 ≤ t ≤ duration.
  FourierMotion at(double t) const;
  // The trajectory with every joint's deflection from rest multiplied by its factor.
  FourierTrajectory scaled(const std::vector<double>& factors) const;

 private:
  double duration_;
  std::vector<double> rest_;
  std::vector<FourierSeries> series_;
};

// The motion at both ends and evenly between them: intervals + 1 samples.
std::vector<FourierMotion> sampled(const FourierTrajectory& trajectory, int intervals);

}  // namespace flatdyn
