// SPDX-License-Identifier: BSD-3-Clause
// Sine and cosine of several angles at a time, without branches, so that the compiler can share what a sine and a
// cosine of the same angle have in common. The values are right under flags that let compilers reorder sums, too.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <xsimd/xsimd.hpp>

namespace flatdyn {

// The largest angle, rad, that is reduced to [-π/4, π/4] without loss; <cmath> computes larger ones. (In float it is
// 6400 where the machine has no fused multiply-adds.)
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

// How generated code's own sines and cosines are rounded over SIMD lanes. Fused: products are rounded together with the
// sums that they go into, where the machine has such instructions. They are written out since the compiler must not
// contract anything in generated code, and xsimd 8 has them for some registers only.
struct Fused {
  // a b + c
  template <class Batch>
  static Batch multiply_add(const Batch& a, const Batch& b, const Batch& c) noexcept {
#ifdef __FMA__
    return Batch(fused(a, b, c));
#else
    return xsimd::fma(a, b, c);
#endif
  }
  // c - a b
  template <class Batch>
  static Batch subtract_product(const Batch& c, const Batch& a, const Batch& b) noexcept {
#ifdef __FMA__
    return Batch(fused(-static_cast<typename Batch::register_type>(a), b, c));
#else
    return xsimd::fnma(a, b, c);
#endif
  }
};

// Every operation is rounded by itself: the bits are those of single calls.
struct AsWritten {
  template <class Batch>
  static Batch multiply_add(const Batch& a, const Batch& b, const Batch& c) noexcept {
    return a * b + c;
  }
  template <class Batch>
  static Batch subtract_product(const Batch& c, const Batch& a, const Batch& b) noexcept {
    return c - a * b;
  }
};

#ifdef __FMA__
inline constexpr bool kHasFused = true;
#else
inline constexpr bool kHasFused = false;
#endif

// The largest angle, rad, that is reduced without loss. In float the parts of π/2 have fewer bits where products are
// rounded by themselves.
template <class T, class Rounding>
constexpr T reduced_angles() noexcept {
  return static_cast<T>(std::is_same_v<T, float> && !(kHasFused && std::is_same_v<Rounding, Fused>) ? 6400
                                                                                                    : kReducedAngles);
}

template <class Batch>
struct SineAndCosine {
  Batch sine, cosine;
};

// The bits of numbers, as integers.
template <class Batch>
using Bits = xsimd::batch<std::conditional_t<sizeof(typename Batch::value_type) == 8, std::uint64_t, std::uint32_t>,
                          typename Batch::arch_type>;

template <class To, class From>
inline To with_bits_of(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From), "registers of the same width");
  To to;
  std::memcpy(&to, &from, sizeof(to));
  return to;
}

// How n, the whole number nearest to 2 x/π, is computed: added to `large`, a number has no room for a fraction, and its
// last bits are those of n, the quadrant. Added to the bits, as integers, `next` makes the last ones those of the next
// quadrant, and the number `next_large` + n. Compilers that may reorder sums cannot undo the rounding, since they do
// not see through the bits.
template <class T>
struct WholeTurns;

template <>
struct WholeTurns<double> {
  static constexpr double large = 0x1.8p+52, next_large = 0x1.c000000000001p+52;
  static constexpr std::uint64_t next = 0x4000000000001U;
};

template <>
struct WholeTurns<float> {
  static constexpr float large = 0x1.8p+23F, next_large = 0x1.c00002p+23F;
  static constexpr std::uint32_t next = 0x200001U;
};

template <class Batch>
inline Bits<Batch> next_quadrant(const Batch& turns) noexcept {
  return with_bits_of<Bits<Batch>>(turns) + Bits<Batch>(WholeTurns<typename Batch::value_type>::next);
}

template <class Batch>
inline Batch whole_number(const Batch& turns) noexcept {
  return with_bits_of<Batch>(next_quadrant(turns)) - Batch(WholeTurns<typename Batch::value_type>::next_large);
}

