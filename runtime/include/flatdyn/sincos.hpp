// SPDX-License-Identifier: BSD-3-Clause
// Sine and cosine of several angles at a time, without branches, so that the compiler sees what a sine and a cosine of
// the same angle have in common. Not for -ffast-math, which would undo the roundings that they are built on.
#pragma once

#include <cmath>
#include <cstddef>
#include <xsimd/xsimd.hpp>

namespace flatdyn {

// Angles up to this size are reduced to within π/4 without loss, larger ones are left to <cmath>. rad
inline constexpr double kReducedAngles = 1e5;

namespace detail {

// The integer next to x, for |x| below 2^51: there is no room for a fraction beside 1.5 2^52.
template <class Batch>
inline Batch nearest_integer(const Batch& x) noexcept {
  const Batch large(0x1.8p+52);
  return (x + large) - large;
}

// x = n π/2 + r + rest, |r| <= π/4 but for a rounding, rest the part of r that its 53 bits have no room for.
template <class Batch>
struct Reduced {
  Batch n, r, rest;
};

// π/2 in three parts, of which the first two have 33 bits: with an n below 2^20 their products are exact (Cody and
// Waite; the split and its two steps as in fdlibm's e_rem_pio2.c).
template <class Batch>
inline Reduced<Batch> reduced(const Batch& x) noexcept {
  const Batch n = nearest_integer(x * Batch(0x1.45f306dc9c883p-1));
  const Batch above = x - n * Batch(0x1.921fb544p+0);
  const Batch product = n * Batch(0x1.0b4611a6p-34);
  const Batch head = above - product;
  const Batch tail = n * Batch(0x1.3198a2e037073p-69) - ((above - head) - product);
  const Batch r = head - tail;
  return {n, r, (head - r) - tail};
}

// Minimax polynomials of sin and cos on [-π/4, π/4], errors below 2^-57 (coefficients of fdlibm's k_sin.c and k_cos.c).
template <class Batch>
inline Batch sine_near_zero(const Batch& r, const Batch& rest) noexcept {
  const Batch z = r * r, cube = z * r;
  const Batch p = Batch(8.33333333332248946124e-03) +
                  z * (Batch(-1.98412698298579493134e-04) +
                       z * (Batch(2.75573137070700676789e-06) +
                            z * (Batch(-2.50507602534068634195e-08) + z * Batch(1.58969099521155010221e-10))));
  return r - ((z * (Batch(0.5) * rest - cube * p) - rest) + cube * Batch(1.66666666666666324348e-01));
}

template <class Batch>
inline Batch cosine_near_zero(const Batch& r, const Batch& rest) noexcept {
  const Batch z = r * r, half = Batch(0.5) * z, leading = Batch(1.0) - half;
  const Batch p = Batch(4.16666666666666019037e-02) +
                  z * (Batch(-1.38888888888741095749e-03) +
                       z * (Batch(2.48015872894767294178e-05) +
                            z * (Batch(-2.75573143513906633035e-07) +
                                 z * (Batch(2.08757232129817482790e-09) + z * Batch(-1.13596475577881948265e-11)))));
  return leading + (((Batch(1.0) - leading) - half) + (z * (z * p) - r * rest));
}

template <class Batch>
struct SineAndCosine {
  Batch sine, cosine;
};

template <class Batch>
inline SineAndCosine<Batch> sine_and_cosine(const Batch& x) noexcept {
  const Reduced<Batch> a = reduced(x);
  const Batch s = sine_near_zero(a.r, a.rest), c = cosine_near_zero(a.r, a.rest);
  const Batch quadrant = a.n - Batch(4.0) * nearest_integer(Batch(0.25) * a.n);  // -2 … 2
  const auto swapped = quadrant * quadrant == Batch(1.0);
  const Batch sine = xsimd::select(swapped, c, s), cosine = xsimd::select(swapped, s, c);
  const auto sine_flips = (quadrant < Batch(-0.5)) | (quadrant > Batch(1.5));
  const auto cosine_flips = (quadrant < Batch(-1.5)) | (quadrant > Batch(0.5));
  return {xsimd::select(sine_flips, -sine, sine), xsimd::select(cosine_flips, -cosine, cosine)};
}

// `value`, but where x is too large the function of <cmath>.
template <class Batch, class Function>
inline Batch or_library(const Batch& x, const Batch& value, Function function) noexcept {
  const auto large = !(xsimd::abs(x) <= Batch(kReducedAngles));
  if (!xsimd::any(large)) return value;
  alignas(64) double lanes[Batch::size];
  x.store_aligned(lanes);
  for (double& lane : lanes) lane = function(lane);
  return xsimd::select(large, Batch::load_aligned(lanes), value);
}

}  // namespace detail

// To 1 ulp; NaN of what is not finite.
template <class A>
inline detail::SineAndCosine<xsimd::batch<double, A>> sin_cos(const xsimd::batch<double, A>& x) noexcept {
  const auto both = detail::sine_and_cosine(x);
  return {detail::or_library(x, both.sine, [](double a) { return std::sin(a); }),
          detail::or_library(x, both.cosine, [](double a) { return std::cos(a); })};
}

template <class A>
inline xsimd::batch<double, A> sin(const xsimd::batch<double, A>& x) noexcept {
  return detail::or_library(x, detail::sine_and_cosine(x).sine, [](double a) { return std::sin(a); });
}

template <class A>
inline xsimd::batch<double, A> cos(const xsimd::batch<double, A>& x) noexcept {
  return detail::or_library(x, detail::sine_and_cosine(x).cosine, [](double a) { return std::cos(a); });
}

// In float, xsimd's own.
template <class A>
inline detail::SineAndCosine<xsimd::batch<float, A>> sin_cos(const xsimd::batch<float, A>& x) noexcept {
  const auto both = xsimd::sincos(x);
  return {both.first, both.second};
}

template <class A>
inline xsimd::batch<float, A> sin(const xsimd::batch<float, A>& x) noexcept {
  return xsimd::sin(x);
}

template <class A>
inline xsimd::batch<float, A> cos(const xsimd::batch<float, A>& x) noexcept {
  return xsimd::cos(x);
}

}  // namespace flatdyn
