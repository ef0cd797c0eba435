// SPDX-License-Identifier: BSD-3-Clause
// Sine and cosine of several angles at a time, without branches, so that the compiler can share what a sine and a
// cosine of the same angle have in common. Not for -ffast-math, which would undo the roundings on which they rely.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <xsimd/xsimd.hpp>

namespace flatdyn {

// The largest angle, rad, that is reduced to [-π/4, π/4] without loss; <cmath> computes larger ones.
inline constexpr double kReducedAngles = 1e5;

namespace detail {

#ifdef __FMA__
inline __m128 fused(__m128 a, __m128 b, __m128 c) noexcept { return _mm_fmadd_ps(a, b, c); }
inline __m128d fused(__m128d a, __m128d b, __m128d c) noexcept { return _mm_fmadd_pd(a, b, c); }
inline __m256 fused(__m256 a, __m256 b, __m256 c) noexcept { return _mm256_fmadd_ps(a, b, c); }
inline __m256d fused(__m256d a, __m256d b, __m256d c) noexcept { return _mm256_fmadd_pd(a, b, c); }
#ifdef __AVX512F__
inline __m512 fused(__m512 a, __m512 b, __m512 c) noexcept { return _mm512_fmadd_ps(a, b, c); }
inline __m512d fused(__m512d a, __m512d b, __m512d c) noexcept { return _mm512_fmadd_pd(a, b, c); }
#endif
#endif

// a b + c and c - a b, with one rounding where the machine has such instructions, with two elsewhere. They are written
// out since the compiler must not contract anything in generated code, and xsimd 8 has them for some registers only.
template <class Batch>
inline Batch multiply_add(const Batch& a, const Batch& b, const Batch& c) noexcept {
#ifdef __FMA__
  return Batch(fused(a, b, c));
#else
  return xsimd::fma(a, b, c);
#endif
}

template <class Batch>
inline Batch subtract_product(const Batch& c, const Batch& a, const Batch& b) noexcept {
#ifdef __FMA__
  return Batch(fused(-static_cast<typename Batch::register_type>(a), b, c));
#else
  return xsimd::fnma(a, b, c);
#endif
}

// The polynomial c_0 + z (c_1 + z (…)).
template <class Batch, class T>
inline Batch polynomial(const Batch&, T c) noexcept {
  return Batch(c);
}
template <class Batch, class T, class... Higher>
inline Batch polynomial(const Batch& z, T c, Higher... higher) noexcept {
  return multiply_add(z, polynomial(z, higher...), Batch(c));
}

// a b rounded to an integer, for |a b| below a quarter of 1 / ε: added to 1.5 / ε, a number has no room for a fraction.
template <class Batch>
inline Batch nearest_integer(const Batch& a, const Batch& b) noexcept {
  using T = typename Batch::value_type;
  const Batch large(T(1.5) / std::numeric_limits<T>::epsilon());
  return multiply_add(a, b, large) - large;
}

template <class Batch>
struct SineAndCosine {
  Batch sine, cosine;
};

// Sine and cosine of n π/2 + r from those of r.
template <class Batch>
inline SineAndCosine<Batch> in_quadrant(const Batch& n, const Batch& s, const Batch& c) noexcept {
  using T = typename Batch::value_type;
  const Batch half(T(0.5)), one(T(1));
  const Batch quadrant = subtract_product(n, Batch(T(4)), nearest_integer(n, Batch(T(0.25))));  // -2 … 2
  const auto swapped = xsimd::abs(quadrant) == one;
  const auto sine_flips = xsimd::abs(quadrant - half) > one, cosine_flips = xsimd::abs(quadrant + half) > one;
  const Batch sine = xsimd::select(swapped, c, s), cosine = xsimd::select(swapped, s, c);
  return {xsimd::select(sine_flips, -sine, sine), xsimd::select(cosine_flips, -cosine, cosine)};
}

// x = n π/2 + r - excess with |r| <= π/4 up to a rounding; excess is the part that the 53 bits of r cannot hold.
template <class Batch>
struct Reduced {
  Batch n, r, excess;
};

// Reduces x with π/2 in three parts, the first two of 33 bits: their products with an n below 2^20 are exact (Cody and
// Waite; the split and its two steps are those of fdlibm's e_rem_pio2.c).
template <class Batch>
inline Reduced<Batch> reduced(const Batch& x) noexcept {
  const Batch n = nearest_integer(x, Batch(0x1.45f306dc9c883p-1));
  const Batch above = subtract_product(x, n, Batch(0x1.921fb544p+0));
  const Batch product = n * Batch(0x1.0b4611a6p-34);
  const Batch head = above - product;
  const Batch tail = multiply_add(n, Batch(0x1.3198a2e037073p-69), product - (above - head));
  const Batch r = head - tail;
  return {n, r, tail - (head - r)};
}

// Minimax polynomials of sin and cos on [-π/4, π/4], errors below 2^-57 (coefficients of fdlibm's k_sin.c and k_cos.c).
template <class Batch>
inline Batch sine_near_zero(const Batch& r, const Batch& excess) noexcept {
  const Batch z = r * r, cube = z * r;
  const Batch p = polynomial(z, 8.33333333332248946124e-03, -1.98412698298579493134e-04, 2.75573137070700676789e-06,
                             -2.50507602534068634195e-08, 1.58969099521155010221e-10);
  const Batch q = subtract_product(excess, z, multiply_add(cube, p, Batch(0.5) * excess));
  return r - multiply_add(cube, Batch(1.66666666666666324348e-01), q);
}

template <class Batch>
inline Batch cosine_near_zero(const Batch& r, const Batch& excess) noexcept {
  const Batch z = r * r, half = Batch(0.5) * z, leading = Batch(1.0) - half;
  const Batch p = polynomial(z, 4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
                             -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11);
  return leading + (((Batch(1.0) - leading) - half) + multiply_add(r, excess, z * (z * p)));
}

template <class A>
inline SineAndCosine<xsimd::batch<double, A>> sine_and_cosine(const xsimd::batch<double, A>& x) noexcept {
  const auto a = reduced(x);
  return in_quadrant(a.n, sine_near_zero(a.r, a.excess), cosine_near_zero(a.r, a.excess));
}

// For float, π/2 is in three parts, too; n times a part is rounded once, together with the difference. (Coefficients of
// Cephes' sinf.c and cosf.c.)
template <class A>
inline SineAndCosine<xsimd::batch<float, A>> sine_and_cosine(const xsimd::batch<float, A>& x) noexcept {
#ifdef __FMA__
  using Batch = xsimd::batch<float, A>;
  const Batch n = nearest_integer(x, Batch(0x1.45f306p-1F));
  const Batch above = subtract_product(x, n, Batch(0x1.921fb6p+0F));
  const Batch r = subtract_product(subtract_product(above, n, Batch(-0x1.777a5cp-25F)), n, Batch(-0x1.ee59dap-50F));
  const Batch z = r * r;
  const Batch s = polynomial(z, -1.6666654611e-1F, 8.3321608736e-3F, -1.9515295891e-4F);
  const Batch c = polynomial(z, 4.166664568298827e-2F, -1.388731625493765e-3F, 2.443315711809948e-5F);
  return in_quadrant(n, multiply_add(z * r, s, r),
                     multiply_add(z * z, c, subtract_product(Batch(1.0F), Batch(0.5F), z)));
#else
  const auto both = xsimd::sincos(x);
  return {both.first, both.second};
#endif
}

// True in lanes where x is too large, or not a number.
template <class Batch>
inline auto is_large(const Batch& x) noexcept {
  return !(xsimd::abs(x) <= Batch(static_cast<typename Batch::value_type>(kReducedAngles)));
}

// `value`, or the function of <cmath> in lanes where x is too large.
template <class Batch, class Function>
inline Batch or_library(const Batch& x, const Batch& value, Function function) noexcept {
  const auto large = is_large(x);
  if (!xsimd::any(large)) return value;
  alignas(64) typename Batch::value_type lanes[Batch::size];
  x.store_aligned(lanes);
  for (auto& lane : lanes) lane = function(lane);
  return xsimd::select(large, Batch::load_aligned(lanes), value);
}

}  // namespace detail

// The sine, in double to 1 ulp, in float to 2; NaN if x is not finite.
template <class T, class A>
inline xsimd::batch<T, A> sine(const xsimd::batch<T, A>& x) noexcept {
  return detail::or_library(x, detail::sine_and_cosine(x).sine, [](T a) { return std::sin(a); });
}

template <class T, class A>
inline xsimd::batch<T, A> cosine(const xsimd::batch<T, A>& x) noexcept {
  return detail::or_library(x, detail::sine_and_cosine(x).cosine, [](T a) { return std::cos(a); });
}

template <class T, class A>
inline detail::SineAndCosine<xsimd::batch<T, A>> sin_cos(const xsimd::batch<T, A>& x) noexcept {
  const auto both = detail::sine_and_cosine(x);
  return {detail::or_library(x, both.sine, [](T a) { return std::sin(a); }),
          detail::or_library(x, both.cosine, [](T a) { return std::cos(a); })};
}

}  // namespace flatdyn