// Sine and cosine of n π/2 + r from those of r; the last two bits of `turns` are those of n. In an odd quadrant they
// are exchanged.
template <class Batch>
inline SineAndCosine<Batch> in_quadrant(const Batch& turns, const Batch& s, const Batch& c) noexcept {
  using Integers = Bits<Batch>;
  using Integer = typename Integers::value_type;
  constexpr int kToSign = 8 * sizeof(Integer) - 2;
  const Integers quadrant = with_bits_of<Integers>(turns), one(Integer(1)), two(Integer(2));
  const Integers of_s = with_bits_of<Integers>(s), of_c = with_bits_of<Integers>(c);
  const Integers exchange = (of_s ^ of_c) & (Integers(Integer(0)) - (quadrant & one));
  const Integers sine = of_s ^ exchange ^ ((quadrant & two) << kToSign);
  const Integers cosine = of_c ^ exchange ^ ((next_quadrant(turns) & two) << kToSign);
  return {with_bits_of<Batch>(sine), with_bits_of<Batch>(cosine)};
}

// The formula of generated code (templates/polynomial_sines.hpp.mustache): x = n π/2 + r - missing with |r| <= π/4 up
// to a rounding; `missing` is the part that the digits of r cannot hold. The last bits of `turns` are those of n. p
// and `missing` are subtracted, which keeps the sign of a zero in double; in float sin(-0) is +0.
//
// The polynomials are minimax on [-π/4, π/4]; in double their errors are below 2^-57 (coefficients of fdlibm's k_sin.c
// and k_cos.c; the parts of π/2 are those of its e_rem_pio2.c), in float they are those of Cephes' sinf.c.
//
// Each of these functions is written in one piece: then g++ finds what a sine and a cosine of an angle have in common.
template <class Rounding, class A>
inline SineAndCosine<xsimd::batch<double, A>> sine_and_cosine(const xsimd::batch<double, A>& x) noexcept {
  using Batch = xsimd::batch<double, A>;
  using R = Rounding;
  const Batch turns = R::multiply_add(x, Batch(0x1.45f306dc9c883p-1), Batch(WholeTurns<double>::large));
  const Batch n = whole_number(turns);
  const Batch above = R::subtract_product(x, n, Batch(0x1.921fb544p+0)), below = n * Batch(0x1.0b4611a6p-34);
  const Batch r = above - below, missing = R::multiply_add(n, Batch(0x1.3198a2e037073p-69), below - (above - r));
  const Batch z = r * r, zz = z * z, leading = R::subtract_product(Batch(1.0), Batch(0.5), z);
  const Batch p_4 = R::multiply_add(z, Batch(-1.58969099521155010221e-10), Batch(2.50507602534068634195e-08));
  const Batch p_2 = R::multiply_add(z, Batch(-2.75573137070700676789e-06), Batch(1.98412698298579493134e-04));
  const Batch p_0 = R::multiply_add(z, Batch(-8.33333333332248946124e-03), Batch(1.66666666666666324348e-01));
  const Batch p = R::multiply_add(zz, R::multiply_add(zz, p_4, p_2), p_0);
  const Batch k_4 = R::multiply_add(z, Batch(-1.13596475577881948265e-11), Batch(2.08757232129817482790e-09));
  const Batch k_2 = R::multiply_add(z, Batch(-2.75573143513906633035e-07), Batch(2.48015872894767294178e-05));
  const Batch k_0 = R::multiply_add(z, Batch(-1.38888888888741095749e-03), Batch(4.16666666666666019037e-02));
  const Batch k = R::multiply_add(zz, R::multiply_add(zz, k_4, k_2), k_0);
  const Batch s = r - R::multiply_add(z * r, p, leading * missing);
  const Batch rest = R::multiply_add(r, missing, R::subtract_product(Batch(1.0) - leading, Batch(0.5), z));
  return in_quadrant(turns, s, leading + R::multiply_add(zz, k, rest));
}

template <class Rounding, class A>
inline SineAndCosine<xsimd::batch<float, A>> sine_and_cosine(const xsimd::batch<float, A>& x) noexcept {
  using Batch = xsimd::batch<float, A>;
  using R = Rounding;
  const Batch turns = R::multiply_add(x, Batch(0x1.45f306p-1F), Batch(WholeTurns<float>::large));
  const Batch n = whole_number(turns);
  Batch s, c;
  if constexpr (kHasFused && std::is_same_v<R, Fused>) {
    // The parts of π/2 have 24 bits: n times a part is rounded once, with the difference, and nothing is missing.
    const Batch above = R::subtract_product(x, n, Batch(0x1.921fb6p+0F));
    const Batch next = R::subtract_product(above, n, Batch(-0x1.777a5cp-25F));
    const Batch r = R::subtract_product(next, n, Batch(-0x1.ee59dap-50F)), z = r * r;
    const Batch p_1 = R::multiply_add(z, Batch(1.9515295891e-4F), Batch(-8.3321608736e-3F));
    const Batch k_1 = R::multiply_add(z, Batch(2.443315711809948e-5F), Batch(-1.388731625493765e-3F));
    s = R::subtract_product(r, z * r, R::multiply_add(z, p_1, Batch(1.6666654611e-1F)));
    c = R::multiply_add(z * z, R::multiply_add(z, k_1, Batch(4.166664568298827e-2F)),
                        R::subtract_product(Batch(1.0F), Batch(0.5F), z));
  } else {
    const Batch above = (x - n * Batch(0x1.922p+0F)) - n * Batch(-0x1.2cp-18F), below = n * Batch(0x1.11p-26F);
    const Batch r = above - below, missing = (below - (above - r)) + n * Batch(0x1.68c234p-39F);
    const Batch z = r * r, leading = Batch(1.0F) - Batch(0.5F) * z;
    const Batch p = Batch(1.6666654611e-1F) + z * (Batch(-8.3321608736e-3F) + z * Batch(1.9515295891e-4F));
    const Batch k =
        Batch(4.166664568298827e-2F) + z * (Batch(-1.388731625493765e-3F) + z * Batch(2.443315711809948e-5F));
    s = r - (z * r * p + leading * missing);
    c = leading + ((((Batch(1.0F) - leading) - Batch(0.5F) * z) + r * missing) + z * z * k);
  }
  return in_quadrant(turns, s, c);
}

// Lanes that are small enough; not a number is not.
template <class Rounding, class Batch>
inline auto is_small(const Batch& x) noexcept {
  return xsimd::abs(x) <= Batch(reduced_angles<typename Batch::value_type, Rounding>());
}

// Whether all lanes are small, which compilers are told to expect: else they compute the rest of the code twice.
template <class Rounding, class Batch>
inline bool all_small(const Batch& x) noexcept {
  return __builtin_expect(static_cast<long>(xsimd::all(is_small<Rounding>(x))), 1L) != 0;
}

// The result of <cmath>'s function in lanes where x is too large, and `value` in the others. It is a function of its
// own since it is seldom needed, and const so that compilers keep what they know around its call.
template <class Rounding, class Batch>
[[gnu::noinline, gnu::cold, gnu::const]] Batch library_sine(Batch x, Batch value) noexcept {
  alignas(64) typename Batch::value_type lanes[Batch::size];
  x.store_aligned(lanes);
  for (auto& lane : lanes) lane = std::sin(lane);
  return xsimd::select(is_small<Rounding>(x), value, Batch::load_aligned(lanes));
}

template <class Rounding, class Batch>
[[gnu::noinline, gnu::cold, gnu::const]] Batch library_cosine(Batch x, Batch value) noexcept {
  alignas(64) typename Batch::value_type lanes[Batch::size];
  x.store_aligned(lanes);
  for (auto& lane : lanes) lane = std::cos(lane);
  return xsimd::select(is_small<Rounding>(x), value, Batch::load_aligned(lanes));
}

template <class Rounding, class Batch>
inline SineAndCosine<Batch> sin_cos_of_any(const Batch& x) noexcept {
  const SineAndCosine<Batch> both = sine_and_cosine<Rounding>(x);
  if (all_small<Rounding>(x)) return both;
  return {library_sine<Rounding>(x, both.sine), library_cosine<Rounding>(x, both.cosine)};
}

}  // namespace detail

// The sine, in double to 1 ulp, in float to 2; NaN if x is not finite. Compilers compute what sine(x), cosine(x) and
// sin_cos(x) have in common once.
template <class T, class A>
inline xsimd::batch<T, A> sine(const xsimd::batch<T, A>& x) noexcept {
  const xsimd::batch<T, A> value = detail::sine_and_cosine<detail::Fused>(x).sine;
  return detail::all_small<detail::Fused>(x) ? value : detail::library_sine<detail::Fused>(x, value);
}

template <class T, class A>
inline xsimd::batch<T, A> cosine(const xsimd::batch<T, A>& x) noexcept {
  const xsimd::batch<T, A> value = detail::sine_and_cosine<detail::Fused>(x).cosine;
  return detail::all_small<detail::Fused>(x) ? value : detail::library_cosine<detail::Fused>(x, value);
}

template <class T, class A>
inline detail::SineAndCosine<xsimd::batch<T, A>> sin_cos(const xsimd::batch<T, A>& x) noexcept {
  return detail::sin_cos_of_any<detail::Fused>(x);
}

}  // namespace flatdyn
